// Pixels of a tile, found one by one, on their way into blocks: for rasterizers that think in pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/polygons.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// Pixels of a tile, relative to its first: [x0, x1) x [y0, y1).
struct TileBox {
  std::int32_t x0, y0, x1, y1;
};

/// The part of the primitive's box that lies in the tile.
inline TileBox box_in_tile(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y) {
  return {std::max(primitive.x0 - tile_x, 0), std::max(primitive.y0 - tile_y, 0), std::min(primitive.x1 - tile_x, tile_size),
          std::min(primitive.y1 - tile_y, tile_size)};
}

class TilePixels {
 public:
  /// A pixel of the tile, relative to its first.
  void add(std::int32_t x, std::int32_t y) {
    coverage_[static_cast<std::size_t>(y / block_size * blocks_per_tile_row + x / block_size)] |=
        std::uint64_t{1} << (y % block_size * block_size + x % block_size);
  }
  /// Pixels [x0, x1) of row y.
  void add_span(std::int32_t x0, std::int32_t x1, std::int32_t y) {
    for (std::int32_t x = x0; x < x1;) {
      const std::int32_t column = x / block_size, end = std::min(x1, (column + 1) * block_size);
      const std::uint64_t bits = (std::uint64_t{0xFF} >> (block_size - (end - x))) << x % block_size;
      coverage_[static_cast<std::size_t>(y / block_size * blocks_per_tile_row + column)] |= bits << (y % block_size * block_size);
      x = end;
    }
  }
  /// Sends the blocks that hold pixels through the primitive's passes.
  void send(const PrimitiveRecord& primitive, const TileBox& box, std::int32_t tile_x, std::int32_t tile_y,
            const TileTarget& target) const {
    FragmentBlock block;
    block.primitive = &primitive;
    for (std::int32_t row = box.y0 / block_size; row * block_size < box.y1; ++row) {
      for (std::int32_t column = box.x0 / block_size; column * block_size < box.x1; ++column) {
        const std::int32_t index = row * blocks_per_tile_row + column;
        block.coverage = coverage_[static_cast<std::size_t>(index)];
        if (block.coverage == 0) continue;
        block.x = tile_x + column * block_size;
        block.y = tile_y + row * block_size;
        block.first_pixel = index * pixels_per_block;
        run_passes(primitive.binding->passes, block, target);
      }
    }
  }

 private:
  std::array<std::uint64_t, blocks_per_tile_row * blocks_per_tile_row> coverage_{};
};

/// Sends those pixels of the box for which inside(x, y), of window positions, is true.
template <class Inside>
void send_pixels(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target,
                 Inside inside) {
  const TileBox box = box_in_tile(primitive, tile_x, tile_y);
  TilePixels pixels;
  for (std::int32_t y = box.y0; y < box.y1; ++y) {
    for (std::int32_t x = box.x0; x < box.x1; ++x) {
      if (inside(tile_x + x, tile_y + y)) pixels.add(x, y);
    }
  }
  pixels.send(primitive, box, tile_x, tile_y, target);
}

}  // namespace gouraud::pipeline
