// The program's buffer and the depth buffer: what is written to them, and when (OSMESA-ABI.md, MESA-RULES 10).
//
// Pictures are painted with scissored clears alone.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "api/osmesa/testing/drivers.h"

namespace gouraud::api::testing {
namespace {

constexpr std::uint32_t untouched = 0xEEEEEEEE, red = 0xFF0000FF, green = 0xFF00FF00;

class Buffer : public BothDrivers {
 protected:
  static constexpr int width = 11, height = 9;
  using Picture = std::vector<std::uint32_t>;
  static Picture blank(int pixels = width * height) { return Picture(static_cast<std::size_t>(pixels), untouched); }

  bool bind(const OwnedContext& context, void* pixels, GLenum type = GL_UNSIGNED_BYTE, int w = width, int h = height) {
    return driver.MakeCurrent(context.get(), pixels, type, w, h) == GL_TRUE;
  }
  void clear(float r, float g, float b, float a = 1.0f) {
    gl.ClearColor(r, g, b, a);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
  void clear_pixel(int x, int y, float r, float g, float b) {
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(x, y, 1, 1);
    clear(r, g, b);
    gl.Disable(GL_SCISSOR_TEST);
  }
};

// Clears with one channel after the other at its maximum and looks for it in the first and the last pixel.
template <class Channel>
void expect_order(const Driver& driver, GLenum format, GLenum type, std::vector<int> order) {
  SCOPED_TRACE(::testing::Message() << "format " << format << " type " << type);
  constexpr int w = 11, h = 3;
  const OwnedContext context = make_context(driver, format);
  const std::size_t channels = order.size();
  std::vector<Channel> picture(w * h * channels + 1, Channel{77});
  ASSERT_TRUE(driver.MakeCurrent(context.get(), picture.data(), type, w, h));
  const Channel full = std::numeric_limits<Channel>::is_integer ? std::numeric_limits<Channel>::max() : Channel{1};
  for (int lit = 0; lit < 4; ++lit) {
    driver.gl.ClearColor(lit == 0, lit == 1, lit == 2, lit == 3);
    driver.gl.Clear(GL_COLOR_BUFFER_BIT);
    driver.gl.Finish();
    for (std::size_t c = 0; c < channels; ++c) {
      EXPECT_EQ(picture[c], order[c] == lit ? full : Channel{0}) << lit << ' ' << c;
      EXPECT_EQ(picture[(w * h - 1) * channels + c], order[c] == lit ? full : Channel{0}) << lit << ' ' << c;
    }
  }
  EXPECT_EQ(picture.back(), Channel{77});
}

TEST_P(Buffer, HasItsBytesInTheOrderOfTheFormat) {
  expect_order<std::uint8_t>(driver, OSMESA_RGBA, GL_UNSIGNED_BYTE, {0, 1, 2, 3});
  expect_order<std::uint8_t>(driver, OSMESA_BGRA, GL_UNSIGNED_BYTE, {2, 1, 0, 3});
  expect_order<std::uint8_t>(driver, OSMESA_ARGB, GL_UNSIGNED_BYTE, {3, 0, 1, 2});
  expect_order<std::uint8_t>(driver, OSMESA_RGB, GL_UNSIGNED_BYTE, {0, 1, 2});
}

TEST_P(Buffer, HasItsWordsAndFloatsInTheOrderRgba) {
  for (const GLenum format : {GLenum{OSMESA_RGBA}, GLenum{OSMESA_BGRA}, GLenum{OSMESA_ARGB}}) {
    expect_order<std::uint16_t>(driver, format, GL_UNSIGNED_SHORT, {0, 1, 2, 3});
    expect_order<float>(driver, format, GL_FLOAT, {0, 1, 2, 3});
  }
  expect_order<float>(driver, OSMESA_RGB, GL_FLOAT, {0, 1, 2});
}

TEST_P(Buffer, OfBytesHoldsTheNearestByte) {
  const OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear(0.5f / 255.0f, 1.5f / 255.0f, 0.5f, 2.0f);
  gl.Finish();
  EXPECT_EQ(picture[0], 0xFF800200u);
}

TEST_P(Buffer, ChangesAtFlushAndFinishAlone) {
  const OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear(1.0f, 0.0f, 0.0f);
  std::uint32_t pixel = 0;
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel, red);
  GLint ignored = 0;
  void* pointer = nullptr;
  driver.GetColorBuffer(context.get(), &ignored, &ignored, &ignored, &pointer);
  EXPECT_EQ(picture, blank());
  gl.Flush();
  EXPECT_EQ(picture, Picture(width * height, red));
  clear(0.0f, 1.0f, 0.0f);
  EXPECT_EQ(picture, Picture(width * height, red));
  gl.Finish();
  EXPECT_EQ(picture, Picture(width * height, green));
}

TEST_P(Buffer, ChangesWhenTheContextIsReleased) {
  const OwnedContext first = make_context(driver), second = make_context(driver);
  Picture picture = blank(), other = blank();
  ASSERT_TRUE(bind(first, picture.data()));
  clear(1.0f, 0.0f, 0.0f);
  ASSERT_TRUE(bind(second, other.data()));
  EXPECT_EQ(picture, Picture(width * height, red));
  EXPECT_EQ(other, blank());
  ASSERT_TRUE(bind(first, picture.data()));
  clear(0.0f, 1.0f, 0.0f);
  driver.MakeCurrent(nullptr, nullptr, 0, 0, 0);
  EXPECT_EQ(picture, Picture(width * height, green));
}

TEST_P(Buffer, IsLeftAloneByDestroyingTheContext) {
  OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear(1.0f, 0.0f, 0.0f);
  context.reset();
  EXPECT_EQ(picture, blank());
}

TEST_P(Buffer, StaysAsItIsWhereNothingIsDrawn) {
  const OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  gl.ClearColor(1.0f, 0.0f, 0.0f, 1.0f);
  gl.Finish();
  gl.Flush();
  EXPECT_EQ(picture, blank());
}

TEST_P(Buffer, BeginsAsZerosWhateverTheMemoryHolds) {
  const OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear_pixel(3, 4, 1.0f, 0.0f, 0.0f);
  gl.Finish();
  Picture expected(width * height, 0u);
  expected[4 * width + 3] = red;
  EXPECT_EQ(picture, expected);
}

TEST_P(Buffer, GetsTheWholePictureAfterRebinding) {
  const OwnedContext context = make_context(driver);
  Picture first = blank(), second = blank(), third = blank();
  ASSERT_TRUE(bind(context, first.data()));
  clear(1.0f, 0.0f, 0.0f);
  ASSERT_TRUE(bind(context, second.data()));
  EXPECT_EQ(first, blank());
  EXPECT_EQ(second, blank());
  gl.Finish();
  EXPECT_EQ(first, blank());
  EXPECT_EQ(second, Picture(width * height, red));

  ASSERT_TRUE(bind(context, third.data()));
  gl.Finish();
  EXPECT_EQ(third, blank());  // nothing was drawn since the last copy
  clear_pixel(0, 0, 0.0f, 1.0f, 0.0f);
  gl.Finish();
  EXPECT_EQ(third[0], green);
  EXPECT_EQ(third[1], red);
}

TEST_P(Buffer, OfAnotherSizeBeginsAnew) {
  const OwnedContext context = make_context(driver);
  Picture small = blank(), large = blank(16 * 16);
  ASSERT_TRUE(bind(context, small.data()));
  clear(1.0f, 0.0f, 0.0f);
  ASSERT_TRUE(bind(context, large.data(), GL_UNSIGNED_BYTE, 16, 16));
  gl.Finish();
  EXPECT_EQ(small, blank());
  EXPECT_EQ(large, blank(16 * 16));
  clear_pixel(15, 15, 0.0f, 1.0f, 0.0f);
  gl.Finish();
  Picture expected(16 * 16, 0u);
  expected.back() = green;
  EXPECT_EQ(large, expected);
}

TEST_P(Buffer, OfAnotherTypeBeginsAnew) {
  const OwnedContext context = make_context(driver);
  Picture bytes = blank();
  std::vector<float> floats(width * height * 4, 7.0f);
  ASSERT_TRUE(bind(context, bytes.data()));
  clear(1.0f, 0.0f, 0.0f);
  ASSERT_TRUE(bind(context, floats.data(), GL_FLOAT));
  gl.Finish();
  EXPECT_EQ(floats[0], 7.0f);
  clear_pixel(1, 0, 0.0f, 0.25f, 0.0f);
  gl.Finish();
  EXPECT_EQ(floats[0], 0.0f);
  EXPECT_EQ(floats[5], 0.25f);
}

TEST_P(Buffer, RunsFromBottomToTopUnlessYUpIsOff) {
  const OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear_pixel(2, 0, 1.0f, 0.0f, 0.0f);
  gl.Finish();
  EXPECT_EQ(picture[2], red);
  driver.PixelStore(OSMESA_Y_UP, 0);
  gl.Finish();
  EXPECT_EQ(picture[2], red);  // acts at the next copy
  clear_pixel(3, 0, 1.0f, 0.0f, 0.0f);
  gl.Finish();
  EXPECT_EQ(picture[2], 0u);
  EXPECT_EQ(picture[(height - 1) * width + 2], red);
  EXPECT_EQ(picture[(height - 1) * width + 3], red);
}

TEST_P(Buffer, HasRowsOfTheRowLength) {
  constexpr int row = width + 5;
  for (const int y_up : {1, 0}) {
    const OwnedContext context = make_context(driver);
    Picture picture = blank(row * height);
    ASSERT_TRUE(bind(context, picture.data()));
    driver.PixelStore(OSMESA_ROW_LENGTH, row);
    driver.PixelStore(OSMESA_Y_UP, y_up);
    clear(1.0f, 0.0f, 0.0f);
    gl.Finish();
    for (std::size_t i = 0; i < picture.size(); ++i) {
      ASSERT_EQ(picture[i], i % row < width ? red : untouched) << i << ' ' << y_up;
    }
  }
}

TEST_P(Buffer, OfEverySizeIsFilledExactly) {
  const OwnedContext context = make_context(driver);
  for (const auto [w, h] :
       {std::array{1, 1}, std::array{7, 9}, std::array{64, 64}, std::array{65, 63}, std::array{131, 66}}) {
    Picture picture = blank(w * h + 1);
    ASSERT_TRUE(bind(context, picture.data(), GL_UNSIGNED_BYTE, w, h));
    clear(1.0f, 0.0f, 0.0f);
    clear_pixel(w - 1, h - 1, 0.0f, 1.0f, 0.0f);
    gl.Finish();
    Picture expected(static_cast<std::size_t>(w * h), red);
    expected.back() = green;
    expected.push_back(untouched);
    ASSERT_EQ(picture, expected) << w << ' ' << h;
  }
}

GOURAUD_ON_BOTH_DRIVERS(Buffer);

class DepthBuffer : public Buffer {
 protected:
  struct Found {
    GLboolean result = GL_FALSE;
    GLint width = -1, height = -1, bytes = -1;
    void* values = nullptr;
    template <class Value>
    Value at(int x, int y) const {
      Value value;
      std::memcpy(&value,
                  static_cast<const std::byte*>(values) + static_cast<std::size_t>(y * width + x) * sizeof value,
                  sizeof value);
      return value;
    }
  };
  Found find(const OwnedContext& context) const {
    Found found;
    found.result = driver.GetDepthBuffer(context.get(), &found.width, &found.height, &found.bytes, &found.values);
    return found;
  }
  void clear_depth(double depth) {
    gl.ClearDepth(depth);
    gl.Clear(GL_DEPTH_BUFFER_BIT);
  }
};

TEST_P(DepthBuffer, DoesNotExistWithoutDepthBits) {
  const OwnedContext context = make_context(driver, OSMESA_RGBA, 0, 0);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  const Found found = find(context);
  EXPECT_FALSE(found.result);
  EXPECT_EQ(found.width, 0);
  EXPECT_EQ(found.height, 0);
  EXPECT_EQ(found.bytes, 0);
  EXPECT_EQ(found.values, nullptr);
}

TEST_P(DepthBuffer, Of16BitsIsGivenAsWords) {
  const OwnedContext context = make_context(driver, OSMESA_RGBA, 16, 0);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear_depth(1.0);
  const Found found = find(context);
  ASSERT_TRUE(found.result);
  EXPECT_EQ(found.bytes, 2);
  EXPECT_EQ(found.at<std::uint16_t>(width - 1, height - 1), 0xFFFF);
}

TEST_P(DepthBuffer, Of24BitsIsGivenInTheLowBitsWithTheStencilAbove) {
  const OwnedContext context = make_context(driver, OSMESA_RGBA, 24, 8);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  gl.ClearStencil(0xAB);
  gl.ClearDepth(0.5);
  gl.Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  const Found found = find(context);
  ASSERT_TRUE(found.result);
  EXPECT_EQ(found.width, width);
  EXPECT_EQ(found.height, height);
  EXPECT_EQ(found.bytes, 4);
  EXPECT_EQ(found.at<std::uint32_t>(0, 0), 0xAB800000u);
}

TEST_P(DepthBuffer, IsRefreshedAtEveryCopyAndNotBefore) {
  const OwnedContext context = make_context(driver, OSMESA_RGBA, 24, 0);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear_depth(0.5);
  const Found found = find(context);
  EXPECT_EQ(found.at<std::uint32_t>(0, 0) & 0xFFFFFFu, 0x800000u);
  clear_depth(1.0);
  EXPECT_EQ(find(context).values, found.values);
  EXPECT_EQ(found.at<std::uint32_t>(0, 0) & 0xFFFFFFu, 0x800000u);
  gl.Finish();
  EXPECT_EQ(found.at<std::uint32_t>(0, 0) & 0xFFFFFFu, 0xFFFFFFu);
}

TEST_P(DepthBuffer, RunsFromBottomToTopWhateverYUpSays) {
  for (const int y_up : {1, 0}) {
    const OwnedContext context = make_context(driver, OSMESA_RGBA, 24, 0);
    Picture picture = blank();
    ASSERT_TRUE(bind(context, picture.data()));
    driver.PixelStore(OSMESA_Y_UP, y_up);
    gl.Enable(GL_SCISSOR_TEST);
    gl.Scissor(4, 1, 1, 1);
    clear_depth(1.0);
    gl.Finish();
    const Found found = find(context);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        ASSERT_EQ(found.at<std::uint32_t>(x, y) & 0xFFFFFFu, x == 4 && y == 1 ? 0xFFFFFFu : 0u) << x << ' ' << y;
      }
    }
  }
}

