// Affine interpolation: the method "colors=affine".
//
// Takes vertices in window space, forgets how far away they are. All that setup makes of them is then linear in the
// window, as in Gouraud's scan-line renderer (H. Gouraud, "Continuous shading of curved surfaces", 1971), and nothing
// is divided for a pixel. Right where all w are equal; elsewhere a texture swims and bends along the diagonals of quads:
// at the middle of an edge between w0 and w1 the value is off by (w1 - w0) / (2 (w0 + w1)) of its range.
#pragma once

#include <cstdint>

#include "pipeline/geometry/processed_vertices.h"

namespace gouraud::pipeline {

/// Sets 1/w to 1 for the vertices from `first` on.
inline void forget_distances(std::int32_t first, ProcessedVertices& vertices) {
  for (std::int32_t i = first; i < vertices.count; ++i) vertices.window[static_cast<std::size_t>(i)].w_inverse = 1.0f;
}

}  // namespace gouraud::pipeline
