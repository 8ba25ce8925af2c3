// Points, lines and polygons into all samples of their pixels at once [GL1.5 §3.2.1, §3.3.3, §3.4.4, §3.5.6].
//
// Coverage and depth are those of each sample's own place; a fragment has one colour and one set of texture coordinates
// for all of its samples, those of the pixel's centre, kept in the range of the vertices where the centre lies outside.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/draw/limits.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// A block of pixels, and what a primitive covers of each sample.
struct SampleBlock {
  std::array<std::uint64_t, max_samples> coverage;
  std::int32_t x, y, first_pixel;  ///< as in FragmentBlock
  std::int32_t primitive;          ///< for whoever lists blocks of several
};
inline constexpr std::size_t most_sample_blocks = std::size_t{blocks_per_tile_row} * blocks_per_tile_row;

/// Lists the blocks that the primitive touches in the tile whose first pixel is (tile_x, tile_y), and returns their number:
/// at most most_sample_blocks. Its binding has a sample_mask.
using SampleBlockFinder = std::size_t (*)(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, SampleBlock* out);
/// Lists the blocks of a small triangle, of which the selection has the masks (triangles.h): from pixel (x, y) on. At most 4.
using SampleMaskCutter = std::size_t (*)(const std::array<std::uint64_t, max_samples>& masks, std::int32_t x, std::int32_t y,
                                         std::int32_t tile_x, std::int32_t tile_y, SampleBlock* out);
/// For the instruction set in use.
SampleBlockFinder sample_block_finder();
SampleMaskCutter sample_mask_cutter();

/// The tile's pixels of each sample, with the places where the binding takes depths.
using SampleTargets = std::array<TileTarget, max_samples>;
SampleTargets place_samples(const SampleTargets& pixels, const RasterBinding& binding);

/// The early passes, for each sample. False if nothing is left of the block.
bool run_early_passes(const PrimitiveRecord& primitive, SampleBlock& block, const SampleTargets& targets);
/// Shades the fragments that are left, once, and runs the passes after that for each sample.
void run_late_passes(const PrimitiveRecord& primitive, const SampleBlock& block, const SampleTargets& targets);

}  // namespace gouraud::pipeline
