#include "conformance/oracle/oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

using pipeline::PrimitiveMode;

TEST(Oracle, NewTargetsAreZero) {
  Oracle oracle;
  oracle.target_changed(test_target(3, 2, 16));
  EXPECT_EQ(oracle.picture().pixels.size(), 6u);
  EXPECT_EQ(oracle.picture().pixels[5], OraclePixel{});
  EXPECT_EQ(oracle.picture().depth_bits, 16);
}

TEST(Oracle, RowsGoBottomUp) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::points, {at(5.5f, 2.5f)});
  EXPECT_EQ(oracle.picture().pixels[2 * test_size + 5].color[0], 1.0);
}

TEST(Oracle, ViewportAndDepthRangeMapTheView) {
  pipeline::DrawState state = window_state();
  state.viewport = {16, 32, 8, 4, 0.25, 0.75, test_size};
  state.raster.depth = {true, true, pipeline::CompareFunc::less};
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::quads, {at(0, 0, 0.5f), at(64, 0, 0.5f), at(64, 64, 0.5f), at(0, 64, 0.5f)});
  EXPECT_EQ(oracle.all_fragments(), 8 * 4);
  EXPECT_EQ(oracle.fragments(16, 32), 1);
  EXPECT_EQ(oracle.fragments(23, 35), 1);
  EXPECT_EQ(oracle.pixel(16, 32).depth_stored, 8388608u);
}

TEST(Oracle, TwoSidedLightingFollowsTheFacing) {
  pipeline::DrawState state = window_state();
  state.lighting.enabled = state.lighting.two_sided = true;
  state.lighting.material.front.emission = {1, 0, 0, 1};
  state.lighting.material.back.emission = {0, 1, 0, 1};
  TestOracle oracle;
  oracle.draw(state, PrimitiveMode::triangles, {at(0, 0), at(20, 0), at(0, 20), at(40, 40), at(40, 60), at(60, 40)});
  EXPECT_EQ(oracle.pixel(5, 5).color[0], 1.0);
  EXPECT_EQ(oracle.pixel(45, 45).color[1], 1.0);
  // Lines and points always show their front.
  oracle.draw(state, PrimitiveMode::lines, {at(60.5f, 5.5f), at(40.5f, 5.5f)});
  EXPECT_EQ(oracle.pixel(50, 5).color[0], 1.0);
}

/// The float chain moves vertices by at most 1/512 pixel and a little rounding: only pixels on edges can change.
TEST(PositionModels, AgreeAwayFromEdges) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> coordinate(0.0f, 64.0f);
  long differing = 0, covered = 0;
  for (int n = 0; n < 200; ++n) {
    const std::vector<TestVertex> triangle{at(coordinate(random), coordinate(random), 0, {1, 0, 0, 1}),
                                           at(coordinate(random), coordinate(random), 0, {0, 1, 0, 1}),
                                           at(coordinate(random), coordinate(random), 0, {0, 0, 1, 1})};
    TestOracle snapped, exact({PositionModel::exact, 0.5});
    snapped.draw(window_state(), PrimitiveMode::triangles, triangle);
    exact.draw(window_state(), PrimitiveMode::triangles, triangle);
    for (std::size_t i = 0; i < snapped.picture().pixels.size(); ++i) {
      const int a = snapped.picture().fragments_written[i], b = exact.picture().fragments_written[i];
      covered += b;
      differing += a != b;
      if (a && b && !(snapped.picture().flags[i] & pixel_extrapolated)) {
        EXPECT_NEAR(snapped.picture().pixels[i].color[0], exact.picture().pixels[i].color[0], 1e-3);
      }
    }
  }
  EXPECT_LT(static_cast<double>(differing), 0.002 * static_cast<double>(covered));
}

/// Nothing crashes, and every stored value is in range, whatever is poured in.
TEST(BadInput, HasADefinedResult) {
  std::mt19937 random(6);
  const std::vector<float> poison{std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::infinity(),
                                  -std::numeric_limits<float>::infinity(),
                                  1e38f,
                                  -3e38f,
                                  1e-40f,
                                  0.0f,
                                  -1.0f};
  const auto number = [&] {
    return random() % 4 == 0 ? poison[random() % poison.size()] : std::uniform_real_distribution(-2.0f, 2.0f)(random);
  };
  const auto color = [&] { return glm::vec4(number(), number(), number(), number()); };
  for (int n = 0; n < 400; ++n) {
    pipeline::DrawState state = window_state();
    if (n % 2) {
      for (int i = 0; i < 3; ++i)
        state.transform.modelview[static_cast<int>(random() % 4)][static_cast<int>(random() % 4)] = number();
      state.transform.modelview_projection = state.transform.projection * state.transform.modelview;
    } else {
      state.transform.projection = state.transform.modelview_projection = glm::mat4(1.0f);
    }
    state.transform.normal_scaling = static_cast<pipeline::NormalScaling>(random() % 3);
    state.raster.depth = {true, true, static_cast<pipeline::CompareFunc>(random() % 8)};
    state.assembly.polygon_mode_front = static_cast<pipeline::PolygonMode>(random() % 3);
    state.assembly.polygon_mode_back = static_cast<pipeline::PolygonMode>(random() % 3);
    pipeline::LightingState& lighting = state.lighting;
    lighting.enabled = random() % 2;
    lighting.two_sided = lighting.local_viewer = lighting.separate_specular = random() % 2;
    lighting.light_count = 2;
    for (auto& light : lighting.lights) {
      light = {color(),
               color(),
               color(),
               random() % 2 == 0,
               glm::vec3(color()),
               glm::vec3(color()),
               random() % 2 == 0,
               glm::vec3(color()),
               number(),
               number()};
    }
    lighting.material = {{color(), color(), color(), color(), number()},
                         {color(), color(), color(), color(), number()}};
    std::vector<TestVertex> vertices(12);
    for (TestVertex& vertex : vertices) {
      vertex = {{number(), number(), number(), n % 3 ? 1.0f : number()},
                {number(), number(), number(), number()},
                {number(), number(), number()}};
    }
    TestOracle oracle({n % 4 < 2 ? PositionModel::snapped : PositionModel::exact, 0.5});
    oracle.draw(state, static_cast<PrimitiveMode>(n % 10), vertices);
    for (const OraclePixel& pixel : oracle.picture().pixels) {
      for (const double channel : pixel.color) EXPECT_TRUE(channel >= 0 && channel <= 1);
      EXPECT_LE(pixel.depth_stored, 16777215u);
    }
  }
}

}  // namespace
}  // namespace gouraud::oracle
