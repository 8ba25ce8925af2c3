// Lighting of vertices [GL1.5 §2.14.1].
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// Lights the batch's vertices: fills color_front; color_back if two-sided; specular_front (and specular_back), alpha
/// 0, if the specular colour is separate. Clamped to [0, 1] [GL1.5 §2.14.6]; NaN becomes 0.
///
/// Reads normal_eye if there are lights; position_eye if a light is positional or the viewer local; the batch's colours
/// if a material parameter follows them. The sum before clamping is within 1e-6, relative to the sum of its terms'
/// magnitudes, of the exact value for those inputs.
void light_vertices(const LightingState& state, const VertexBatch& batch, ProcessedVertices& out);

}  // namespace gouraud::pipeline
