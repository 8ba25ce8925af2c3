// Triangles set up from homogeneous coordinates, without clipping: the methods "coverage=homogeneous" and
// "clipping=homogeneous".
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {

/// Sets up a triangle whose vertices may lie anywhere, behind the eye as well; none is `outside_invalid`. `record` has
/// record_size bytes, 64-byte aligned; it refers to `shape`. False if it is culled, has no area, or draws nothing.
bool setup_homogeneous(const SetupState& state, const ViewportState& viewport, const ProcessedVertices& vertices,
                       const AssembledTriangle& triangle, void* record, MethodTriangle& shape);

/// The corners of a triangle as rays see them.
void set_ray_corners(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledTriangle& triangle, MethodTriangle& shape);

}  // namespace gouraud::pipeline
