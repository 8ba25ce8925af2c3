// Blits: colours scaled, flipped, filtered and converted; depth and stencil; scissor, clipping, errors
// [ARB_framebuffer_object].
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

void attach(GLenum point, GLenum format, GLsizei width, GLsizei height, GLsizei samples = 0) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
}

/// A framebuffer of these formats, bound for drawing and reading.
GLuint framebuffer(GLsizei width, GLsizei height, GLenum color = GL_RGBA8, GLenum depth_stencil = GL_DEPTH24_STENCIL8,
                   GLsizei samples = 0) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  attach(GL_COLOR_ATTACHMENT0, color, width, height, samples);
  attach(GL_DEPTH_STENCIL_ATTACHMENT, depth_stencil, width, height, samples);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
  return name;
}

std::uint32_t pixel(int x, int y) {
  std::uint32_t rgba = 0;
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &rgba);
  return rgba;
}

void fill(int x, int y, int width, int height, float r, float g, float b) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, width, height);
  glClearColor(r, g, b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

/// 2x2 pixels: red and green below, blue and white above.
void four_colors() {
  fill(0, 0, 1, 1, 1, 0, 0);
  fill(1, 0, 1, 1, 0, 1, 0);
  fill(0, 1, 1, 1, 0, 0, 1);
  fill(1, 1, 1, 1, 1, 1, 1);
}

void to_window() { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0); }
void read_window() { glBindFramebuffer(GL_READ_FRAMEBUFFER, 0); }

constexpr std::uint32_t red = 0xFF0000FF, green = 0xFF00FF00, blue = 0xFFFF0000, white = 0xFFFFFFFF;

