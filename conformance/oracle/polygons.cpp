// Triangles [GL1.5 §3.5.1]: a pixel belongs to the triangle if its centre lies inside, or on an edge that owns its
// samples (left edges, and horizontal bottom edges). Colours by eq 3.6, depth linear in window space.
#include <algorithm>
#include <cmath>
#include <map>

#include "conformance/oracle/rasterize.h"
#include "conformance/oracle/shading.h"
#include "conformance/oracle/smooth.h"

namespace gouraud::oracle {

Integer doubled_area(const SubpixelPoint& a, const SubpixelPoint& b, const SubpixelPoint& c) {
  return static_cast<Integer>(b.x - a.x) * (c.y - a.y) - static_cast<Integer>(c.x - a.x) * (b.y - a.y);
}

Color color_of(const FragmentSink& sink, const VertexColors& colors) {
  Color out = colors.primary[sink.face];
  for (std::size_t i = 0; sink.has_secondary && sink.texturing.count == 0 && i < 3; ++i) out[i] += colors.secondary[sink.face][i];
  return out;
}

namespace {

/// Positive inside, y up; the triangle lies to the left of its edges.
struct Edge {
  SubpixelPoint from, to;
  bool owns_samples = false;

  Edge(const SubpixelPoint& a, const SubpixelPoint& b)
      : from(a), to(b), owns_samples(b.y < a.y || (b.y == a.y && b.x > a.x)) {}
  bool covers(const SubpixelPoint& sample) const {
    const Integer area = doubled_area(from, to, sample);
    return area > 0 || (area == 0 && owns_samples);
  }
};

/// Values over a triangle as functions of the barycentric coordinates of its unsnapped window positions.
class Interpolation {
 public:
  Interpolation(const FragmentSink& sink, const std::array<WindowVertex, 3>& vertices) : sink_(sink), vertices_(vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      colors_[i] = color_of(sink, sink.flat_colors ? *sink.flat_colors : vertices[i].colors);
    }
    flat_ = sink.flat_colors != nullptr;
  }

  /// False if the unsnapped triangle has no inside.
  bool has_area() const {
    const auto& [a, b, c] = vertices_;
    using Real = long double;
    return (static_cast<Real>(b.x) - a.x) * (static_cast<Real>(c.y) - a.y) !=
           (static_cast<Real>(c.x) - a.x) * (static_cast<Real>(b.y) - a.y);
  }

  /// [GL1.5 §3.5.1]; extended precision, because slivers divide by next to nothing. Without area all is vertex 0.
  Vector3 barycentric(double x, double y) const {
    const auto& [a, b, c] = vertices_;
    using Real = long double;
    const Real abx = static_cast<Real>(b.x) - a.x, aby = static_cast<Real>(b.y) - a.y;
    const Real acx = static_cast<Real>(c.x) - a.x, acy = static_cast<Real>(c.y) - a.y;
    const Real apx = static_cast<Real>(x) - a.x, apy = static_cast<Real>(y) - a.y;
    const Real area = abx * acy - acx * aby;
    if (area == 0) return {1, 0, 0};
    const Real of_b = (apx * acy - acx * apy) / area, of_c = (abx * apy - apx * aby) / area;
    return {static_cast<double>(1 - of_b - of_c), static_cast<double>(of_b), static_cast<double>(of_c)};
  }

  /// Perspective-correct, kept inside the range of the vertices [GL1.5 §3.5.1 eq 3.6].
  Color color(const Vector3& weight) const {
    if (flat_) return colors_[0];
    const auto& [a, b, c] = vertices_;
    // Beyond the horizon the plane's last colours count.
    const double horizon = std::min({a.w_inverse, b.w_inverse, c.w_inverse}) * 1e-6;
    const double q = std::max(weight[0] * a.w_inverse + weight[1] * b.w_inverse + weight[2] * c.w_inverse, horizon);
    Color out;
    for (std::size_t i = 0; i < 4; ++i) {
      const double sum = weight[0] * a.w_inverse * colors_[0][i] + weight[1] * b.w_inverse * colors_[1][i] +
                         weight[2] * c.w_inverse * colors_[2][i];
      out[i] = in_range(sum / q, colors_[0][i], colors_[1][i], colors_[2][i]);
    }
    return out;
  }

