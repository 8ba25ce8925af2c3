// Multisampled framebuffer objects [GL1.5 §3.2.1, §4.1.3] and clip control [ARB_clip_control].
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

GLint integer(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}

/// A framebuffer object of `side_px` with 4 samples, bound.
void multisampled() {
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
void resolve() {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, side_px, side_px, 0, 0, side_px, side_px, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

int red_at(int x, int y) {
  std::uint8_t rgba[4] = {};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  return rgba[0];
}

float depth_at(int x, int y) {
  float depth = -1;
  glReadPixels(x, y, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  return depth;
}

/// In pixels.
void rectangle(float x0, float y0, float x1, float y1, float z = 0) {
  const auto ndc = [](float pixel) { return pixel / (0.5f * side_px) - 1; };
  glBegin(GL_QUADS);
  glVertex3f(ndc(x0), ndc(y0), z);
  glVertex3f(ndc(x1), ndc(y0), z);
  glVertex3f(ndc(x1), ndc(y1), z);
  glVertex3f(ndc(x0), ndc(y1), z);
  glEnd();
}

TEST(Multisample, EdgesHaveTheShareOfTheirSamples) {
  const Screen screen;
  multisampled();
  EXPECT_EQ(integer(GL_SAMPLES), 4);
  EXPECT_EQ(integer(GL_SAMPLE_BUFFERS), 1);
  rectangle(0, 0, 8.25f, 32);
  rectangle(16, 0, 20.5f, 32);
  rectangle(24, 0, 28.75f, 32);
  resolve();
  EXPECT_EQ(integer(GL_SAMPLES), 0);
  EXPECT_EQ(red_at(7, 5), 255);
  EXPECT_EQ(red_at(8, 5), 64);
  EXPECT_EQ(red_at(9, 5), 0);
  EXPECT_EQ(red_at(20, 5), 128);
  EXPECT_EQ(red_at(28, 5), 191);
  EXPECT_EQ(red_at(0, 0), 255);
  EXPECT_EQ(red_at(0, 31), 255);
}

TEST(Multisample, DisabledAllSamplesHaveThePixelsCentre) {
  const Screen screen;
  multisampled();
  glDisable(GL_MULTISAMPLE);
  rectangle(0, 0, 8.25f, 32);
  rectangle(16, 0, 20.75f, 32);
  resolve();
  EXPECT_EQ(red_at(8, 5), 0);
  EXPECT_EQ(red_at(20, 5), 255);
}

TEST(Multisample, EverySampleHasItsDepth) {
  const Screen screen;
  multisampled();
  glEnable(GL_DEPTH_TEST);
  glClearDepth(1);
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  glColor3f(0, 1, 0);
  rectangle(0, 0, 10.5f, 32, -0.5f);
  glColor3f(1, 0, 0);
  rectangle(0, 0, 32, 32, 0.5f);
  resolve();
  EXPECT_EQ(red_at(9, 5), 0);
  EXPECT_EQ(red_at(10, 5), 128) << "the samples that the near rectangle left";
  EXPECT_EQ(red_at(11, 5), 255);
  EXPECT_NEAR(depth_at(9, 5), 0.25, 1e-7);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(Multisample, SampleCoverageLeavesSomeSamples) {
  struct {
    float value;
    GLboolean inverted;
    int expected;
  } const cases[] = {{0, GL_FALSE, 0}, {0.25f, GL_FALSE, 64}, {0.5f, GL_TRUE, 128}, {0.75f, GL_TRUE, 64}, {1, GL_FALSE, 255}};
  for (const auto& test : cases) {
    const Screen screen;
    multisampled();
    glEnable(GL_SAMPLE_COVERAGE);
    glSampleCoverage(test.value, test.inverted);
    rectangle(0, 0, 32, 32);
    resolve();
    EXPECT_EQ(red_at(8, 8), test.expected) << test.value;
  }
  const Screen screen;
  glEnable(GL_SAMPLE_COVERAGE);
  glSampleCoverage(0, GL_FALSE);
  rectangle(0, 0, 32, 32);
  EXPECT_EQ(red_at(8, 8), 255) << "without samples it has no effect";
}

TEST(ClipControl, DepthFromZeroToOne) {
  const Screen screen;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  EXPECT_EQ(integer(GL_CLIP_DEPTH_MODE), GL_ZERO_TO_ONE);
  glClear(GL_DEPTH_BUFFER_BIT);
  rectangle(0, 0, 8, 32, 0.25f);
  rectangle(8, 0, 16, 32, -0.25f);
  glDepthRange(1, 0);
  rectangle(16, 0, 24, 32, 0.25f);
  EXPECT_NEAR(depth_at(4, 4), 0.25, 1e-7);
  EXPECT_EQ(depth_at(12, 4), 1.0f) << "clipped";
  EXPECT_NEAR(depth_at(20, 4), 0.75, 1e-7);
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_TRIANGLES);
  glVertex3f(-1, -1, -1);
  glVertex3f(1, -1, -1);
  glVertex3f(0, 1, 1);
  glEnd();
  EXPECT_EQ(red_at(16, 15), 0) << "in front of the near plane, z = 0";
  EXPECT_EQ(red_at(16, 17), 255);
}

TEST(ClipControl, OriginAtTheUpperLeft) {
  const Screen screen;
  glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  glEnable(GL_CULL_FACE);
  rectangle(0, 0, 32, 8);
  EXPECT_EQ(red_at(5, 31), 255);
  EXPECT_EQ(red_at(5, 24), 255);
  EXPECT_EQ(red_at(5, 23), 0);
  EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_UPPER_LEFT);
}

TEST(ClipControl, ErrorsChangeNothingAndTheTransformGroupKeepsIt) {
  const Screen screen;
  glPushAttrib(GL_TRANSFORM_BIT);
  glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  glClipControl(GL_LOWER_LEFT, GL_LEQUAL);
  EXPECT_EQ(glGetError(), GL_INVALID_ENUM);
  glClipControl(GL_FRONT, GL_ZERO_TO_ONE);
  EXPECT_EQ(glGetError(), GL_INVALID_ENUM);
  EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_UPPER_LEFT);
  glPopAttrib();
  EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_LOWER_LEFT);
  EXPECT_EQ(integer(GL_CLIP_DEPTH_MODE), GL_NEGATIVE_ONE_TO_ONE);
}

}  // namespace
}  // namespace gouraud::api
