#include "conformance/oracle/lighting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

using pipeline::PreparedLight;

/// One vertex at the origin of eye space with the normal (0, 0, 1), lit by one white light; nothing but what a test
/// asks.
struct LightingTest : testing::Test {
  LightingTest() {
    state.lighting.enabled = true;
    state.lighting.light_count = 1;
    state.lighting.material.front = black();
    state.lighting.material.back = black();
    light.diffuse = light.specular = light.ambient = glm::vec4(1.0f);
    light.position_eye = {0, 0, 1};
  }
  static pipeline::Material black() {
    pipeline::Material material;
    material.ambient = material.diffuse = material.specular = material.emission = {0, 0, 0, 1};
    return material;
  }
  VertexColors lit() { return lit(vertex); }
  VertexColors lit(const TestVertex& v) {
    state.lighting.lights[0] = light;
    const auto batch = make_batch(pipeline::PrimitiveMode::points, {v});
    Lighting lighting(state, *batch);
    const VertexColors colors = lighting.shade(0);
    knife_edges = lighting.knife_edges();
    return colors;
  }
  double red() { return lit().primary[front][0]; }

  pipeline::DrawState state;
  PreparedLight light;
  pipeline::Material& material = state.lighting.material.front;
  TestVertex vertex{{0, 0, 0, 1}, {0.25f, 0.5f, 0.75f, 0.125f}, {0, 0, 1}};
  std::int64_t knife_edges = 0;
};

TEST_F(LightingTest, OffPassesTheClampedColour) {
  state.lighting = {};
  vertex.color = {-1.0f, 0.5f, 2.0f, 0.25f};
  EXPECT_EQ(lit().primary[front], (Color{0, 0.5, 1, 0.25}));
}

TEST_F(LightingTest, DiffuseIsTheCosine) {
  material.diffuse = {0.5f, 0.25f, 1, 0.75f};
  light.position_eye = {0.6f, 0, 0.8f};
  const Color color = lit().primary[front];
  EXPECT_NEAR(color[0], 0.5 * 0.8f, 1e-12);
  EXPECT_NEAR(color[1], 0.25 * 0.8f, 1e-12);
  EXPECT_EQ(color[3], 0.75);  // alpha is the diffuse alpha
  light.position_eye = {0.6f, 0, -0.8f};
  EXPECT_EQ(red(), 0.0);
}

TEST_F(LightingTest, EmissionAndSceneAmbientNeedNoLight) {
  state.lighting.light_count = 0;
  state.lighting.scene_ambient = {0.5f, 0.5f, 0.5f, 1};
  material.emission = {0.125f, 0, 0, 1};
  material.ambient = {0.25f, 1, 0, 1};
  EXPECT_EQ(lit().primary[front], (Color{0.25, 0.5, 0, 1}));
}

TEST_F(LightingTest, AttenuationFallsWithDistance) {
  material.diffuse = {1, 1, 1, 1};
  light.positional = true;
  light.position_eye = {0, 0, 2};
  light.attenuation = {1, 0.5f, 0.25f};
  EXPECT_NEAR(red(), 1.0 / (1 + 0.5 * 2 + 0.25 * 4), 1e-12);
}

TEST_F(LightingTest, SpotLightsEndAtTheirCutoff) {
  material.diffuse = {1, 1, 1, 1};
  light.positional = light.spot = true;
  light.position_eye = {0, 0, 1};
  light.spot_exponent = 3;
  light.spot_cutoff_cosine = 0.5f;
  light.spot_direction_eye = {0, 0.6f, -0.8f};
  EXPECT_NEAR(red(), std::pow(static_cast<double>(0.8f), 3), 1e-12);
  light.spot_direction_eye = {0, 0.9f, -0.43588989f};
  EXPECT_EQ(red(), 0.0);
  EXPECT_EQ(knife_edges, 0);
  light.spot_cutoff_cosine = 0.43588989f;
  red();
  EXPECT_EQ(knife_edges, 1);
}

TEST_F(LightingTest, AZeroExponentIsOneEvenOfZero) {
  material.diffuse = {1, 1, 1, 1};
  light.positional = light.spot = true;
  light.position_eye = {0, 0, 1};
  light.spot_cutoff_cosine = 0.0f;
  light.spot_direction_eye = {1, 0, 0};
  EXPECT_EQ(red(), 1.0);
}

TEST_F(LightingTest, HighlightUsesTheHalfVector) {
  material.specular = {1, 1, 1, 1};
  material.shininess = 5;
  light.position_eye = {0.6f, 0, 0.8f};
  const double half_cosine = std::sqrt((1 + static_cast<double>(0.8f)) / 2);
  EXPECT_NEAR(red(), std::pow(half_cosine, 5), 1e-7);
  light.position_eye = {0.99f, 0, -0.1f};  // behind the surface, the half vector is not
  EXPECT_EQ(red(), 0.0);
}