  /// With the textures [GL1.5 §3.8]; `in_range` keeps their coordinates in the range of the vertices.
  TexturedColor shaded(const Vector3& weight, bool in_range = false) const {
    const Color primary = color(weight);
    if (sink_.texturing.count == 0) return {primary, primary, primary};
    const auto& [a, b, c] = vertices_;
    // Barycentric coordinates are planes: their slopes.
    const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y), scale = area != 0 ? 1 / area : 0;
    const Vector3 ddx{(b.y - c.y) * scale, (c.y - a.y) * scale, (a.y - b.y) * scale};
    const Vector3 ddy{(c.x - b.x) * scale, (a.x - c.x) * scale, (b.x - a.x) * scale};
    std::array<VertexShare, 3> shares;
    for (std::size_t i = 0; i < 3; ++i) {
      const double q = vertices_[i].w_inverse;
      shares[i] = {&vertices_[i].colors, weight[i] * q, ddx[i] * q, ddy[i] * q};
    }
    return shade(sink_, primary, shares, nullptr, in_range);
  }

  /// Where 1/w is not positive the plane has no values.
  bool is_beyond_horizon(const Vector3& weight) const {
    return weight[0] * vertices_[0].w_inverse + weight[1] * vertices_[1].w_inverse + weight[2] * vertices_[2].w_inverse <= 0;
  }

  bool is_textured() const { return sink_.texturing.count > 0; }

  double fog_coordinate(const Vector3& weight) const {
    const auto& [a, b, c] = vertices_;
    const double q = weight[0] * a.w_inverse + weight[1] * b.w_inverse + weight[2] * c.w_inverse;
    const double f[3] = {a.colors.fog_coordinate, b.colors.fog_coordinate, c.colors.fog_coordinate};
    const double sum = weight[0] * a.w_inverse * f[0] + weight[1] * b.w_inverse * f[1] + weight[2] * c.w_inverse * f[2];
    return in_range(sum / q, f[0], f[1], f[2]);
  }

  double depth(const Vector3& weight) const {
    const auto& [a, b, c] = vertices_;
    return in_range(weight[0] * a.z + weight[1] * b.z + weight[2] * c.z, a.z, b.z, c.z);
  }
  double lowest_depth() const { return std::min({vertices_[0].z, vertices_[1].z, vertices_[2].z}); }
  double highest_depth() const { return std::max({vertices_[0].z, vertices_[1].z, vertices_[2].z}); }

 private:
  /// NaN (weights of 1/w that underflow) becomes the lowest value.
  static double in_range(double value, double a, double b, double c) {
    const double lowest = std::min({a, b, c}), highest = std::max({a, b, c});
    return value >= lowest ? std::min(value, highest) : lowest;
  }

  const FragmentSink& sink_;
  const std::array<WindowVertex, 3>& vertices_;
  std::array<Color, 3> colors_;
  bool flat_ = false;
};

/// The point of the triangle that is near the one with these barycentric coordinates.
Vector3 moved_inside(Vector3 weight) {
  for (double& w : weight) w = std::max(w, 0.0);
  const double sum = weight[0] + weight[1] + weight[2];
  return {weight[0] / sum, weight[1] / sum, weight[2] / sum};
}

/// A colour that changes by more within half a sub-pixel is not resolved.
constexpr double resolved = 1.0 / 255;

void set_depth(const Interpolation& values, const Vector3& weight, Fragment& fragment) {
  fragment.depth = fragment.depth_lowest = fragment.depth_highest = values.depth(weight);
}

/// Widens the bounds of a depth at (x, y), which only snapping covers, by those that the triangle has within half a sub-pixel.
void bound_depth(const Interpolation& values, int subpixel_bits, double x, double y, Fragment& fragment) {
  fragment.extrapolated = true;
  const double reach = std::ldexp(0.5, -subpixel_bits);
  for (const double dx : {-reach, reach}) {
    for (const double dy : {-reach, reach}) {
      const double depth = values.depth(moved_inside(values.barycentric(x + dx, y + dy)));
      fragment.depth_lowest = std::min(fragment.depth_lowest, depth);
      fragment.depth_highest = std::max(fragment.depth_highest, depth);
    }
  }
  if (values.has_area()) return;
  fragment.depth_lowest = values.lowest_depth();
  fragment.depth_highest = values.highest_depth();
}

