// Bitmaps: set bits to blocks of fragments [GL1.5 §3.7].
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/pixel_image.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// The set bits inside `clip` that lie in the tile whose first pixel is (tile_x, tile_y), as blocks that are not empty.
void find_bitmap_blocks(const Bitmap& bitmap, const PixelRect& clip, std::int32_t tile_x, std::int32_t tile_y,
                        std::vector<BlockMask>& blocks);

/// The pixels that a bitmap may touch inside `clip`.
inline PixelRect bitmap_box(const Bitmap& bitmap, const PixelRect& clip) {
  return {std::max(bitmap.x, clip.x0), std::max(bitmap.y, clip.y0), std::min(bitmap.x + bitmap.width_px, clip.x1),
          std::min(bitmap.y + bitmap.height_px, clip.y1)};
}

}  // namespace gouraud::pipeline
