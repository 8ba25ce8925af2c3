// What a smooth shape covers of 64 pixels [GL1.5 §3.3.1, §3.4.2, §3.5.3].
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// Of the pixels of a block, row by row, each in [0, 1] but for rounding.
struct alignas(64) Areas : std::array<double, 64> {};

/// The area that the shape shares with each pixel of the block from (x, y) on: exact for corners (to within rounding), to
/// within 0.001 for discs.
void areas_of(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area);

/// Pixels that share less than this with a shape have no fragment: a shape and its neighbour's rounding.
inline constexpr double least_coverage = 1.0 / (1 << 20);

/// The same, at most 1; returns which are at least least_coverage.
std::uint64_t shares_of(const SmoothShape& shape, std::int32_t x, std::int32_t y, std::array<float, 64>& coverage);

/// The stretch [x0, x1] in which the shape lies between y and y + 8; empty if x0 > x1.
struct Stretch {
  double x0, x1;
};
Stretch stretch_of(const SmoothShape& shape, std::int32_t y);

/// How a block lies to a shape with corners. `outside` and `inside` are certain.
enum class BlockPlace : std::uint8_t { outside, crossed, inside };
BlockPlace place_of_block(const SmoothShape& shape, std::int32_t x, std::int32_t y);

}  // namespace gouraud::pipeline
