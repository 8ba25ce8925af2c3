#include "pipeline/raster/pixel_rectangle.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

// The rule itself, by trying every source [GL1.5 §3.6.4].
std::int32_t source_by_rule(double origin, double zoom, std::int32_t count, std::int32_t pixel) {
  for (std::int32_t n = 0; n < count; ++n) {
    const double a = origin + zoom * n, b = origin + zoom * (n + 1), center = pixel + 0.5;
    if (std::min(a, b) <= center && center < std::max(a, b)) return n;
  }
  return -1;
}

TEST(PixelRectangles, GivePixelsToTheSourceThatHoldsTheirCentre) {
  for (const double zoom : {1.0, -1.0, 2.0, -2.0, 0.5, -0.5, 1.5, -1.5, 0.7, -0.7, 3.25, 0.1, 1.0 / 3.0, -17.0}) {
    for (const double origin : {0.0, 0.5, 10.0, 10.5, 10.25, -3.5, 19.999, 7.7}) {
      for (const std::int32_t count : {1, 2, 7, 30}) {
        const AxisMap map = map_axis(origin, zoom, 0, count, 0, 32);
        for (std::int32_t pixel = 0; pixel < 32; ++pixel) {
          const bool inside = pixel >= map.begin && pixel < map.end;
          ASSERT_EQ(inside ? map.source_of(pixel) : -1, source_by_rule(origin, zoom, count, pixel))
              << "zoom " << zoom << " origin " << origin << " count " << count << " pixel " << pixel;
        }
      }
    }
  }
}

TEST(PixelRectangles, KnowWhichSourcesAreSeen) {
  const SourceRange all = visible_sources(map_axis(0, 1, 0, 10, 0, 32));
  EXPECT_EQ(all.first, 0);
  EXPECT_EQ(all.end, 10);
  const SourceRange cut = visible_sources(map_axis(-4, 2, 0, 10, 0, 5));
  EXPECT_EQ(cut.first, 2);
  EXPECT_EQ(cut.end, 5);
  const SourceRange mirrored = visible_sources(map_axis(20, -2, 0, 100, 0, 32));
  EXPECT_EQ(mirrored.first, 0);
  EXPECT_EQ(mirrored.end, 10);
  const AxisMap rest = map_axis(-4, 2, 2, 3, 0, 5);
  EXPECT_EQ(rest.source_of(0), 0);
  EXPECT_EQ(rest.source_of(4), 2);
}

TEST(PixelRectangles, OfAbsurdZoomsAreEmptyOrFinite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr std::int32_t most = std::numeric_limits<std::int32_t>::max();
  for (const double zoom : {0.0, infinity, -infinity, std::nan("")}) EXPECT_TRUE(map_axis(0, zoom, 0, 10, 0, 32).empty());
  for (const double origin : {infinity, -infinity, std::nan("")}) EXPECT_TRUE(map_axis(origin, 1, 0, 10, 0, 32).empty());
  for (const double zoom : {1e-30, 1e30, -1e30, 3e38, 1e-45}) {
    for (const double origin : {0.0, -3e38, 3e38, 1e10, -1e10}) {
      const AxisMap map = map_axis(origin, zoom, 0, most, 0, 32);
      for (std::int32_t pixel = map.begin; pixel < map.end; ++pixel) EXPECT_GE(map.source_of(pixel), 0);
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
