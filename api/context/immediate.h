// Immediate mode's pending vertices [GL1.5 §2.6]. Vertices of consecutive Begin/End pairs gather in one batch as long
// as their DrawState stays the same.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "api/state/current.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::api {

/// Where elements stand in the batch: an open hash table that SharedVertices (commands/shared_vertices.h) uses.
struct ElementSlots {
  /// Valid if `batch_number` is the table's.
  struct Slot {
    std::uint32_t element = 0;
    std::uint16_t batch_number = 0;
    std::uint16_t vertex = 0;
  };
  static constexpr int bits = 11;  ///< twice as many slots as a batch has vertices: they fit the nearest cache
  std::uint16_t batch_number = 0;
  std::array<Slot, std::size_t{1} << bits> slot{};

  /// All slots are free again.
  void clear();
};

struct Immediate {
  /// A vertex may be appended while batch.count < limit. 0 outside Begin/End and while nothing that is drawn can change
  /// the target, so that the hot path needs one comparison.
  std::int32_t limit = 0;
  /// pipeline::VertexAttribute bits to keep besides the position.
  std::uint32_t demand = 0;
  bool inside_begin_end = false;
  /// Of the open primitive.
  pipeline::PrimitiveMode mode = pipeline::PrimitiveMode::points;
  /// The material (canonical) for the next vertex; what the batch's first vertex had is in the draw state.
  pipeline::MaterialPair material{};
  pipeline::VertexBatch batch;
  std::uint32_t batch_modes = 0;  ///< bit k: the batch has a primitive of mode k
  ElementSlots element_slots;
};

/// The number of vertices by whole multiples of which a primitive of this mode may be cut into ranges.
std::int32_t cut_multiple(pipeline::PrimitiveMode mode);

/// Whether primitives of these modes (bit k: mode k) look different under one state and the other. Widths of lines, say,
/// do not concern triangles.
bool differ_for(std::uint32_t modes, std::uint32_t parts, const pipeline::DrawState& a, const pipeline::DrawState& b);

/// From the next vertex on `now` applies; the batch has vertices, and none of a primitive that is not complete. `before`
/// has applied so far if the batch has no transform runs yet.
void append_transform(pipeline::VertexBatch& batch, const pipeline::TransformState& before, const pipeline::TransformState& now);

/// The components of what a vertex attribute takes from the current values.
const float* current_value(const CurrentGroup& current, std::uint32_t attribute);

/// Gives the batch's next vertex the attributes in `demand` beyond normal and colour.
void keep_more_attributes(pipeline::VertexBatch& batch, std::uint32_t demand, const CurrentGroup& current);

}  // namespace gouraud::api
