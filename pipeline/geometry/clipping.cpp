// Takes primitives that lie partly outside the clip volume, gives the parts inside [GL1.5 §2.12].
//
// Triangles: Sutherland-Hodgman against those planes that a vertex violates, the frustum's in homogeneous clip space, so
// that w <= 0 needs no special care, then the user's in eye space. Colours and other attributes are interpolated along with the positions [GL1.5 §2.14.8].
// Lines: the intersections come from exact sums, for nothing says how far outside a line may begin.
#include "pipeline/geometry/clipping.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "pipeline/geometry/clip_planes.h"
#include "pipeline/geometry/viewport.h"

namespace gouraud::pipeline {
namespace {

/// The planes in clipping order: those of the frustum, as bits of the outcode, then the user's. Distances are positive
/// inside.
constexpr std::uint32_t frustum_planes = 6, plane_count = frustum_planes + max_clip_planes;

bool is_outside(std::uint32_t outcode, std::uint32_t plane) {
  constexpr std::uint32_t gap = 1;  // outside_invalid
  static_assert(outside_clip_plane_0 == 1u << (frustum_planes + gap));
  return (outcode >> (plane < frustum_planes ? plane : plane + gap) & 1) != 0;
}

/// The upper planes bound a coordinate by w, the lower ones by -w.
bool is_upper(std::uint32_t plane) {
  return (1u << plane & (outside_right | outside_top | outside_far)) != 0;
}

bool is_near(std::uint32_t plane) { return 1u << plane == outside_near; }

float distance(const ProcessedVertices& vertices, const ClipAttributes& attributes, std::uint16_t index, std::uint32_t plane) {
  if (plane >= frustum_planes) {
    return static_cast<float>(distance_from(attributes.planes->plane_eye[plane - frustum_planes], vertices, index));
  }
  const float coordinate = vertices.position_clip[plane / 2][index], w = vertices.position_clip[3][index];
  if (is_upper(plane)) return -coordinate + w;
  return coordinate + (is_near(plane) ? vertices.near_plane_w * w : w);
}

/// Vertex numbers, and whether the edge from each vertex to the next is a boundary edge: what is left of a triangle.
struct Polygon {
  static constexpr std::size_t capacity = 3 + max_clip_vertices;
  std::size_t size = 0;
  std::array<std::uint16_t, capacity> vertex;
  std::array<bool, capacity> boundary;
  void add(std::uint16_t index, bool boundary_edge) {
    vertex[size] = index;
    boundary[size++] = boundary_edge;
  }
};

/// Appends a vertex whose every component is mix(component of a, component of b).
template <class Mix>
std::uint16_t add_vertex(ProcessedVertices& vertices, const ClipAttributes& attributes, std::uint16_t a,
                         std::uint16_t b, const Mix& mix) {
  const auto index = static_cast<std::uint16_t>(vertices.count++);
  const auto mix_arrays = [&](auto& arrays) {
    for (auto& array : arrays) array[index] = mix(array[a], array[b]);
  };
  const auto mix_colors = [&](auto& colors) {
    const Rgba &from = colors[a], &to = colors[b];
    colors[index] = {mix(from.r, to.r), mix(from.g, to.g), mix(from.b, to.b), mix(from.a, to.a)};
  };
  mix_arrays(vertices.position_clip);
  if (attributes.eye) mix_arrays(vertices.position_eye);
  if (attributes.color_front) mix_colors(vertices.color_front);
  if (attributes.color_back) mix_colors(vertices.color_back);
  if (attributes.specular) mix_colors(vertices.specular_front);
  if (attributes.specular && attributes.color_back) mix_colors(vertices.specular_back);
  for (std::size_t k = 0; k < static_cast<std::size_t>(attributes.varyings); ++k) {
    auto& array = vertices.varying[k];
    array[index] = mix(array[a], array[b]);
  }
  return index;
}

/// Where the edge between an inside and an outside vertex meets the plane, measured from the nearer of the two.
std::uint16_t intersect(ProcessedVertices& vertices, const ClipAttributes& attributes, std::uint16_t inside,
                        std::uint16_t outside, std::uint32_t plane) {
  const float d_inside = distance(vertices, attributes, inside, plane);
  const float d_outside = distance(vertices, attributes, outside, plane);
  const bool from_outside = -d_outside < d_inside;
  const float t = from_outside ? d_outside / (d_outside - d_inside) : d_inside / (d_inside - d_outside);
  return add_vertex(vertices, attributes, from_outside ? outside : inside, from_outside ? inside : outside,
                    [t](float from, float to) { return from + t * (to - from); });
}

/// The part of the polygon on the plane's inner side. False if a distance is infinite, or if rounding has bent the
/// polygon so much that the new vertices do not fit.
template <class Polygon>
bool clip_to_plane(const Polygon& in, std::uint32_t plane, const ClipAttributes& attributes, std::int32_t room_end,
                   ProcessedVertices& vertices, Polygon& out) {
  out.size = 0;
  float d = distance(vertices, attributes, in.vertex[0], plane);
  for (std::size_t i = 0; i < in.size; ++i) {
    const std::uint16_t here = in.vertex[i], next = in.vertex[i + 1 < in.size ? i + 1 : 0];
    const float d_next = distance(vertices, attributes, next, plane);
    if (!std::isfinite(d) || vertices.count >= room_end) return false;
    if (d >= 0) out.add(here, in.boundary[i]);
    // Leaving, the new edge runs along the plane; coming back, along the old edge.
    if (d >= 0 && d_next < 0) out.add(intersect(vertices, attributes, here, next, plane), true);
    if (d < 0 && d_next >= 0) out.add(intersect(vertices, attributes, next, here, plane), in.boundary[i]);
    d = d_next;
  }
  return out.size >= 3;
}

/// Clips against the planes in `outcodes`; the result is in `polygon`. False if nothing is left.
template <class Polygon>
bool clip_polygon(std::uint32_t outcodes, const ClipAttributes& attributes, std::int32_t room_end,
                  ProcessedVertices& vertices, Polygon& polygon) {
  if ((outcodes & outside_invalid) != 0) return false;
  Polygon clipped;
  for (std::uint32_t plane = 0; plane < plane_count; ++plane) {
    if (!is_outside(outcodes, plane)) continue;
    if (!clip_to_plane(polygon, plane, attributes, room_end, vertices, clipped)) return false;
    polygon = clipped;
  }
  return true;
}

/// The sum of the terms, rounded as if it were computed exactly (to within a unit in the last place), so that its sign
/// is right: partial sums that do not overlap (Shewchuk, "Adaptive Precision Floating-Point Arithmetic", 1997).
template <std::size_t terms>
double exact_sum(const std::array<double, terms>& values) {
  std::array<double, terms> partial;
  std::size_t count = 0;
  for (double x : values) {
    std::size_t kept = 0;
    for (std::size_t j = 0; j < count; ++j) {
      double y = partial[j];
      if (std::abs(x) < std::abs(y)) std::swap(x, y);
      const double high = x + y, low = y - (high - x);
      if (low != 0) partial[kept++] = low;
      x = high;
    }
    partial[kept] = x;
    count = kept + 1;
  }
  double sum = 0;
  while (count > 0) sum += partial[--count];
  return sum;
}

/// A line as the clipper of lines sees it. A product of two floats is exact in double, so that everything below is;
/// distances from the user's planes are rounded to double.
class Line {
 public:
  Line(const ProcessedVertices& vertices, const ClipAttributes& attributes, const AssembledLine& line)
      : vertices_(vertices), attributes_(attributes), line_(line) {}

