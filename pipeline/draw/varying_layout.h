// Which varyings a draw interpolates: what the plan demands, less what the vertices of this batch make needless.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/plan.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

/// How many of s, t, r a unit's texture is looked up by; r also is what a depth texture is compared with.
int coordinate_dimensions(const TextureUnitState& unit);

VaryingLayout make_varying_layout(const DrawState& state, const Plan& plan, const VertexBatch& batch);

}  // namespace gouraud::pipeline
