// The accumulation buffer: exact where programs count on it, clamped everywhere [GL1.5 §4.2.4].
#include "api/commands/accumulation.h"

#include <array>

#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

using Pixel = std::array<GLubyte, 4>;

struct AccumScreen {
  explicit AccumScreen(pipeline::ColorFormat format = pipeline::ColorFormat::rgba8) : context({24, 8, 16}, nullptr) {
    EXPECT_TRUE(context.set_window_size(70, 9, format));
    make_current(&context);
  }
  Context context;
};

void clear(int value) {
  const float v = static_cast<float>(value) / 255.0f;
  glClearColor(v, v, v, v);
  glClear(GL_COLOR_BUFFER_BIT);
}

void fill() {
  glBegin(GL_QUADS);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
}

Pixel pixel(int x = 66, int y = 7) {
  Pixel rgba{};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

TEST(Accum, LoadAndReturnGiveEveryByteBack) {
  for (const auto format : {pipeline::ColorFormat::rgba8, pipeline::ColorFormat::rgba16, pipeline::ColorFormat::rgba32f}) {
    AccumScreen screen(format);
    for (int value = 0; value < 256; ++value) {
      clear(value);
      glAccum(GL_LOAD, 1);
      clear(0);
      glAccum(GL_RETURN, 1);
      ASSERT_EQ(pixel()[0], value);
    }
  }
}

TEST(Accum, EqualPartsAddUpExactly) {
  AccumScreen screen;
  for (const int parts : {2, 3, 4, 8, 16, 100}) {
    for (int value = 0; value < 256; value += 5) {
      clear(value);
      glClear(GL_ACCUM_BUFFER_BIT);
      for (int i = 0; i < parts; ++i) glAccum(GL_ACCUM, 1.0f / static_cast<float>(parts));
      clear(0);
      glAccum(GL_RETURN, 1);
      ASSERT_EQ(pixel()[3], value) << parts;
    }
  }
}

TEST(Accum, ClampsAndNeverWraps) {
  AccumScreen screen;
  clear(255);
  glAccum(GL_LOAD, 1);
  glAccum(GL_ACCUM, 1);
  glAccum(GL_RETURN, 0.5f);
  EXPECT_EQ(pixel()[0], 128);
  glAccum(GL_ADD, -1);
  glAccum(GL_ADD, -1);
  glAccum(GL_ADD, -1);
  glAccum(GL_ADD, 1);
  glAccum(GL_RETURN, 1);
  EXPECT_EQ(pixel()[0], 0);
  glAccum(GL_ADD, 0.5f);
  glAccum(GL_MULT, -9);  // as -1
  glAccum(GL_RETURN, -1);
  EXPECT_EQ(pixel()[0], 128);
}

TEST(Accum, ReturnsUnderScissorAndColorMask) {
  AccumScreen screen;
  glClearAccum(1, 0.5f, -3, 1);
  glClear(GL_ACCUM_BUFFER_BIT);
  clear(51);
  glEnable(GL_SCISSOR_TEST);
  glScissor(63, 0, 2, 9);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
  glAccum(GL_RETURN, 1);
  EXPECT_EQ(pixel(62), (Pixel{51, 51, 51, 51}));
  EXPECT_EQ(pixel(63), (Pixel{255, 128, 0, 51}));
  EXPECT_EQ(pixel(64), (Pixel{255, 128, 0, 51}));
  EXPECT_EQ(pixel(65), (Pixel{51, 51, 51, 51}));
}

TEST(Accum, HappensInOrderWithDraws) {
  AccumScreen screen;
  clear(255);
  glAccum(GL_LOAD, 0.4f);
  clear(0);
  glColor4f(1, 0, 0, 1);
  fill();
  glAccum(GL_ACCUM, 0.6f);
  glColor4f(0, 1, 0, 1);
  fill();
  glAccum(GL_RETURN, 1);
  EXPECT_EQ(pixel(), (Pixel{255, 102, 102, 255}));
}

TEST(Accum, NeedsAnAccumulationBuffer) {
  Screen screen;
  GLint bits = 7;
  glGetIntegerv(GL_ACCUM_RED_BITS, &bits);
  EXPECT_EQ(bits, 0);
  glAccum(GL_LOAD, 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  glAccum(GL_ZERO, 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  glClear(GL_ACCUM_BUFFER_BIT);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace gouraud::api
