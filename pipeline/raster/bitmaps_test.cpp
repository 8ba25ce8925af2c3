#include "pipeline/raster/bitmaps.h"

#include <random>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

TEST(Bitmaps, CoverThePixelsOfTheirBitsInsideTheClip) {
  std::mt19937 random(3);
  const auto below = [&random](int n) { return static_cast<std::int32_t>(random() % static_cast<unsigned>(n)); };
  for (int trial = 0; trial < 2000; ++trial) {
    Bitmap bitmap{below(200) - 60, below(200) - 60, below(90), below(40), nullptr, 0};
    bitmap.row_bytes = (bitmap.width_px + 7) / 8;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(bitmap.row_bytes * bitmap.height_px) + 1);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
    bitmap.rows = bytes.data();
    const PixelRect clip{below(60), below(60), 60 + below(68), 60 + below(68)};
    std::vector<int> covered(128 * 128);
    for (std::int32_t tile = 0; tile < 4; ++tile) {
      std::vector<BlockMask> blocks;
      find_bitmap_blocks(bitmap, clip, tile % 2 * 64, tile / 2 * 64, blocks);
      for (const BlockMask& block : blocks) {
        for (std::int32_t lane = 0; lane < 64; ++lane) {
          const std::int32_t x = tile % 2 * 64 + block.block % 8 * 8 + lane % 8, y = tile / 2 * 64 + block.block / 8 * 8 + lane / 8;
          covered[static_cast<std::size_t>(y * 128 + x)] += static_cast<int>(block.coverage >> lane & 1);
        }
      }
    }
    for (std::int32_t y = 0; y < 128; ++y) {
      for (std::int32_t x = 0; x < 128; ++x) {
        const std::int32_t i = x - bitmap.x, j = y - bitmap.y;
        bool set = i >= 0 && i < bitmap.width_px && j >= 0 && j < bitmap.height_px && x >= clip.x0 && x < clip.x1 &&
                   y >= clip.y0 && y < clip.y1;
        if (set) set = (bytes[static_cast<std::size_t>(j * bitmap.row_bytes + i / 8)] >> i % 8 & 1) != 0;
        ASSERT_EQ(covered[static_cast<std::size_t>(y * 128 + x)], set ? 1 : 0) << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