  /// d_a(v0) d_b(v1) - d_b(v0) d_a(v1), with d the distances of the end points from the planes a and b.
  double cross(std::uint32_t a, std::uint32_t b) const {
    const Pair a0 = distance(0, a), a1 = distance(1, a), b0 = distance(0, b), b1 = distance(1, b);
    return exact_sum<8>({a0[0] * b1[0], a0[0] * b1[1], a0[1] * b1[0], a0[1] * b1[1], -b0[0] * a1[0], -b0[0] * a1[1],
                         -b0[1] * a1[0], -b0[1] * a1[1]});
  }

  /// A quantity that is value0 at v0 and value1 at v1, where the line meets the plane.
  float at_plane(std::uint32_t plane, float value0, float value1) const {
    const Pair d0 = distance(0, plane), d1 = distance(1, plane);
    const double v0 = value0, v1 = value1;
    const double weighted = exact_sum<4>({d0[0] * v1, d0[1] * v1, -d1[0] * v0, -d1[1] * v0});
    return static_cast<float>(weighted / exact_sum<4>({d0[0], d0[1], -d1[0], -d1[1]}));
  }

  /// The plane where the line comes in, seen from the end point: the last of those that the end point is outside of.
  /// plane_count if it is inside.
  std::uint32_t entry(std::size_t end) const {
    std::uint32_t last = plane_count;
    for (std::uint32_t plane = 0; plane < plane_count; ++plane) {
      if (!is_outside(vertices_.outcode[line_.vertex[end]], plane)) continue;
      const bool later = last == plane_count || (end == 0 ? cross(last, plane) > 0 : cross(last, plane) < 0);
      if (later) last = plane;
    }
    return last;
  }

  std::uint16_t add_vertex_at(std::uint32_t plane, ProcessedVertices& out) const;

 private:
  using Pair = std::array<double, 2>;  ///< an exact sum of two

