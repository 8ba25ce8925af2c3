// Normals to eye space, and their length [GL1.5 §2.11.3].
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// `state` has the matrix of a batch that has no transform runs. Fills normal_eye: the batch's normals times the normal matrix, then as they are, times the rescale factor, or of
/// unit length. Computed in double, rounded to float once. Under `normalize` a normal that has no direction (zero, NaN
/// or infinite) becomes zero: diffuse and specular light vanish there. Otherwise a component that is not finite does.
void transform_normals(const TransformState& state, const VertexBatch& batch, ProcessedVertices& out);

}  // namespace gouraud::pipeline
