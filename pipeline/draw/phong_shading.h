// Lighting per fragment: the method "shading=phong".
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

/// What the vertices bring, as varyings from VaryingLayout::lighting on: the normal, the position in eye space, and the
/// colour if a material parameter follows it.
int lighting_varyings(const LightingState& lighting);

/// Fills them for the batch. Normals and eye positions must be there.
void make_lighting_varyings(const LightingState& lighting, const VaryingLayout& layout, const VertexBatch& batch,
                            ProcessedVertices& vertices);

/// Fills FragmentBlock::color, and the secondary colour's varyings if the layout has them.
FragmentPass phong_shading_pass();

}  // namespace gouraud::pipeline
