// Vertex colours without lighting [GL1.5 §2.14.6].
#pragma once

#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// Fills color_front with the batch's colours, clamped to [0, 1]; NaN becomes 0.
void clamp_vertex_colors(const VertexBatch& batch, ProcessedVertices& out);
/// The same for secondary colours: out.specular_front.
void clamp_secondary_colors(const VertexBatch& batch, ProcessedVertices& out);

}  // namespace gouraud::pipeline