TEST_P(DepthBuffer, ChangingAloneCopiesTheColorsToo) {
  const OwnedContext context = make_context(driver);
  Picture picture = blank();
  ASSERT_TRUE(bind(context, picture.data()));
  clear_depth(0.25);
  gl.Finish();
  EXPECT_EQ(picture, Picture(width * height, 0u));
}

GOURAUD_ON_BOTH_DRIVERS(DepthBuffer);

template <class Word>
void expect_opaque(const Driver& driver, GLenum format, GLenum type) {
  const OwnedContext context = make_context(driver, format);
  const GlTable& gl = driver.gl;
  std::array<Word, 4> buffer{};
  ASSERT_TRUE(driver.MakeCurrent(context.get(), buffer.data(), type, 1, 1));
  const auto alpha = [&] {
    GLfloat rgba[4] = {};
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, rgba);
    return rgba[3];
  };
  EXPECT_EQ(alpha(), 1.0f);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  EXPECT_EQ(alpha(), 1.0f);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_DST_ALPHA, GL_ZERO);
  gl.Color4f(1, 1, 1, 0.25f);
  gl.Rectf(-1, -1, 1, 1);
  gl.Rectf(-1, -1, 1, 1);
  GLubyte rgba[4] = {};
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  EXPECT_EQ((std::array{rgba[0], rgba[1], rgba[2], rgba[3]}), (std::array<GLubyte, 4>{255, 255, 255, 255}));
}

