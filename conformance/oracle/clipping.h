// Takes clip-space vertices, gives what of a primitive lies in the view volume [GL1.5 §2.12, §2.14.8].
// Triangles are cut in T, in the order and from the end that MESA-RULES 2.4 prescribes; their colours by the same
// intersection computed in double. Lines are cut exactly, and the cut end is rounded to T: Mesa's float form would lose
// lines whose ends are far away. The user's planes come last, in eye space. A primitive with a coordinate that is not finite is
// dropped, and a triangle with such a distance to a plane that it crosses.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "conformance/oracle/vertex.h"
#include "pipeline/draw/draw_state.h"

namespace gouraud::oracle {

/// A convex polygon; edge i runs from vertex i to the next. `boundary[i]`: it is drawn in polygon mode line.
template <typename T>
struct ClippedPolygon {
  std::vector<ClipVertex<T>> vertices;
  std::vector<bool> boundary;
  bool is_cut = false;  ///< false: the triangle as it was
};

/// The near plane is z = -w, or z = 0 if `zero_to_one` [ARB_clip_control].
///
/// The part of a triangle inside the view volume; no vertices if there is none. Bit i of `boundary_edges` stands for
/// edge i. Edges along the view volume's faces are boundary edges [GL1.5 §2.12].
template <typename T>
ClippedPolygon<T> clip_triangle(const std::array<ClipVertex<T>, 3>& triangle, unsigned boundary_edges,
                                const pipeline::ClipPlaneState& user = {}, bool zero_to_one = false);

template <typename T>
std::optional<std::array<ClipVertex<T>, 2>> clip_line(const std::array<ClipVertex<T>, 2>& line,
                                                       const pipeline::ClipPlaneState& user = {}, bool zero_to_one = false);

/// A point is kept iff its position is in the volume.
template <typename T>
bool in_view_volume(const ClipVertex<T>& point, const pipeline::ClipPlaneState& user = {}, bool zero_to_one = false);

}  // namespace gouraud::oracle