TEST_F(LightingTest, LocalViewerSitsAtTheOrigin) {
  material.specular = {1, 1, 1, 1};
  material.shininess = 1;
  state.lighting.local_viewer = true;
  vertex.position = {3, 0, -4, 1};
  // To the eye (-0.6, 0, 0.8), to the light (0, 0, 1): half vector (-0.6, 0, 1.8) / sqrt(3.6).
  EXPECT_NEAR(red(), 1.8 / std::sqrt(3.6), 1e-12);
}

TEST_F(LightingTest, HomogeneousVerticesAreDivided) {
  material.diffuse = {1, 1, 1, 1};
  light.positional = true;
  light.position_eye = {0, 0, 2};
  light.attenuation = {0, 1, 0};
  const double plain = lit({{0, 0, 1.5f, 1}, {}, {0, 0, 1}}).primary[front][0];
  const double scaled = lit({{0, 0, 4.5f, 3}, {}, {0, 0, 1}}).primary[front][0];
  EXPECT_EQ(plain, scaled);
  EXPECT_EQ(plain, 1.0);  // 1 / 0.5 is clamped
}

TEST_F(LightingTest, SeparateSpecularGoesToTheSecondaryColour) {
  material.diffuse = {0.5f, 0.5f, 0.5f, 1};
  material.specular = {0.25f, 0, 0, 1};
  state.lighting.separate_specular = true;
  EXPECT_EQ(lit().primary[front], (Color{0.5, 0.5, 0.5, 1}));
  EXPECT_EQ(lit().secondary[front][0], 0.25);
}

TEST_F(LightingTest, TwoSidesLightTheBackWithTheNegatedNormal) {
  state.lighting.two_sided = true;
  material.diffuse = {1, 0, 0, 1};
  state.lighting.material.back.diffuse = {0, 1, 0, 1};
  light.position_eye = {0, 0, -1};
  EXPECT_EQ(lit().primary[front], (Color{0, 0, 0, 1}));
  EXPECT_EQ(lit().primary[back], (Color{0, 1, 0, 1}));
  state.lighting.two_sided = false;
  EXPECT_EQ(lit().primary[back], lit().primary[front]);
}

TEST_F(LightingTest, ColorMaterialFollowsTheVertexColour) {
  state.lighting.color_material_front = pipeline::material_diffuse;
  EXPECT_EQ(lit().primary[front], (Color{0.25, 0.5, 0.75, 0.125}));
  state.lighting.color_material_front = pipeline::material_emission;
  state.lighting.light_count = 0;
  EXPECT_EQ(lit().primary[front], (Color{0.25, 0.5, 0.75, 1}));
}

TEST_F(LightingTest, MaterialRunsChangeLaterVertices) {
  state.lighting.light_count = 0;
  const auto batch = make_batch(pipeline::PrimitiveMode::points, {vertex, vertex, vertex, vertex});
  pipeline::MaterialRun run{1, {black(), black()}};
  run.material.front.emission = {0.5f, 0, 0, 1};
  batch->material_runs.push_back(run);
  run.first = 3;
  run.material.front.emission = {0.75f, 0, 0, 1};
  batch->material_runs.push_back(run);
  Lighting lighting(state, *batch);
  EXPECT_EQ(lighting.shade(0).primary[front][0], 0.0);
  EXPECT_EQ(lighting.shade(1).primary[front][0], 0.5);
  EXPECT_EQ(lighting.shade(2).primary[front][0], 0.5);
  EXPECT_EQ(lighting.shade(3).primary[front][0], 0.75);
}

TEST_F(LightingTest, NormalsGoThroughTheInverseTranspose) {
  material.diffuse = {1, 1, 1, 1};
  state.transform.modelview[0][0] = 2.0f;  // scales x: a plane's normal (1, 0, 1) becomes (0.5, 0, 1)
  vertex.normal = {1, 0, 1};
  light.position_eye = {1, 0, 0};
  EXPECT_NEAR(red(), 0.5, 1e-12);
  state.transform.normal_scaling = pipeline::NormalScaling::normalize;
  EXPECT_NEAR(red(), 0.5 / std::sqrt(1.25), 1e-12);
}

TEST_F(LightingTest, RescaleUndoesAUniformScale) {
  material.diffuse = {1, 1, 1, 1};
  for (int i = 0; i < 3; ++i) state.transform.modelview[i][i] = 4.0f;
  EXPECT_NEAR(red(), 0.25, 1e-12);
  state.transform.normal_scaling = pipeline::NormalScaling::rescale;
  EXPECT_NEAR(red(), 1.0, 1e-12);
}

TEST_F(LightingTest, AZeroNormalLeavesTheAmbientTerms) {
  state.transform.normal_scaling = pipeline::NormalScaling::normalize;
  vertex.normal = {0, 0, 0};
  material.ambient = {0.25f, 0, 0, 1};
  material.diffuse = material.specular = {1, 1, 1, 1};
  EXPECT_EQ(red(), 0.25);
}

TEST_F(LightingTest, GrazingHighlightsAreReported) {
  material.specular = {1, 1, 1, 1};
  light.position_eye = {1, 0, 0};
  EXPECT_EQ(red(), 0.0);
  EXPECT_EQ(knife_edges, 1);
}

}  // namespace
}  // namespace gouraud::oracle