/// Widens the bounds of the colour by all that the triangle has: textures have some that the corners do not have.
void include_all(const Interpolation& values, Fragment& fragment) {
  const int steps = values.is_textured() ? 12 : 1;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; i + j <= steps; ++j) {
      include_color(values.shaded({1.0 * i / steps, 1.0 * j / steps, 1.0 * (steps - i - j) / steps}), fragment);
    }
  }
}

/// Widens the fragment's bounds by the values that the triangle has within half a sub-pixel; if those are not resolved,
/// by all values of the triangle (PixelFlags).
void bound_extrapolation(const Interpolation& values, int subpixel_bits, Fragment& fragment) {
  fragment.extrapolated = true;
  const auto include = [&](const Vector3& weight) {
    include_color(values.shaded(weight), fragment);
    fragment.depth_lowest = std::min(fragment.depth_lowest, values.depth(weight));
    fragment.depth_highest = std::max(fragment.depth_highest, values.depth(weight));
  };
  const double reach = std::ldexp(0.5, -subpixel_bits);
  for (const double dx : {-reach, reach}) {
    for (const double dy : {-reach, reach}) {
      include(moved_inside(values.barycentric(fragment.x + 0.5 + dx, fragment.y + 0.5 + dy)));
    }
  }
  bool is_resolved = values.has_area();
  for (std::size_t i = 0; i < 4; ++i) is_resolved &= fragment.color_highest[i] - fragment.color_lowest[i] < resolved;
  if (is_resolved) return;
  include_all(values, fragment);
  fragment.depth_lowest = std::min(fragment.depth_lowest, values.lowest_depth());
  fragment.depth_highest = std::max(fragment.depth_highest, values.highest_depth());
}

/// Barycentric coordinates of samples inside err by less.
constexpr double rounding = 1e-12;

void offset_depth(const FragmentSink& sink, Fragment& fragment) {
  fragment.depth += sink.depth_offset;
  // The slope is known to within rounding alone.
  const double slack = sink.depth_offset != 0 ? sink.depth_slack : 0.0;
  fragment.depth_lowest += sink.depth_offset - slack;
  fragment.depth_highest += sink.depth_offset + slack;
}

/// With the slack and the polygon's offset.
void finish_depth(const FragmentSink& sink, const Interpolation& values, Fragment& fragment) {
  fragment.depth_lowest = std::max(fragment.depth_lowest - sink.depth_slack, values.lowest_depth());
  fragment.depth_highest = std::min(fragment.depth_highest + sink.depth_slack, values.highest_depth());
  offset_depth(sink, fragment);
}

/// By the polygon stipple [GL1.5 §3.5.2].
bool is_kept(const FragmentSink& sink, int x, int y) {
  const pipeline::PolygonStippleState& stipple = sink.state.polygon_stipple;
  return !stipple.enabled || (stipple.rows[static_cast<std::size_t>(y & 31)] >> (x & 31) & 1) != 0;
}

void make_fragment(const FragmentSink& sink, const Interpolation& values, int x, int y) {
  const Vector3 weight = values.barycentric(x + 0.5, y + 0.5);
  Fragment fragment;
  fragment.face = sink.face;
  fragment.x = x;
  fragment.y = y;
  set_color(values.shaded(weight), fragment);
  fragment.fog_coordinate = values.fog_coordinate(weight);
  set_depth(values, weight, fragment);
  if (!values.has_area() || std::ranges::any_of(weight, [](double w) { return w < -rounding; })) {
    bound_extrapolation(values, sink.subpixel_bits, fragment);
  }
  finish_depth(sink, values, fragment);
  sink.give(fragment);
}

