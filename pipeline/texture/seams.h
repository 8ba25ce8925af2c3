// Linear filtering across the edges of a cube map [ARB_seamless_cube_map].
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// Replaces `lanes` of `out`, whose filters reach over an edge of the face: texels beyond it come from the neighbouring face;
/// at a corner the missing fourth texel is the mean of the other three. Lane by lane: few are near an edge. `s`, `t`: the
/// coordinates on the face.
void filter_across_seams(const PreparedUnit& unit, std::int32_t face, std::int32_t level, const float* s, const float* t,
                         std::uint64_t lanes, TexelBlock& out);

}  // namespace gouraud::pipeline
