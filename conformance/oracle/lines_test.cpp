#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "conformance/oracle/rasterize.h"
#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

using pipeline::PrimitiveMode;
using Pixels = std::set<std::pair<int, int>>;

Pixels pixels_of(const TestOracle& oracle) {
  Pixels out;
  for (int y = 0; y < test_size; ++y) {
    for (int x = 0; x < test_size; ++x) {
      if (oracle.fragments(x, y)) out.emplace(x, y);
    }
  }
  return out;
}

Pixels line(float x0, float y0, float x1, float y1) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::lines, {at(x0, y0), at(x1, y1)});
  return pixels_of(oracle);
}

Pixels row(int y, int x_begin, int x_end) {
  Pixels out;
  for (int x = x_begin; x < x_end; ++x) out.emplace(x, y);
  return out;
}

TEST(DiamondExit, LinesAreHalfOpenBetweenPixelCentres) {
  EXPECT_EQ(line(10.5f, 20.5f, 30.5f, 20.5f), row(20, 10, 30));
  EXPECT_EQ(line(30.5f, 20.5f, 10.5f, 20.5f), row(20, 11, 31));
  EXPECT_EQ(line(10.5f, 20.5f, 13.5f, 23.5f), (Pixels{{10, 20}, {11, 21}, {12, 22}}));
  EXPECT_EQ(line(13.5f, 23.5f, 10.5f, 20.5f), (Pixels{{13, 23}, {12, 22}, {11, 21}}));
}

TEST(DiamondExit, TheShiftDecidesLinesBetweenPixels) {
  EXPECT_EQ(line(10, 20, 30, 20), row(19, 10, 30));                      // y = 20 - e^2
  EXPECT_EQ(line(10, 20, 10, 23), (Pixels{{9, 20}, {9, 21}, {9, 22}}));  // x = 10 - e
}

TEST(DiamondExit, ALineThatLeavesNoDiamondDrawsNothing) {
  EXPECT_TRUE(line(10.4f, 20.5f, 10.6f, 20.5f).empty());  // within one diamond
  EXPECT_TRUE(line(10.5f, 20.5f, 10.5f, 20.5f).empty());  // no length
  EXPECT_TRUE(line(10.9f, 20.9f, 11.1f, 21.1f).empty());  // between diamonds
}

TEST(DiamondExit, ALineThatEntersOrLeavesADiamondDrawsItOnlyWhenLeaving) {
  EXPECT_EQ(line(10.5f, 20.5f, 11.0f, 21.0f), (Pixels{{10, 20}}));  // leaves, ends between the diamonds
  EXPECT_TRUE(line(11.0f, 21.0f, 11.5f, 21.5f).empty());            // enters the next one and stays
  EXPECT_EQ(line(10.0f, 20.4f, 11.0f, 20.4f), (Pixels{{10, 20}}));  // passes through
}

TEST(DiamondExit, ReducesToBresenhamBetweenPixelCentres) {
  for (int dx = 1; dx < 20; ++dx) {
    for (int dy = 0; dy <= dx; ++dy) {
      Pixels expected;
      for (int i = 0; i < dx; ++i) {
        // Half-way up to the next centre goes up: the line is moved left, so a rising one is higher at each centre.
        expected.emplace(20 + i, 30 + (2 * dy * i + dx) / (2 * dx));
      }
      EXPECT_EQ(line(20.5f, 30.5f, 20.5f + static_cast<float>(dx), 30.5f + static_cast<float>(dy)), expected)
          << dx << ' ' << dy;
    }
  }
}

/// The rule with a small number for the infinitely small one, checked by clipping the segment to the open diamond.
bool exits_diamond_numerically(double ax, double ay, double bx, double by, int x, int y) {
  constexpr double e = 1.0 / 4096;
  const double shift_x = -e - (x + 0.5), shift_y = -e * e - (y + 0.5);
  ax += shift_x, bx += shift_x, ay += shift_y, by += shift_y;
  if (std::abs(bx) + std::abs(by) < 0.5) return false;
  double begin = 0, end = 1;
  for (const int sx : {-1, 1}) {
    for (const int sy : {-1, 1}) {
      const double from = 0.5 - (sx * ax + sy * ay), to = 0.5 - (sx * bx + sy * by);  // inside where positive
      if (from <= 0 && to <= 0) return false;
      if (from < 0) begin = std::max(begin, from / (from - to));
      if (to < 0) end = std::min(end, from / (from - to));
    }
  }
  return begin < end;
}

