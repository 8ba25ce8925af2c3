// Takes primitives that lie partly outside the clip volume, gives the parts inside [GL1.5 §2.12].
//
// Triangles: Sutherland-Hodgman against those frustum planes that a vertex violates, in homogeneous clip space, so that
// w <= 0 needs no special care. Colours and other attributes are interpolated along with the positions [GL1.5 §2.14.8].
// Lines: see line_clipping.cpp. Points need no clipper: they are drawn if their outcode is 0.
#include "pipeline/geometry/clipping.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "pipeline/geometry/viewport.h"

namespace gouraud::pipeline {
namespace {

/// The planes in clipping order, as bits of the outcode; distances are positive inside.
constexpr std::uint32_t plane_count = 6;

float distance(const ProcessedVertices& vertices, std::uint16_t index, std::uint32_t plane) {
  const float coordinate = vertices.position_clip[plane / 2][index], w = vertices.position_clip[3][index];
  const bool upper = (1u << plane & (outside_right | outside_top | outside_far)) != 0;
  return upper ? -coordinate + w : coordinate + w;
}

/// A convex polygon: vertex numbers, and whether the edge from each vertex to the next is a boundary edge. Every plane
/// adds at most one corner; rounding, which may make the polygon not quite convex, is kept from adding more.
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

Rgba mix(const Rgba& from, const Rgba& to, float t) {
  return {from.r + t * (to.r - from.r), from.g + t * (to.g - from.g), from.b + t * (to.b - from.b), from.a + t * (to.a - from.a)};
}

template <int components>
void mix(ProcessedArray<components>& array, std::size_t from, std::size_t to, float t, std::size_t out) {
  for (auto& component : array) component[out] = component[from] + t * (component[to] - component[from]);
}

/// Appends the vertex from + t (to - from).
std::uint16_t add_vertex(ProcessedVertices& vertices, const ClipAttributes& attributes, std::uint16_t from, std::uint16_t to, float t) {
  const auto index = static_cast<std::uint16_t>(vertices.count++);
  mix<4>(vertices.position_clip, from, to, t, index);
  if (attributes.eye) mix<4>(vertices.position_eye, from, to, t, index);
  const auto mix_colors = [&](auto& colors) { colors[index] = mix(colors[from], colors[to], t); };
  if (attributes.color_front) mix_colors(vertices.color_front);
  if (attributes.color_back) mix_colors(vertices.color_back);
  if (attributes.specular) mix_colors(vertices.specular_front);
  if (attributes.specular && attributes.color_back) mix_colors(vertices.specular_back);
  return index;
}

}  // namespace
}  // namespace gouraud::pipeline
