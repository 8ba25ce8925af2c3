// Multisampled framebuffer objects, and polygons in them [GL1.5 §3.2.1, §3.5.6, §4.1.3].
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_samples.h"
#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

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

TEST(Multisample, AFragmentsSamplesHaveOneColor) {
  const Screen screen;
  multisampled();
  // From 0 at the left to 1 at the right: where a sample has its own colour, a pixel's mean is not its centre's.
  glBegin(GL_QUADS);
  glColor3f(0, 0, 0);
  glVertex2f(-1, -1);
  glColor3f(1, 0, 0);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glColor3f(0, 0, 0);
  glVertex2f(-1, 1);
  glEnd();
  resolve();
  for (int x = 0; x < side_px; ++x) EXPECT_EQ(red_at(x, 5), std::lround((x + 0.5) / side_px * 255)) << x;
}

TEST(Multisample, ACentreOutsideKeepsToTheVerticesColors) {
  const Screen screen;
  multisampled();
  const auto shaded = [](float x0, float x1, auto color) {
    const auto ndc = [](float pixel) { return pixel / (0.5f * side_px) - 1; };
    glBegin(GL_QUADS);
    for (const auto& [x, y, red] : {std::array{x0, -1.0f, 0.0f}, {x1, -1.0f, 1.0f}, {x1, 1.0f, 1.0f}, {x0, 1.0f, 0.0f}}) {
      color(red);
      glVertex2f(ndc(x), y);
    }
    glEnd();
  };
  shaded(8.625f, 16.375f, [](float red) { glColor3f(red, 0, 0); });
  resolve();
  EXPECT_EQ(red_at(8, 5), 0) << "two samples of black, whose line leads below it";
  EXPECT_EQ(red_at(16, 5), 64) << "a sample of full red, whose line leads beyond it";
}

TEST(Multisample, LinesAndPolygonsOfOneBatchKeepTheirOrder) {
  const Screen screen;
  multisampled();
  glLineWidth(4);
  const auto line = [] {
    glBegin(GL_LINES);
    glVertex2f(-1, 0);
    glVertex2f(1, 0);
    glEnd();
  };
  glColor3f(0, 1, 0);
  line();
  glColor3f(1, 0, 0);
  rectangle(0, 0, 16, 32);
  glColor3f(0, 0, 1);
  rectangle(8, 0, 16, 32);
  glColor3f(1, 0, 0);
  line();
  glColor3f(0, 1, 0);
  rectangle(0, 0, 4, 32);
  resolve();
  EXPECT_EQ(red_at(2, 16), 0) << "the last rectangle";
  EXPECT_EQ(red_at(6, 16), 255);
  EXPECT_EQ(red_at(12, 16), 255) << "the second line";
  EXPECT_EQ(red_at(12, 20), 0);
  EXPECT_EQ(red_at(24, 16), 255) << "the second line";
}

