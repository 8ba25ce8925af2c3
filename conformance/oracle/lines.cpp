// Lines by the diamond-exit rule as it is written, wide, stippled and smooth ones; points [GL1.5 §3.3.1, §3.4.1, §3.4.2].
//
// In the coordinates u = x + y, v = x - y a diamond is a square: |u - uf| < 1/2 and |v - vf| < 1/2. The line is moved
// by
// (-e, -e^2), so u by -(e + e^2) and v by -(e - e^2), for an e smaller than any other number. The times at which it is
// between the square's sides form an open interval for u and one for v; it meets the square if both overlap within
// [0, 1]. Times are exact: (n + e1 e + e2 e^2) / d.
#include <algorithm>
#include <cmath>

#include "conformance/oracle/rasterize.h"
#include "conformance/oracle/shading.h"
#include "conformance/oracle/smooth.h"

namespace gouraud::oracle {
namespace {

/// (n + e1 e + e2 e^2) / d with d > 0 and e infinitely small.
struct Time {
  Integer n = 0, e1 = 0, e2 = 0, d = 1;
};

bool operator<(const Time& a, const Time& b) {
  const Integer difference_n = a.n * b.d - b.n * a.d;
  if (difference_n != 0) return difference_n < 0;
  const Integer difference_e1 = a.e1 * b.d - b.e1 * a.d;
  if (difference_e1 != 0) return difference_e1 < 0;
  return a.e2 * b.d < b.e2 * a.d;
}

struct Interval {
  Time begin, end;  ///< open
  bool empty = false;
};

constexpr Time before_all{-1, 0, 0, 1}, after_all{2, 0, 0, 1};

/// When position + time * direction - (e + sign e^2) is between -half and half.
Interval time_inside(Integer position, Integer direction, int sign, Integer half) {
  if (direction == 0) {
    const bool inside = position > -half && position <= half;  // less an infinitely small amount
    return {before_all, after_all, !inside};
  }
  // time = (side - position + e + sign e^2) / direction for the two sides.
  const Integer s = direction > 0 ? 1 : -1;
  const auto time_at = [&](Integer side) { return Time{s * (side - position), s, s * sign, s * direction}; };
  return direction > 0 ? Interval{time_at(-half), time_at(half)} : Interval{time_at(half), time_at(-half)};
}

bool contains_end(Integer u, Integer v, Integer half) {
  return u > -half && u <= half && v > -half && v <= half;
}

/// The line's colour where it is t of the way [GL1.5 §3.4.1 eq 3.4]. With t beyond the ends the weights' sum may
/// vanish: the nearer end's colour then.
/// In perspective kept between the ends', as 1/w may pass zero beyond them.
double fog_coordinate_at(const std::array<WindowVertex, 2>& ends, double t) {
  const auto& [a, b] = ends;
  const double f0 = a.colors.fog_coordinate, f1 = b.colors.fog_coordinate;
  if (a.w_inverse == b.w_inverse) return (1 - t) * f0 + t * f1;
  const double s = std::clamp(t, 0.0, 1.0), q0 = (1 - s) * a.w_inverse, q1 = s * b.w_inverse;
  return (q0 * f0 + q1 * f1) / (q0 + q1);
}

Color color_at(const std::array<WindowVertex, 2>& ends, const std::array<Color, 2>& colors, double t) {
  const double weight_a = (1 - t) * ends[0].w_inverse, weight_b = t * ends[1].w_inverse, sum = weight_a + weight_b;
  if (sum <= 0) return colors[t < 0.5 ? 0 : 1];
  Color out;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = colors[0][i], b = colors[1][i];
    out[i] = a == b ? a : (weight_a * a + weight_b * b) / sum;
  }
  return out;
}

double length_squared(const std::array<WindowVertex, 2>& ends) {
  const double dx = ends[1].x - ends[0].x, dy = ends[1].y - ends[0].y;
  return dx * dx + dy * dy;
}

/// How far along the line a place is: 0 at its start, 1 at its end [GL1.5 §3.4.1 eq 3.3].
double time_at(const std::array<WindowVertex, 2>& ends, double x, double y) {
  const auto& [a, b] = ends;
  const double squared = length_squared(ends);
  return squared > 0 ? ((x - a.x) * (b.x - a.x) + (y - a.y) * (b.y - a.y)) / squared : 0.0;
}

/// The line's colour there [GL1.5 §3.4.1 eq 3.4], with its textures at `t`.
TexturedColor shaded_at(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, const std::array<Color, 2>& colors, double t, double color_t) {
  const auto& [a, b] = ends;
  const double squared = length_squared(ends);
  const double slope_x = squared > 0 ? (b.x - a.x) / squared : 0.0, slope_y = squared > 0 ? (b.y - a.y) / squared : 0.0;
  const std::array<VertexShare, 2> shares{
      VertexShare{&a.colors, (1 - t) * a.w_inverse, -slope_x * a.w_inverse, -slope_y * a.w_inverse},
      VertexShare{&b.colors, t * b.w_inverse, slope_x * b.w_inverse, slope_y * b.w_inverse}};
  Color primary = color_at(ends, colors, color_t);
  // What texture environments take in is in [0, 1], also beyond an end.
  for (double& channel : primary) channel = sink.texturing.count > 0 ? std::clamp(channel, 0.0, 1.0) : channel;
  return shade(sink, primary, shares);
}
TexturedColor shaded_at(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, const std::array<Color, 2>& colors, double t) {
  return shaded_at(sink, ends, colors, t, t);
}

std::array<Color, 2> colors_of(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends) {
  return {color_of(sink, sink.flat_colors ? *sink.flat_colors : ends[0].colors), color_of(sink, sink.flat_colors ? *sink.flat_colors : ends[1].colors)};
}

/// [GL1.5 §3.4.1 eq 3.5].
void set_depth(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, double t, Fragment& fragment) {
  const double a = ends[0].z, b = ends[1].z;
  fragment.depth = (a == b ? a : (1 - t) * a + t * b) + sink.depth_offset;
  const double slack = a == b && sink.depth_offset == 0 ? 0.0 : sink.depth_slack;
  fragment.depth_lowest = fragment.depth - slack;
  fragment.depth_highest = fragment.depth + slack;
}

/// Centres before the start or behind the end have, as the equations say, colours beyond those of the end points. In
/// perspective they may be far beyond: legal is all from there to the end's own colour (PixelFlags), or any colour of
/// the line if the equation has none.
void bound_extrapolation(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, const std::array<Color, 2>& colors, double t,
                         Fragment& fragment) {
  fragment.extrapolated = true;
  const bool beyond_horizon = (1 - t) * ends[0].w_inverse + t * ends[1].w_inverse <= 0;
  if (beyond_horizon) include_color(shaded_at(sink, ends, colors, t < 0.5 ? 1.0 : 0.0), fragment);
  const double end = t < 0.5 ? 0 : 1;
  include_color(shaded_at(sink, ends, colors, end), fragment);
  if (beyond_horizon || sink.texturing.count == 0) return;
  // Colours and texture coordinates may be bounded apart.
  include_color(shaded_at(sink, ends, colors, t, end), fragment);
  include_color(shaded_at(sink, ends, colors, end, t), fragment);
}

/// Colour and depth of the line at a pixel's centre.
void make_fragment(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, int x, int y, double coverage = 1) {
  const double t = time_at(ends, x + 0.5, y + 0.5);
  Fragment fragment;
  fragment.face = sink.face;
  fragment.x = x;
  fragment.y = y;
  fragment.coverage = coverage;
  fragment.coverage_slack = coverage < 1 ? coverage_rounding : 0;
  const std::array<Color, 2> colors = colors_of(sink, ends);
  set_color(shaded_at(sink, ends, colors, t), fragment);
  fragment.fog_coordinate = fog_coordinate_at(ends, t);
  if ((t < 0 || t > 1) && ends[0].w_inverse != ends[1].w_inverse) bound_extrapolation(sink, ends, colors, t, fragment);
  set_depth(sink, ends, t, fragment);
  sink.give(fragment);
}

/// Data of all samples at once may be those of any place in the pixel, depths are each sample's own [GL1.5 §3.4.4]. What
/// lies beyond the ends may have the end's.
void make_sample(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, int x, int y, std::size_t k, bool may_be_absent) {
  Fragment fragment;
  fragment.face = sink.face;
  fragment.x = x;
  fragment.y = y;
  fragment.may_be_absent = may_be_absent;
  const std::array<Color, 2> colors = colors_of(sink, ends);
  const double center = time_at(ends, x + 0.5, y + 0.5), t = time_at(ends, x + sample_places[k].x, y + sample_places[k].y);
  set_color(shaded_at(sink, ends, colors, std::clamp(center, 0.0, 1.0)), fragment);
  fragment.extrapolated |= colors[0] != colors[1] || sink.texturing.count > 0;
  for (const SamplePosition& place : sample_places) {
    include_color(shaded_at(sink, ends, colors, std::clamp(time_at(ends, x + place.x, y + place.y), 0.0, 1.0)), fragment);
  }
  fragment.fog_coordinate = fog_coordinate_at(ends, std::clamp(center, 0.0, 1.0));
  fragment.other_fog_coordinate = fog_coordinate_at(ends, std::clamp(t, 0.0, 1.0));
  fragment.extrapolated |= sink.state.fog.mode != pipeline::FogMode::none;
  set_depth(sink, ends, t, fragment);
  sink.give(fragment, k);
}

bool stipple_keeps(const pipeline::LineState& lines, std::int64_t count) {
  return (lines.stipple_pattern >> (count / lines.stipple_factor % 16) & 1) != 0;
}

/// The pixels of the line of width 1, in order from a to b.
std::vector<std::array<int, 2>> pixels_of(const SubpixelPoint& a, const SubpixelPoint& b, int subpixel_bits) {
  // Walk the columns (rows, if the line is steep) and ask the five pixels around the line in each.
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const double unit = std::ldexp(1.0, -subpixel_bits);
  const double major_a = static_cast<double>(steep ? a.y : a.x) * unit,
               minor_a = static_cast<double>(steep ? a.x : a.y) * unit;
  const double major_b = static_cast<double>(steep ? b.y : b.x) * unit,
               minor_b = static_cast<double>(steep ? b.x : b.y) * unit;
  const double slope = (minor_b - minor_a) / (major_b - major_a);
  const int first = static_cast<int>(std::floor(std::min(major_a, major_b)) - 1);
  const int last = static_cast<int>(std::ceil(std::max(major_a, major_b)) + 1);
  std::vector<std::array<int, 2>> pixels;
  for (int major = first; major <= last; ++major) {
    const auto middle = static_cast<int>(std::lround(minor_a + slope * (major - major_a)));
    for (int minor = middle - 2; minor <= middle + 2; ++minor) {
      const int x = steep ? minor : major, y = steep ? major : minor;
      if (exits_diamond(a, b, x, y, subpixel_bits)) pixels.push_back({x, y});
    }
  }
  if (major_b < major_a) std::ranges::reverse(pixels);
  return pixels;
}

/// Moved in the minor direction, and so many fragments in each column [GL1.5 §3.4.2].
void rasterize_aliased(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices, std::int64_t& stipple_count) {
  SubpixelPoint a = vertices[0].snapped, b = vertices[1].snapped;
  if (a == b) return;
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const int width = static_cast<int>(sink.lines.width_px);
  const std::int64_t shift = (std::int64_t{1} << sink.subpixel_bits) / 2 * (width - 1);
  (steep ? a.x : a.y) -= shift;
  (steep ? b.x : b.y) -= shift;
  for (const auto& [x, y] : pixels_of(a, b, sink.subpixel_bits)) {
    if (!stipple_keeps(sink.lines, stipple_count++)) continue;
    for (int k = 0; k < width; ++k) make_fragment(sink, vertices, x + (steep ? k : 0), y + (steep ? 0 : k));
  }
}

/// So near to an edge of a line or point, in pixels, a sample may be on either side: corners may be rounded to a sub-pixel.
constexpr double edge_slack = 1.0 / 256;

/// The samples inside the rectangle around a stretch of the line [GL1.5 §3.4.4].
void sample_stretch(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices, double begin, double end) {
  const WindowVertex &a = vertices[0], &b = vertices[1];
  const double length = std::hypot(b.x - a.x, b.y - a.y), half = 0.5 * static_cast<double>(sink.lines.width_px);
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length, reach = half + 1;
  const auto [x0, x1] = std::minmax({a.x + begin * ux, a.x + end * ux});
  const auto [y0, y1] = std::minmax({a.y + begin * uy, a.y + end * uy});
  const pipeline::PixelRect& box = sink.state.scissor;
  for (int y = std::max(static_cast<int>(std::floor(y0 - reach)), box.y0); y < std::min<double>(y1 + reach, box.y1); ++y) {
    for (int x = std::max(static_cast<int>(std::floor(x0 - reach)), box.x0); x < std::min<double>(x1 + reach, box.x1); ++x) {
      for (std::size_t k = 0; k < sample_places.size(); ++k) {
        const double dx = x + sample_places[k].x - a.x, dy = y + sample_places[k].y - a.y;
        const double along = dx * ux + dy * uy, across = std::abs(dy * ux - dx * uy);
        const double outside = std::max({begin - along, along - end, across - half});
        if (outside < edge_slack) make_sample(sink, vertices, x, y, k, outside > -edge_slack);
      }
    }
  }
}

/// A rectangle around the stretch of the line between two distances from its start [GL1.5 §3.4.2].
void rasterize_stretch(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices, double begin, double end) {
  if (sink.multisample.enabled) return sample_stretch(sink, vertices, begin, end);
  const WindowVertex &a = vertices[0], &b = vertices[1];
  const double length = std::hypot(b.x - a.x, b.y - a.y), half = 0.5 * static_cast<double>(sink.lines.width_px);
  const double ux = (b.x - a.x) / length, uy = (b.y - a.y) / length;
  const auto corner = [&](double along, double across) {
    return Place{a.x + along * ux - across * uy, a.y + along * uy + across * ux};
  };
  const Outline rectangle{corner(begin, -half), corner(end, -half), corner(end, half), corner(begin, half)};
  const auto [x0, x1] = std::ranges::minmax(rectangle, {}, &Place::x);
  const auto [y0, y1] = std::ranges::minmax(rectangle, {}, &Place::y);
  for (int y = static_cast<int>(std::floor(y0.y)); y < y1.y; ++y) {
    for (int x = static_cast<int>(std::floor(x0.x)); x < x1.x; ++x) {
      const double coverage = area_of(clipped_to_pixel(rectangle, x, y));
      if (coverage >= least_coverage) make_fragment(sink, vertices, x, y, coverage);
    }
  }
}

/// Neighbouring unit rectangles that the stipple keeps are one.
void rasterize_smooth(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices, std::int64_t& stipple_count) {
  const double length = std::hypot(vertices[1].x - vertices[0].x, vertices[1].y - vertices[0].y);
  if (length == 0) return;
  if (sink.lines.stipple_pattern == 0xFFFF) return rasterize_stretch(sink, vertices, 0, length);
  const auto count = static_cast<std::int64_t>(std::ceil(length));
  std::int64_t begin = 0;
  for (std::int64_t i = 0; i <= count; ++i) {
    if (i < count && stipple_keeps(sink.lines, stipple_count + i)) continue;
    if (i > begin) rasterize_stretch(sink, vertices, static_cast<double>(begin), std::min(static_cast<double>(i), length));
    begin = i + 1;
  }
  stipple_count += count;
}

}  // namespace

