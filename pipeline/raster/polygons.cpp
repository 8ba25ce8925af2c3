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

using IntTag = hn::CappedTag<std::int32_t, 16>;
using IntVector = hn::Vec<IntTag>;

alignas(64) constexpr std::int32_t lane_column[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr std::int32_t lane_row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};

/// An edge's values in the lanes of a row pair, relative to lane 0, and from one pair to the next.
HWY_INLINE IntVector edge_pattern(std::int32_t a, std::int32_t b, std::size_t offset) {
  const IntTag d;
  return hn::Add(hn::Mul(hn::Load(d, lane_column + offset), hn::Set(d, a)), hn::Mul(hn::Load(d, lane_row + offset), hn::Set(d, b)));
}

HWY_INLINE std::uint64_t not_negative(IntVector v) {
  const IntTag d;
  std::uint64_t bits = 0;
  hn::StoreMaskBits(d, hn::Gt(v, hn::Set(d, -1)), reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}

/// Lanes of a block on the inner side of an edge whose value at lane 0 is `value`.
HWY_INLINE std::uint64_t inside(std::int32_t value, std::int32_t a, std::int32_t b) {
  const IntTag d;
  std::uint64_t mask = 0;
  for (std::size_t offset = 0; offset < 16; offset += hn::Lanes(d)) {
    IntVector v = hn::Add(hn::Set(d, value), edge_pattern(a, b, offset));
    for (std::size_t pair = 0; pair < 4; ++pair, v = hn::Add(v, hn::Set(d, 2 * b))) {
      mask |= not_negative(v) << (pair * 16 + offset);
    }
  }
  return mask;
}

/// Lanes of a block inside three edges, without a branch.
HWY_INLINE std::uint64_t inside_all(const TileEdge (&edges)[3], std::int32_t x, std::int32_t y) {
  const IntTag d;
  std::uint64_t mask = 0;
  for (std::size_t offset = 0; offset < 16; offset += hn::Lanes(d)) {
    const auto start = [&](const TileEdge& e) HWY_ATTR {
      return hn::Add(hn::Set(d, e.value + e.a * x + e.b * y), edge_pattern(e.a, e.b, offset));
    };
    IntVector v0 = start(edges[0]), v1 = start(edges[1]), v2 = start(edges[2]);
    for (std::size_t pair = 0; pair < 4; ++pair) {
      mask |= not_negative(hn::Or(hn::Or(v0, v1), v2)) << (pair * 16 + offset);
      v0 = hn::Add(v0, hn::Set(d, 2 * edges[0].b));
      v1 = hn::Add(v1, hn::Set(d, 2 * edges[1].b));
      v2 = hn::Add(v2, hn::Set(d, 2 * edges[2].b));
    }
  }
  return mask;
}

/// Blocks of the tile, both ends included.
struct BlockBox {
  std::int32_t x0, y0, x1, y1;
};

/// Sends a block on its way.
HWY_INLINE void emit(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, std::int32_t column,
                     std::int32_t row, std::uint64_t coverage, const TileTarget& target) {
  FragmentBlock block;
  block.primitive = &primitive;
  block.x = tile_x + column * block_size;
  block.y = tile_y + row * block_size;
  block.first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
  block.coverage = primitive.scissored ? coverage & box_mask(primitive, block.x, block.y) : coverage;
  if (block.coverage != 0) run_passes(primitive.binding->passes, block, target);
}

/// Few blocks: which edge crosses which is a coin toss that a processor guesses wrong, so all are evaluated everywhere.
constexpr std::int32_t few_blocks = 4;

HWY_INLINE void rasterize_few_blocks(const PrimitiveRecord& primitive, const TileEdge (&edges)[3], const BlockBox& box,
                                     std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  struct Found {
    std::uint64_t coverage;
    std::int32_t column, row;
  };
  Found found[few_blocks + 1];
  std::size_t count = 0;
  for (std::int32_t row = box.y0; row <= box.y1; ++row) {
    for (std::int32_t column = box.x0; column <= box.x1; ++column) {
      found[count] = {inside_all(edges, column * block_size, row * block_size), column, row};
      count += found[count].coverage != 0 ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    emit(primitive, tile_x, tile_y, found[i].column, found[i].row, found[i].coverage, target);
  }
}

/// Many blocks: those wholly on one side of an edge skip its evaluation.
HWY_INLINE void rasterize_many_blocks(const PrimitiveRecord& primitive, const TileEdge* edges, int edge_count,
                                      const BlockBox& box, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  for (std::int32_t row = box.y0; row <= box.y1; ++row) {
    for (std::int32_t column = box.x0; column <= box.x1; ++column) {
      std::uint64_t coverage = ~std::uint64_t{0};
      for (int k = 0; k < edge_count && coverage != 0; ++k) {
        const TileEdge& edge = edges[k];
        const std::int32_t value = edge.value + edge.a * (column * block_size) + edge.b * (row * block_size);
        if (value + edge.most < 0) coverage = 0;
        if (value + edge.least < 0) coverage &= inside(value, edge.a, edge.b);
      }
      if (coverage != 0) emit(primitive, tile_x, tile_y, column, row, coverage, target);
    }
  }
}

void rasterize(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  constexpr std::int32_t far_corner = tile_size - 1, far_lane = block_size - 1;
  const auto least_of = [](const EdgeFunction& e, std::int32_t n) { return (e.a < 0 ? e.a * n : 0) + (e.b < 0 ? e.b * n : 0); };
  const auto most_of = [](const EdgeFunction& e, std::int32_t n) { return (e.a > 0 ? e.a * n : 0) + (e.b > 0 ? e.b * n : 0); };

  // Keep the edges that cross the tile; the rest of the array holds edges that everything is inside of.
  TileEdge edges[3] = {};
  int edge_count = 0;
  for (const EdgeFunction& edge : primitive.edges) {
    const std::int64_t value = edge.c + static_cast<std::int64_t>(edge.a) * tile_x + static_cast<std::int64_t>(edge.b) * tile_y;
    if (value + most_of(edge, far_corner) < 0) return;
    if (value + least_of(edge, far_corner) >= 0) continue;
    edges[edge_count++] = {static_cast<std::int32_t>(value), edge.a, edge.b, least_of(edge, far_lane), most_of(edge, far_lane)};
  }

  // Visit the blocks of the primitive's box.
  const BlockBox box{std::max(primitive.x0 - tile_x, 0) / block_size, std::max(primitive.y0 - tile_y, 0) / block_size,
                     (std::min(primitive.x1 - tile_x, tile_size) - 1) / block_size,
                     (std::min(primitive.y1 - tile_y, tile_size) - 1) / block_size};
  if ((box.x1 - box.x0 + 1) * (box.y1 - box.y0 + 1) <= few_blocks) {
    rasterize_few_blocks(primitive, edges, box, tile_x, tile_y, target);
  } else {
    rasterize_many_blocks(primitive, edges, edge_count, box, tile_x, tile_y, target);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
PolygonRasterizer polygon_rasterizer() { return GOURAUD_SIMD_PICK(rasterize); }
}  // namespace gouraud::pipeline
#endif
