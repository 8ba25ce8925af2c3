#include "pipeline/framebuffer/read.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

constexpr int width = 133, height = 75;  // partial tiles and partial blocks in both directions

template <class Value>
void store(const TiledBuffer& buffer, int x, int y, const std::vector<Value>& values) {
  std::memcpy(buffer.pixel(x, y), values.data(), values.size() * sizeof(Value));
}

std::uint32_t number_of(int x, int y) {
  return static_cast<std::uint32_t>(y * width + x) + 0x01000000u;
}

// Every pixel bears its own number.
Framebuffer numbered() {
  Framebuffer target(width, height, ColorFormat::rgba8, DepthFormat::z24s8, 8);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      store<std::uint32_t>(target.color, x, y, {number_of(x, y)});
      store<std::uint32_t>(target.depth, x, y, {number_of(x, y)});
    }
  }
  return target;
}

TEST(ReadRows, GiveEveryPixelOfEveryRectangleInItsPlace) {
  const Framebuffer target = numbered();
  for (const auto [x, y, w, h] : {std::array{0, 0, width, height}, std::array{3, 5, 1, 1}, std::array{7, 7, 2, 2},
                                  std::array{61, 62, 70, 12}, std::array{8, 16, 64, 40}, std::array{5, 5, 0, 3}}) {
    std::vector<std::uint32_t> rows(static_cast<std::size_t>(w * h) + 1, 0xDEADu);
    read_color_rows(target, x, y, w, h, reinterpret_cast<std::byte*>(rows.data()), w * 4);
    std::vector<std::uint32_t> row(static_cast<std::size_t>(w) + 1, 0xDEADu);
    for (int j = 0; j < h; ++j) {
      read_color_row(target, x, y + j, w, row.data());
      for (int i = 0; i < w; ++i) {
        ASSERT_EQ(rows[static_cast<std::size_t>(j * w + i)], number_of(x + i, y + j));
        ASSERT_EQ(row[static_cast<std::size_t>(i)], number_of(x + i, y + j));
      }
      ASSERT_EQ(row.back(), 0xDEADu);
    }
    ASSERT_EQ(rows.back(), 0xDEADu);
  }
}

TEST(ReadRows, WithNegativeStrideTurnThePictureUpsideDown) {
  const Framebuffer target = numbered();
  std::vector<std::uint32_t> picture(width * height);
  read_depth_rows(target, 0, 0, width, height, reinterpret_cast<std::byte*>(&picture[width * (height - 1)]),
                  -width * 4);
  for (int y = 0; y < height; ++y)
    ASSERT_EQ(picture[static_cast<std::size_t>((height - 1 - y) * width)], number_of(0, y));
}

TEST(ReadRows, MoveTheBytesOfEveryPixelSize) {
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba16, ColorFormat::rgba32f}) {
    Framebuffer target(20, 10, format, DepthFormat::z16, 0);
    const auto size = static_cast<std::size_t>(bytes_per_pixel(format));
    for (int x = 0; x < 20; ++x) std::memset(target.color.pixel(x, 9), x + 1, size);
    std::vector<std::uint8_t> row(20 * size);
    read_color_row(target, 0, 9, 20, row.data());
    for (std::size_t i = 0; i < row.size(); ++i) ASSERT_EQ(row[i], i / size + 1);
  }
}

TEST(ReadColor, OfBytesAsFloatIsTheProductWithTheReciprocal) {
  Framebuffer target(64, 1, ColorFormat::rgba8, DepthFormat::none, 0);
  for (int x = 0; x < 64; ++x) {
    std::vector<std::uint8_t> pixel;
    for (int c = 0; c < 4; ++c) pixel.push_back(static_cast<std::uint8_t>(x * 4 + c));
    store(target.color, x, 0, pixel);
  }
  std::vector<float> row(256);
  read_color_row_float(target, 0, 0, 64, row.data());
  for (int value = 0; value < 256; ++value) {
    ASSERT_EQ(row[static_cast<std::size_t>(value)], static_cast<float>(value) * (1.0f / 255.0f));
  }
}

TEST(ReadColor, OfWordsAsBytesIsTheNearestByte) {
  for (std::uint32_t word = 0; word <= 65535; word += 4) {
    Framebuffer target(1, 1, ColorFormat::rgba16, DepthFormat::none, 0);
    std::vector<std::uint16_t> pixel;
    for (std::uint32_t c = 0; c < 4; ++c) pixel.push_back(static_cast<std::uint16_t>(word + c));
    store(target.color, 0, 0, pixel);
    std::uint8_t bytes[4];
    read_color_row_unorm8(target, 0, 0, 1, bytes);
    for (int c = 0; c < 4; ++c) ASSERT_EQ(bytes[c], std::lrint((word + static_cast<unsigned>(c)) / 257.0));
  }
}

