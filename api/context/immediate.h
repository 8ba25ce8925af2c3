// Immediate mode's pending vertices [GL1.5 §2.6]. Vertices of consecutive Begin/End pairs gather in one batch as long
// as their DrawState stays the same.
#pragma once

#include <cstdint>

#include "api/state/current.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::api {

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
};

/// The components of what a vertex attribute takes from the current values.
const float* current_value(const CurrentGroup& current, std::uint32_t attribute);

/// Gives the batch's next vertex the attributes in `demand` beyond normal and colour.
void keep_more_attributes(pipeline::VertexBatch& batch, std::uint32_t demand, const CurrentGroup& current);

}  // namespace gouraud::api
