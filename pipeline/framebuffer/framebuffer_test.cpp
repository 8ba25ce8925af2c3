// Framebuffers as views: planes are shared, may be larger than the view, and outlive it.
#include "pipeline/framebuffer/framebuffer.h"

#include <cstring>

#include <gtest/gtest.h>

#include "pipeline/framebuffer/clear.h"
#include "pipeline/framebuffer/read.h"

namespace gouraud::pipeline {
namespace {

std::uint32_t word(const TiledBuffer& plane, int x, int y) {
  std::uint32_t value;
  std::memcpy(&value, plane.pixel(x, y), sizeof value);
  return value;
}

Framebuffer view(int width, int height, const TiledBuffer& color) {
  Framebuffer target(width, height, ColorFormat::none, DepthFormat::none, 0);
  target.color_format = ColorFormat::rgba8;
  target.color = color;
  return target;
}

void clear_to_white(const Framebuffer& target) {
  const ClearState white{.color = true, .scissor = {0, 0, target.width_px, target.height_px}, .clear_color = glm::vec4(1)};
  for (int tile = 0; tile < target.tile_count(); ++tile) clear_tile(target, tile, white);
}

TEST(Framebuffer, ViewsShareTheirPlanes) {
  TiledBuffer plane(100, 70, 4);
  {
    const Framebuffer first = view(100, 70, plane);
    clear_to_white(first);
  }
  const Framebuffer second = view(100, 70, plane);
  plane = {};
  std::uint8_t rgba[4] = {};
  read_color_row_unorm8(second, 99, 69, 1, rgba);
  EXPECT_EQ(rgba[0], 255);
}

TEST(Framebuffer, AViewSmallerThanItsPlaneStaysInsideItself) {
  const TiledBuffer plane(300, 200, 4);
  clear_to_white(view(130, 65, plane));
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 300; ++x) ASSERT_EQ(word(plane, x, y), x < 130 && y < 65 ? ~0u : 0u) << x << " " << y;
  }
}

TEST(Framebuffer, StencilInUseIsTrueOfThePlane) {
  const TiledBuffer plane(8, 8, 4);
  const TiledBuffer same = plane;
  EXPECT_FALSE(same.stencil_in_use());
  plane.use_stencil();
  EXPECT_TRUE(same.stencil_in_use());
}

TEST(Framebuffer, EmptyPlanesHaveNoPixels) {
  const Framebuffer target(8, 8, ColorFormat::rgba8, DepthFormat::z24s8, 8);
  EXPECT_FALSE(target.color.empty());
  EXPECT_FALSE(target.depth.empty());
  EXPECT_TRUE(target.stencil.empty());
}

}  // namespace
}  // namespace gouraud::pipeline
