#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "api/osmesa/testing/drivers.h"

namespace gouraud::api::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

class ReadPixels : public BothDrivers {
 protected:
  static constexpr int width = 13, height = 10;

  void SetUp() override { bind(24, 8); }
  void TearDown() override {
    EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
    context.reset();
    BothDrivers::TearDown();
  }
  void bind(int depth_bits, int stencil_bits, GLenum type = GL_UNSIGNED_BYTE) {
    context = make_context(driver, OSMESA_RGBA, depth_bits, stencil_bits);
    ASSERT_TRUE(driver.MakeCurrent(context.get(), buffer.data(), type, width, height));
    gl.Enable(GL_SCISSOR_TEST);
  }
  // Red and green tell the pixel.
  void number_pixels() {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) clear_pixel(x, y, x, y, 30, 40);
    }
  }
  void clear_pixel(int x, int y, int r, int g, int b, int a) {
    const auto component = [](int byte) { return static_cast<float>(byte) / 255.0f; };
    gl.Scissor(x, y, 1, 1);
    gl.ClearColor(component(r), component(g), component(b), component(a));
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  Bytes read(int x, int y, int w, int h, GLenum format, GLenum type, std::size_t size) {
    Bytes out(size, 0xEE);
    gl.ReadPixels(x, y, w, h, format, type, out.data());
    return out;
  }
  template <class Value>
  Value read_one(GLenum format, GLenum type) {
    Value value{};
    gl.ReadPixels(0, 0, 1, 1, format, type, &value);
    return value;
  }

  std::vector<float> buffer = std::vector<float>(width * height * 4);
  OwnedContext context;
};

TEST_P(ReadPixels, GivesTheElementsOfEveryFormatInOrder) {
  clear_pixel(0, 0, 10, 20, 30, 40);
  struct Row {
    GLenum format;
    Bytes elements;
  };
  for (const Row& row : {Row{GL_RGBA, {10, 20, 30, 40}}, Row{GL_BGRA, {30, 20, 10, 40}}, Row{GL_RGB, {10, 20, 30}},
                         Row{GL_BGR, {30, 20, 10}}, Row{GL_RED, {10}}, Row{GL_RG, {10, 20}}, Row{GL_GREEN, {20}}, Row{GL_BLUE, {30}},
                         Row{GL_ALPHA, {40}}, Row{GL_LUMINANCE, {60}}, Row{GL_LUMINANCE_ALPHA, {60, 40}}}) {
    Bytes expected = row.elements;
    expected.push_back(0xEE);
    EXPECT_EQ(read(0, 0, 1, 1, row.format, GL_UNSIGNED_BYTE, expected.size()), expected) << row.format;
    std::vector<float> floats(row.elements.size());
    gl.ReadPixels(0, 0, 1, 1, row.format, GL_FLOAT, floats.data());
    for (std::size_t i = 0; i < floats.size(); ++i) {
      EXPECT_NEAR(floats[i], static_cast<float>(row.elements[i]) / 255.0f, 1e-6f) << row.format;
    }
  }
}

TEST_P(ReadPixels, AsFloatMultipliesBytesWithTheReciprocal) {
  for (int value = 0; value < 256; ++value) {
    clear_pixel(0, 0, value, 0, 0, 0);
    EXPECT_EQ(read_one<float>(GL_RED, GL_FLOAT), static_cast<float>(value) * (1.0f / 255.0f)) << value;
  }
}

TEST_P(ReadPixels, ClampsLuminance) {
  clear_pixel(0, 0, 200, 100, 50, 0);
  EXPECT_EQ(read_one<std::uint8_t>(GL_LUMINANCE, GL_UNSIGNED_BYTE), 255);
  EXPECT_EQ(read_one<float>(GL_LUMINANCE, GL_FLOAT), 1.0f);
}