TEST(BlitFramebuffer, Scales) {
  const Screen screen;
  framebuffer(2, 2);
  four_colors();
  to_window();
  glBlitFramebuffer(0, 0, 2, 2, 1, 2, 13, 22, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  read_window();
  EXPECT_EQ(pixel(0, 2), 0u);
  EXPECT_EQ(pixel(1, 2), red);
  EXPECT_EQ(pixel(6, 11), red);
  EXPECT_EQ(pixel(7, 11), green);
  EXPECT_EQ(pixel(6, 12), blue);
  EXPECT_EQ(pixel(12, 21), white);
  EXPECT_EQ(pixel(13, 21), 0u);
  EXPECT_EQ(pixel(12, 22), 0u);
}

TEST(BlitFramebuffer, Flips) {
  const Screen screen;
  framebuffer(2, 2);
  four_colors();
  to_window();
  glBlitFramebuffer(2, 0, 0, 2, 0, 2, 2, 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  read_window();
  EXPECT_EQ(pixel(0, 0), white);
  EXPECT_EQ(pixel(1, 0), blue);
  EXPECT_EQ(pixel(0, 1), green);
  EXPECT_EQ(pixel(1, 1), red);
}

TEST(BlitFramebuffer, Interpolates) {
  const Screen screen;
  framebuffer(2, 1);
  fill(0, 0, 1, 1, 0, 0, 0);
  fill(1, 0, 1, 1, 1, 1, 1);
  to_window();
  glBlitFramebuffer(0, 0, 2, 1, 0, 0, 8, 1, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  read_window();
  const int expected[8] = {0, 0, 32, 96, 159, 223, 255, 255};
  for (int x = 0; x < 8; ++x) EXPECT_EQ(static_cast<int>(pixel(x, 0) & 0xFF), expected[x]) << x;
}

TEST(BlitFramebuffer, StaysInsideScissorAndBothFramebuffers) {
  const Screen screen;
  framebuffer(4, 4);
  fill(0, 0, 4, 4, 1, 0, 0);
  to_window();
  glEnable(GL_SCISSOR_TEST);
  glScissor(3, 3, 4, 100);
  glBlitFramebuffer(-2, -2, 100, 100, 0, 0, 102, 102, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  read_window();
  for (int y = 0; y < side_px; ++y) {
    for (int x = 0; x < side_px; ++x) {
      const bool written = x >= 3 && x < 6 && y >= 3 && y < 6;
      ASSERT_EQ(pixel(x, y), written ? red : 0u) << x << " " << y;
    }
  }
}

TEST(BlitFramebuffer, ExtremeRectanglesAreHarmless) {
  const Screen screen;
  framebuffer(4, 4);
  to_window();
  constexpr GLint most = 2147483647, least = -2147483647 - 1;
  for (const GLenum filter : {GL_NEAREST, GL_LINEAR}) {
    glBlitFramebuffer(least, least, most, most, least, least, most, most, GL_COLOR_BUFFER_BIT, filter);
    glBlitFramebuffer(most, 0, least, 4, 0, most, 4, least, GL_COLOR_BUFFER_BIT, filter);
    glBlitFramebuffer(0, 0, 0, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, filter);
    glBlitFramebuffer(0, 0, 4, 4, 7, 7, 7, 9, GL_COLOR_BUFFER_BIT, filter);
    glBlitFramebuffer(most - 1, most - 1, most, most, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, filter);
  }
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(BlitFramebuffer, ConvertsFormatsAndKeepsAbsentChannels) {
  const Screen screen;
  const GLuint from = framebuffer(4, 4, GL_RGBA16);
  glClearColor(0.5f, 0.25f, 1, 0.5f);
  glClear(GL_COLOR_BUFFER_BIT);
  framebuffer(4, 4, GL_RGB8);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from + 1);
  EXPECT_EQ(pixel(3, 3), 0xFFFF4080u);
  glBlitFramebuffer(0, 0, 2, 2, 2, 2, 4, 4, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  EXPECT_EQ(pixel(3, 3), 0xFFFF4080u);
}

TEST(BlitFramebuffer, CopiesDepthAndStencilApart) {
  const Screen screen;
  framebuffer(8, 8);
  glClearDepth(0.25);
  glClearStencil(0x5A);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  to_window();
  glClearDepth(1);
  glClearStencil(0x11);
  glClear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBlitFramebuffer(0, 0, 8, 8, 8, 0, 16, 8, GL_STENCIL_BUFFER_BIT, GL_NEAREST);
  read_window();
  float depth[2] = {};
  std::uint8_t stencil[2] = {};
  glReadPixels(7, 7, 2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, depth);
  glReadPixels(7, 7, 2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil);
  EXPECT_NEAR(depth[0], 0.25, 1e-7);
  EXPECT_EQ(depth[1], 1.0f);
  EXPECT_EQ(stencil[0], 0x11);
  EXPECT_EQ(stencil[1], 0x5A);
}

TEST(BlitFramebuffer, ResolvesAndSpreadsSamples) {
  const Screen screen;
  const GLuint single = framebuffer(8, 8);
  four_colors();
  const GLuint multiple = framebuffer(8, 8, GL_RGBA8, GL_DEPTH24_STENCIL8, 4);
  EXPECT_EQ(pixel(0, 0), 0u);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION) << "a multisampled picture is read";
  glBindFramebuffer(GL_READ_FRAMEBUFFER, single);
  glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multiple);
  to_window();
  glBlitFramebuffer(0, 0, 8, 8, 0, 0, 8, 8, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  read_window();
  EXPECT_EQ(pixel(0, 0), red);
  EXPECT_EQ(pixel(1, 1), white);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multiple);
  glBlitFramebuffer(0, 0, 8, 8, 0, 0, 16, 8, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  EXPECT_EQ(glGetError(), GL_INVALID_OPERATION);
}

TEST(BlitFramebuffer, ErrorsChangeNothing) {
  const Screen screen;
  framebuffer(4, 4, GL_RGBA8, GL_DEPTH32F_STENCIL8);
  fill(0, 0, 4, 4, 1, 0, 0);
  to_window();
  const auto error_of = [](GLbitfield mask, GLenum filter) {
    glBlitFramebuffer(0, 0, 4, 4, 0, 0, 4, 4, mask, filter);
    return glGetError();
  };
  EXPECT_EQ(error_of(GL_ACCUM_BUFFER_BIT | GL_COLOR_BUFFER_BIT, GL_NEAREST), GL_INVALID_VALUE);
  EXPECT_EQ(error_of(GL_COLOR_BUFFER_BIT, GL_REPEAT), GL_INVALID_ENUM);
  EXPECT_EQ(error_of(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT, GL_LINEAR), GL_INVALID_OPERATION);
  EXPECT_EQ(error_of(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST), GL_INVALID_OPERATION);
  GLuint empty = 0;
  glGenFramebuffers(1, &empty);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, empty);
  EXPECT_EQ(error_of(GL_COLOR_BUFFER_BIT, GL_NEAREST), GL_INVALID_FRAMEBUFFER_OPERATION);
  read_window();
  EXPECT_EQ(pixel(0, 0), 0u);
}

}  // namespace
}  // namespace gouraud::api