TEST(DiamondExit, AgreesWithTheRuleForASmallShift) {
  std::mt19937 random(2);
  for (int n = 0; n < 20000; ++n) {
    const auto coordinate = [&random] { return static_cast<double>(random() % 64) / 8 + 28; };
    const double ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    const auto snapped = [](double px, double py) {
      return SubpixelPoint{std::llround((px - 0.5) * 256), std::llround((py - 0.5) * 256)};
    };
    for (int y = 27; y < 37; ++y) {
      for (int x = 27; x < 37; ++x) {
        const bool expected = (ax != bx || ay != by) && exits_diamond_numerically(ax, ay, bx, by, x, y);
        ASSERT_EQ(exits_diamond(snapped(ax, ay), snapped(bx, by), x, y, 8), expected)
            << ax << ' ' << ay << ' ' << bx << ' ' << by << " at " << x << ' ' << y;
      }
    }
  }
}

TEST(DiamondExit, TheWalkMissesNoPixel) {
  std::mt19937 random(3);
  for (int n = 0; n < 500; ++n) {
    const float grid = n % 2 ? 8.0f : 256.0f;
    const auto coordinate = [&] {
      return std::floor(std::uniform_real_distribution(0.0f, 64.0f)(random) * grid) / grid;
    };
    const float ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
    const auto snapped = [](float px, float py) {
      return SubpixelPoint{std::lround((px - 0.5f) * 256), std::lround((py - 0.5f) * 256)};
    };
    Pixels expected;
    for (int y = 0; y < test_size; ++y) {
      for (int x = 0; x < test_size; ++x) {
        if (exits_diamond(snapped(ax, ay), snapped(bx, by), x, y, 8)) expected.emplace(x, y);
      }
    }
    EXPECT_EQ(line(ax, ay, bx, by), expected);
  }
}

TEST(LineStrip, ConnectedLinesDrawSharedPixelsOnce) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::line_strip,
              {at(2.3f, 5.1f), at(20.7f, 11.9f), at(40.2f, 30.4f), at(60.6f, 33.3f)});
  for (const int n : oracle.picture().fragments_written) EXPECT_LE(n, 1);
  EXPECT_EQ(oracle.all_fragments(), 58);  // one pixel in every column from 2 to 59; the last one's diamond is not left
}

TEST(LineAttributes, ArePerspectiveCorrectAlongTheLine) {
  TestOracle oracle;
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, true, pipeline::CompareFunc::always};
  const float w = 4.0f;
  oracle.draw(state, PrimitiveMode::lines,
              {at(4.5f, 10.5f, 0.25f, {0, 0, 0, 1}),
               TestVertex{{60.5f * w, 10.5f * w, 0.75f * w, w}, {1, 0, 0, 1}, {0, 0, 1}}});
  const double t = (20 - 4) / 56.0;
  EXPECT_NEAR(oracle.pixel(20, 10).color[0], t / 4 / ((1 - t) + t / 4), 1e-12);
  EXPECT_NEAR(oracle.pixel(20, 10).depth_units, (0.25 + 0.5 * t) * 16777215, 1e-6);
}

TEST(LineAttributes, ContinueBeyondTheEndPoints) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::lines,
              {at(4.75f, 10.5f, 0, {0.5f, 0, 0, 1}), at(8.75f, 10.5f, 0, {0.75f, 0, 0, 1})});
  EXPECT_NEAR(oracle.pixel(4, 10).color[0], 0.5 - 0.25 * 0.25 / 4, 1e-12);
  EXPECT_EQ(oracle.picture().count(pixel_extrapolated), 0u);
}

