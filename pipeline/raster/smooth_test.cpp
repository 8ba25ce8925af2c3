#include "pipeline/raster/smooth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "pipeline/raster/areas.h"

namespace gouraud::pipeline {
namespace {

double sum_of(const SmoothShape& shape) {
  const PixelRect box = box_of(shape);
  double sum = 0;
  for (std::int32_t y = box.y0; y < box.y1; y += 8) {
    for (std::int32_t x = box.x0; x < box.x1; x += 8) {
      std::array<float, 64> coverage;
      cover_block(shape, x, y, coverage);
      for (const float c : coverage) sum += c;
    }
  }
  return sum;
}

/// The disc's part of the pixel from (x, y) on, by strips so thin that nothing is left to say.
double thin_strips(double x, double y, double radius) {
  constexpr int strips = 20000;
  double area = 0;
  for (int i = 0; i < strips; ++i) {
    const double at = x + (i + 0.5) / strips, half = std::sqrt(std::max(radius * radius - at * at, 0.0));
    area += std::max(std::min(y + 1, half) - std::max(y, -half), 0.0);
  }
  return area / strips;
}

TEST(Smooth, ASquareCoversItsShareOfEachPixel) {
  const SmoothShape square{{{{1.25, 2.5}, {4.0, 2.5}, {4.0, 5.75}, {1.25, 5.75}}}, 4, 0};
  std::array<float, 64> coverage;
  const std::uint64_t covered = cover_block(square, 0, 0, coverage);
  EXPECT_FLOAT_EQ(coverage[2 * 8 + 1], 0.75f * 0.5f);
  EXPECT_FLOAT_EQ(coverage[3 * 8 + 2], 1.0f);
  EXPECT_FLOAT_EQ(coverage[5 * 8 + 3], 0.75f);
  EXPECT_EQ(coverage[0], 0.0f);
  EXPECT_EQ(covered, 0x00000E0E0E0E0000u);
}

TEST(Smooth, AreasOfTrianglesAddUpWhicheverWayTheyTurn) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-3, 30);
  for (int i = 0; i < 300; ++i) {
    SmoothShape triangle;
    triangle.corner_count = 3;
    for (std::size_t k = 0; k < 3; ++k) triangle.corner[k] = {place(random), place(random)};
    const auto& [a, b, c, unused] = triangle.corner;
    const double area = 0.5 * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y));
    ASSERT_NEAR(sum_of(triangle), area, 1e-4);
  }
}

/// The area that a convex shape shares with the pixel from (x, y) on: what is left of it when the pixel's four sides cut.
double clipped_area(const SmoothShape& shape, double x, double y) {
  using Corner = SmoothShape::Corner;
  std::vector<Corner> polygon(shape.corner.begin(), shape.corner.begin() + shape.corner_count);
  const auto keep = [&](const auto& distance) {
    std::vector<Corner> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = distance(a), db = distance(b);
      if (da >= 0) kept.push_back(a);
      if ((da < 0) != (db < 0)) kept.push_back({a.x + (b.x - a.x) * (da / (da - db)), a.y + (b.y - a.y) * (da / (da - db))});
    }
    polygon = kept;
  };
  keep([&](const Corner& at) { return at.x - x; });
  keep([&](const Corner& at) { return x + 1 - at.x; });
  keep([&](const Corner& at) { return at.y - y; });
  keep([&](const Corner& at) { return y + 1 - at.y; });
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += (a.x - x) * (b.y - y) - (b.x - x) * (a.y - y);
  }
  return 0.5 * std::abs(twice);
}

TEST(Smooth, LinesShareWithEachPixelWhatClippingLeavesOfThem) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-20, 28), part(0, 1);
  for (int i = 0; i < 400; ++i) {
    // A rectangle along any direction; every fourth nearly along an axis, every eighth exactly.
    const double width = 0.3 + 4 * part(random), length = 40 * part(random);
    double angle = 6.28 * part(random);
    if (i % 4 == 0) angle = std::round(angle / 1.5707963267948966) * 1.5707963267948966 + (i % 8 == 0 ? 0 : 1e-6 * (part(random) - 0.5));
    const double dx = length * std::cos(angle), dy = length * std::sin(angle), nx = -width * std::sin(angle), ny = width * std::cos(angle);
    const double x = place(random), y = place(random);
    const SmoothShape line{{{{x, y}, {x + dx, y + dy}, {x + dx + nx, y + dy + ny}, {x + nx, y + ny}}}, 4, 0};
    std::array<float, 64> coverage;
    const std::uint64_t covered = cover_block(line, 0, 0, coverage);
    for (std::size_t lane = 0; lane < 64; ++lane) {
      const double area = clipped_area(line, static_cast<double>(lane % 8), static_cast<double>(lane / 8));
      ASSERT_NEAR(coverage[lane], area, 2e-6) << "line " << i << " pixel " << lane;
      ASSERT_TRUE((covered >> lane & 1) == (area >= least_coverage) || std::abs(area - least_coverage) < 1e-9) << "line " << i << " pixel " << lane;
    }
  }
}

/// The least and the largest area of a pixel in the block.
std::pair<double, double> range_of_areas(const SmoothShape& shape, std::int32_t x, std::int32_t y) {
  Areas area;
  areas_of(shape, x, y, area);
  const auto [least, largest] = std::minmax_element(area.begin(), area.end());
  return {*least, *largest};
}

TEST(Smooth, BlocksThatAreLeftOutHaveNothing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-10, 60);
  for (int i = 0; i < 300; ++i) {
    SmoothShape shape;
    shape.corner_count = i % 3 == 0 ? 0 : 3;
    for (std::size_t k = 0; k < 3; ++k) shape.corner[k] = {place(random), place(random)};
    if (shape.corner_count == 0) shape.radius = 0.2 * place(random) + 3;
    for (std::int32_t y = -16; y < 72; y += 8) {
      const Stretch stretch = stretch_of(shape, y);
      for (std::int32_t x = -16; x < 72; x += 8) {
        const auto [least, largest] = range_of_areas(shape, x, y);
        const BlockPlace block = place_of_block(shape, x, y);
        const bool left_out = stretch.x0 > x + 8 || stretch.x1 < x || block == BlockPlace::outside;
        ASSERT_TRUE(!left_out || largest < least_coverage);
        ASSERT_TRUE(block != BlockPlace::inside || least > 1 - 1e-9);
      }
    }
  }
}

TEST(Smooth, DiscsAreExactToATenthOfAByte) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(0, 1);
  for (const double radius : {0.5, 0.7, 1.0, 2.3, 10.0, 127.5}) {
    for (int i = 0; i < 20; ++i) {
      const SmoothShape disc{{{{place(random) + 200, place(random) + 200}}}, 0, radius};
      const double angle = 6.28 * place(random);
      const auto x = static_cast<std::int32_t>(std::floor(disc.corner[0].x + radius * std::cos(angle)));
      const auto y = static_cast<std::int32_t>(std::floor(disc.corner[0].y + radius * std::sin(angle)));
      std::array<float, 64> coverage;
      cover_block(disc, x, y, coverage);
      ASSERT_NEAR(coverage[0], thin_strips(x - disc.corner[0].x, y - disc.corner[0].y, radius), 0.4 / 255) << radius;
    }
    EXPECT_NEAR(sum_of({{{{20.3, 40.8}}}, 0, radius}), std::numbers::pi * radius * radius, 0.002 * radius * radius + 0.002);
  }
}

}  // namespace
}  // namespace gouraud::pipeline
