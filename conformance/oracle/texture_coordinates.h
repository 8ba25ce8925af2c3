// Takes vertices, gives their texture coordinates [GL1.5 §2.11.4]: given or generated, times the texture matrix. In double,
// in eye space, from the modelview matrix as given.
#pragma once

#include <vector>

#include "conformance/oracle/vertex.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::oracle {

/// s, t, r, q of vertex `index` for each textured unit, in the order of state.texturing. What is not finite is 0.
std::vector<Vector4> texture_coordinates(const pipeline::DrawState& state, const pipeline::VertexBatch& batch, int index);

}  // namespace gouraud::oracle
