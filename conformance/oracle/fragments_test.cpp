#include <gtest/gtest.h>

#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

using pipeline::CompareFunc;
using pipeline::PrimitiveMode;

/// A picture-filling rectangle at one depth.
std::vector<TestVertex> screen(float z, std::array<float, 4> color) {
  return {at(0, 0, z, color), at(64, 0, z, color), at(64, 64, z, color), at(0, 64, z, color)};
}

constexpr std::array<float, 4> red{1, 0, 0, 1}, green{0, 1, 0, 1};

TEST(DepthTest, ComparesWithTheStoredDepth) {
  for (int f = 0; f < 8; ++f) {
    const auto func = static_cast<CompareFunc>(f);
    for (const float z : {0.25f, 0.5f, 0.75f}) {
      pipeline::DrawState state = window_state();
      state.raster.depth = {true, true, CompareFunc::always};
      TestOracle oracle;
      oracle.draw(state, PrimitiveMode::quads, screen(0.5f, red));
      state.raster.depth.func = func;
      oracle.draw(state, PrimitiveMode::quads, screen(z, green));
      const bool expected = func == CompareFunc::always || (func == CompareFunc::less && z < 0.5f) ||
                            (func == CompareFunc::lequal && z <= 0.5f) || (func == CompareFunc::greater && z > 0.5f) ||
                            (func == CompareFunc::gequal && z >= 0.5f) || (func == CompareFunc::equal && z == 0.5f) ||
                            (func == CompareFunc::notequal && z != 0.5f);
      EXPECT_EQ(oracle.pixel(5, 5).color[1] == 1.0, expected) << f << ' ' << z;
      EXPECT_EQ(oracle.pixel(5, 5).depth_units, static_cast<double>(expected ? z : 0.5f) * 16777215);
      EXPECT_EQ(oracle.picture().count(pixel_depth_ambiguous), 0u);
    }
  }
}

TEST(DepthTest, RoundsToTheBuffersBits) {
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, true, CompareFunc::less};
  TestOracle oracle16({}, 16), oracle24, oracle0({}, 0);
  for (TestOracle* oracle : {&oracle16, &oracle24, &oracle0})
    oracle->draw(state, PrimitiveMode::quads, screen(0.5f, red));
  EXPECT_EQ(oracle16.pixel(0, 0).depth_stored, 32768u);  // 32767.5 to even
  EXPECT_EQ(oracle24.pixel(0, 0).depth_stored, 8388608u);
  EXPECT_EQ(oracle0.pixel(0, 0).depth_stored, 0u);
  EXPECT_EQ(oracle0.pixel(0, 0).color[0], 1.0);
}

TEST(DepthTest, WithoutWritesLeavesTheDepth) {
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, false, CompareFunc::less};
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::quads, screen(0.5f, red));
  EXPECT_EQ(oracle.pixel(0, 0).color[0], 1.0);
  EXPECT_EQ(oracle.pixel(0, 0).depth_stored, 16777215u);
}

TEST(DepthTest, RepeatingTheSameGeometryIsEqual) {
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, true, CompareFunc::less};
  const auto triangle = [](std::array<float, 4> color) {
    return std::vector{at(1, 2, 0.1f, color), at(60, 7, 0.9f, color), at(20, 61, 0.4f, color)};
  };
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::triangles, triangle(red));
  const int covered = oracle.all_fragments();
  state.raster.depth.func = CompareFunc::equal;
  oracle.draw(state, PrimitiveMode::triangles, triangle(green));
  EXPECT_EQ(oracle.all_fragments(), 2 * covered);
  EXPECT_EQ(oracle.picture().count(pixel_depth_ambiguous), 0u);
}

