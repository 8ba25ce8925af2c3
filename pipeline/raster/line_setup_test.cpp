#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {
namespace {

constexpr int height = 64;

std::vector<PixelPosition> pixels_of(float x0, float y0, float x1, float y1) {
  static const auto vertices = std::make_unique<ProcessedVertices>();
  vertices->window[0] = {x0, static_cast<float>(height) - y0, 0.5f, 1};
  vertices->window[1] = {x1, static_cast<float>(height) - y1, 0.5f, 1};
  const RasterBinding binding;
  SetupState state;
  state.binding = &binding;
  state.target_height_px = height;
  state.scissor = {-64, -64, 128, 128};
  PrimitiveRecord record;
  std::vector<PixelPosition> pixels;
  StippleCount count = 0;
  if (setup_line(state, *vertices, {{0, 1}, 1, false}, count, &record, pixels) != LinePixels::edges) return pixels;
  for (std::int32_t y = record.y0; y < record.y1; ++y) {
    for (std::int32_t x = record.x0; x < record.x1; ++x) {
      const auto inside = [&](const EdgeFunction& e) { return e.c + e.a * x + e.b * y >= 0; };
      if (std::all_of(record.edges.begin(), record.edges.end(), inside)) pixels.push_back({x, y});
    }
  }
  return pixels;
}

/// The definition itself [GL1.5 §3.4.1]: does the segment, moved by (-eps, -eps^2), meet the open diamond of (i, j), and
/// end outside it? eps is smaller than any distance that end points on a 1/256 grid leave to a tie.
bool diamond_rule_draws(long double x0, long double y0, long double x1, long double y1, int i, int j) {
  constexpr long double eps = 0x1p-24L, eps2 = eps * eps;
  x0 -= eps, x1 -= eps, y0 -= eps2, y1 -= eps2;
  const auto distance = [&](long double t) {
    return std::abs(x0 + (x1 - x0) * t - (i + 0.5L)) + std::abs(y0 + (y1 - y0) * t - (j + 0.5L));
  };
  if (distance(1) < 0.5L) return false;
  // The distance is convex and piecewise linear in t: its least value is at an end or where a term vanishes.
  std::vector<long double> candidates{0.0L, 1.0L};
  if (x1 != x0) candidates.push_back((i + 0.5L - x0) / (x1 - x0));
  if (y1 != y0) candidates.push_back((j + 0.5L - y0) / (y1 - y0));
  return std::any_of(candidates.begin(), candidates.end(), [&](long double t) { return t >= 0 && t <= 1 && distance(t) < 0.5L; });
}

void expect_diamond_rule(float x0, float y0, float x1, float y1) {
  const std::vector<PixelPosition> pixels = pixels_of(x0, y0, x1, y1);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < 64; ++i) {
      const bool drawn = std::find(pixels.begin(), pixels.end(), PixelPosition{i, j}) != pixels.end();
      ASSERT_EQ(drawn, diamond_rule_draws(x0, y0, x1, y1, i, j))
          << "pixel " << i << "," << j << " of " << x0 << "," << y0 << " - " << x1 << "," << y1;
    }
  }
}

TEST(Line, FromCentreToCentreLeavesTheLastPixel) {
  const std::vector<PixelPosition> pixels = pixels_of(10.5f, 20.5f, 30.5f, 20.5f);
  ASSERT_EQ(pixels.size(), 20u);
  EXPECT_EQ(pixels.front(), (PixelPosition{10, 20}));
  EXPECT_EQ(pixels.back(), (PixelPosition{29, 20}));
}

TEST(Line, OfNoLengthDrawsNothing) { EXPECT_TRUE(pixels_of(10.3f, 20.7f, 10.3f, 20.7f).empty()); }

TEST(Line, OnAPixelBorderFollowsTheShift) {
  for (const PixelPosition& pixel : pixels_of(10, 20, 30, 20)) EXPECT_EQ(pixel.y, 19);
  for (const PixelPosition& pixel : pixels_of(10, 20, 10, 30)) EXPECT_EQ(pixel.x, 9);
}

