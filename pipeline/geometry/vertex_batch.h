// The vertices of one or more consecutive Begin/End pairs that share a DrawState, as the application gave them:
// structure of arrays, object space. Immediate mode fills it; the geometry stages read it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pipeline/draw/draw_state.h"

namespace gouraud::pipeline {

/// Vertices a batch can hold: a multiple of 12, so that runs of separate lines, triangles and quads fill it exactly.
inline constexpr int batch_capacity = 1020;
/// Length of an attribute array: the capacity, room for a kernel's last full vector, and a stride that is no
/// multiple of 4096 bytes (arrays a page apart would all fall into the same cache sets).
inline constexpr int batch_stride = 1040;

template <int components>
using VertexArray = std::array<std::array<float, batch_stride>, components>;

/// Attributes that a draw can demand of each vertex besides its position (Plan::vertex_demand).
enum VertexAttribute : std::uint32_t {
  attribute_normal = 1u << 0,
  attribute_color = 1u << 1,
  attribute_secondary_color = 1u << 2,
  attribute_fog_coordinate = 1u << 3,
  attribute_edge_flag = 1u << 4,
  attribute_texture_coordinates_0 = 1u << 8,  ///< of unit 0; unit k's is this << k
};
constexpr std::uint32_t attribute_texture_coordinates(int unit) { return attribute_texture_coordinates_0 << unit; }

/// How the application gave a primitive: see QuadDiagonal.
enum class PrimitiveOrigin : std::uint8_t { begin_end, display_list, arrays };

/// A stretch of one primitive: vertices [first, first + count). A Begin/End too long for one batch comes as several
/// ranges in successive batches. `begins`/`ends` tell whether the range holds the primitive's true start and end.
/// A continued range repeats the vertices that assembly still needs:
///   line_strip 1 (the last); triangle_strip, quad_strip 2 (the last two; batches are cut after an even number of
///   vertices so that orientation is kept); triangle_fan, polygon 2 (the very first and the last);
///   line_loop 2 (the very first and the last: no edge joins these two; the closing edge goes from the final vertex
///   to the very first, drawn by the range that `ends`).
/// Separate points, lines, triangles and quads repeat nothing and are cut between whole primitives.
struct PrimitiveRange {
  PrimitiveMode mode = PrimitiveMode::points;
  bool begins = true, ends = true;
  std::int32_t first = 0, count = 0;
  /// The range is [first, first + count) of VertexBatch::elements, which name the vertices: some are shared.
  bool indexed = false;
  PrimitiveOrigin origin = PrimitiveOrigin::begin_end;
  bool moved = false;  ///< a matrix has changed since the range before: a transform run starts here
};

/// From vertex `first` on, this material applies (glMaterial between vertices).
struct MaterialRun {
  std::int32_t first = 0;
  MaterialPair material{};
};

/// From vertex `first` on, these matrices apply (glRotate between primitives).
struct TransformRun {
  std::int32_t first = 0;
  TransformState transform{};
};

struct VertexBatch {
  std::int32_t count = 0;
  alignas(64) VertexArray<4> position_object;  ///< x, y, z, w
  alignas(64) VertexArray<3> normal_object;    ///< valid if attribute_normal is demanded
  alignas(64) VertexArray<4> color;            ///< current colour, unclamped; valid if attribute_color is demanded
  alignas(64) VertexArray<3> secondary_color;  ///< unclamped; valid if demanded, as all that follow
  alignas(64) VertexArray<1> fog_coordinate;
  alignas(64) std::array<VertexArray<4>, max_texture_units> texture_coordinates;  ///< s, t, r, q of each unit
  alignas(64) std::array<std::uint8_t, batch_stride> edge_flag;  ///< 1: the edge that starts here is a boundary edge
  std::vector<PrimitiveRange> primitives;      ///< in drawing order
  std::vector<std::uint16_t> elements;         ///< vertices of indexed ranges
  std::vector<MaterialRun> material_runs;      ///< ascending `first`; the DrawState's material applies before
  /// Ascending `first`, the first one's 0. Empty: the DrawState's matrices apply to all vertices. A primitive has all its
  /// vertices in one run.
  std::vector<TransformRun> transform_runs;

  void clear() {
    count = 0;
    primitives.clear();
    elements.clear();
    material_runs.clear();
    transform_runs.clear();
  }
};

/// Calls visit(transform, first, end) for the stretches [first, end) of vertices that go by the same matrices, in
/// ascending order: what a kernel's last vector writes beyond `end` is overwritten.
template <class Visit>
void for_each_transform(const TransformState& of_all, const VertexBatch& batch, const Visit& visit) {
  const auto count = static_cast<std::size_t>(batch.count);
  if (batch.transform_runs.empty()) return visit(of_all, std::size_t{0}, count);
  for (std::size_t i = 0; i < batch.transform_runs.size(); ++i) {
    const TransformRun& run = batch.transform_runs[i];
    const bool last = i + 1 == batch.transform_runs.size();
    visit(run.transform, static_cast<std::size_t>(run.first),
          last ? count : static_cast<std::size_t>(batch.transform_runs[i + 1].first));
  }
}

/// Calls visit(attribute, arrays), arrays a VertexArray, for each float attribute in `demand`.
template <class Visit>
void for_each_attribute(VertexBatch& batch, std::uint32_t demand, const Visit& visit) {
  if (demand & attribute_normal) visit(attribute_normal, batch.normal_object);
  if (demand & attribute_color) visit(attribute_color, batch.color);
  if (demand < attribute_secondary_color) return;
  if (demand & attribute_secondary_color) visit(attribute_secondary_color, batch.secondary_color);
  if (demand & attribute_fog_coordinate) visit(attribute_fog_coordinate, batch.fog_coordinate);
  for (int unit = 0; demand >= attribute_texture_coordinates(unit); ++unit) {
    const std::uint32_t attribute = attribute_texture_coordinates(unit);
    if (demand & attribute) visit(attribute, batch.texture_coordinates[static_cast<std::size_t>(unit)]);
  }
}

/// Calls visit(vertex) for the vertices of all ranges in the order in which the application named them.
template <class Visit>
void for_each_named_vertex(const VertexBatch& batch, Visit visit) {
  for (const PrimitiveRange& range : batch.primitives) {
    for (std::int32_t i = range.first; i < range.first + range.count; ++i) {
      visit(range.indexed ? static_cast<std::int32_t>(batch.elements[static_cast<std::size_t>(i)]) : i);
    }
  }
}

}  // namespace gouraud::pipeline
