// Takes a tile and edge functions, gives blocks with the coverage of each sample: edges are exact at every sample. Blocks
// that an edge has wholly on one side, whichever sample, skip its test.
#include "pipeline/raster/sample_blocks.h"

#include <algorithm>

#include "pipeline/raster/polygons.h"
#include "pipeline/raster/sample_positions.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/sample_blocks.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/edge_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// An edge that crosses the tile for some sample, relative to the tile's first pixel.
struct SampleEdge {
  std::array<std::int32_t, max_samples> value;
  std::int32_t a, b;
  std::int32_t least, most;  ///< over the samples and the pixels of a block, at the tile's first block
};

/// What an edge grows by over `n` pixels to the right and upwards, at most downwards and upwards.
HWY_INLINE std::int32_t least_growth(const EdgeFunction& e, std::int32_t n) { return (e.a < 0 ? e.a * n : 0) + (e.b < 0 ? e.b * n : 0); }
HWY_INLINE std::int32_t most_growth(const EdgeFunction& e, std::int32_t n) { return (e.a > 0 ? e.a * n : 0) + (e.b > 0 ? e.b * n : 0); }

enum class TileSide : std::uint8_t { outside, inside, crossed };

/// An edge of 22 bits crosses the tile: its values are below 2^30 (see EdgeFunction; a sample is less than a pixel away).
HWY_INLINE TileSide enter_tile(const EdgeFunction& edge, bool apart, std::int32_t tile_x, std::int32_t tile_y, SampleEdge& out) {
  const std::int64_t c = edge.c + subpixels * (std::int64_t{edge.a} * tile_x + std::int64_t{edge.b} * tile_y);
  std::array<std::int64_t, max_samples> value;
  for (std::size_t k = 0; k < max_samples; ++k) {
    const auto from_center = [&](std::size_t axis) HWY_ATTR {
      return apart ? static_cast<std::int64_t>((sample_positions[k][axis] - 0.5f) * subpixels) : 0;
    };
    value[k] = (c + edge.a * from_center(0) + edge.b * from_center(1)) >> subpixel_bits;
  }
  const auto [low, high] = std::minmax_element(value.begin(), value.end());
  if (*high + most_growth(edge, tile_size - 1) < 0) return TileSide::outside;
  if (*low + least_growth(edge, tile_size - 1) >= 0) return TileSide::inside;
  for (std::size_t k = 0; k < max_samples; ++k) out.value[k] = static_cast<std::int32_t>(value[k]);
  out.a = edge.a;
  out.b = edge.b;
  out.least = static_cast<std::int32_t>(*low) + least_growth(edge, block_size - 1);
  out.most = static_cast<std::int32_t>(*high) + most_growth(edge, block_size - 1);
  return TileSide::crossed;
}

std::size_t find_blocks(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, SampleBlock* out) {
  const RasterBinding& binding = *primitive.binding;
  std::array<SampleEdge, 3> edges;
  std::size_t edge_count = 0;
  for (const EdgeFunction& edge : primitive.edges) {
    const TileSide side = enter_tile(edge, binding.samples_apart, tile_x, tile_y, edges[edge_count]);
    if (side == TileSide::outside) return 0;
    if (side == TileSide::crossed) ++edge_count;
  }
  std::array<std::uint64_t, max_samples> wanted;
  for (std::size_t k = 0; k < max_samples; ++k) wanted[k] = (binding.sample_mask >> k & 1) != 0 ? ~std::uint64_t{0} : 0;

  const std::int32_t x0 = std::max(primitive.x0 - tile_x, 0) / block_size, y0 = std::max(primitive.y0 - tile_y, 0) / block_size;
  const std::int32_t x1 = std::min(primitive.x1 - tile_x, tile_size), y1 = std::min(primitive.y1 - tile_y, tile_size);
  std::size_t count = 0;
  for (std::int32_t row = y0; row * block_size < y1; ++row) {
    for (std::int32_t column = x0; column * block_size < x1; ++column) {
      SampleBlock& block = out[count];
      block.coverage = wanted;
      bool outside = false;
      for (std::size_t e = 0; e < edge_count && !outside; ++e) {
        const SampleEdge& edge = edges[e];
        const std::int32_t step = edge.a * (column * block_size) + edge.b * (row * block_size);
        outside = edge.most + step < 0;
        if (outside || edge.least + step >= 0) continue;
        for (std::size_t k = 0; k < max_samples; ++k) block.coverage[k] &= inside(edge.value[k] + step, edge.a, edge.b);
      }
      if (outside) continue;
      block.x = tile_x + column * block_size;
      block.y = tile_y + row * block_size;
      block.first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
      std::uint64_t some = 0;
      const std::uint64_t box = primitive.scissored ? box_mask(primitive, block.x, block.y) : ~std::uint64_t{0};
      for (std::uint64_t& coverage : block.coverage) some |= coverage &= box;
      count += some != 0 ? 1 : 0;
    }
  }
  return count;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
static_assert(subpixels == 256 && sample_reach < subpixels / 2);

SampleBlockFinder sample_block_finder() { return GOURAUD_SIMD_PICK(find_blocks); }

SampleTargets place_samples(const SampleTargets& pixels, const RasterBinding& binding) {
  SampleTargets targets = pixels;
  for (std::size_t k = 0; binding.samples_apart && k < max_samples; ++k) {
    targets[k].sample_x = sample_positions[k][0] - 0.5f;
    targets[k].sample_y = sample_positions[k][1] - 0.5f;
  }
  return targets;
}

namespace {

/// The head of a FragmentBlock for the block's fragments.
void begin(const PrimitiveRecord& primitive, const SampleBlock& block, FragmentBlock& out) {
  out.primitive = &primitive;
  out.x = block.x;
  out.y = block.y;
  out.first_pixel = block.first_pixel;
}

}  // namespace

bool run_early_passes(const PrimitiveRecord& primitive, SampleBlock& block, const SampleTargets& targets) {
  const FragmentPasses& passes = primitive.binding->passes;
  FragmentBlock fragments;
  begin(primitive, block, fragments);
  std::uint64_t left = 0;
  for (std::size_t k = 0; k < max_samples; ++k) {
    fragments.coverage = block.coverage[k];
    if (fragments.coverage != 0) run_passes(passes, 0, passes.early, fragments, targets[k]);
    left |= block.coverage[k] = fragments.coverage;
  }
  return left != 0;
}

void run_late_passes(const PrimitiveRecord& primitive, const SampleBlock& block, const SampleTargets& targets) {
  const FragmentPasses& passes = primitive.binding->passes;
  if (passes.early == passes.count) return;
  FragmentBlock fragments;
  begin(primitive, block, fragments);
  fragments.coverage = 0;
  for (const std::uint64_t coverage : block.coverage) fragments.coverage |= coverage;
  run_passes(passes, passes.early, passes.shaded, fragments, targets[0]);
  const std::uint64_t shaded = fragments.coverage;

  // What passes do to a sample's colours is not for the next one. Alpha is all that they change (sample_alpha.h).
  std::array<float, 64> alpha;
  const bool changes_alpha = primitive.binding->state.alpha_to_one;
  if (changes_alpha) alpha = fragments.color[3];
  for (std::size_t k = 0; k < max_samples; ++k) {
    fragments.coverage = block.coverage[k] & shaded;
    if (fragments.coverage == 0) continue;
    if (changes_alpha) fragments.color[3] = alpha;
    run_passes(passes, passes.shaded, passes.count, fragments, targets[k]);
  }
}

}  // namespace gouraud::pipeline
#endif
