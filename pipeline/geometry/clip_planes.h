// Which vertices lie outside the user's clip planes [GL1.5 §2.12].
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"

namespace gouraud::pipeline {

/// Adds the planes' bits to the outcodes of all `count` vertices, which must have eye positions. A vertex on a plane is
/// inside, one whose distance is not a number outside.
void test_clip_planes(const ClipPlaneState& state, ProcessedVertices& vertices);

/// The vertex's distance from a plane, scaled as the plane; the number that test_clip_planes takes the sign of.
double distance_from(const glm::vec4& plane_eye, const ProcessedVertices& vertices, std::uint16_t index);

}  // namespace gouraud::pipeline