/// Here t = -1/16, and the sum of the weights 17/16 / 32 - 1/16 < 0.
TEST(LineAttributes, AreAnyOfTheLinesBeyondItsHorizon) {
  const float w = 32.0f;
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::lines,
              {TestVertex{{4.75f * w, 10.5f * w, 0.5f * w, w}, {0.25f, 0, 0, 1}, {0, 0, 1}},
               at(8.75f, 10.5f, 0.5f, {0.75f, 0, 0, 1})});
  const OraclePixel& pixel = oracle.pixel(4, 10);
  EXPECT_EQ(oracle.picture().count(pixel_extrapolated), 1u);
  EXPECT_EQ(pixel.color[0], 0.25);
  EXPECT_EQ(pixel.color_lowest[0], 0.25f);
  EXPECT_EQ(pixel.color_highest[0], 0.75f);
}

TEST(LineAttributes, FlatLinesHaveTheSecondVertexsColour) {
  TestOracle oracle;
  pipeline::DrawState state = window_state();
  state.assembly.shade_model = pipeline::ShadeModel::flat;
  oracle.draw(state, PrimitiveMode::lines, {at(4.5f, 10.5f, 0, {1, 0, 0, 1}), at(60.5f, 10.5f, 0, {0, 1, 0, 1})});
  EXPECT_EQ(oracle.pixel(20, 10).color, (std::array<double, 4>{0, 1, 0, 1}));
}

TEST(Points, FillThePixelThatHoldsThem) {
  const auto pixel = [](double x, double y) { return pixel_of_point(x, y, 8); };
  EXPECT_EQ(pixel(10.0, 20.0), (std::array{10, 20}));
  EXPECT_EQ(pixel(10.5, 20.5), (std::array{10, 20}));
  EXPECT_EQ(pixel(10.99, 20.99), (std::array{10, 20}));
  EXPECT_EQ(pixel(10.999, 20.999), (std::array{11, 21}));  // rounded to 1/256 first
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::points, {at(3.25f, 7.75f), at(63.0f, 0.0f)});
  EXPECT_EQ(oracle.all_fragments(), 2);
  EXPECT_EQ(oracle.fragments(3, 7), 1);
  EXPECT_EQ(oracle.fragments(63, 0), 1);
}

TEST(PolygonMode, LineDrawsTheOutlineOnceAndNoDiagonal) {
  pipeline::DrawState state = window_state();
  state.assembly.polygon_mode_front = pipeline::PolygonMode::line;
  for (const PrimitiveMode mode : {PrimitiveMode::quads, PrimitiveMode::polygon}) {
    TestOracle oracle;
    oracle.draw(state, mode, {at(10.5f, 10.5f), at(20.5f, 10.5f), at(20.5f, 20.5f), at(10.5f, 20.5f)});
    EXPECT_EQ(oracle.all_fragments(), 40);
    for (const auto& [x, y] : pixels_of(oracle)) EXPECT_TRUE(x == 10 || x == 20 || y == 10 || y == 20);
  }
}

TEST(PolygonMode, PointDrawsEachVertexOnce) {
  pipeline::DrawState state = window_state();
  state.assembly.polygon_mode_front = pipeline::PolygonMode::point;
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::polygon,
              {at(10.5f, 10.5f), at(20.5f, 10.5f), at(24.5f, 15.5f), at(20.5f, 20.5f), at(10.5f, 20.5f)});
  EXPECT_EQ(pixels_of(oracle), (Pixels{{10, 10}, {20, 10}, {24, 15}, {20, 20}, {10, 20}}));
  EXPECT_EQ(oracle.all_fragments(), 5);
}

TEST(PolygonMode, BackFacesHaveTheirOwn) {
  pipeline::DrawState state = window_state();
  state.assembly.polygon_mode_back = pipeline::PolygonMode::point;
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::triangles,
              {at(10, 10), at(30, 10), at(10, 30), at(40.5f, 40.5f), at(40.5f, 60.5f), at(60.5f, 40.5f)});
  EXPECT_GT(oracle.fragments(12, 12), 0);
  EXPECT_EQ(oracle.fragments(45, 45), 0);
  EXPECT_EQ(oracle.fragments(40, 60), 1);
}

}  // namespace
}  // namespace gouraud::oracle
