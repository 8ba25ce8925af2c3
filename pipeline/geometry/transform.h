// Object-space positions to clip space and to eye space [GL1.5 §2.11].
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// `state` has the matrices of a batch that has no transform runs.
///
/// Fills position_clip by the combined matrix and sets `out.count` to the batch's. In float, each coordinate is
/// ((x*m0 + y*m1) + z*m2) + w*m3 without fused operations: Mesa's bits (MESA-RULES 2.2).
void transform_to_clip(const TransformState& state, const VertexBatch& batch, ProcessedVertices& out);

/// Fills position_eye by the modelview matrix, with the same arithmetic. Not divided by w.
void transform_to_eye(const TransformState& state, const VertexBatch& batch, ProcessedVertices& out);

}  // namespace gouraud::pipeline
