// Triangles and lines cut at the clip volume [GL1.5 §2.12].
#pragma once

#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/outlines.h"
#include "pipeline/geometry/processed_vertices.h"

namespace gouraud::pipeline {

/// What the clipper interpolates beside the clip position.
struct ClipAttributes {
  bool eye = false, color_front = false, color_back = false, specular = false;
  int varyings = 0;  ///< how many of ProcessedVertices::varying
  const ClipPlaneState* planes = nullptr;  ///< the user's, behind the frustum's; they need `eye`
};

/// Most vertices that one primitive can add: two a plane, of the frustum's six and the user's.
inline constexpr int max_clip_vertices = 2 * (6 + max_clip_planes);

/// Cuts a triangle some of whose vertices have outcodes and appends what is left, as a fan, to `out`. New vertices go
/// to the end of `vertices`: the caller guarantees vertices.count + max_clip_vertices <= processed_stride.
///
/// Mesa's order of planes and direction of interpolation, in float (MESA-RULES 2.4), so that coverage has Mesa's bits.
/// A triangle with an invalid vertex, or with an infinite distance from a plane, is dropped. The provoking vertex stays
/// the triangle's, even if it was cut off: its colours are still there.
/// deviation: edges that run along the clip volume are boundary edges [GL1.5 §2.12]; Mesa does not draw them.
void clip_triangle(const AssembledTriangle& triangle, const ViewportState& viewport, const ClipAttributes& attributes,
                   ProcessedVertices& vertices, std::vector<AssembledTriangle>& out);

/// Cuts a whole polygon in the same way, with all the room that `vertices` have; false if nothing is left, or if a
/// polygon that is not convex makes more vertices than there is room for.
bool clip_outline(Outline& outline, const ViewportState& viewport, const ClipAttributes& attributes,
                  ProcessedVertices& vertices);

/// Cuts a line some of whose vertices have outcodes; new vertices as for triangles. False if nothing is left.
/// deviation: intersections come from exact sums, rounded once, so that a line that passes through the clip volume is
/// drawn where it should, however far away its ends are; Mesa's floats lose it (MESA-RULES 2.4).
bool clip_line(AssembledLine& line, const ViewportState& viewport, const ClipAttributes& attributes,
               ProcessedVertices& vertices);

}  // namespace gouraud::pipeline
