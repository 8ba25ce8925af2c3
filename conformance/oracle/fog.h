// Fog [GL1.5 §3.10]: coordinates of vertices, and what becomes of a fragment's colour. All in double.
#pragma once

#include "conformance/oracle/vertex.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::oracle {

/// The vertex's own, or its distance |z_eye| (MESA-RULES 6).
double fog_coordinate(const pipeline::DrawState& state, const pipeline::VertexBatch& batch, int index);

/// In [0, 1]: how much of its own colour a fragment keeps. The fog is on.
double fog_factor(const pipeline::FogState& fog, double coordinate);

/// The colour behind the fog, clamped before; without fog as it is.
Color fogged(const pipeline::FogState& fog, const Color& color, double coordinate);

}  // namespace gouraud::oracle