TEST(Line, AtRandomEndPointsObeysTheDiamondRule) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> sub_pixel(4 * 256, 60 * 256);
  for (int k = 0; k < 150; ++k) {
    const auto next = [&] { return static_cast<float>(sub_pixel(random)) / 256.0f; };
    const float x0 = next(), y0 = next(), x1 = next(), y1 = next();
    expect_diamond_rule(x0, y0, x1, y1);
    const auto near = [](float from, float to) { return from + std::round((to - from) * 8) / 256; };
    expect_diamond_rule(x0, y0, near(x0, x1), near(y0, y1));
  }
}

TEST(Line, AtHalfPixelEndPointsObeysTheDiamondRule) {
  for (int x0 = 0; x0 < 4; ++x0) {
    for (int y0 = 0; y0 < 4; ++y0) {
      for (int dx = -5; dx <= 5; ++dx) {
        for (int dy = -5; dy <= 5; ++dy) {
          const float fx = 20.0f + 0.25f * static_cast<float>(x0), fy = 20.0f + 0.25f * static_cast<float>(y0);
          expect_diamond_rule(fx, fy, fx + 0.5f * static_cast<float>(dx), fy + 0.5f * static_cast<float>(dy));
        }
      }
    }
  }
}

TEST(Line, StripsTouchEachPixelOfTheirJointsOnce) {
  std::mt19937 random(9);
  std::uniform_real_distribution<float> place(4, 60);
  for (int k = 0; k < 200; ++k) {
    const float x = place(random), y = place(random);
    const float dx = std::uniform_real_distribution<float>(-3, 3)(random), dy = std::uniform_real_distribution<float>(-3, 3)(random);
    std::vector<PixelPosition> whole = pixels_of(x - dx, y - dy, x, y);
    const std::vector<PixelPosition> second = pixels_of(x, y, x + dx, y + dy);
    for (const PixelPosition& pixel : second) EXPECT_EQ(std::count(whole.begin(), whole.end(), pixel), 0);
  }
}

TEST(Point, LandsInThePixelThatHoldsItsRoundedPosition) {
  const auto vertices = std::make_unique<ProcessedVertices>();
  const RasterBinding binding;
  SetupState state;
  state.binding = &binding;
  state.target_height_px = height;
  PrimitiveRecord record;
  state.scissor = {0, 0, 64, 64};
  vertices->window[0] = {10.999f, static_cast<float>(height) - 20.25f, 0.5f, 1};
  ASSERT_TRUE(setup_point(state, *vertices, {0, 0, false}, 1.0f, &record, nullptr));
  EXPECT_EQ((PixelRect{record.x0, record.y0, record.x1, record.y1}), (PixelRect{11, 20, 12, 21}));
}

TEST(Point, OfEvenSizeIsCentredOnTheNearestCorner) {
  const auto vertices = std::make_unique<ProcessedVertices>();
  const RasterBinding binding;
  SetupState state;
  state.binding = &binding;
  state.target_height_px = height;
  state.scissor = {0, 0, 64, 64};
  PrimitiveRecord record;
  vertices->window[0] = {10.4f, static_cast<float>(height) - 20.6f, 0.5f, 1};
  ASSERT_TRUE(setup_point(state, *vertices, {0, 0, false}, 2.5f, &record, nullptr));
  EXPECT_EQ((PixelRect{record.x0, record.y0, record.x1, record.y1}), (PixelRect{9, 20, 11, 22}));
}

TEST(Point, IsAttenuatedByItsDistanceFromTheEye) {
  PointState points;
  points.size_px = 20;
  points.attenuated = true;
  points.attenuation = {0, 0, 0.25f};
  EXPECT_FLOAT_EQ(derived_point_size(points, 0, 3, -4), 8.0f);
  points.smallest_px = 9;
  EXPECT_FLOAT_EQ(derived_point_size(points, 0, 3, -4), 9.0f);
  points.attenuation = {0, 0, -1};
  EXPECT_FLOAT_EQ(derived_point_size(points, 0, 3, -4), 9.0f) << "no number";
}