// [GL1.5 §4.1.8, §4.3.2]
TEST_P(Buffer, WithoutAlphaIsOpaque) {
  expect_opaque<std::uint8_t>(driver, OSMESA_RGB, GL_UNSIGNED_BYTE);
  expect_opaque<float>(driver, OSMESA_RGB, GL_FLOAT);
  expect_opaque<std::uint16_t>(driver, OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5);
}

TEST_P(Buffer, HasTheBitsOfItsFormat) {
  struct Row {
    GLenum format, type;
    std::array<GLint, 4> bits;
  };
  for (const Row& row : {Row{OSMESA_RGBA, GL_UNSIGNED_BYTE, {8, 8, 8, 8}}, Row{OSMESA_ARGB, GL_UNSIGNED_SHORT, {16, 16, 16, 16}},
                         Row{OSMESA_RGB, GL_UNSIGNED_BYTE, {8, 8, 8, 0}}, Row{OSMESA_RGB, GL_FLOAT, {32, 32, 32, 0}},
                         Row{OSMESA_RGB_565, GL_UNSIGNED_SHORT_5_6_5, {5, 6, 5, 0}}}) {
    const OwnedContext context = make_context(driver, row.format);
    std::array<float, 4> buffer{};
    ASSERT_TRUE(driver.MakeCurrent(context.get(), buffer.data(), row.type, 1, 1));
    std::array<GLint, 4> bits{};
    const GLenum names[] = {GL_RED_BITS, GL_GREEN_BITS, GL_BLUE_BITS, GL_ALPHA_BITS};
    for (std::size_t i = 0; i < 4; ++i) gl.GetIntegerv(names[i], &bits[i]);
    EXPECT_EQ(bits, row.bits) << row.format << ' ' << row.type;
  }
}

