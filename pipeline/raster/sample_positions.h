// Where the samples of a multisampled pixel lie [GL1.5 §3.2.1].
#pragma once

#include <array>

#include "pipeline/draw/limits.h"

namespace gouraud::pipeline {

/// In pixels from the pixel's lower left corner: each in a row and a column of its own, where Mesa has them in framebuffer
/// objects.
inline constexpr std::array<std::array<float, 2>, max_samples> sample_positions{
    {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}}};
/// The farthest that one lies from the pixel's centre, to either side, in 1/256 pixel.
inline constexpr int sample_reach = 96;

}  // namespace gouraud::pipeline
