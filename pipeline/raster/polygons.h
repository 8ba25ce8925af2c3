// Polygon coverage: a tile and a primitive's edge functions to FragmentBlocks [GL1.5 §3.5.1].
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// Finds the primitive's pixels in the tile whose first pixel is (tile_x, tile_y) and sends their blocks through the
/// primitive's passes.
using PolygonRasterizer = void (*)(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y,
                                   const TileTarget& target);

/// The rasterizer for the instruction set in use.
PolygonRasterizer polygon_rasterizer();

/// A block of a group of triangles: what one of them covers, or what is left of that behind the early passes of its plan.
struct SeenBlock {
  std::uint64_t coverage;
  std::int32_t x, y, first_pixel;  ///< as in FragmentBlock
  std::int32_t primitive;          ///< counted in its group
  bool operator==(const SeenBlock&) const = default;
};
struct TriangleGroup;  // pipeline/raster/triangles.h
/// Most blocks of a group in a tile, and room to write one more that turns out not to count.
inline constexpr std::size_t most_seen_blocks = std::size_t{8} * 64 + 1;

/// Lists the blocks that triangles whose depths are set up cover, in order. Returns the number of blocks.
using GroupRasterizer = std::size_t (*)(const TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, SeenBlock* found);
GroupRasterizer group_rasterizer();

/// Sends one block through passes [first, end) of its primitive.
inline void run_passes(const FragmentPasses& passes, std::int32_t first, std::int32_t end, FragmentBlock& block,
                       const TileTarget& target) {
  for (std::int32_t i = first; i < end; ++i) {
    passes.pass[static_cast<std::size_t>(i)](block, target);
    if (block.coverage == 0) return;
  }
}
inline void run_passes(const FragmentPasses& passes, FragmentBlock& block, const TileTarget& target) {
  run_passes(passes, 0, passes.count, block, target);
}

/// Lanes of a block that lie inside the primitive's box; `x`, `y` is the block's first pixel.
inline std::uint64_t box_mask(const PrimitiveRecord& primitive, std::int32_t x, std::int32_t y) {
  const auto low = [](std::int32_t value) { return value < 0 ? 0 : value > 8 ? 8 : value; };
  const std::int32_t c0 = low(primitive.x0 - x), c1 = low(primitive.x1 - x);
  const std::int32_t r0 = low(primitive.y0 - y), r1 = low(primitive.y1 - y);
  if (c0 >= c1 || r0 >= r1) return 0;
  const std::uint64_t row = ((1u << c1) - 1) & ~((1u << c0) - 1);
  const std::uint64_t all_rows = row * 0x0101010101010101u;
  const std::uint64_t above = r1 == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * r1)) - 1;
  const std::uint64_t below = (std::uint64_t{1} << (8 * r0)) - 1;
  return all_rows & above & ~below;
}

}  // namespace gouraud::pipeline