TEST_P(ReadPixels, SeesWhatWasDrawnWithoutFlush) {
  clear_pixel(0, 0, 1, 2, 3, 4);
  EXPECT_EQ(read(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 4), (Bytes{1, 2, 3, 4}));
  clear_pixel(0, 0, 5, 6, 7, 8);
  EXPECT_EQ(read(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 4), (Bytes{5, 6, 7, 8}));
}

TEST_P(ReadPixels, GivesTheRectangleBottomUp) {
  number_pixels();
  for (const GLenum format : {GL_RGBA, GL_LUMINANCE_ALPHA}) {  // at once, and by way of elements
    const int elements = format == GL_RGBA ? 4 : 2;
    const Bytes out = read(3, 2, 9, 7, format, GL_UNSIGNED_BYTE, static_cast<std::size_t>(9 * 7 * 4));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    const Bytes tight = read(3, 2, 9, 7, format, GL_UNSIGNED_BYTE, static_cast<std::size_t>(9 * 7 * elements));
    for (int j = 0; j < 7; ++j) {
      for (int i = 0; i < 9; ++i) {
        const std::size_t at = static_cast<std::size_t>((j * 9 + i) * elements);
        const int first = format == GL_RGBA ? 3 + i : 3 + i + 2 + j + 30;
        ASSERT_EQ(tight[at], first) << i << ' ' << j;
      }
    }
    gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
    if (format == GL_RGBA) {
      EXPECT_EQ(out, tight);
    }
  }
}

TEST_P(ReadPixels, LeavesPixelsOutsideTheTargetAsTheyAre) {
  number_pixels();
  for (const GLenum format : {GL_RGBA, GL_DEPTH_COMPONENT}) {
    const GLenum type = format == GL_RGBA ? GL_UNSIGNED_BYTE : GL_UNSIGNED_INT;
    constexpr int margin = 3, w = width + 2 * margin, h = height + 2 * margin;
    std::vector<std::uint32_t> out(w * h, 0xEEEEEEEE);
    gl.ReadPixels(-margin, -margin, w, h, format, type, out.data());
    for (int j = 0; j < h; ++j) {
      for (int i = 0; i < w; ++i) {
        const bool inside = i >= margin && i < margin + width && j >= margin && j < margin + height;
        const int x = i - margin, y = j - margin;
        const auto pixel = static_cast<std::uint32_t>(x | y << 8 | 30 << 16 | 40 << 24);
        const std::uint32_t expected = !inside ? 0xEEEEEEEE : format == GL_RGBA ? pixel : 0;
        ASSERT_EQ(out[static_cast<std::size_t>(j * w + i)], expected) << i << ' ' << j;
      }
    }
  }
}

TEST_P(ReadPixels, OfAPlaceOutsideTheTargetWritesNothing) {
  const Bytes untouched(4, 0xEE);
  const auto expect_nothing = [&](int x, int y, int w, int h) {
    EXPECT_EQ(read(x, y, w, h, GL_RGBA, GL_UNSIGNED_BYTE, 4), untouched) << x << ' ' << y;
  };
  expect_nothing(width, 0, 1, 1);
  expect_nothing(0, height, 1, 1);
  expect_nothing(-1, 0, 1, 1);
  expect_nothing(0, -1, 1, 1);
  expect_nothing(0, 0, 0, 1);
  expect_nothing(0, 0, 1, 0);
  constexpr int most = std::numeric_limits<int>::max(), least = std::numeric_limits<int>::min();
  if (driver.is_ours) {  // Mesa's sums overflow
    expect_nothing(most, most, 1, 1);
    expect_nothing(most, 0, most, most);
    expect_nothing(least, least, 1, 1);
    expect_nothing(least, 0, most, most);
  }
}