  Pair distance(std::size_t end, std::uint32_t plane) const {
    const std::uint16_t index = line_.vertex[end];
    if (plane >= frustum_planes) {
      return {distance_from(attributes_.planes->plane_eye[plane - frustum_planes], vertices_, index), 0.0};
    }
    const double coordinate = vertices_.position_clip[plane / 2][index], w = vertices_.position_clip[3][index];
    return {is_upper(plane) ? -coordinate : coordinate, is_near(plane) ? vertices_.near_plane_w * w : w};
  }

  const ProcessedVertices& vertices_;
  const ClipAttributes& attributes_;
  const AssembledLine& line_;
};

std::uint16_t Line::add_vertex_at(std::uint32_t plane, ProcessedVertices& out) const {
  return add_vertex(out, attributes_, line_.vertex[0], line_.vertex[1],
                    [&](float value0, float value1) { return at_plane(plane, value0, value1); });
}

/// The clipped polygon as a fan; the edges inside it are no boundary.
void emit_fan(const Polygon& polygon, const AssembledTriangle& whole, std::vector<AssembledTriangle>& out) {
  for (std::size_t i = 2; i < polygon.size; ++i) {
    const bool first = i == 2, last = i == polygon.size - 1;
    const unsigned edges = (polygon.boundary[i - 1] ? 1u : 0u) | (last && polygon.boundary[i] ? 2u : 0u) |
                           (first && polygon.boundary[0] ? 4u : 0u);
    out.push_back({{polygon.vertex[i - 1], polygon.vertex[i], polygon.vertex[0]},
                   whole.provoking,
                   static_cast<std::uint8_t>(edges),
                   whole.continues || !first});
  }
}

}  // namespace

void clip_triangle(const AssembledTriangle& triangle, const ViewportState& viewport, const ClipAttributes& attributes,
                   ProcessedVertices& vertices, std::vector<AssembledTriangle>& out) {
  const std::int32_t count = vertices.count;
  Polygon polygon;
  std::uint32_t outcodes = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    polygon.add(triangle.vertex[i], (triangle.edges >> i & 1) != 0);
    outcodes |= vertices.outcode[triangle.vertex[i]];
  }
  bool drawable = clip_polygon(outcodes, attributes, count + max_clip_vertices, vertices, polygon);
  for (std::size_t i = 0; drawable && i < polygon.size; ++i) {
    const std::uint16_t index = polygon.vertex[i];
    if (index >= count) drawable = project_vertex(viewport, vertices, index);
  }
  if (drawable) {
    emit_fan(polygon, triangle, out);
  } else {
    vertices.count = count;
  }
}

bool clip_outline(Outline& outline, const ViewportState& viewport, const ClipAttributes& attributes,
                  ProcessedVertices& vertices) {
  const std::int32_t count = vertices.count;
  std::uint32_t any = 0, all = ~0u;
  for (std::size_t i = 0; i < outline.size; ++i) {
    const std::uint32_t outcode = vertices.outcode[outline.vertex[i]];
    any |= outcode;
    all &= outcode;
  }
  // Each new vertex makes the outline longer by one at most.
  const auto room = static_cast<std::int32_t>(Outline::capacity - outline.size);
  const std::int32_t room_end = std::min(processed_stride, count + room);
  bool left = all == 0 && (any == 0 || clip_polygon(any, attributes, room_end, vertices, outline));
  for (std::size_t i = 0; left && i < outline.size; ++i) {
    if (outline.vertex[i] >= count) left = project_vertex(viewport, vertices, outline.vertex[i]);
  }
  if (!left) vertices.count = count;
  return left;
}

bool clip_line(AssembledLine& line, const ViewportState& viewport, const ClipAttributes& attributes,
               ProcessedVertices& vertices) {
  const std::uint32_t outcode0 = vertices.outcode[line.vertex[0]], outcode1 = vertices.outcode[line.vertex[1]];
  if ((outcode0 & outcode1) != 0 || ((outcode0 | outcode1) & outside_invalid) != 0) return false;
  const Line uncut(vertices, attributes, line);
  const std::uint32_t entry = uncut.entry(0), exit = uncut.entry(1);
  const bool leaves_before_it_comes_in = entry != plane_count && exit != plane_count && uncut.cross(entry, exit) >= 0;
  if (leaves_before_it_comes_in) return false;

  const std::int32_t count = vertices.count;
  AssembledLine cut = line;
  bool drawable = true;
  for (const auto& [end, plane] : {std::pair{std::size_t{0}, entry}, std::pair{std::size_t{1}, exit}}) {
    if (plane == plane_count) continue;
    cut.vertex[end] = uncut.add_vertex_at(plane, vertices);
    drawable = drawable && project_vertex(viewport, vertices, cut.vertex[end]);
  }
  if (drawable) {
    line = cut;
  } else {
    vertices.count = count;
  }
  return drawable;
}

}  // namespace gouraud::pipeline