bool exits_diamond(const SubpixelPoint& a, const SubpixelPoint& b, int x, int y, int subpixel_bits) {
  const Integer half = Integer{1} << (subpixel_bits - 1);
  const Integer ax = a.x - (std::int64_t{x} << subpixel_bits), ay = a.y - (std::int64_t{y} << subpixel_bits);
  const Integer bx = b.x - (std::int64_t{x} << subpixel_bits), by = b.y - (std::int64_t{y} << subpixel_bits);
  if (contains_end(bx + by, bx - by, half)) return false;
  const Interval u = time_inside(ax + ay, (bx + by) - (ax + ay), +1, half);
  const Interval v = time_inside(ax - ay, (bx - by) - (ax - ay), -1, half);
  if (u.empty || v.empty) return false;
  const Time begin = std::max(u.begin, v.begin), end = std::min(u.end, v.end);
  return begin < end && begin < Time{1, 0, 0, 1} && Time{0, 0, 0, 1} < end;
}

void rasterize_line(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices, std::int64_t& stipple_count) {
  if (sink.lines.smooth) {
    rasterize_smooth(sink, vertices, stipple_count);
  } else {
    rasterize_aliased(sink, vertices, stipple_count);
  }
}

std::array<int, 2> pixel_of_point(double x, double y, int subpixel_bits) {
  const double subpixels = std::ldexp(1.0, subpixel_bits);
  const double snapped_x = std::floor(x * subpixels + 0.5), snapped_y = std::ceil(y * subpixels - 0.5);
  return {static_cast<int>(std::floor(snapped_x / subpixels)), static_cast<int>(std::floor(snapped_y / subpixels))};
}

