// Takes a tile and edge functions or a disc, gives blocks with the coverage of each sample: edges are exact at every sample.
// Blocks that an edge has wholly on one side, whichever sample, skip its test.
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
  const std::int64_t to_tile = std::int64_t{edge.a} * tile_x + std::int64_t{edge.b} * tile_y;
  std::array<std::int64_t, max_samples> value;
  for (std::size_t k = 0; k < max_samples; ++k) {
    const auto from_center = [&](std::size_t axis) HWY_ATTR { return static_cast<std::int64_t>((sample_positions[k][axis] - 0.5f) * subpixels); };
    value[k] = to_tile + (apart ? (edge.c + edge.a * from_center(0) + edge.b * from_center(1)) >> subpixel_bits : edge.c);
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

/// The edges that cross a tile.
struct CrossingEdges {
  std::array<SampleEdge, 4> edge;
  std::size_t count = 0;
  bool outside = false;  ///< one has the tile on its outer side

  template <class Edges>
  HWY_INLINE void enter(const Edges& edges, bool apart, std::int32_t tile_x, std::int32_t tile_y) {
    for (std::size_t i = 0; i < edges.size() && !outside; ++i) {
      const TileSide side = enter_tile(edges[i], apart, tile_x, tile_y, edge[count]);
      outside = side == TileSide::outside;
      count += side == TileSide::crossed ? 1 : 0;
    }
  }
};

/// The pixels of a block, from (x, y) on, whose sample `k` lies in the disc.
HWY_INLINE std::uint64_t inside_disc(const SmoothShape& disc, std::int32_t x, std::int32_t y, std::size_t k) {
  const hn::CappedTag<double, block_size> d;
  const auto columns = hn::Set(d, x + double{sample_positions[k][0]} - disc.corner[0].x);
  const auto squared = hn::Set(d, disc.radius * disc.radius);
  std::uint64_t mask = 0;
  for (std::size_t row = 0; row < block_size; ++row) {
    const auto dy = hn::Set(d, y + static_cast<double>(row) + double{sample_positions[k][1]} - disc.corner[0].y);
    for (std::size_t column = 0; column < block_size; column += hn::Lanes(d)) {
      const auto dx = hn::Add(columns, hn::Iota(d, static_cast<double>(column)));
      std::uint64_t bits = 0;
      hn::StoreMaskBits(d, hn::Lt(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), squared), reinterpret_cast<std::uint8_t*>(&bits));
      mask |= bits << (row * block_size + column);
    }
  }
  return mask;
}

std::size_t find_blocks(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, SampleBlock* out) {
  const RasterBinding& binding = *primitive.binding;
  const SmoothShape* const disc = primitive.is_rectangle ? nullptr : primitive.shape;
  CrossingEdges edges;
  if (primitive.is_rectangle) {
    edges.enter(primitive.rectangle.all(), binding.samples_apart, tile_x, tile_y);
  } else {
    edges.enter(primitive.edges, binding.samples_apart, tile_x, tile_y);
  }
  if (edges.outside) return 0;
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
      for (std::size_t e = 0; e < edges.count && !outside; ++e) {
        const SampleEdge& edge = edges.edge[e];
        const std::int32_t step = edge.a * (column * block_size) + edge.b * (row * block_size);
        outside = edge.most + step < 0;
        if (outside || edge.least + step >= 0) continue;
        for (std::size_t k = 0; k < max_samples; ++k) block.coverage[k] &= inside(edge.value[k] + step, edge.a, edge.b);
      }
      if (outside) continue;
      block.x = tile_x + column * block_size;
      block.y = tile_y + row * block_size;
      block.first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
      for (std::size_t k = 0; disc != nullptr && k < max_samples; ++k) block.coverage[k] &= inside_disc(*disc, block.x, block.y, k);
      std::uint64_t some = 0;
      const std::uint64_t box = primitive.scissored ? box_mask(primitive, block.x, block.y) : ~std::uint64_t{0};
      for (std::uint64_t& coverage : block.coverage) some |= coverage &= box;
      count += some != 0 ? 1 : 0;
    }
  }
  return count;
}

/// As send_cut in polygons.cpp, a sample a lane.
std::size_t cut_masks(const std::array<std::uint64_t, max_samples>& masks, std::int32_t x, std::int32_t y, std::int32_t tile_x,
                      std::int32_t tile_y, SampleBlock* out) {
  const hn::CappedTag<std::uint64_t, max_samples> d;
  const std::int32_t column = (x - tile_x) >> 3, row = (y - tile_y) >> 3, right = x & 7, up = y & 7;  // rounded down
  static_assert(block_size == 8 && tile_size % 8 == 0);
  const auto stay = hn::Set(d, (0xFFu >> right) * std::uint64_t{0x0101010101010101u});
  const auto put = [&](std::size_t block, hn::Vec<decltype(d)> coverage, std::size_t k) HWY_ATTR { hn::StoreU(coverage, d, out[block].coverage.data() + k); };
  for (std::size_t k = 0; k < max_samples; k += hn::Lanes(d)) {
    const auto mask = hn::LoadU(d, masks.data() + k);
    const auto left_half = hn::ShiftLeftSame(hn::And(mask, stay), right), right_half = hn::ShiftRightSame(hn::AndNot(stay, mask), 8 - right);
    put(0, hn::ShiftLeftSame(left_half, 8 * up), k);
    put(1, hn::ShiftLeftSame(right_half, 8 * up), k);
    put(2, hn::ShiftRight<8>(hn::ShiftRightSame(left_half, 56 - 8 * up)), k);
    put(3, hn::ShiftRight<8>(hn::ShiftRightSame(right_half, 56 - 8 * up)), k);
  }
  std::size_t count = 0;
  for (std::int32_t i = 0; i < 4; ++i) {
    const std::int32_t block_column = column + i % 2, block_row = row + i / 2;
    const auto in_tile = [](std::int32_t place) { return static_cast<std::uint32_t>(place) < static_cast<std::uint32_t>(blocks_per_tile_row); };
    std::uint64_t some = 0;
    for (const std::uint64_t coverage : out[i].coverage) some |= coverage;
    if (some == 0 || !in_tile(block_column) || !in_tile(block_row)) continue;
    SampleBlock& block = out[count++];
    block.coverage = out[i].coverage;
    block.x = tile_x + block_column * block_size;
    block.y = tile_y + block_row * block_size;
    block.first_pixel = (block_row * blocks_per_tile_row + block_column) * pixels_per_block;
  }
  return count;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
static_assert(subpixels == 256 && sample_reach < subpixels / 2);

SampleBlockFinder sample_block_finder() { return GOURAUD_SIMD_PICK(find_blocks); }
SampleMaskCutter sample_mask_cutter() { return GOURAUD_SIMD_PICK(cut_masks); }

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
  if (primitive.shape != nullptr) fragments.pixel_coverage.fill(primitive.shape->fade);
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
