// Takes a tile and edge functions, gives blocks of covered pixels. Tiles and blocks that an edge has wholly on one side
// skip its test: a block inside all edges costs no per-pixel work.
#include "pipeline/raster/polygons.h"

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/polygons.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// An edge that crosses the tile, relative to the tile's first pixel.
struct TileEdge {
  std::int32_t value, a, b;
  std::int32_t least, most;  ///< what the value grows by at most downwards and upwards inside a block
};

alignas(64) constexpr std::int32_t lane_column[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr std::int32_t lane_row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};

/// Lanes of a block on the inner side of an edge whose value at lane 0 is `value`.
HWY_INLINE std::uint64_t inside(std::int32_t value, std::int32_t a, std::int32_t b) {
  const hn::CappedTag<std::int32_t, 16> d;
  const std::size_t lanes = hn::Lanes(d);
  std::uint64_t mask = 0;
  for (std::size_t offset = 0; offset < 16; offset += lanes) {
    auto v = hn::Add(hn::Set(d, value), hn::Add(hn::Mul(hn::Load(d, lane_column + offset), hn::Set(d, a)),
                                                hn::Mul(hn::Load(d, lane_row + offset), hn::Set(d, b))));
    const auto two_rows = hn::Set(d, 2 * b);
    for (std::size_t pair = 0; pair < 4; ++pair) {
      std::uint64_t bits = 0;
      hn::StoreMaskBits(d, hn::Gt(v, hn::Set(d, -1)), reinterpret_cast<std::uint8_t*>(&bits));
      mask |= bits << (pair * 16 + offset);
      v = hn::Add(v, two_rows);
    }
  }
  return mask;
}

void rasterize(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  constexpr std::int32_t far_corner = tile_size - 1, far_lane = block_size - 1;
  const auto least_of = [](const EdgeFunction& e, std::int32_t n) { return (e.a < 0 ? e.a * n : 0) + (e.b < 0 ? e.b * n : 0); };
  const auto most_of = [](const EdgeFunction& e, std::int32_t n) { return (e.a > 0 ? e.a * n : 0) + (e.b > 0 ? e.b * n : 0); };

  // Keep the edges that cross the tile.
  TileEdge edges[3];
  int edge_count = 0;
  for (const EdgeFunction& edge : primitive.edges) {
    const std::int64_t value = edge.c + static_cast<std::int64_t>(edge.a) * tile_x + static_cast<std::int64_t>(edge.b) * tile_y;
    if (value + most_of(edge, far_corner) < 0) return;
    if (value + least_of(edge, far_corner) >= 0) continue;
    edges[edge_count++] = {static_cast<std::int32_t>(value), edge.a, edge.b, least_of(edge, far_lane), most_of(edge, far_lane)};
  }

  // Visit the blocks of the primitive's box.
  const std::int32_t first_column = std::max(primitive.x0 - tile_x, 0) / block_size;
  const std::int32_t last_column = (std::min(primitive.x1 - tile_x, tile_size) - 1) / block_size;
  const std::int32_t first_row = std::max(primitive.y0 - tile_y, 0) / block_size;
  const std::int32_t last_row = (std::min(primitive.y1 - tile_y, tile_size) - 1) / block_size;
  const FragmentPasses passes = primitive.binding->passes;
  FragmentBlock block;
  block.primitive = &primitive;
  for (std::int32_t row = first_row; row <= last_row; ++row) {
    for (std::int32_t column = first_column; column <= last_column; ++column) {
      std::uint64_t coverage = ~std::uint64_t{0};
      for (int k = 0; k < edge_count; ++k) {
        const TileEdge& edge = edges[k];
        const std::int32_t value = edge.value + edge.a * (column * block_size) + edge.b * (row * block_size);
        if (value + edge.most < 0) {
          coverage = 0;
          break;
        }
        if (value + edge.least < 0) coverage &= inside(value, edge.a, edge.b);
      }
      if (coverage == 0) continue;
      block.x = tile_x + column * block_size;
      block.y = tile_y + row * block_size;
      if (primitive.scissored) coverage &= box_mask(primitive, block.x, block.y);
      if (coverage == 0) continue;
      block.coverage = coverage;
      block.first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
      run_passes(passes, block, target);
    }
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
PolygonRasterizer polygon_rasterizer() { return GOURAUD_SIMD_PICK(rasterize); }
}  // namespace gouraud::pipeline
#endif
