// Takes a tile and edge functions, gives blocks of covered pixels. Tiles and blocks that an edge has wholly on one side
// skip its test: a block inside all edges costs no per-pixel work.
#include "pipeline/raster/polygons.h"

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/polygons.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/edge_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
/// An edge that crosses the tile, relative to the tile's first pixel.
struct TileEdge {
  std::int32_t value, a, b;
  std::int32_t least, most;  ///< what the value grows by at most downwards and upwards inside a block
};

/// The blocks of a row of the tile.
using BlockTag = hn::CappedTag<std::int32_t, blocks_per_tile_row>;
using IntBlocks = hn::Vec<BlockTag>;
alignas(64) constexpr std::int32_t first_column[blocks_per_tile_row] = {0, 8, 16, 24, 32, 40, 48, 56};  ///< their first pixels
static_assert(blocks_per_tile_row == 8 && block_size == 8);

HWY_INLINE std::uint32_t negative(IntBlocks v) {
  const BlockTag d;
  std::uint64_t bits = 0;
  hn::StoreMaskBits(d, hn::Lt(v, hn::Zero(d)), reinterpret_cast<std::uint8_t*>(&bits));
  return static_cast<std::uint32_t>(bits);
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

/// Lanes of the 8x8 pixels around which the edges are given, inside all three and in the first `pairs` row pairs.
struct SmallEdges {
  std::int32_t value[3], a[3], b[3];
};
HWY_INLINE std::uint64_t inside_small(const SmallEdges& edges, std::size_t pairs) {
  const IntTag d;
  std::uint64_t mask = 0;
  for (std::size_t offset = 0; offset < 16; offset += hn::Lanes(d)) {
    const auto start = [&](std::size_t k) HWY_ATTR {
      return hn::Add(hn::Set(d, edges.value[k]), edge_pattern(edges.a[k], edges.b[k], offset));
    };
    const auto step = [&](std::size_t k) HWY_ATTR { return hn::Set(d, 2 * edges.b[k]); };
    IntVector v0 = start(0), v1 = start(1), v2 = start(2);
    const IntVector step0 = step(0), step1 = step(1), step2 = step(2);
    for (std::size_t pair = 0; pair < pairs; ++pair) {
      mask |= not_negative(hn::Or(hn::Or(v0, v1), v2)) << (pair * 16 + offset);
      v0 = hn::Add(v0, step0);
      v1 = hn::Add(v1, step1);
      v2 = hn::Add(v2, step2);
    }
  }
  return mask;
}

/// Blocks of the tile, both ends included.
struct BlockBox {
  std::int32_t x0, y0, x1, y1;
};

/// A tile, and what becomes of the blocks that are found in it: they go through all passes of their primitive.
struct WholeWay {
  std::int32_t tile_x, tile_y;
  const TileTarget& target;
  const PrimitiveRecord* primitive;

  /// Only the head of a FragmentBlock is written.
  HWY_INLINE void send(std::int32_t column, std::int32_t row, std::uint64_t coverage) const {
    if (coverage == 0) return;
    FragmentBlock block;
    block.primitive = primitive;
    block.x = tile_x + column * block_size;
    block.y = tile_y + row * block_size;
    block.first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
    block.coverage = coverage;
    run_passes(primitive->binding->passes, block, target);
  }
};

/// They are listed. (No branch: whether a block is empty is hard to guess.)
struct ToAList {
  std::int32_t tile_x, tile_y;
  std::int32_t number;  ///< of the primitive
  SeenBlock* end;

  HWY_INLINE void send(std::int32_t column, std::int32_t row, std::uint64_t coverage) {
    *end = {coverage, tile_x + column * block_size, tile_y + row * block_size,
            (row * blocks_per_tile_row + column) * pixels_per_block, number};
    end += coverage != 0 ? 1 : 0;
  }
};

/// Sends a block on its way, cut by the scissor.
template <class Way>
HWY_INLINE void emit(const PrimitiveRecord& primitive, std::int32_t column, std::int32_t row, std::uint64_t coverage, Way& way) {
  if (primitive.scissored) coverage &= box_mask(primitive, way.tile_x + column * block_size, way.tile_y + row * block_size);
  way.send(column, row, coverage);
}

/// 8x8 pixels, wherever they lie, cut into the four blocks that they may touch. Bit 8 * row + column of `mask` is the pixel
/// (x + column, y + row), relative to the tile; blocks outside it are left out. Shifts by 64 come in two parts.
template <class Way>
HWY_INLINE void send_cut(std::uint64_t mask, std::int32_t x, std::int32_t y, Way& way) {
  const std::int32_t column = x >> 3, row = y >> 3, right = x & 7, up = y & 7;  // rounded down: they may be negative
  static_assert(block_size == 8);
  constexpr std::uint64_t every_row = 0x0101010101010101u;
  const std::uint64_t stay = (0xFFu >> right) * every_row;
  const std::uint64_t left_half = (mask & stay) << right, right_half = (mask & ~stay) >> (8 - right);
  const std::int32_t down = 8 * (7 - up);
  const auto send = [&](std::uint64_t coverage, std::int32_t block_column, std::int32_t block_row) HWY_ATTR {
    const auto in_tile = [](std::int32_t i) { return static_cast<std::uint32_t>(i) < static_cast<std::uint32_t>(blocks_per_tile_row); };
    const bool here = static_cast<int>(in_tile(block_column)) & static_cast<int>(in_tile(block_row));
    way.send(block_column, block_row, here ? coverage : 0);
  };
  send(left_half << 8 * up, column, row);
  send(right_half << 8 * up, column + 1, row);
  send(left_half >> down >> 8, column, row + 1);
  send(right_half >> down >> 8, column + 1, row + 1);
}

/// An edge far away is as good as one at this distance: inside the tile a value changes by less.
HWY_INLINE std::int32_t nearer(std::int64_t value) {
  constexpr std::int64_t far_away = std::int64_t{1} << 29;
  return static_cast<std::int32_t>(HWY_MIN(HWY_MAX(value, -far_away), far_away));
}

/// At most 8x8 pixels: their edges are evaluated once, wherever they lie. `box` is relative to the tile and inside it.
template <class Way>
HWY_INLINE void rasterize_small(const PrimitiveRecord& primitive, const PixelRect& box, Way& way) {
  SmallEdges edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& e = primitive.edges[k];
    edges.value[k] = nearer(e.c + std::int64_t{e.a} * (way.tile_x + box.x0) + std::int64_t{e.b} * (way.tile_y + box.y0));
    edges.a[k] = e.a;
    edges.b[k] = e.b;
  }
  constexpr std::uint64_t every_row = 0x0101010101010101u;
  const std::int32_t width = box.x1 - box.x0, height = box.y1 - box.y0;
  const std::uint64_t in_box = (0xFFu >> (8 - width)) * every_row & ~std::uint64_t{0} >> (64 - 8 * height);
  send_cut(inside_small(edges, static_cast<std::size_t>(height + 1) / 2) & in_box, box.x0, box.y0, way);
}