TEST(Multisample, TheScissorCutsSamplesToo) {
  const Screen screen;
  multisampled();
  glEnable(GL_SCISSOR_TEST);
  glScissor(5, 5, 10, 10);
  rectangle(0, 0, 32, 32);
  glDisable(GL_SCISSOR_TEST);
  resolve();
  for (int i = 0; i < side_px; ++i) EXPECT_EQ(red_at(i, 7), i >= 5 && i < 15 ? 255 : 0) << i;
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

TEST(Multisample, AlphaChoosesSamples) {
  const float alphas[] = {0.0f, 0.1f, 0.2f, 0.4f, 0.6f, 0.7f, 0.9f, 1.0f};
  const int covered[] = {0, 0, 1, 2, 2, 3, 4, 4};
  const Screen screen;
  multisampled();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  for (int i = 0; i < 8; ++i) {
    glColor4f(1, 0, 0, alphas[i]);
    rectangle(4.0f * static_cast<float>(i), 0, 4.0f * static_cast<float>(i) + 4, 16);
  }
  glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  for (int i = 0; i < 8; ++i) {
    glColor4f(1, 0, 0, alphas[i]);
    rectangle(4.0f * static_cast<float>(i), 16, 4.0f * static_cast<float>(i) + 4, 32);
  }
  resolve();
  for (int i = 0; i < 8; ++i) {
    const double share = covered[i] / 4.0;
    EXPECT_NEAR(pixel_at(4 * i + 1, 8)[0], 255 * share, 0.51) << alphas[i];
    EXPECT_NEAR(pixel_at(4 * i + 1, 8)[3], 255 * static_cast<double>(alphas[i]) * share, 1.01) << alphas[i];
    EXPECT_NEAR(pixel_at(4 * i + 1, 24)[0], 255 * share, 0.51) << alphas[i];
    EXPECT_NEAR(pixel_at(4 * i + 1, 24)[3], 255 * share, 0.51) << alphas[i];
  }
}

TEST(Multisample, AlphaChoosesSamplesOfDepthsAndPixelImages) {
  const Screen screen;
  multisampled();
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glColor4f(1, 1, 1, 0.5f);
  rectangle(0, 0, 32, 32, -0.5f);
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  rectangle(0, 0, 16, 32, 0.5f);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  const std::uint8_t texels[2][4] = {{255, 0, 0, 64}, {255, 0, 0, 191}};
  glRasterPos2f(0.5f, 0);
  glDrawPixels(2, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  resolve();
  EXPECT_EQ(pixel_at(4, 4)[0], 128) << "two samples were behind";
  EXPECT_EQ(pixel_at(24, 16)[0], 64);
  EXPECT_EQ(pixel_at(25, 16)[0], 191);
}

TEST(Multisample, WithoutMultisamplingAlphaChoosesNothing) {
  const Screen screen;
  multisampled();
  glDisable(GL_MULTISAMPLE);
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  glEnable(GL_SAMPLE_ALPHA_TO_ONE);
  glColor4f(1, 0, 0, 0.4f);
  rectangle(0, 0, 32, 32);
  resolve();
  EXPECT_EQ(pixel_at(8, 8)[0], 255);
  EXPECT_EQ(pixel_at(8, 8)[3], 102);
}

/// A little of everything, smooth and jagged, blended.
void draw_everything() {
  glClearColor(0.1f, 0.2f, 0.3f, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (const bool smooth : {false, true}) {
    for (const GLenum cap : {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_POLYGON_SMOOTH}) smooth ? glEnable(cap) : glDisable(cap);
    const float y = smooth ? 0.5f : -0.5f;
    glPointSize(5.3f);
    glLineWidth(2.7f);
    glColor4f(0.9f, 0.3f, 0.2f, 0.7f);
    glBegin(GL_POINTS);
    glVertex2f(-0.7f, y);
    glEnd();
    glBegin(GL_POLYGON);
    for (const auto& [dx, dy] : {std::array{-0.5f, -0.3f}, {0.1f, -0.35f}, {0.2f, 0.1f}, {-0.2f, 0.4f}}) glVertex2f(dx, y + dy);
    glEnd();
    glColor4f(0.2f, 0.9f, 0.6f, 0.8f);
    glBegin(GL_LINES);
    glVertex2f(-0.9f, y - 0.4f);
    glVertex2f(0.9f, y + 0.3f);
    glEnd();
    glEnable(GL_LINE_STIPPLE);
    glLineStipple(1, 0x5AF0);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glRectf(0.3f, y - 0.3f, 0.9f, y + 0.2f);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_LINE_STIPPLE);
  }
  const std::uint8_t bits[4] = {0xB7, 0, 0, 0}, texels[2][4] = {{255, 0, 0, 64}, {0, 255, 0, 191}};
  glRasterPos2f(0.2f, 0.9f);
  glBitmap(8, 1, 0, 0, 0, 0, bits);
  glDrawPixels(2, 1, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glDisable(GL_BLEND);
}

TEST(Multisample, DisabledThePictureIsThatOfOneSample) {
  Screen screen;
  draw_everything();
  const auto expected = screen.pixels();
  multisampled();
  glDisable(GL_MULTISAMPLE);
  draw_everything();
  resolve();
  EXPECT_TRUE(screen.pixels() == expected);
}

/// Triangles of a few pixels and of many, of whose fragments the alpha test leaves half. Returns colours and depths.
std::vector<std::uint32_t> half_opaque_triangles(GLenum func, bool writes_depth, bool counts_in_stencil, bool in_samples) {
  glClearColor(0, 0, 0, 0);
  glClearDepth(0.5);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(func);
  glDepthMask(writes_depth ? GL_TRUE : GL_FALSE);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0.5f);
  if (counts_in_stencil) {
    glEnable(GL_STENCIL_TEST);
    glStencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  }
  std::mt19937 random(6);
  std::uniform_real_distribution<float> place(-1, 1), unit(0, 1);
  std::uniform_int_distribution<int> depth(0, 4);
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 400; ++i) {
    const float x = place(random), y = place(random), size = i % 3 == 0 ? 0.8f : 0.2f, z = static_cast<float>(depth(random)) * 0.25f - 0.5f;
    for (int k = 0; k < 3; ++k) {
      glColor4f(unit(random), unit(random), unit(random), unit(random));
      const float dx = place(random), dy = place(random);
      glVertex3f(x + size * dx, y + size * dy, z);
    }
  }
  glEnd();
  glDisable(GL_STENCIL_TEST);
  glDisable(GL_ALPHA_TEST);
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  if (in_samples) resolve();
  std::vector<std::uint32_t> result(2 * side_px * side_px);
  glReadPixels(0, 0, side_px, side_px, GL_RGBA, GL_UNSIGNED_BYTE, result.data());
  glReadPixels(0, 0, side_px, side_px, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, result.data() + side_px * side_px);
  return result;
}

// Hidden fragments go before they are shaded for the alpha test, but not where a stencil buffer learns of them.
TEST(Multisample, HiddenFragmentsAreRejectedEarlyWithoutAnyDifference) {
  const Screen screen;
  for (const int samples : {0, 1, 4}) {
    for (const GLenum func : {GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS}) {
      for (const bool writes : {true, false}) {
        const auto draw = [&](bool counts_in_stencil) {
          if (samples > 0) multisampled();
          samples > 1 ? glEnable(GL_MULTISAMPLE) : glDisable(GL_MULTISAMPLE);
          return half_opaque_triangles(func, writes, counts_in_stencil, samples > 0);
        };
        EXPECT_TRUE(draw(false) == draw(true)) << samples << " " << func << " " << writes;
      }
    }
  }
}

}  // namespace
}  // namespace gouraud::api
