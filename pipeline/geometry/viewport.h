// Clip space to window space, and which vertices lie outside the clip volume [GL1.5 §2.11, §2.11.1, §2.12].
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"

namespace gouraud::pipeline {

/// window = (clip * (1 / w)) * scale + translation, for x, y (from the top of the target) and z.
struct ViewportTransform {
  std::array<float, 3> scale, translation;
};
ViewportTransform make_viewport_transform(const ViewportState& state);

/// Fills the outcodes of all `count` vertices, and window positions where the outcode is 0. Mesa's bits
/// (MESA-RULES 2.3, 2.4): in float, (clip * (1 / w)) * scale + translation, each step rounded.
///
/// A vertex is `outside_invalid` if a coordinate is NaN or infinite, or if it lies inside all planes but has no finite
/// window position (w = 0).
void project_to_window(const ViewportState& state, ProcessedVertices& vertices);

/// The same window position for one vertex, that the clipper made: sets its outcode to 0. False, and the vertex
/// invalid, if the position is not finite.
bool project_vertex(const ViewportState& state, ProcessedVertices& vertices, std::int32_t index);

/// The window position of a vertex inside the clip volume as the application sees it: y up, z in [0, 1]; computed from
/// its clip position in double, rounded once [GL1.5 §2.11.1].
glm::vec3 window_position(const ViewportState& state, const ProcessedVertices& vertices, std::int32_t index);

}  // namespace gouraud::pipeline
