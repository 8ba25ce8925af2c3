#include "demos/shell/circle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace shell {
namespace {

std::set<std::pair<int, int>> as_set(const std::vector<Pixel>& pixels) {
  std::set<std::pair<int, int>> set;
  for (const Pixel pixel : pixels) set.insert({pixel.x, pixel.y});
  return set;
}

TEST(MidpointCircle, HasEachPixelOnce) {
  for (int radius = 0; radius <= 200; ++radius) {
    const std::vector<Pixel> pixels = midpoint_circle(radius);
    EXPECT_EQ(as_set(pixels).size(), pixels.size()) << radius;
  }
}

TEST(MidpointCircle, IsItsOwnMirrorImageInEveryOctant) {
  const auto set = as_set(midpoint_circle(57));
  for (const auto& [x, y] : set) {
    EXPECT_TRUE(set.contains({-x, y}));
    EXPECT_TRUE(set.contains({x, -y}));
    EXPECT_TRUE(set.contains({y, x}));
  }
}

TEST(MidpointCircle, TakesThePixelOfEachColumnThatIsNearestToTheCircle) {
  for (const int radius : {1, 2, 5, 30, 171}) {
    for (const Pixel pixel : midpoint_circle(radius)) {
      if (pixel.x < 0 || pixel.y < pixel.x) continue;
      EXPECT_LE(std::abs(std::sqrt(radius * radius - pixel.x * pixel.x) - pixel.y), 0.5 + 0.5 / radius) << radius << ": " << pixel.x;
    }
  }
}

TEST(MidpointCircle, OfNoRadiusIsOnePixelOfANegativeOneNone) {
  EXPECT_EQ(midpoint_circle(0), (std::vector<Pixel>{{0, 0}}));
  EXPECT_TRUE(midpoint_circle(-3).empty());
}

}  // namespace
}  // namespace shell
