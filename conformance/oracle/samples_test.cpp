// Multisampling: which samples primitives have, and what alpha leaves of them.
#include <gtest/gtest.h>

#include "conformance/oracle/blits.h"
#include "conformance/oracle/targets.h"
#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

using pipeline::PrimitiveMode;

/// An oracle with four samples a pixel.
struct SampledOracle : Oracle {
  SampledOracle() { target_changed(test_target(test_size, test_size, 24, 4)); }
  using Oracle::draw;
  void draw(const pipeline::DrawState& state, PrimitiveMode mode, const std::vector<TestVertex>& vertices) {
    draw(state, *make_batch(mode, vertices));
  }
};

pipeline::DrawState sampled_state() {
  pipeline::DrawState state = window_state();
  state.multisample.enabled = true;
  return state;
}

/// The mean of the pixel's samples, by way of a blit into a target of one.
double resolved(SampledOracle& oracle, int x, int y, std::size_t channel = 0) {
  pipeline::Blit blit{{x, y, x + 1, y + 1}, {x, y, x + 1, y + 1}};
  blit.scissor = {0, 0, test_size, test_size};
  blit.color = true;
  Samples to(1, oracle.picture());
  blit_samples(oracle.samples(), to, blit, 0xF);
  return to[0].pixels[to[0].index(x, y)].color[channel];
}

/// A rectangle as two triangles.
std::vector<TestVertex> rectangle(float x0, float y0, float x1, float y1, std::array<float, 4> color = {1, 1, 1, 1}) {
  return {at(x0, y0, 0, color), at(x1, y0, 0, color), at(x1, y1, 0, color), at(x0, y0, 0, color), at(x1, y1, 0, color), at(x0, y1, 0, color)};
}

TEST(Samples, OfPolygonsAreThoseInside) {
  // In steps of a quarter pixel upwards: each has a row of its own.
  for (int quarter = 0; quarter <= 4; ++quarter) {
    SampledOracle oracle;
    oracle.draw(sampled_state(), PrimitiveMode::triangles, rectangle(10, 10, 12, 10 + 0.25f * static_cast<float>(quarter)));
    EXPECT_DOUBLE_EQ(resolved(oracle, 10, 10), quarter / 4.0);
    EXPECT_DOUBLE_EQ(resolved(oracle, 10, 11), 0);
  }
}

TEST(Samples, HaveTheColourOfThePixelsCentre) {
  SampledOracle oracle;
  oracle.draw(sampled_state(), PrimitiveMode::triangles, {at(0, 0, 0, {0, 0, 0, 1}), at(64, 0, 0, {1, 0, 0, 1}), at(0, 64, 0, {0, 0, 0, 1})});
  for (const OraclePicture& picture : oracle.samples()) EXPECT_DOUBLE_EQ(picture.pixels[picture.index(20, 20)].color[0], 20.5 / 64);
}

TEST(Samples, HaveDepthsOfTheirOwnPlaces) {
  SampledOracle oracle;
  pipeline::DrawState state = sampled_state();
  state.raster.depth = {true, true, pipeline::CompareFunc::always};
  oracle.draw(state, PrimitiveMode::triangles, {at(0, 0, 0), at(64, 0, 0.5f), at(0, 64, 0)});
  for (std::size_t k = 0; k < 4; ++k) {
    const OraclePicture& picture = oracle.samples()[k];
    EXPECT_NEAR(picture.pixels[picture.index(20, 20)].depth_units / 16777215.0, (20 + sample_places[k].x) / 128, 1e-9);
  }
}

TEST(Samples, AreAllCoveredWhereMultisamplingIsOff) {
  SampledOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::triangles, rectangle(10, 10, 11, 10.55f));
  EXPECT_DOUBLE_EQ(resolved(oracle, 10, 10), 1);
}

TEST(Samples, AreLeftOutByTheMask) {
  SampledOracle oracle;
  pipeline::DrawState state = sampled_state();
  state.multisample.sample_mask = 0x5;
  oracle.draw(state, PrimitiveMode::triangles, rectangle(10, 10, 12, 12));
  EXPECT_DOUBLE_EQ(resolved(oracle, 10, 10), 0.5);
}

TEST(Samples, OfAlphaAreTheNearestNumber) {
  for (const auto& [alpha, count] : {std::pair{0.1f, 0}, {0.13f, 1}, {0.37f, 1}, {0.5f, 2}, {0.87f, 3}, {0.88f, 4}, {1.0f, 4}}) {
    SampledOracle oracle;
    pipeline::DrawState state = sampled_state();
    state.raster.alpha_to_coverage = 4;
    oracle.draw(state, PrimitiveMode::triangles, rectangle(10, 10, 12, 12, {1, 1, 1, alpha}));
    EXPECT_DOUBLE_EQ(resolved(oracle, 10, 10), count / 4.0) << alpha;
  }
}

TEST(Samples, AreOpaqueBeforeTheAlphaTest) {
  SampledOracle oracle;
  pipeline::DrawState state = sampled_state();
  state.raster.alpha_to_coverage = 4;
  state.raster.alpha_to_one = true;
  state.raster.alpha_test = {true, pipeline::CompareFunc::greater, 0.9f};
  oracle.draw(state, PrimitiveMode::triangles, rectangle(10, 10, 12, 12, {1, 1, 1, 0.5f}));
  EXPECT_DOUBLE_EQ(resolved(oracle, 10, 10, 3), 0.5);
}

TEST(Samples, OfLinesLieInTheirRectangle) {
  SampledOracle oracle;
  pipeline::DrawState state = sampled_state();
  state.lines.smooth = true;
  state.lines.width_px = 1.0f;
  oracle.draw(state, PrimitiveMode::lines, {at(10, 10), at(20.5f, 10)});
  EXPECT_DOUBLE_EQ(resolved(oracle, 15, 10), 0.5);
  EXPECT_DOUBLE_EQ(resolved(oracle, 15, 9), 0.5);
  EXPECT_DOUBLE_EQ(resolved(oracle, 20, 10), 0.25);
  EXPECT_DOUBLE_EQ(resolved(oracle, 9, 10), 0);
}

TEST(Samples, OfPointsLieInTheirDiscAndSmallOnesFade) {
  SampledOracle oracle;
  pipeline::DrawState state = sampled_state();
  state.points.smooth = true;
  state.points.size_px = 1.0f;
  oracle.draw(state, PrimitiveMode::points, {at(10, 10)});
  EXPECT_DOUBLE_EQ(resolved(oracle, 10, 10), 0.25);
  EXPECT_DOUBLE_EQ(resolved(oracle, 9, 9), 0.25);
  state.points.fade_threshold_px = 4.0f;
  oracle.draw(state, PrimitiveMode::points, {at(30, 30)});
  EXPECT_DOUBLE_EQ(resolved(oracle, 30, 30), 1);
  EXPECT_NEAR(resolved(oracle, 30, 30, 3), 16 / 255.0, 1e-9);
}

}  // namespace
}  // namespace gouraud::oracle