/// Data of all samples at once may be those of any place in the pixel [GL1.5 §3.5.6]. Where the pixel's centre is inside
/// the triangle they are those of the centre; else any that the triangle has in the pixel, or the centre's, kept in the
/// range of the vertices: any in that range, if the centre lies beyond the horizon.
Fragment shaded_once(const FragmentSink& sink, const std::array<WindowVertex, 3>& vertices, const Interpolation& values, int x, int y) {
  const Vector3 center = values.barycentric(x + 0.5, y + 0.5);
  Fragment fragment;
  fragment.face = sink.face;
  fragment.x = x;
  fragment.y = y;
  const bool inside = values.has_area() && std::ranges::none_of(center, [](double w) { return w < -rounding; });
  Vector3 place = center;
  Outline shared;
  if (!inside) {
    shared = clipped_to_pixel({{vertices[0].x, vertices[0].y}, {vertices[1].x, vertices[1].y}, {vertices[2].x, vertices[2].y}}, x, y);
    const bool has_place = area_of(shared) > 0;
    const Place middle = has_place ? centroid_of(shared) : Place{};
    place = moved_inside(has_place ? values.barycentric(middle.x, middle.y) : center);
  }
  set_color(values.shaded(place), fragment);
  fragment.fog_coordinate = values.fog_coordinate(place);
  if (inside) return fragment;

  fragment.extrapolated = true;
  fragment.other_fog_coordinate = values.fog_coordinate(center);
  const auto include = [&](const Vector3& weight, bool in_range) { include_color(values.shaded(weight, in_range), fragment); };
  include(center, true);
  const auto include_at = [&](double at_x, double at_y) { include(moved_inside(values.barycentric(at_x, at_y)), false); };
  for (const Place& corner : shared) include_at(corner.x, corner.y);
  // Textures have colours in between that the corners do not have.
  for (std::size_t i = 0; i < shared.size() && values.is_textured(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const double share : {0.25, 0.5, 0.75}) {
        include_at(shared[i].x + share * (shared[j].x - shared[i].x), shared[i].y + share * (shared[j].y - shared[i].y));
      }
    }
  }
  if (shared.empty() || !values.has_area() || values.is_beyond_horizon(center)) include_all(values, fragment);
  return fragment;
}

/// Depths are each sample's own.
void give_to_samples(const FragmentSink& sink, const std::array<WindowVertex, 3>& vertices, const Interpolation& values, int x, int y, unsigned covered) {
  const Fragment shaded = shaded_once(sink, vertices, values, x, y);
  for (std::size_t k = 0; k < sample_places.size(); ++k) {
    if ((covered >> k & 1) == 0) continue;
    Fragment fragment = shaded;
    const Vector3 weight = values.barycentric(x + sample_places[k].x, y + sample_places[k].y);
    set_depth(values, weight, fragment);
    if (!values.has_area() || std::ranges::any_of(weight, [](double w) { return w < -rounding; })) {
      bound_depth(values, sink.subpixel_bits, x + sample_places[k].x, y + sample_places[k].y, fragment);
    }
    finish_depth(sink, values, fragment);
    sink.give(fragment, k);
  }
}

Outline outline_of(const SmoothPart& part) {
  Outline outline;
  for (const WindowVertex& vertex : part.vertices) outline.push_back({vertex.x, vertex.y});
  return outline;
}

/// Data are the means over what triangle and pixel share, that is (without perspective) those at its centroid.
void make_smooth_fragment(const SmoothPart& part, int x, int y, double coverage) {
  FragmentSink sink = part.sink;
  if (sink.flat_colors != nullptr) sink.flat_colors = &part.flat_colors;
  if (!is_kept(sink, x, y)) return;
  const Interpolation values(sink, part.vertices);
  const Place at = centroid_of(clipped_to_pixel(outline_of(part), x, y));
  const Vector3 weight = values.barycentric(at.x, at.y);
  Fragment fragment;
  fragment.face = sink.face;
  fragment.x = x;
  fragment.y = y;
  fragment.coverage = std::min(coverage, 1.0);
  fragment.coverage_slack = coverage_rounding;
  fragment.color = fragment.color_lowest = fragment.color_highest = values.color(weight);
  fragment.depth = values.depth(weight);
  fragment.depth_lowest = fragment.depth - sink.depth_slack;
  fragment.depth_highest = fragment.depth + sink.depth_slack;
  offset_depth(sink, fragment);
  sink.give(fragment);
}

}  // namespace

