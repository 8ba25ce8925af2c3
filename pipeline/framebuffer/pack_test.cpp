#include "pipeline/framebuffer/pack.h"

#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

constexpr int width = 29, height = 11;

// Channel c of pixel (x, y): different in every channel and every pixel.
std::uint32_t channel_of(int x, int y, int c) {
  return static_cast<std::uint32_t>((y * width + x) * 4 + c) * 2654435761u;
}

template <class Channel>
Channel value_of(int x, int y, int c) {
  return static_cast<Channel>(channel_of(x, y, c) >> 16);
}
template <>
std::uint8_t value_of(int x, int y, int c) {
  return static_cast<std::uint8_t>(channel_of(x, y, c) >> 24);
}

template <class Channel>
Framebuffer filled(ColorFormat format) {
  Framebuffer target(width, height, format, DepthFormat::none, 0);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      Channel pixel[4];
      for (int c = 0; c < 4; ++c) pixel[c] = value_of<Channel>(x, y, c);
      std::memcpy(target.color.pixel(x, y), pixel, sizeof pixel);
    }
  }
  return target;
}

// Packs the rectangle that begins at (x0, y0) and ends at the target's end; expects the channels in this order.
template <class Channel>
void expect_order(PackedLayout layout, const std::vector<int>& order, int x0, int y0) {
  const Framebuffer target = filled<Channel>(stored_format(layout));
  const auto channels = order.size();
  ASSERT_EQ(static_cast<std::size_t>(bytes_per_pixel(layout)), channels * sizeof(Channel));
  const int w = width - x0, h = height - y0;
  const auto row_bytes = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(w) * channels * sizeof(Channel));
  std::vector<std::byte> out(static_cast<std::size_t>(row_bytes * h) + 1, std::byte{0xEE});
  pack_color_rows(target, layout, x0, y0, w, h, out.data() + 1, row_bytes);  // at an odd address
  EXPECT_EQ(out[0], std::byte{0xEE});
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      for (std::size_t c = 0; c < channels; ++c) {
        Channel value;
        const std::size_t index = static_cast<std::size_t>(y * w + x) * channels + c;
        std::memcpy(&value, out.data() + 1 + index * sizeof(Channel), sizeof value);
        ASSERT_EQ(value, value_of<Channel>(x0 + x, y0 + y, order[c])) << x << ' ' << y << ' ' << c;
      }
    }
  }
}

class PackedColor : public ::testing::TestWithParam<std::array<int, 2>> {};

TEST_P(PackedColor, HasItsChannelsInTheOrderOfItsName) {
  const auto [x, y] = GetParam();
  expect_order<std::uint8_t>(PackedLayout::rgba8, {0, 1, 2, 3}, x, y);
  expect_order<std::uint8_t>(PackedLayout::bgra8, {2, 1, 0, 3}, x, y);
  expect_order<std::uint8_t>(PackedLayout::argb8, {3, 0, 1, 2}, x, y);
  expect_order<std::uint8_t>(PackedLayout::rgb8, {0, 1, 2}, x, y);
  expect_order<std::uint8_t>(PackedLayout::bgr8, {2, 1, 0}, x, y);
  expect_order<std::uint16_t>(PackedLayout::rgba16, {0, 1, 2, 3}, x, y);
  expect_order<std::uint16_t>(PackedLayout::rgb16, {0, 1, 2}, x, y);
  expect_order<std::uint16_t>(PackedLayout::bgr16, {2, 1, 0}, x, y);
  expect_order<float>(PackedLayout::rgba32f, {0, 1, 2, 3}, x, y);
  expect_order<float>(PackedLayout::rgb32f, {0, 1, 2}, x, y);
  expect_order<float>(PackedLayout::bgr32f, {2, 1, 0}, x, y);
}

INSTANTIATE_TEST_SUITE_P(Origins, PackedColor,
                         ::testing::Values(std::array{0, 0}, std::array{3, 5}, std::array{8, 8}, std::array{28, 10}));

TEST(PackedColor565, HoldsTheNearest) {
  const Framebuffer target = filled<std::uint8_t>(ColorFormat::rgba8);
  std::vector<std::uint16_t> out(width * height);
  const auto nearest = [](int value, int most) { return static_cast<int>(std::lround(value * most / 255.0)); };
  pack_color_rows(target, PackedLayout::rgb565, 0, 0, width, height, reinterpret_cast<std::byte*>(out.data()),
                  width * 2);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int red = value_of<std::uint8_t>(x, y, 0), green = value_of<std::uint8_t>(x, y, 1),
                blue = value_of<std::uint8_t>(x, y, 2);
      ASSERT_EQ(out[static_cast<std::size_t>(y * width + x)], nearest(red, 31) * 2048 + nearest(green, 63) * 32 + nearest(blue, 31));
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
