// The walk along a thin line finds the pixels that its edges give, block by block.
#include "pipeline/raster/lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/line_coverage.h"

namespace gouraud::pipeline {
namespace {

/// The pixels of a tile by both ways must be the same. False if the line has none in it.
bool expect_same_pixels(const PrimitiveRecord& record, std::int32_t tile_x, std::int32_t tile_y) {
  std::array<std::uint64_t, 64> expected{}, walked{};
  bool some = false;
  for (std::int32_t y = 0; y < tile_size; ++y) {
    for (std::int32_t x = 0; x < tile_size; ++x) {
      const std::int64_t i = tile_x + x, j = tile_y + y;
      if (i < record.x0 || i >= record.x1 || j < record.y0 || j >= record.y1) continue;
      const auto value = [&](std::size_t k) { return record.edges[k].c + record.edges[k].a * i + record.edges[k].b * j; };
      if (value(0) < 0 || value(1) < 0) continue;
      expected[static_cast<std::size_t>(y / 8 * 8 + x / 8)] |= std::uint64_t{1} << (y % 8 * 8 + x % 8);
      some = true;
    }
  }
  std::array<BlockMask, most_line_blocks> blocks;
  const std::size_t count = walk_line(record, tile_x, tile_y, blocks.data());
  for (std::size_t k = 0; k < count; ++k) {
    EXPECT_EQ(walked[static_cast<std::size_t>(blocks[k].block)], 0u) << "a block comes once";
    walked[static_cast<std::size_t>(blocks[k].block)] |= blocks[k].coverage;
  }
  EXPECT_EQ(walked, expected);
  return some;
}

TEST(ThinLines, WalkThePixelsBetweenTheirEdges) {
  std::mt19937 random(23);
  int drawn = 0;
  for (const int step : {1, 16, 128, 256}) {  // in 1/256 pixel: the coarser, the more ties
    std::uniform_int_distribution<int> place(-40 * subpixels / step, 230 * subpixels / step);
    for (int round = 0; round < 2000; ++round) {
      const SubpixelPoint a{std::int64_t{place(random)} * step, std::int64_t{place(random)} * step};
      SubpixelPoint b{std::int64_t{place(random)} * step, std::int64_t{place(random)} * step};
      if (round % 5 == 0) b.x = a.x;
      if (round % 5 == 1) b.y = a.y;
      if (round % 5 == 2) b.y = a.y + (b.x - a.x) * (round % 2 == 0 ? 1 : -1);
      if (a == b) continue;
      const LineCoverage coverage(a, b, 1);
      if (!coverage.is_simple()) continue;
      PrimitiveRecord record;
      const auto edges = coverage.edges();
      record.edges = {edges[0], edges[1], {}};
      const PixelRect box = coverage.box();
      // Some are scissored.
      record.x0 = std::max(box.x0, round % 3 == 0 ? 70 : -100);
      record.y0 = std::max(box.y0, -100);
      record.x1 = box.x1;
      record.y1 = std::min(box.y1, round % 7 == 0 ? 101 : 1000);
      for (const std::int32_t x : {0, 64, 128}) {
        for (const std::int32_t y : {0, 64, 128}) drawn += expect_same_pixels(record, x, y) ? 1 : 0;
      }
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(drawn, 3000);
}

}  // namespace
}  // namespace gouraud::pipeline