/// r in steps of the depth buffer: two, as Mesa's (MESA-RULES 4.4).
constexpr double offset_unit = 2.0;

double polygon_offset(const pipeline::PolygonState& state, int depth_bits, const std::array<WindowVertex, 3>& vertices) {
  const auto& [a, b, c] = vertices;
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  double slope = 0;
  if (area != 0) {
    const double dx = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area;
    const double dy = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / area;
    slope = std::max(std::abs(dx), std::abs(dy));
  }
  return slope * static_cast<double>(state.offset_factor) + offset_unit * static_cast<double>(state.offset_units) / depth_units_of(depth_bits) +
         static_cast<double>(state.offset_bias);
}

void rasterize_triangle(const FragmentSink& sink, const std::array<WindowVertex, 3>& vertices) {
  SubpixelPoint a = vertices[0].snapped, b = vertices[1].snapped;
  const SubpixelPoint c = vertices[2].snapped;
  const Integer area = doubled_area(a, b, c);
  if (area == 0) return;
  if (area < 0) std::swap(a, b);
  const std::array<Edge, 3> edges{Edge(a, b), Edge(b, c), Edge(c, a)};
  const Interpolation values(sink, vertices);

  const auto is_covered = [&edges](const SubpixelPoint& sample) {
    return std::ranges::all_of(edges, [&sample](const Edge& edge) { return edge.covers(sample); });
  };

  // Every pixel that may have a sample in the triangle's box and that may be written. (0, 0) is a pixel's centre.
  const bool apart = sink.multisample.enabled;
  const std::int64_t reach = apart ? 1 : 0;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
  const pipeline::PixelRect& box = sink.state.scissor;
  const auto x0 = static_cast<int>(std::max<std::int64_t>((left >> sink.subpixel_bits) - reach, box.x0));
  const auto x1 = static_cast<int>(std::min<std::int64_t>((right >> sink.subpixel_bits) + reach, box.x1 - 1));
  const auto y0 = static_cast<int>(std::max<std::int64_t>((bottom >> sink.subpixel_bits) - reach, box.y0));
  const auto y1 = static_cast<int>(std::min<std::int64_t>((top >> sink.subpixel_bits) + reach, box.y1 - 1));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (!is_kept(sink, x, y)) continue;
      const SubpixelPoint center{std::int64_t{x} << sink.subpixel_bits, std::int64_t{y} << sink.subpixel_bits};
      if (!apart) {
        if (is_covered(center)) make_fragment(sink, values, x, y);
        continue;
      }
      unsigned covered = 0;
      for (std::size_t k = 0; k < sample_places.size(); ++k) {
        const auto subpixels = [&](double from_center) { return static_cast<std::int64_t>(std::ldexp(from_center, sink.subpixel_bits)); };
        const SubpixelPoint sample{center.x + subpixels(sample_places[k].x - 0.5), center.y + subpixels(sample_places[k].y - 0.5)};
        if (sink.draws(k) && is_covered(sample)) covered |= 1u << k;
      }
      if (covered != 0) give_to_samples(sink, vertices, values, x, y, covered);
    }
  }
}

void rasterize_smooth_polygon(const std::vector<SmoothPart>& parts) {
  struct Share {
    double sum = 0, largest = 0;
    const SmoothPart* owner = nullptr;
  };
  std::map<std::array<int, 2>, Share> pixels;
  for (const SmoothPart& part : parts) {
    const Outline outline = outline_of(part);
    const auto [left, right] = std::ranges::minmax(outline, {}, &Place::x);
    const auto [bottom, top] = std::ranges::minmax(outline, {}, &Place::y);
    for (int y = static_cast<int>(std::floor(bottom.y)); y < top.y; ++y) {
      for (int x = static_cast<int>(std::floor(left.x)); x < right.x; ++x) {
        const double area = area_of(clipped_to_pixel(outline, x, y));
        Share& share = pixels[{x, y}];
        share.sum += area;
        if (area > share.largest) share = {share.sum, area, &part};
      }
    }
  }
  for (const auto& [at, share] : pixels) {
    if (share.sum >= least_coverage) make_smooth_fragment(*share.owner, at[0], at[1], share.sum);
  }
}

}  // namespace gouraud::oracle