// Where we differ from Mesa on purpose.

// Of what is drawn and of what is cleared [GL1.5 §2.14.9].
TEST(OurBuffer, Of565HoldsTheNearestFiveAndSixBits) {
  const OwnedContext context = make_context(ours(), OSMESA_RGB_565);
  const GlTable& gl = ours().gl;
  std::uint16_t pixel = 0;
  ASSERT_TRUE(ours().MakeCurrent(context.get(), &pixel, GL_UNSIGNED_SHORT_5_6_5, 1, 1));
  for (int value = 0; value < 256; ++value) {
    const double level = value / 255.0;
    const int five = static_cast<int>(std::lround(level * 31)), six = static_cast<int>(std::lround(level * 63));
    const auto byte = static_cast<GLubyte>(value);
    gl.Color3ub(byte, byte, byte);
    gl.Rectf(-1, -1, 1, 1);
    gl.Finish();
    EXPECT_EQ(pixel, five << 11 | six << 5 | five) << value;
    pixel = 0;
    const auto clear_value = static_cast<float>(level);
    gl.ClearColor(clear_value, clear_value, clear_value, 0.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    gl.Finish();
    EXPECT_EQ(pixel, five << 11 | six << 5 | five) << value;
  }
}

TEST(OurBuffer, OfRgbWordsAndOfBgrIsFilled) {
  expect_order<std::uint16_t>(ours(), OSMESA_RGB, GL_UNSIGNED_SHORT, {0, 1, 2});
  expect_order<std::uint8_t>(ours(), OSMESA_BGR, GL_UNSIGNED_BYTE, {2, 1, 0});
  expect_order<std::uint16_t>(ours(), OSMESA_BGR, GL_UNSIGNED_SHORT, {2, 1, 0});
  expect_order<float>(ours(), OSMESA_BGR, GL_FLOAT, {2, 1, 0});
}

TEST(OurBuffer, IsLeftAloneByReadPixels) {
  const OwnedContext context = make_context(ours());
  std::uint32_t picture = untouched, pixel = 0;
  ours().MakeCurrent(context.get(), &picture, GL_UNSIGNED_BYTE, 1, 1);
  ours().gl.Clear(GL_COLOR_BUFFER_BIT);
  ours().gl.Finish();
  picture = untouched;
  ours().gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  ours().gl.Finish();
  EXPECT_EQ(picture, untouched);  // Mesa copies once more
}

TEST(OurBuffer, IgnoresNegativeRowLengths) {
  const OwnedContext context = make_context(ours());
  std::uint32_t picture = untouched;
  ours().MakeCurrent(context.get(), &picture, GL_UNSIGNED_BYTE, 1, 1);
  ours().PixelStore(OSMESA_ROW_LENGTH, -5);
  GLint row_length = -1;
  ours().GetIntegerv(OSMESA_ROW_LENGTH, &row_length);
  EXPECT_EQ(row_length, 0);
}

// Mesa keeps the memory of the first size.
TEST(OurDepthBuffer, HasTheNewSizeAfterResizing) {
  const OwnedContext context = make_context(ours());
  std::vector<std::uint32_t> picture(128 * 128);
  GLint width = 0, height = 0, bytes = 0;
  void* values = nullptr;
  for (const int side : {8, 128, 3}) {
    ASSERT_TRUE(ours().MakeCurrent(context.get(), picture.data(), GL_UNSIGNED_BYTE, side, side));
    ours().gl.ClearDepth(side == 128 ? 1.0 : 0.0);
    ours().gl.Clear(GL_DEPTH_BUFFER_BIT);
    ours().gl.Finish();
    ASSERT_TRUE(ours().GetDepthBuffer(context.get(), &width, &height, &bytes, &values));
    EXPECT_EQ(width, side);
    EXPECT_EQ(height, side);
    std::uint32_t last = 0;
    std::memcpy(&last, static_cast<const std::byte*>(values) + (side * side - 1) * 4, 4);
    EXPECT_EQ(last & 0xFFFFFFu, side == 128 ? 0xFFFFFFu : 0u);
  }
}

TEST(OurDepthBuffer, Of32BitsIsGivenInFixedPoint) {
  const OwnedContext context = make_context(ours(), OSMESA_RGBA, 32, 0);
  std::uint32_t picture = 0;
  ours().MakeCurrent(context.get(), &picture, GL_UNSIGNED_BYTE, 1, 1);
  GLint width = 0, height = 0, bytes = 0;
  void* values = nullptr;
  for (const auto& [depth, expected] : {std::pair{0.0, 0u}, std::pair{0.5, 0x80000000u}, std::pair{1.0, 0xFFFFFFFFu}}) {
    ours().gl.ClearDepth(depth);
    ours().gl.Clear(GL_DEPTH_BUFFER_BIT);
    ours().gl.Finish();
    ASSERT_TRUE(ours().GetDepthBuffer(context.get(), &width, &height, &bytes, &values));
    EXPECT_EQ(bytes, 4);
    EXPECT_EQ(*static_cast<const std::uint32_t*>(values), expected);
  }
}

}  // namespace
}  // namespace gouraud::api::testing
