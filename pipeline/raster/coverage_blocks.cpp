// "coverage=blocks4", "blocks16", "blocks64": the default's edge functions, with another grain.
//
// Takes integer edge functions, gives the pixels where none is negative: the default's pixels. Cells of N x N pixels that
// an edge has wholly on its outer side are left out, those inside all edges need no test, the others test every pixel, 16 at a
// time. Small cells test fewer pixels in vain but ask about more cells; cells of 64 are whole tiles: every pixel of the
// box is tested.
// Source: N. Greene, "Hierarchical polygon tiling with coverage masks", 1996; M. Abrash, "Rasterization on Larrabee", 2009.
#include <algorithm>

#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/tile_pixels.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/coverage_blocks.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using IntTag = hn::CappedTag<std::int32_t, 16>;

/// An edge relative to the tile's first pixel.
struct CellEdge {
  std::int32_t value, a, b;
  HWY_INLINE std::int32_t at(std::int32_t x, std::int32_t y) const { return value + a * x + b * y; }
  HWY_INLINE std::int32_t least(std::int32_t n) const { return HWY_MIN(a, 0) * n + HWY_MIN(b, 0) * n; }
  HWY_INLINE std::int32_t most(std::int32_t n) const { return HWY_MAX(a, 0) * n + HWY_MAX(b, 0) * n; }
};

/// Which of 16 pixels, `width` a row, from (x, y) on are inside all edges.
template <std::size_t width>
HWY_INLINE std::uint32_t inside_16(const CellEdge (&edges)[3], std::int32_t x, std::int32_t y) {
  const IntTag d;
  std::uint32_t mask = 0;
  for (std::size_t lane = 0; lane < 16; lane += hn::Lanes(d)) {
    const auto index = hn::Iota(d, static_cast<std::int32_t>(lane));
    const auto column = hn::And(index, hn::Set(d, static_cast<std::int32_t>(width - 1)));
    const auto row = hn::ShiftRight<width == 4 ? 2 : 3>(index);
    auto outside = hn::Zero(d);
    for (const CellEdge& e : edges) {
      const auto value = hn::Add(hn::Set(d, e.at(x, y)), hn::Add(hn::Mul(hn::Set(d, e.a), column), hn::Mul(hn::Set(d, e.b), row)));
      outside = hn::Or(outside, value);
    }
    std::uint64_t bits = 0;
    hn::StoreMaskBits(d, hn::Gt(outside, hn::Set(d, -1)), reinterpret_cast<std::uint8_t*>(&bits));
    mask |= static_cast<std::uint32_t>(bits) << lane;
  }
  return mask;
}

/// The pixels of a block of 8x8 inside all edges.
HWY_INLINE std::uint64_t inside_block(const CellEdge (&edges)[3], std::int32_t x, std::int32_t y) {
  std::uint64_t mask = 0;
  for (std::int32_t pair = 0; pair < 4; ++pair) mask |= std::uint64_t{inside_16<8>(edges, x, y + 2 * pair)} << (16 * pair);
  return mask;
}

/// A cell of 4x4 as part of its block.
HWY_INLINE std::uint64_t inside_quarter(const CellEdge (&edges)[3], std::int32_t x, std::int32_t y) {
  const std::uint64_t bits = inside_16<4>(edges, x, y);
  std::uint64_t mask = 0;
  for (int row = 0; row < 4; ++row) mask |= (bits >> (4 * row) & 0xF) << (8 * row);
  return mask;
}

enum class Side { outside, crossed, inside };
template <std::int32_t size>
HWY_INLINE Side side_of(const CellEdge (&edges)[3], std::int32_t x, std::int32_t y) {
  Side side = Side::inside;
  for (const CellEdge& e : edges) {
    const std::int32_t value = e.at(x, y);
    if (value + e.most(size - 1) < 0) return Side::outside;
    if (value + e.least(size - 1) < 0) side = Side::crossed;
  }
  return side;
}

/// The coverage of one block, whose cells may be smaller.
template <std::int32_t size>
HWY_INLINE std::uint64_t cover_block(const CellEdge (&edges)[3], std::int32_t x, std::int32_t y, Side side) {
  if constexpr (size >= block_size) return side == Side::inside ? ~std::uint64_t{0} : inside_block(edges, x, y);
  std::uint64_t mask = 0;
  for (std::int32_t quarter = 0; quarter < 4; ++quarter) {
    const std::int32_t right = quarter % 2 * 4, up = quarter / 2 * 4;
    const Side of_quarter = side_of<size>(edges, x + right, y + up);
    if (of_quarter == Side::outside) continue;
    const std::uint64_t bits = of_quarter == Side::inside ? 0x0F0F0F0Fu : inside_quarter(edges, x + right, y + up);
    mask |= bits << (8 * up + right);
  }
  return mask;
}

template <std::int32_t size>
void rasterize(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const TileBox box = box_in_tile(primitive, tile_x, tile_y);
  CellEdge edges[3] = {};
  int count = 0;
  for (const EdgeFunction& e : primitive.edges) {
    const CellEdge slopes{0, e.a, e.b};
    const std::int64_t value = e.c + std::int64_t{e.a} * tile_x + std::int64_t{e.b} * tile_y;
    if (value + slopes.most(tile_size - 1) < 0) return;
    if (value + slopes.least(tile_size - 1) < 0) edges[count++] = {static_cast<std::int32_t>(value), e.a, e.b};
  }

  constexpr std::int32_t cell = HWY_MAX(size, block_size);
  FragmentBlock block;
  block.primitive = &primitive;
  for (std::int32_t cell_y = box.y0 / cell * cell; cell_y < box.y1; cell_y += cell) {
    for (std::int32_t cell_x = box.x0 / cell * cell; cell_x < box.x1; cell_x += cell) {
      const Side side = size < block_size || size == tile_size ? Side::crossed : side_of<cell>(edges, cell_x, cell_y);
      if (side == Side::outside) continue;
      for (std::int32_t y = cell_y; y < cell_y + cell; y += block_size) {
        for (std::int32_t x = cell_x; x < cell_x + cell; x += block_size) {
          block.x = tile_x + x;
          block.y = tile_y + y;
          const std::uint64_t in_box = box_mask(primitive, block.x, block.y);
          block.coverage = in_box == 0 ? 0 : in_box & cover_block<size>(edges, x, y, side);
          if (block.coverage == 0) continue;
          block.first_pixel = (y / block_size * blocks_per_tile_row + x / block_size) * pixels_per_block;
          run_passes(primitive.binding->passes, block, target);
        }
      }
    }
  }
}

ShapeRasterizer select(CoverageMethod method) {
  switch (method) {
    case CoverageMethod::blocks4: return rasterize<4>;
    case CoverageMethod::blocks16: return rasterize<16>;
    default: break;
  }
  return rasterize<64>;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
ShapeRasterizer block_rasterizer(CoverageMethod method) { return GOURAUD_SIMD_PICK(select)(method); }
}  // namespace gouraud::pipeline
#endif