namespace {
/// [ARB_point_sprite]: from (0, 0) at the top left to (1, 1); kept inside, because a snapped square may stand out.
TextureCoordinate sprite_coordinate(const WindowVertex& vertex, double size_px, double x, double y) {
  TextureCoordinate out;
  out.value = {std::clamp(0.5 + (x - vertex.x) / size_px, 0.0, 1.0), std::clamp(0.5 - (y - vertex.y) / size_px, 0.0, 1.0), 0, 1};
  out.ddx = {1 / size_px, 0, 0, 0};
  out.ddy = {0, -1 / size_px, 0, 0};
  return out;
}

/// The samples inside a disc, or a sprite's square [GL1.5 §3.3.3]. The texels of all samples at once may be those of any
/// place in the pixel.
void sample_point(const FragmentSink& sink, const WindowVertex& vertex, double size_px, Fragment fragment) {
  const std::array<VertexShare, 1> shares{VertexShare{&vertex.colors, 1, 0, 0}};
  const Color primary = color_of(sink, sink.flat_colors ? *sink.flat_colors : vertex.colors);
  const double half = 0.5 * size_px;
  const pipeline::PixelRect& box = sink.state.scissor;
  const bool textured = sink.texturing.sprite_units != 0;
  const auto shade_sprite = [&](double x, double y) {
    const TextureCoordinate coordinate = sprite_coordinate(vertex, size_px, x, y);
    return shade(sink, primary, shares, &coordinate);
  };
  for (int y = std::max(static_cast<int>(std::floor(vertex.y - half)), box.y0); y < std::min<double>(vertex.y + half + 1, box.y1); ++y) {
    for (int x = std::max(static_cast<int>(std::floor(vertex.x - half)), box.x0); x < std::min<double>(vertex.x + half + 1, box.x1); ++x) {
      fragment.x = x;
      fragment.y = y;
      if (textured) {
        set_color(shade_sprite(x + 0.5, y + 0.5), fragment);
        fragment.extrapolated = true;
        for (const SamplePosition& place : sample_places) include_color(shade_sprite(x + place.x, y + place.y), fragment);
      }
      for (std::size_t k = 0; k < sample_places.size(); ++k) {
        const double dx = std::abs(x + sample_places[k].x - vertex.x), dy = std::abs(y + sample_places[k].y - vertex.y);
        const double outside = (sink.points.sprite ? std::max(dx, dy) : std::hypot(dx, dy)) - half;
        fragment.may_be_absent = outside > -edge_slack;
        if (outside < edge_slack) sink.give(fragment, k);
      }
    }
  }
}

/// Multisampled points that are too small are drawn larger, and fade by their area [GL1.5 §3.3].
double faded(const FragmentSink& sink, double& size_px) {
  const auto threshold = static_cast<double>(sink.points.fade_threshold_px);
  if (!sink.multisample.enabled || size_px >= threshold) return 1;
  const double ratio = size_px / threshold;
  size_px = threshold;
  return ratio * ratio;
}
}  // namespace