/// Few blocks: which edge crosses which is a coin toss that a processor guesses wrong, so all are evaluated everywhere.
constexpr std::int32_t few_blocks = 4;

template <class Way>
HWY_INLINE void rasterize_few_blocks(const PrimitiveRecord& primitive, const BlockBox& box, Way& way) {
  TileEdge edges[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& e = primitive.edges[k];
    edges[k] = {nearer(e.c + std::int64_t{e.a} * way.tile_x + std::int64_t{e.b} * way.tile_y), e.a, e.b, 0, 0};
  }
  for (std::int32_t row = box.y0; row <= box.y1; ++row) {
    for (std::int32_t column = box.x0; column <= box.x1; ++column) {
      emit(primitive, column, row, inside_all(edges, column * block_size, row * block_size), way);
    }
  }
}

/// A row of a tile's blocks, as bits: those that an edge has wholly on its outer side, and those that it crosses.
struct BlockRow {
  std::uint32_t outside, crossed;
};
HWY_INLINE BlockRow look_at_row(const TileEdge (&edges)[3], std::int32_t row) {
  const BlockTag d;
  BlockRow result{0, 0};
  for (std::size_t first = 0; first < blocks_per_tile_row; first += hn::Lanes(d)) {
    IntBlocks most = hn::Zero(d), least = hn::Zero(d);  // negative where they are for one of the edges
    for (const TileEdge& e : edges) {
      const IntBlocks column = hn::Load(d, first_column + first);
      const IntBlocks value = hn::Add(hn::Mul(column, hn::Set(d, e.a)), hn::Set(d, e.value + e.b * (row * block_size)));
      most = hn::Or(most, hn::Add(value, hn::Set(d, e.most)));
      least = hn::Or(least, hn::Add(value, hn::Set(d, e.least)));
    }
    result.outside |= negative(most) << first;
    result.crossed |= negative(least) << first;
  }
  return result;
}