std::vector<PixelPosition> columns_of(const LineCoverage& coverage, int width) {
  std::vector<PixelPosition> columns, pixels;
  coverage.list_columns(columns);
  for (const PixelPosition& lowest : columns) coverage.list_column(lowest, pixels);
  EXPECT_EQ(pixels.size(), columns.size() * static_cast<std::size_t>(width));
  return pixels;
}

TEST(LineCoverage, EdgesAndBoxHoldExactlyTheListedPixels) {
  std::mt19937 random(3);
  int simple = 0;
  const auto order = [](const PixelPosition& a, const PixelPosition& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t grid = i % 4 == 0 ? 64 : i % 4 == 1 ? 128 : 1;  // every tie, and generic places
    const auto place = [&] { return static_cast<std::int64_t>(random() % (24 * 256)) / grid * grid; };
    const SubpixelPoint a{place(), place()};
    const SubpixelPoint b = i % 3 == 0 ? SubpixelPoint{a.x + place() / 16 / grid * grid, a.y + place() / 16 / grid * grid}
                                       : SubpixelPoint{place(), place()};
    if (a == b) continue;
    const int width = i % 5 + 1;
    const LineCoverage coverage(a, b, width);
    if (!coverage.is_simple()) continue;
    ++simple;
    std::vector<PixelPosition> listed = columns_of(coverage, width), inside;
    const auto edges = coverage.edges();
    const PixelRect box = coverage.box();
    for (std::int32_t y = box.y0; y < box.y1; ++y) {
      for (std::int32_t x = box.x0; x < box.x1; ++x) {
        const auto covers = [&](const EdgeFunction& e) { return e.c + e.a * x + e.b * y >= 0; };
        if (covers(edges[0]) && covers(edges[1])) inside.push_back({x, y});
      }
    }
    std::ranges::sort(listed, order);
    ASSERT_EQ(listed, inside) << a.x << "," << a.y << " - " << b.x << "," << b.y << " width " << width;
  }
  EXPECT_GT(simple, 19000);
}

// Coordinates run from the top left corner to the bottom right one, whatever the vertex has [ARB_point_sprite].
TEST(PointSprite, ItsCoordinatesRunOverIt) {
  const auto vertices = std::make_unique<ProcessedVertices>();
  vertices->window[0] = {20.5f, static_cast<float>(height) - 30.25f, 0.5f, 1};
  for (std::size_t k = 0; k < 4; ++k) vertices->varying[k][0] = 7.0f;
  TexturingState texturing;
  texturing.sprite_units = 1;
  RasterBinding binding;
  binding.texturing = &texturing;
  binding.varyings.count = 4;
  binding.varyings.texture_coordinates[0] = {0, 3, true};
  SetupState state;
  state.binding = &binding;
  state.target_height_px = height;
  state.scissor = {0, 0, 64, 64};
  state.points.sprite = true;
  alignas(64) std::byte memory[1024];
  ASSERT_TRUE(setup_point(state, *vertices, {0, 0, false}, 5.0f, memory, nullptr));
  const auto& record = *reinterpret_cast<const PrimitiveRecord*>(memory);
  EXPECT_EQ(record.x0, 18);
  EXPECT_EQ(record.x1, 23);
  EXPECT_EQ(record.y0, 28);
  EXPECT_EQ(record.y1, 33);
  const VaryingPlane* planes = planes_of(varyings_of(record));
  const auto value = [&](int k, double x, double y) { return planes[k].origin + planes[k].dx * (x - 0.5) + planes[k].dy * (y - 0.5); };
  EXPECT_NEAR(value(0, 18, 0), 0.0, 1e-9);
  EXPECT_NEAR(value(0, 23, 0), 1.0, 1e-9);
  EXPECT_NEAR(value(1, 0, 32.75), 0.0, 1e-9);
  EXPECT_NEAR(value(1, 0, 27.75), 1.0, 1e-9);
  EXPECT_EQ(planes[2].base, 0.0f);
  EXPECT_EQ(planes[3].base, 1.0f);
  EXPECT_EQ(varyings_of(record).constant, 0b1100u);
}

}  // namespace
}  // namespace gouraud::pipeline
