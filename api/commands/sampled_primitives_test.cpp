// Points, lines and outlines in multisampled framebuffer objects [GL1.5 §3.2.1, §3.3.2, §3.4.4, §3.5.4].
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_samples.h"
#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

constexpr double sample_places[4][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};

/// What the samples for which inside(x, y) holds leave red in every pixel of the window.
template <class Inside>
void expect_samples(const Inside& inside) {
  for (int y = 0; y < side_px; ++y) {
    for (int x = 0; x < side_px; ++x) {
      int count = 0;
      for (const auto& place : sample_places) count += inside(x + place[0], y + place[1]) ? 1 : 0;
      ASSERT_NEAR(pixel_at(x, y)[0], 255 * count / 4.0, 0.51) << x << "," << y;
    }
  }
}

// [GL1.5 §3.3.2]: whether smooth or not.
TEST(Multisample, PointsAreDiscsAndSpritesSquares) {
  const Screen screen;
  for (const bool sprite : {false, true}) {
    multisampled();
    glClear(GL_COLOR_BUFFER_BIT);
    sprite ? glEnable(GL_POINT_SPRITE_ARB) : glDisable(GL_POINT_SPRITE_ARB);
    glPointSize(9.7f);
    glBegin(GL_POINTS);
    glVertex2f(0.03125f, -0.09375f);
    glEnd();
    resolve();
    const double center_x = 16.5, center_y = 14.5, half = 0.5 * 9.7f;
    expect_samples([&](double x, double y) {
      const double dx = x - center_x, dy = y - center_y;
      return sprite ? std::max(std::abs(dx), std::abs(dy)) < half : dx * dx + dy * dy < half * half;
    });
  }
}

// [GL1.5 §3.4.4]: rectangles, whatever LINE_SMOOTH says; the stipple cuts them.
TEST(Multisample, LinesAreRectangles) {
  const Screen screen;
  multisampled();
  glLineWidth(2.5f);
  glBegin(GL_LINES);
  glVertex2f(-0.75f, -0.375f);
  glVertex2f(0.5f, -0.375f);
  glEnd();
  glEnable(GL_LINE_STIPPLE);
  glLineStipple(2, 0x5555);
  glBegin(GL_LINES);
  glVertex2f(-0.75f, 0.375f);
  glVertex2f(0.5f, 0.375f);
  glEnd();
  resolve();
  expect_samples([](double x, double y) {
    if (x < 4 || x >= 24) return false;
    const bool kept = static_cast<int>(x - 4) / 2 % 2 == 0;
    return std::abs(y - 10) < 1.25 || (std::abs(y - 22) < 1.25 && kept);
  });
}

TEST(Multisample, LinesOfAnyDirectionAreRectangles) {
  const Screen screen;
  const struct {
    float x0, y0, x1, y1, width;
  } cases[] = {{3.3f, 5.1f, 27.7f, 24.2f, 1}, {28.4f, 3.6f, 22.1f, 29.9f, 3.7f}, {9.9f, 27.3f, 14.2f, 1.6f, 1.4f}, {15.7f, 16.1f, 17.4f, 16.4f, 7.5f}};
  for (const auto& line : cases) {
    multisampled();
    glClear(GL_COLOR_BUFFER_BIT);
    glLineWidth(line.width);
    const auto ndc = [](float pixel) { return pixel / (0.5f * side_px) - 1; };
    glBegin(GL_LINES);
    glVertex2f(ndc(line.x0), ndc(line.y0));
    glVertex2f(ndc(line.x1), ndc(line.y1));
    glEnd();
    resolve();
    const double dx = double{line.x1} - line.x0, dy = double{line.y1} - line.y0, length = std::hypot(dx, dy);
    expect_samples([&](double x, double y) {
      const double along = ((x - line.x0) * dx + (y - line.y0) * dy) / length, across = ((x - line.x0) * dy - (y - line.y0) * dx) / length;
      return along > 0 && along < length && std::abs(across) < 0.5 * line.width;
    });
  }
}