/// Many blocks: those wholly on one side of all edges skip their evaluation.
template <class Way>
HWY_INLINE void rasterize_many_blocks(const PrimitiveRecord& primitive, const BlockBox& box, Way& way) {
  constexpr std::int32_t far_corner = tile_size - 1, far_lane = block_size - 1;
  const auto least_of = [](const EdgeFunction& e, std::int32_t n) { return (e.a < 0 ? e.a * n : 0) + (e.b < 0 ? e.b * n : 0); };
  const auto most_of = [](const EdgeFunction& e, std::int32_t n) { return (e.a > 0 ? e.a * n : 0) + (e.b > 0 ? e.b * n : 0); };

  // Keep the edges that cross the tile; the rest of the array holds edges that everything is inside of.
  TileEdge edges[3] = {};
  int edge_count = 0;
  for (const EdgeFunction& edge : primitive.edges) {
    const std::int64_t value = edge.c + static_cast<std::int64_t>(edge.a) * way.tile_x + static_cast<std::int64_t>(edge.b) * way.tile_y;
    if (value + most_of(edge, far_corner) < 0) return;
    if (value + least_of(edge, far_corner) >= 0) continue;
    edges[edge_count++] = {static_cast<std::int32_t>(value), edge.a, edge.b, least_of(edge, far_lane), most_of(edge, far_lane)};
  }

  const std::uint32_t columns = (2u << box.x1) - (1u << box.x0);
  for (std::int32_t row = box.y0; row <= box.y1; ++row) {
    const BlockRow blocks = look_at_row(edges, row);
    for (std::uint32_t left = columns & ~blocks.outside; left != 0; left &= left - 1) {
      const auto column = static_cast<std::int32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(left));
      const bool crossed = (blocks.crossed >> column & 1) != 0;
      emit(primitive, column, row, crossed ? inside_all(edges, column * block_size, row * block_size) : ~std::uint64_t{0}, way);
    }
  }
}

template <class Way>
HWY_INLINE void rasterize_edges(const PrimitiveRecord& primitive, Way& way) {
  const PixelRect pixels{std::max(primitive.x0 - way.tile_x, 0), std::max(primitive.y0 - way.tile_y, 0),
                         std::min(primitive.x1 - way.tile_x, tile_size), std::min(primitive.y1 - way.tile_y, tile_size)};
  if (pixels.x1 - pixels.x0 <= block_size && pixels.y1 - pixels.y0 <= block_size) {
    return rasterize_small(primitive, pixels, way);
  }
  const BlockBox box{pixels.x0 / block_size, pixels.y0 / block_size, (pixels.x1 - 1) / block_size, (pixels.y1 - 1) / block_size};
  if ((box.x1 - box.x0 + 1) * (box.y1 - box.y0 + 1) <= few_blocks) {
    rasterize_few_blocks(primitive, box, way);
  } else {
    rasterize_many_blocks(primitive, box, way);
  }
}

void rasterize(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  WholeWay way{tile_x, tile_y, target, &primitive};
  rasterize_edges(primitive, way);
}

std::size_t rasterize_group(const TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, SeenBlock* found) {
  ToAList way{tile_x, tile_y, 0, found};
  for (std::size_t i = 0; i < group.count; ++i) {
    const WaitingTriangle& triangle = *group.triangle[i];
    way.number = static_cast<std::int32_t>(i);
    if (triangle.small()) {
      send_cut(triangle.mask, triangle.x0 - tile_x, triangle.y0 - tile_y, way);
    } else {
      rasterize_edges(group.record(i), way);
    }
  }
  return static_cast<std::size_t>(way.end - found);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
static_assert(most_seen_blocks == group_capacity * blocks_per_tile_row * blocks_per_tile_row + 1);

PolygonRasterizer polygon_rasterizer() { return GOURAUD_SIMD_PICK(rasterize); }
GroupRasterizer group_rasterizer() { return GOURAUD_SIMD_PICK(rasterize_group); }
}  // namespace gouraud::pipeline
#endif
