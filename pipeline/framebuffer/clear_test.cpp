#include "pipeline/framebuffer/clear.h"

#include <gtest/gtest.h>

#include <vector>

#include "pipeline/framebuffer/read.h"

namespace gouraud::pipeline {
namespace {

void clear_all(Framebuffer& target, const ClearState& state) {
  if (state.stencil && state.clear_stencil != 0) target.depth.use_stencil();
  for (int tile = 0; tile < target.tile_count(); ++tile) clear_tile(target, tile, state);
}

std::vector<std::uint8_t> pixel(const Framebuffer& target, int x, int y) {
  std::vector<std::uint8_t> rgba(4);
  read_color_row_unorm8(target, x, y, 1, rgba.data());
  return rgba;
}

using Bytes = std::vector<std::uint8_t>;

TEST(Clear, ConvertsColorsToNearestInEveryFormat) {
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba16, ColorFormat::rgba32f}) {
    Framebuffer target(70, 5, format, DepthFormat::none, 0);
    ClearState state{.color = true, .scissor = {0, 0, 70, 5}};
    state.clear_color = {0.5f, 1.0f, 0.0f, 0.25f};
    clear_all(target, state);
    EXPECT_EQ(pixel(target, 69, 4), (Bytes{128, 255, 0, 64}));
  }
}

TEST(Clear, StaysInsideTheScissorAndTheMask) {
  Framebuffer target(100, 80, ColorFormat::rgba8, DepthFormat::none, 0);
  ClearState state{.color = true, .scissor = {9, 11, 67, 70}, .color_write_mask = 0b0101, .clear_color = glm::vec4(1)};
  clear_all(target, state);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 100; ++x) {
      const bool inside = x >= 9 && x < 67 && y >= 11 && y < 70;
      ASSERT_EQ(pixel(target, x, y), (inside ? Bytes{255, 0, 255, 0} : Bytes{0, 0, 0, 0})) << x << " " << y;
    }
  }
}

TEST(Clear, OfDepthLeavesStencilAndTheOtherWayRound) {
  Framebuffer target(64, 64, ColorFormat::none, DepthFormat::z24s8, 8);
  clear_all(target, {.stencil = true, .scissor = {0, 0, 64, 64}, .clear_stencil = 0xA5});
  clear_all(target, {.depth = true, .scissor = {0, 0, 64, 64}, .clear_depth = 0.3});
  std::uint32_t depth = 0;
  std::uint8_t stencil = 0;
  read_depth_row(target, 5, 6, 1, &depth);
  read_stencil_row(target, 5, 6, 1, &stencil);
  EXPECT_EQ(depth, 5033164u);
  EXPECT_EQ(stencil, 0xA5);
  clear_all(target, {.stencil = true, .scissor = {0, 0, 64, 64}, .clear_stencil = 0x0F, .stencil_write_mask = 0x3C});
  read_stencil_row(target, 5, 6, 1, &stencil);
  EXPECT_EQ(stencil, 0x8D);
}

TEST(Clear, OfAWholeTileWaitsUntilItsPixelsAreAskedFor) {
  Framebuffer target(128, 64, ColorFormat::rgba8, DepthFormat::z24s8, 8);
  const auto waits = [&](const TiledBuffer& plane, int tile) { return plane.waiting_clear(tile, 0) != nullptr; };
  clear_all(target, {.color = true, .depth = true, .scissor = {0, 0, 128, 64}, .clear_color = glm::vec4(1)});
  EXPECT_TRUE(waits(target.color, 0) && waits(target.color, 1) && waits(target.depth, 0));
  EXPECT_EQ(pixel(target, 3, 60), (Bytes{255, 255, 255, 255}));
  EXPECT_FALSE(waits(target.color, 0));
  EXPECT_TRUE(waits(target.color, 1) && waits(target.depth, 0));
}

TEST(Clear, UnderAMaskMeetsAClearThatWaits) {
  Framebuffer target(64, 64, ColorFormat::rgba8, DepthFormat::z24s8, 8);
  const PixelRect all{0, 0, 64, 64};
  clear_all(target, {.color = true, .scissor = all, .clear_color = glm::vec4(1)});
  clear_all(target, {.color = true, .scissor = all, .color_write_mask = 0b0110});
  clear_all(target, {.depth = true, .scissor = all, .clear_depth = 0.5});
  clear_all(target, {.stencil = true, .scissor = all, .clear_stencil = 0xFF, .stencil_write_mask = 0x3C});
  EXPECT_NE(target.color.waiting_clear(0, 0), nullptr);
  EXPECT_NE(target.depth.waiting_clear(0, 0), nullptr);
  EXPECT_EQ(pixel(target, 1, 2), (Bytes{255, 0, 0, 255}));
  std::uint32_t depth = 0;
  std::uint8_t stencil = 0;
  read_depth_row(target, 5, 6, 1, &depth);
  read_stencil_row(target, 5, 6, 1, &stencil);
  EXPECT_EQ(depth, 0x800000u);
  EXPECT_EQ(stencil, 0x3C);
}

TEST(Clear, InsideAScissorKeepsTheClearThatWaitedOutside) {
  Framebuffer target(64, 64, ColorFormat::rgba8, DepthFormat::none, 0);
  clear_all(target, {.color = true, .scissor = {0, 0, 64, 64}, .clear_color = glm::vec4(1)});
  clear_all(target, {.color = true, .scissor = {0, 0, 5, 64}});
  EXPECT_EQ(pixel(target, 4, 63), (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(pixel(target, 5, 63), (Bytes{255, 255, 255, 255}));
}

TEST(Clear, OfDepthRoundsToNearestIn16Bits) {
  Framebuffer target(8, 8, ColorFormat::none, DepthFormat::z16, 0);
  clear_all(target, {.depth = true, .scissor = {0, 0, 8, 8}, .clear_depth = 0.5});
  std::uint32_t depth = 0;
  read_depth_row(target, 7, 7, 1, &depth);
  EXPECT_EQ(depth, 32768u);
}

}  // namespace
}  // namespace gouraud::pipeline