TEST(Multisample, EachSampleOfALineHasItsDepth) {
  const Screen screen;
  multisampled();
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  rectangle(0, 0, 32, 32, 0.0f);
  glDepthFunc(GL_LESS);
  glColor3f(0, 1, 0);
  glLineWidth(8);
  // Through the plane at x = 16, where it comes out in the samples left of the middle.
  glBegin(GL_LINES);
  glVertex3f(-1, 0, -0.5f);
  glVertex3f(1, 0, 0.5f);
  glEnd();
  rectangle(0, 0, 1, 1, -0.9f);
  resolve();
  EXPECT_EQ(red_at(14, 16), 0);
  EXPECT_EQ(red_at(15, 16), 0);
  EXPECT_EQ(red_at(16, 16), 255);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  multisampled();
  glClear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
  glColor3f(1, 0, 0);
  rectangle(0, 0, 32, 32, 0.0f);
  glColor3f(0, 1, 0);
  glBegin(GL_LINES);
  glVertex3f(-1 + 1 / 32.0f, 0, -0.5f);
  glVertex3f(1 + 1 / 32.0f, 0, 0.5f);
  glEnd();
  resolve();
  EXPECT_EQ(red_at(15, 16), 0);
  EXPECT_EQ(red_at(16, 16), 128) << "two samples lie before the plane";
  EXPECT_EQ(red_at(17, 16), 255);
}

TEST(Multisample, ALinesCentreBeforeItsEndKeepsToTheEndsColor) {
  const Screen screen;
  multisampled();
  const auto ndc = [](float pixel) { return pixel / (0.5f * side_px) - 1; };
  glLineWidth(6);
  glBegin(GL_LINES);
  glColor3f(0.5f, 0, 0);
  glVertex2f(ndc(8.625f), 0);
  glColor3f(1, 0, 0);
  glVertex2f(ndc(16.375f), 0);
  glEnd();
  resolve();
  EXPECT_EQ(red_at(8, 16), 64) << "two samples of the start's colour, 127.5, whose line leads below it";
  EXPECT_EQ(red_at(16, 16), 64) << "a sample of full red";
}

TEST(Multisample, OutlinesAndFillsOfOneBatchKeepTheirOrder) {
  const Screen screen;
  multisampled();
  glPolygonMode(GL_BACK, GL_LINE);
  glLineWidth(4);
  glColor3f(1, 0, 0);
  rectangle(24, 8, 8, 24);  // faces away
  glColor3f(0, 1, 0);
  rectangle(0, 0, 16, 32);
  glColor3f(1, 0, 0);
  rectangle(12, 2, 4, 6);
  resolve();
  EXPECT_EQ(red_at(24, 16), 255) << "the outline";
  EXPECT_EQ(red_at(20, 16), 0) << "inside it";
  EXPECT_EQ(red_at(8, 16), 0) << "under the rectangle";
  EXPECT_EQ(red_at(8, 2), 255) << "the last outline";
}

TEST(Multisample, DisabledLinesAndPointsHaveAllSamplesOfTheirPixels) {
  const Screen screen;
  multisampled();
  glDisable(GL_MULTISAMPLE);
  glBegin(GL_LINES);
  glVertex2f(-0.75f, 0.03f);
  glVertex2f(0.5f, 0.03f);
  glEnd();
  glPointSize(3);
  glBegin(GL_POINTS);
  glVertex2f(0.5f + 1 / 32.0f, 0.5f + 1 / 32.0f);
  glEnd();
  resolve();
  for (int x = 0; x < side_px; ++x) EXPECT_EQ(red_at(x, 16), x >= 4 && x < 24 ? 255 : 0) << x;
  for (int x = 0; x < side_px; ++x) EXPECT_EQ(red_at(x, 25), x >= 23 && x < 26 ? 255 : 0) << x;
}

TEST(Multisample, SampleCoverageLeavesSomeSamplesOfLinesPointsAndBitmaps) {
  const Screen screen;
  multisampled();
  glEnable(GL_SAMPLE_COVERAGE);
  glSampleCoverage(0.5f, GL_FALSE);
  glLineWidth(8);
  glBegin(GL_LINES);
  glVertex2f(-1, -0.5f);
  glVertex2f(1, -0.5f);
  glEnd();
  glPointSize(8);
  glBegin(GL_POINTS);
  glVertex2f(0, 0.5f);
  glEnd();
  const std::uint8_t bits[4] = {0xFF, 0, 0, 0};
  glRasterPos2f(0, 0);
  glBitmap(8, 1, 0, 0, 0, 0, bits);
  resolve();
  EXPECT_EQ(red_at(16, 8), 128);
  EXPECT_EQ(red_at(16, 24), 128);
  EXPECT_EQ(red_at(18, 16), 128);
}

// [GL1.5 §3.12].
TEST(Multisample, PointsBelowTheThresholdFade) {
  const Screen screen;
  multisampled();
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glPointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, 8);
  glPointSize(4);
  glBegin(GL_POINTS);
  glVertex2f(0, 0);
  glEnd();
  resolve();
  EXPECT_EQ(pixel_at(16, 16)[0], 255);
  EXPECT_EQ(pixel_at(16, 16)[3], 64);
  EXPECT_EQ(pixel_at(19, 16)[0], 255) << "drawn with the threshold's size";
}

}  // namespace
}  // namespace gouraud::api
