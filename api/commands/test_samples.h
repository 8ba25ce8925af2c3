// For tests of samples: a multisampled framebuffer of a Screen's size, rectangles in pixels, and what single pixels hold.
#pragma once

#include <array>
#include <cstdint>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {

inline GLint integer(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}

/// A framebuffer object of `side_px` with 4 samples, bound.
inline void multisampled() {
  GLuint names[3] = {};
  glGenFramebuffers(1, &names[0]);
  glGenRenderbuffers(2, &names[1]);
  glBindFramebuffer(GL_FRAMEBUFFER, names[0]);
  const GLenum formats[2] = {GL_RGBA8, GL_DEPTH24_STENCIL8}, points[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, names[1 + i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, formats[i], side_px, side_px);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, points[i], GL_RENDERBUFFER, names[1 + i]);
  }
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE);
}

/// Copies the multisampled picture to the window, and binds that.
inline void resolve() {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, side_px, side_px, 0, 0, side_px, side_px, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

inline int red_at(int x, int y) {
  std::uint8_t rgba[4] = {};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  return rgba[0];
}

inline float depth_at(int x, int y) {
  float depth = -1;
  glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  return depth;
}

/// In pixels.
inline void rectangle(float x0, float y0, float x1, float y1, float z = 0) {
  const auto ndc = [](float pixel) { return pixel / (0.5f * side_px) - 1; };
  glBegin(GL_QUADS);
  glVertex3f(ndc(x0), ndc(y0), z);
  glVertex3f(ndc(x1), ndc(y0), z);
  glVertex3f(ndc(x1), ndc(y1), z);
  glVertex3f(ndc(x0), ndc(y1), z);
  glEnd();
}

inline std::array<std::uint8_t, 4> pixel_at(int x, int y) {
  std::array<std::uint8_t, 4> rgba{};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return rgba;
}

}  // namespace gouraud::api