/// A slanted rectangle, and one crossing it: only where they meet is the winner open.
TEST(DepthTest, KeepsBothOutcomesWhereSurfacesMeet) {
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, true, CompareFunc::less};
  TestOracle oracle;
  const float slope = 16.0f / 16777215;  // a quarter unit a pixel: surfaces meet under a very small angle
  oracle.draw(state, PrimitiveMode::quads, screen(0.5f, red));
  oracle.draw(state, PrimitiveMode::quads,
              {at(0, 0, 0.5f - slope, green), at(64, 0, 0.5f + slope, green), at(64, 64, 0.5f + slope, green),
               at(0, 64, 0.5f - slope, green)});
  EXPECT_EQ(oracle.picture().flags[oracle.picture().index(10, 30)] & pixel_depth_ambiguous, 0);
  EXPECT_EQ(oracle.picture().flags[oracle.picture().index(54, 30)] & pixel_depth_ambiguous, 0);
  const std::size_t middle = oracle.picture().index(31, 30);
  EXPECT_NE(oracle.picture().flags[middle] & pixel_depth_ambiguous, 0);
  ASSERT_EQ(oracle.picture().alternatives.count(middle), 1u);
  // Either colour is right, a mixture of both is not.
  const auto depth = oracle.picture().pixels[middle].depth_stored;
  EXPECT_EQ(measure(oracle.picture(), 31, 30, {255, 0, 0, 255}, depth).color, 0.0);
  EXPECT_EQ(measure(oracle.picture(), 31, 30, {0, 255, 0, 255}, depth).color, 0.0);
  EXPECT_GT(measure(oracle.picture(), 31, 30, {128, 128, 0, 255}, depth).color, 100.0);
  EXPECT_GT(measure(oracle.picture(), 54, 30, {0, 255, 0, 255}, depth).color, 100.0);
  // Covering everything settles it.
  state.raster.depth.func = CompareFunc::always;
  oracle.draw(state, PrimitiveMode::quads, screen(0.25f, red));
  EXPECT_TRUE(oracle.picture().alternatives.empty());
}

TEST(ColorMask, KeepsMaskedChannels) {
  pipeline::DrawState state = window_state();
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::quads, screen(0, {0.5f, 0.5f, 0.5f, 0.5f}));
  state.raster.color_write_mask = 0b1010;
  oracle.draw(state, PrimitiveMode::quads, screen(0, {1, 1, 1, 1}));
  EXPECT_EQ(oracle.pixel(9, 9).color, (std::array<double, 4>{0.5, 1, 0.5, 1}));
  EXPECT_EQ(oracle.pixel(9, 9).color_unorm8, (std::array<std::uint8_t, 4>{128, 255, 128, 255}));
}

TEST(Clear, ObeysScissorAndMasks) {
  TestOracle oracle;
  pipeline::ClearState clear;
  clear.color = clear.depth = true;
  clear.scissor = {10, 20, 12, 21};
  clear.color_write_mask = 0b0001;
  clear.clear_color = {0.25f, 1, 1, 1};
  clear.clear_depth = 0.3;
  oracle.clear(clear);
  EXPECT_EQ(oracle.pixel(11, 20).color, (std::array<double, 4>{0.25, 0, 0, 0}));
  EXPECT_EQ(oracle.pixel(11, 20).color_unorm8[0], 64);
  EXPECT_EQ(oracle.pixel(11, 20).depth_stored, 5033164u);
  EXPECT_EQ(oracle.pixel(12, 20).color[0], 0.0);
  EXPECT_EQ(oracle.pixel(12, 20).depth_stored, 16777215u);
}

TEST(Clear, StartsTheCountsAnew) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::quads, screen(0, red));
  EXPECT_EQ(oracle.picture().count(pixel_covered), 64u * 64u);
  pipeline::ClearState clear;
  clear.color = true;
  clear.scissor = {0, 0, test_size, test_size};
  oracle.clear(clear);
  EXPECT_EQ(oracle.picture().count(pixel_covered), 0u);
  EXPECT_EQ(oracle.all_fragments(), 0);
}

TEST(Measure, TakesDistancesFromTheIdeal) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::quads, screen(0, {0.25f, 0, 0, 1}));  // 63.75
  EXPECT_DOUBLE_EQ(measure(oracle.picture(), 1, 1, {64, 0, 0, 255}, 16777215).color, 0.25);
  EXPECT_DOUBLE_EQ(measure(oracle.picture(), 1, 1, {65, 0, 0, 255}, 16777215).color, 1.25);
  EXPECT_DOUBLE_EQ(measure(oracle.picture(), 1, 1, {64, 0, 0, 255}, 16777212).depth, 3.0);
  EXPECT_DOUBLE_EQ(measure(oracle.picture(), 1, 1, {64, 0, 0, 255}, 0, false).depth, 0.0);
}

TEST(SeparateSpecular, IsAddedToTheFragmentAndClamped) {
  pipeline::DrawState state = window_state();
  state.lighting.enabled = true;
  state.lighting.separate_specular = true;
  state.lighting.light_count = 1;
  state.lighting.lights[0].specular = {1, 1, 1, 1};
  state.lighting.lights[0].position_eye = {0, 0, 1};
  state.lighting.material.front.emission = {0.75f, 0.25f, 0, 1};
  state.lighting.material.front.specular = {0.5f, 0.5f, 0, 1};
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::quads, screen(0, red));
  EXPECT_EQ(oracle.pixel(3, 3).color, (std::array<double, 4>{1.0, 0.75, 0, 1}));
}

}  // namespace
}  // namespace gouraud::oracle