void rasterize_point(const FragmentSink& sink, const WindowVertex& vertex, double size_px) {
  Fragment fragment;
  fragment.coverage = faded(sink, size_px);
  fragment.face = sink.face;
  const std::array<VertexShare, 1> shares{VertexShare{&vertex.colors, 1, 0, 0}};
  const Color primary = color_of(sink, sink.flat_colors ? *sink.flat_colors : vertex.colors);
  const bool sprite = sink.texturing.sprite_units != 0;
  if (!sprite) set_color(shade(sink, primary, shares), fragment);
  fragment.fog_coordinate = vertex.colors.fog_coordinate;
  fragment.depth = fragment.depth_lowest = fragment.depth_highest = vertex.z + sink.depth_offset;
  if (sink.depth_offset != 0) {
    fragment.depth_lowest -= sink.depth_slack;
    fragment.depth_highest += sink.depth_slack;
  }
  if (sink.multisample.enabled) return sample_point(sink, vertex, size_px, fragment);
  const auto each_pixel = [&](int x0, int y0, int x1, int y1, const auto& coverage_of) {
    for (fragment.y = y0; fragment.y < y1; ++fragment.y) {
      for (fragment.x = x0; fragment.x < x1; ++fragment.x) {
        fragment.coverage = coverage_of(fragment.x, fragment.y);
        fragment.coverage_slack = sink.points.smooth && fragment.coverage < 1 ? disc_slack : 0;
        if (sprite) {
          const TextureCoordinate over_sprite = sprite_coordinate(vertex, size_px, fragment.x + 0.5, fragment.y + 0.5);
          fragment.extrapolated = false;
          set_color(shade(sink, primary, shares, &over_sprite), fragment);
        }
        if (fragment.coverage >= least_coverage) sink.give(fragment);
      }
    }
  };
  const auto whole = [](int, int) { return 1.0; };
  const double half = 0.5 * size_px;
  const auto floor_of = [](double v) { return static_cast<int>(std::floor(v)); };
  if (sink.points.smooth) {
    return each_pixel(floor_of(vertex.x - half), floor_of(vertex.y - half), floor_of(vertex.x + half) + 1,
                      floor_of(vertex.y + half) + 1,
                      [&](int x, int y) { return disc_in_pixel({vertex.x, vertex.y}, half, x, y); });
  }
  if (sink.points.sprite) {
    // The centres inside the square; left and bottom edges own theirs.
    const auto first = [&](double edge) {
      const double subpixels = std::ldexp(1.0, sink.subpixel_bits);
      return static_cast<int>(std::ceil(std::nearbyint((edge - 0.5) * subpixels) / subpixels));
    };
    return each_pixel(first(vertex.x - half), first(vertex.y - half), first(vertex.x + half), first(vertex.y + half), whole);
  }
  // Rounded halves down (MESA-RULES 5.4): a square of that many pixels around the pixel, or around the nearest corner.
  const int size = std::max(static_cast<int>(std::ceil(size_px - 0.5)), 1);
  const double to_corner = size % 2 == 0 ? 0.5 : 0.0;
  const auto [x, y] = pixel_of_point(vertex.x + to_corner, vertex.y + to_corner, sink.subpixel_bits);
  each_pixel(x - size / 2, y - size / 2, x - size / 2 + size, y - size / 2 + size, whole);
}

}  // namespace gouraud::oracle
