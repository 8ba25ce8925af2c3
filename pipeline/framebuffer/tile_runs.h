// The part of a tile that an operation on the whole framebuffer touches, as runs of pixels that lie behind each other in
// memory.
#pragma once

#include <algorithm>
#include <cstdint>

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

inline constexpr PixelRect whole_tile{0, 0, tile_size, tile_size};

/// A tile of a target, and what of it lies inside a scissor box.
struct TileCut {
  std::int32_t tile_x, tile_y;
  PixelRect scissor;

  TileCut(const Framebuffer& target, std::int32_t tile_index, const PixelRect& box)
      : tile_x(tile_index % target.tiles_x), tile_y(tile_index / target.tiles_x), scissor(box) {}

  /// The pixels to touch, relative to the tile. A scissor box that reaches the plane's edge may as well hold the padding
  /// beyond it.
  PixelRect of(const TiledBuffer& plane) const {
    const std::int32_t x = tile_x * tile_size, y = tile_y * tile_size;
    const std::int32_t x1 = scissor.x1 >= plane.width_px() ? tile_size : scissor.x1 - x;
    const std::int32_t y1 = scissor.y1 >= plane.height_px() ? tile_size : scissor.y1 - y;
    return {std::max(scissor.x0 - x, 0), std::max(scissor.y0 - y, 0), std::min(x1, tile_size), std::min(y1, tile_size)};
  }
};

/// Calls run(first_pixel, count) for each run of pixels of the tile that lie inside `cut` (tile-relative): one run for
/// the whole tile, else one for each row of each block.
template <class Run>
void for_each_run(const PixelRect& cut, const Run& run) {
  if (cut == whole_tile) return run(0, pixels_per_tile);
  for (std::int32_t y = cut.y0; y < cut.y1; ++y) {
    for (std::int32_t x = cut.x0; x < cut.x1;) {
      const std::int32_t block_end = std::min((x / block_size + 1) * block_size, cut.x1);
      const std::int32_t block = y / block_size * blocks_per_tile_row + x / block_size;
      run(block * pixels_per_block + y % block_size * block_size + x % block_size, block_end - x);
      x = block_end;
    }
  }
}

}  // namespace gouraud::pipeline
