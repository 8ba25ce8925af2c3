// Lighting in other ways: the methods "highlight=reflection" and "power=libm".
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/methods.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// Takes and gives what light_vertices does (lighting.h), vertex by vertex in double.
void light_vertices(const LightingState& state, HighlightMethod highlight, const VertexBatch& batch, ProcessedVertices& out);

}  // namespace gouraud::pipeline