TEST(ReadColor, OfWordsAsFloatIsExactAtTheEnds) {
  Framebuffer target(1, 1, ColorFormat::rgba16, DepthFormat::none, 0);
  store<std::uint16_t>(target.color, 0, 0, {0, 65535, 32768, 1});
  float color[4];
  read_color_row_float(target, 0, 0, 1, color);
  EXPECT_EQ(color[0], 0.0f);
  EXPECT_EQ(color[1], 1.0f);
  EXPECT_FLOAT_EQ(color[2], 32768.0f / 65535.0f);
  EXPECT_FLOAT_EQ(color[3], 1.0f / 65535.0f);
}

TEST(ReadColor, OfFloatsAsBytesClampsAndRoundsToNearestEven) {
  const float infinity = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  Framebuffer target(3, 1, ColorFormat::rgba32f, DepthFormat::none, 0);
  store<float>(target.color, 0, 0, {-1.0f, 2.0f, 0.5f, 1.0f});
  store<float>(target.color, 1, 0, {nan, infinity, -infinity, 1e38f});
  store<float>(target.color, 2, 0, {0.5f / 255.0f, 1.5f / 255.0f, 0.0f, -0.0f});
  std::uint8_t bytes[12];
  read_color_row_unorm8(target, 0, 0, 3, bytes);
  const std::uint8_t expected[12] = {0, 255, 128, 255, 0, 255, 0, 255, 0, 2, 0, 0};
  for (int i = 0; i < 12; ++i) EXPECT_EQ(bytes[i], expected[i]) << i;
  float floats[12];
  read_color_row_float(target, 0, 0, 3, floats);
  EXPECT_EQ(floats[0], -1.0f);
  EXPECT_EQ(floats[1], 2.0f);
}

TEST(ReadDepth, KeepsStencilOutOfDepthAndDepthOutOfStencil) {
  Framebuffer target(9, 1, ColorFormat::none, DepthFormat::z24s8, 8);
  store<std::uint32_t>(target.depth, 8, 0, {0xAB800000u});
  std::uint32_t depth;
  float depth_float;
  std::uint8_t stencil;
  read_depth_row(target, 8, 0, 1, &depth);
  read_depth_row_float(target, 8, 0, 1, &depth_float);
  read_stencil_row(target, 8, 0, 1, &stencil);
  EXPECT_EQ(depth, 0x800000u);
  EXPECT_EQ(depth_float, 8388608.0f / 16777215.0f);
  EXPECT_EQ(stencil, 0xAB);
}

TEST(ReadDepth, OfEveryFormatIsOneAtTheFarEnd) {
  float depth;
  Framebuffer z16(1, 1, ColorFormat::none, DepthFormat::z16, 0);
  store<std::uint16_t>(z16.depth, 0, 0, {0xFFFF});
  read_depth_row_float(z16, 0, 0, 1, &depth);
  EXPECT_EQ(depth, 1.0f);
  Framebuffer z24(1, 1, ColorFormat::none, DepthFormat::z24s8, 0);
  store<std::uint32_t>(z24.depth, 0, 0, {0x00FFFFFF});
  read_depth_row_float(z24, 0, 0, 1, &depth);
  EXPECT_EQ(depth, 1.0f);
  Framebuffer z32f(1, 1, ColorFormat::none, DepthFormat::z32f, 0);
  store<float>(z32f.depth, 0, 0, {1.0f});
  read_depth_row_float(z32f, 0, 0, 1, &depth);
  EXPECT_EQ(depth, 1.0f);
}

TEST(ReadStencil, ComesFromItsOwnBufferBesideOtherDepthFormats) {
  Framebuffer target(1, 1, ColorFormat::none, DepthFormat::z16, 8);
  store<std::uint8_t>(target.stencil, 0, 0, {77});
  std::uint8_t stencil;
  read_stencil_row(target, 0, 0, 1, &stencil);
  EXPECT_EQ(stencil, 77);
  Framebuffer without(1, 1, ColorFormat::none, DepthFormat::z24s8, 0);
  store<std::uint32_t>(without.depth, 0, 0, {0xAB000000u});
  read_stencil_row(without, 0, 0, 1, &stencil);
  EXPECT_EQ(stencil, 0);
}

}  // namespace
}  // namespace gouraud::pipeline