TEST_P(ReadPixels, PlacesRowsByThePackParameters) {
  number_pixels();
  struct Row {
    int alignment, row_length, skip_pixels, skip_rows;
  };
  for (const Row& row : {Row{4, 0, 0, 0}, Row{1, 0, 0, 0}, Row{2, 0, 0, 0}, Row{8, 0, 0, 0}, Row{1, 7, 0, 0},
                         Row{4, 7, 2, 1}, Row{8, 3, 1, 2}}) {
    for (const GLenum format : {GL_RGB, GL_RED}) {
      gl.PixelStorei(GL_PACK_ALIGNMENT, row.alignment);
      gl.PixelStorei(GL_PACK_ROW_LENGTH, row.row_length);
      gl.PixelStorei(GL_PACK_SKIP_PIXELS, row.skip_pixels);
      gl.PixelStorei(GL_PACK_SKIP_ROWS, row.skip_rows);
      const int w = 5, h = 3, pixel = format == GL_RGB ? 3 : 1;
      const int length = (row.row_length > 0 ? row.row_length : w) * pixel;
      const int stride = (length + row.alignment - 1) / row.alignment * row.alignment;
      Bytes expected(256, 0xEE);
      for (int j = 0; j < h; ++j) {
        for (int i = 0; i < w; ++i) {
          const std::array<int, 3> color{1 + i, 2 + j, 30};
          for (int c = 0; c < pixel; ++c) {
            const int at = (j + row.skip_rows) * stride + (i + row.skip_pixels) * pixel + c;
            expected[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(color[static_cast<std::size_t>(c)]);
          }
        }
      }
      EXPECT_EQ(read(1, 2, w, h, format, GL_UNSIGNED_BYTE, 256), expected)
          << row.alignment << ' ' << row.row_length << ' ' << format;
    }
  }
}

TEST_P(ReadPixels, SwapsTheBytesOfEveryElement) {
  clear_pixel(0, 0, 255, 51, 0, 255);
  gl.ClearDepth(0.3);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  const auto expect_swapped = [&](GLenum format, GLenum type, std::size_t element, std::size_t size) {
    gl.PixelStorei(GL_PACK_SWAP_BYTES, GL_FALSE);
    Bytes expected = read(0, 0, 1, 1, format, type, size);
    for (std::size_t i = 0; i < size; i += element) std::reverse(&expected[i], &expected[i] + element);
    gl.PixelStorei(GL_PACK_SWAP_BYTES, GL_TRUE);
    EXPECT_EQ(read(0, 0, 1, 1, format, type, size), expected) << format << ' ' << type;
  };
  expect_swapped(GL_RGBA, GL_FLOAT, 4, 16);
  expect_swapped(GL_RGBA, GL_UNSIGNED_BYTE, 1, 4);
  if (driver.is_ours) expect_swapped(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, 4, 4);  // Mesa reads another value to swap
  expect_swapped(GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, 2, 2);
  expect_swapped(GL_DEPTH_COMPONENT, GL_FLOAT, 4, 4);
}

TEST_P(ReadPixels, GivesDepthInEveryType) {
  for (const double depth : {0.0, 0.3, 0.5, 0.999, 1.0}) {
    gl.Scissor(0, 0, width, height);
    gl.ClearDepth(depth);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    const auto z = static_cast<std::uint32_t>(std::lrint(depth * 16777215.0));
    const float window_z = static_cast<float>(z) / 16777215.0f;
    EXPECT_EQ(read_one<float>(GL_DEPTH_COMPONENT, GL_FLOAT), window_z);
    EXPECT_EQ(read_one<std::uint32_t>(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT), z << 8 | z >> 16);
    EXPECT_EQ(read_one<std::uint16_t>(GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT), std::lrint(window_z * 65535.0f));
    EXPECT_EQ(read_one<std::uint8_t>(GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE), static_cast<int>(window_z * 255.0f));
  }
}

TEST_P(ReadPixels, GivesSixteenBitDepthInEveryType) {
  bind(16, 0);
  for (const double depth : {0.0, 0.3, 1.0}) {
    gl.Scissor(0, 0, width, height);
    gl.ClearDepth(depth);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    const auto z = static_cast<std::uint32_t>(std::lrint(depth * 65535.0));
    EXPECT_FLOAT_EQ(read_one<float>(GL_DEPTH_COMPONENT, GL_FLOAT), static_cast<float>(z) / 65535.0f);
    EXPECT_EQ(read_one<std::uint32_t>(GL_DEPTH_COMPONENT, GL_UNSIGNED_INT), z << 16 | z);
    EXPECT_EQ(read_one<std::uint16_t>(GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT), z);
  }
}

TEST_P(ReadPixels, GivesStencil) {
  gl.Scissor(0, 0, width, height);
  gl.ClearStencil(0xAB);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  EXPECT_EQ(read(0, 0, 3, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, 4), (Bytes{0xAB, 0xAB, 0xAB, 0xEE}));
}

TEST_P(ReadPixels, OfAFloatTargetKeepsThePrecision) {
  bind(0, 0, GL_FLOAT);
  gl.Scissor(0, 0, 1, 1);
  gl.ClearColor(0.1f, 0.25f, 0.9f, 1.0f);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(read_one<float>(GL_RED, GL_FLOAT), 0.1f);
  EXPECT_EQ(read(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 4), (Bytes{26, 64, 230, 255}));
}

TEST_P(ReadPixels, RefusesWhatTheSpecificationRefuses) {
  const auto expect_error = [&](GLenum error, GLsizei w, GLsizei h, GLenum format, GLenum type) {
    EXPECT_EQ(read(0, 0, w, h, format, type, 64), Bytes(64, 0xEE)) << format << ' ' << type;
    EXPECT_EQ(gl.GetError(), error) << format << ' ' << type;
  };
  expect_error(GL_INVALID_VALUE, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
  expect_error(GL_INVALID_VALUE, 1, -1, GL_RGBA, GL_UNSIGNED_BYTE);
  expect_error(GL_INVALID_ENUM, 1, 1, 0, GL_UNSIGNED_BYTE);
  expect_error(GL_INVALID_ENUM, 1, 1, GL_RGBA, 0);
  expect_error(GL_INVALID_ENUM, 1, 1, GL_RGBA8, GL_UNSIGNED_BYTE);
  expect_error(GL_INVALID_ENUM, 1, 1, GL_RGBA, GL_BITMAP);
  expect_error(GL_INVALID_OPERATION, 1, 1, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5);
  expect_error(GL_INVALID_OPERATION, 1, 1, GL_RGB, GL_UNSIGNED_INT_8_8_8_8);
  expect_error(GL_INVALID_OPERATION, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE);
  bind(0, 0);
  expect_error(GL_INVALID_OPERATION, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT);
  expect_error(GL_INVALID_OPERATION, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE);
  gl.Begin(GL_POINTS);
  read(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 4);
  gl.End();
  EXPECT_EQ(gl.GetError(), GLenum{GL_INVALID_OPERATION});
}

GOURAUD_ON_BOTH_DRIVERS(ReadPixels);

TEST(OurReadPixels, IntoNothingDoesNothing) {
  const OwnedContext context = make_context(ours());
  std::uint32_t pixel = 0;
  ours().MakeCurrent(context.get(), &pixel, GL_UNSIGNED_BYTE, 1, 1);
  ours().gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(ours().gl.GetError(), GLenum{GL_NO_ERROR});
}

TEST(OurReadPixels, OfFloatDepthGivesFixedPointTypes) {
  const OwnedContext context = make_context(ours(), OSMESA_RGBA, 32, 0);
  std::uint32_t pixel = 0;
  ours().MakeCurrent(context.get(), &pixel, GL_UNSIGNED_BYTE, 1, 1);
  ours().gl.ClearDepth(0.75);
  ours().gl.Clear(GL_DEPTH_BUFFER_BIT);
  std::uint32_t fixed = 0;
  std::uint16_t word = 0;
  float depth = 0.0f;
  ours().gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, &fixed);
  ours().gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_SHORT, &word);
  ours().gl.ReadPixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  EXPECT_EQ(fixed, 0xBFFFFFFFu);
  EXPECT_EQ(word, 0xBFFF);
  EXPECT_EQ(depth, 0.75f);
}

}  // namespace
}  // namespace gouraud::api::testing
