// A block takes one byte of each of eight rows: the bits that stand over its eight columns.
#include "pipeline/raster/bitmaps.h"

namespace gouraud::pipeline {
namespace {

/// Bits [first, first + 8) of a row; those outside it are 0.
std::uint64_t eight_bits(const Bitmap& bitmap, const std::uint8_t* row, std::int32_t first) {
  const std::int32_t byte = first >> 3, shift = first & 7;  // rounds down, also below 0
  const auto at = [&](std::int32_t i) { return i >= 0 && i < bitmap.row_bytes ? std::uint32_t{row[i]} : 0u; };
  return (at(byte) | at(byte + 1) << 8) >> shift & 0xFFu;
}

std::uint64_t columns_inside(std::int32_t x, const PixelRect& box) {
  const auto low = [x](std::int32_t edge) { return std::clamp(edge - x, 0, block_size); };
  return ((1u << low(box.x1)) - 1) & ~((1u << low(box.x0)) - 1);
}

}  // namespace

void find_bitmap_blocks(const Bitmap& bitmap, const PixelRect& clip, std::int32_t tile_x, std::int32_t tile_y,
                        std::vector<BlockMask>& blocks) {
  const PixelRect box = bitmap_box(bitmap, clip);
  const PixelRect here{std::max(box.x0, tile_x), std::max(box.y0, tile_y), std::min(box.x1, tile_x + tile_size),
                       std::min(box.y1, tile_y + tile_size)};
  if (here.empty()) return;
  for (std::int32_t y = here.y0 / block_size * block_size; y < here.y1; y += block_size) {
    for (std::int32_t x = here.x0 / block_size * block_size; x < here.x1; x += block_size) {
      const std::uint64_t columns = columns_inside(x, here);
      std::uint64_t coverage = 0;
      for (std::int32_t j = std::max(y, here.y0); j < std::min(y + block_size, here.y1); ++j) {
        const std::uint8_t* const row = bitmap.rows + static_cast<std::ptrdiff_t>(j - bitmap.y) * bitmap.row_bytes;
        coverage |= (eight_bits(bitmap, row, x - bitmap.x) & columns) << ((j - y) * block_size);
      }
      const std::int32_t block = (y - tile_y) / block_size * blocks_per_tile_row + (x - tile_x) / block_size;
      if (coverage != 0) blocks.push_back({coverage, block});
    }
  }
}

}  // namespace gouraud::pipeline
