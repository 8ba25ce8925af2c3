#include "pipeline/geometry/lighting.h"

#include <cmath>

#include "pipeline/geometry/test_support.h"

namespace gouraud::pipeline {
namespace {

/// One vertex to be lit, and its colours.
struct Vertex {
  glm::vec3 normal{0, 0, 1};
  glm::vec4 position{0, 0, 0, 1};
  glm::vec4 color{0, 0, 0, 0};
};
struct Lit {
  Rgba front, back, specular_front, specular_back;
};

Lit light_one(const LightingState& state, const Vertex& vertex) {
  const auto batch = random_batch(1, 1);
  const auto out = blank_vertices();
  for (std::size_t k = 0; k < 4; ++k) {
    if (k < 3) out->normal_eye[k][0] = vertex.normal[static_cast<int>(k)];
    out->position_eye[k][0] = vertex.position[static_cast<int>(k)];
    batch->color[k][0] = vertex.color[static_cast<int>(k)];
  }
  light_vertices(state, *batch, *out);
  return {out->color_front[0], out->color_back[0], out->specular_front[0], out->specular_back[0]};
}

/// Lighting on, everything black: no ambient light, a material that reflects nothing.
LightingState darkness() {
  LightingState state;
  state.enabled = true;
  for (Material* m : {&state.material.front, &state.material.back}) m->ambient = m->diffuse = {0, 0, 0, 1};
  return state;
}
constexpr glm::vec4 white(1, 1, 1, 1);
const float root_half = std::sqrt(0.5f);

/// A white light from +z on a material that reflects diffuse light.
LightingState one_light(bool positional, glm::vec3 position) {
  LightingState state = darkness();
  state.light_count = 1;
  state.lights[0].diffuse = white;
  state.lights[0].positional = positional;
  state.lights[0].position_eye = position;
  state.material.front.diffuse = state.material.back.diffuse = white;
  return state;
}

/// The same with a highlight only.
LightingState one_highlight(bool positional, glm::vec3 position, float shininess) {
  LightingState state = one_light(positional, position);
  state.lights[0].diffuse = {0, 0, 0, 1};
  state.lights[0].specular = state.material.front.specular = state.material.back.specular = white;
  state.material.front.shininess = state.material.back.shininess = shininess;
  return state;
}

TEST(Lighting, WithoutLightsIsEmissionPlusSceneAmbient) {
  LightingState state = darkness();
  state.scene_ambient = {0.5f, 0.25f, 1, 1};
  state.material.front.ambient = {0.5f, 0.5f, 0.5f, 1};
  state.material.front.emission = {0, 0.25f, 0.125f, 0.9f};
  state.material.front.diffuse.w = 0.75f;
  const Rgba color = light_one(state, {}).front;
  EXPECT_EQ(color.r, 0.25f);
  EXPECT_EQ(color.g, 0.375f);
  EXPECT_EQ(color.b, 0.625f);
  EXPECT_EQ(color.a, 0.75f);  // of the diffuse material
}

TEST(DirectionalLight, GivesTheCosineOfTheAngle) {
  const LightingState state = one_light(false, {0.6f, 0, 0.8f});
  EXPECT_FLOAT_EQ(light_one(state, {{0, 0, 1}}).front.r, 0.8f);
  EXPECT_FLOAT_EQ(light_one(state, {{1, 0, 0}}).front.r, 0.6f);
  EXPECT_EQ(light_one(state, {{0, 1, 0}}).front.r, 0.0f);
  EXPECT_EQ(light_one(state, {{-1, 0, 0}}).front.r, 0.0f);
}

TEST(PositionalLight, ShinesFromItsPlace) {
  const LightingState state = one_light(true, {3, 0, 4});
  EXPECT_FLOAT_EQ(light_one(state, {}).front.r, 0.8f);
  EXPECT_FLOAT_EQ(light_one(state, {{0, 0, 1}, {3, 0, 3, 1}}).front.r, 1.0f);
  EXPECT_FLOAT_EQ(light_one(state, {{0, 0, 1}, {6, 0, 6, 2}}).front.r, 1.0f);  // the same point, homogeneous
  EXPECT_EQ(light_one(state, {{0, 0, 1}, {3, 0, 5, 1}}).front.r, 0.0f);        // from behind
}

TEST(PositionalLight, IsAttenuatedByDistance) {
  LightingState state = one_light(true, {0, 0, 2});
  state.lights[0].attenuation = {1, 0.5f, 0.25f};
  state.lights[0].ambient = {0.3f, 0.3f, 0.3f, 1};
  state.material.front.ambient = white;
  EXPECT_FLOAT_EQ(light_one(state, {}).front.r, 1.3f / 3);
}

TEST(PositionalLight, GivesOnlyAmbientLightToAVertexInIt) {
  LightingState state = one_light(true, {1, 2, 3});
  state.lights[0].ambient = {0.25f, 0, 0, 1};
  state.material.front.ambient = white;
  const Rgba color = light_one(state, {{0, 0, 1}, {1, 2, 3, 1}}).front;
  EXPECT_EQ(color.r, 0.25f);
  EXPECT_EQ(color.g, 0.0f);
}

TEST(PositionalLight, WithoutAnyAttenuationConstantLeavesBlackBlack) {
  LightingState state = one_light(true, {0, 0, 1});
  state.lights[0].attenuation = {0, 0, 0};
  state.lights[0].diffuse = {1, 0, 0.5f, 1};
  const Rgba color = light_one(state, {}).front;
  EXPECT_EQ(color.r, 1.0f);
  EXPECT_EQ(color.g, 0.0f);
  EXPECT_EQ(color.b, 1.0f);
}

/// A spot light at the origin that looks down -z; the vertex lies `degrees` off its axis and faces it.
float seen_off_axis(const LightingState& state, float degrees) {
  const float angle = degrees * 3.14159265f / 180;
  const glm::vec3 direction(std::sin(angle), 0, -std::cos(angle));
  return light_one(state, {-direction, {direction * 2.0f, 1}}).front.r;
}
LightingState one_spot(float cutoff_cosine, float exponent) {
  LightingState state = one_light(true, {0, 0, 0});
  state.lights[0].spot = true;
  state.lights[0].spot_direction_eye = {0, 0, -1};
  state.lights[0].spot_cutoff_cosine = cutoff_cosine;
  state.lights[0].spot_exponent = exponent;
  return state;
}

TEST(SpotLight, ShinesInsideItsConeAndNowhereElse) {
  const LightingState state = one_spot(root_half, 0);
  for (const float sign : {-1.0f, 1.0f}) {
    for (const float degrees : {0.0f, 10.0f, 44.99f})
      EXPECT_FLOAT_EQ(seen_off_axis(state, sign * degrees), 1.0f) << degrees;
    for (const float degrees : {45.01f, 90.0f, 135.0f, 180.0f})
      EXPECT_EQ(seen_off_axis(state, sign * degrees), 0.0f) << degrees;
  }
}

TEST(SpotLight, ShinesOnItsRim) {
  EXPECT_EQ(seen_off_axis(one_spot(1, 0), 0), 1.0f);
  EXPECT_EQ(seen_off_axis(one_spot(1, 0), 1), 0.0f);
}

TEST(SpotLight, FadesWithThePowerOfTheCosine) {
  for (const float exponent : {1.0f, 2.0f, 7.5f, 128.0f}) {
    const double expected = std::pow(std::cos(20 * 3.14159265358979 / 180), exponent);
    EXPECT_NEAR(seen_off_axis(one_spot(0, exponent), 20), expected, 1e-5 * expected);
  }
}

TEST(SpotLight, OfNinetyDegreesContributesNothingBehind) {
  for (const float exponent : {0.0f, 1.0f}) {
    EXPECT_GT(seen_off_axis(one_spot(0, exponent), 89), 0.0f);
    EXPECT_EQ(seen_off_axis(one_spot(0, exponent), 91), 0.0f);
    EXPECT_EQ(seen_off_axis(one_spot(0, exponent), 180), 0.0f);
  }
}

TEST(SpotLight, AtInfinityShinesOnEverythingOrNothing) {
  LightingState state = one_spot(0.5f, 2);
  state.lights[0].positional = false;
  state.lights[0].position_eye = {0, 0, 1};
  EXPECT_FLOAT_EQ(light_one(state, {}).front.r, 1.0f);
  state.lights[0].spot_direction_eye = {0.6f, 0, -0.8f};
  EXPECT_FLOAT_EQ(light_one(state, {}).front.r, 0.64f);
  state.lights[0].spot_direction_eye = {0.8f, 0, 0.6f};
  EXPECT_EQ(light_one(state, {}).front.r, 0.0f);
}

TEST(Highlight, IsThePowerOfTheCosineToTheHalfVector) {
  // Light from +x, viewer at +z: the half vector is their diagonal.
  for (const float shininess : {1.0f, 2.0f, 5.0f, 10.5f}) {
    const double expected = std::pow(std::sqrt(0.5), shininess);
    EXPECT_NEAR(light_one(one_highlight(false, {1, 0, 0}, shininess), {{1, 0, 0}}).front.r, expected, 1e-6);
    EXPECT_NEAR(light_one(one_highlight(true, {9, 0, 0}, shininess), {{1, 0, 0}}).front.r, expected, 1e-6);
  }
}

TEST(Highlight, OfALocalViewerLooksTowardsTheEye) {
  LightingState state = one_highlight(true, {4, 0, 3}, 1);
  state.local_viewer = true;
  // From (0, 0, 3) the eye is along -z, the light along +x.
  EXPECT_NEAR(light_one(state, {{1, 0, 0}, {0, 0, 3, 1}}).front.r, std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(light_one(state, {{root_half, 0, -root_half}, {0, 0, 3, 1}}).front.r, 1.0, 1e-6);
}

TEST(Highlight, VanishesWhereTheLightIsBehind) {
  const LightingState state = one_highlight(false, {1, 0, 0}, 0);
  EXPECT_EQ(light_one(state, {{-0.1f, 0, 1}}).front.r, 0.0f);
  EXPECT_EQ(light_one(state, {{0, 0, 1}}).front.r, 0.0f);
  EXPECT_EQ(light_one(state, {{1e-30f, 0, 1}}).front.r, 1.0f);
}

TEST(Highlight, OfShininessZeroIsEverywhereThatTheLightReaches) {
  // n . h is negative here, and 0^0 = 1.
  EXPECT_EQ(light_one(one_highlight(false, {1, 0, 0}, 0), {{0.1f, 0, -1}}).front.r, 1.0f);
  EXPECT_EQ(light_one(one_highlight(true, {1, 0, 0}, 0), {{0.1f, 0, -1}}).front.r, 1.0f);
  EXPECT_EQ(light_one(one_highlight(true, {1, 0, 0}, 1), {{0.1f, 0, -1}}).front.r, 0.0f);
}

TEST(Highlight, HasNoHalfVectorWhereLightAndViewerAreOpposite) {
  for (const bool positional : {false, true}) {
    EXPECT_EQ(light_one(one_highlight(positional, {0, 0, -1}, 8), {{0, 0, -1}}).front.r, 0.0f);
  }
}

TEST(TwoSided, LightsTheBackWithTheReversedNormalAndTheBackMaterial) {
  LightingState state = one_light(false, {0, 0, 1});
  state.two_sided = true;
  state.material.back.diffuse = {0, 0.5f, 0, 0.25f};
  Lit lit = light_one(state, {{0, 0, 1}});
  EXPECT_EQ(lit.front.r, 1.0f);
  EXPECT_EQ(lit.back.g, 0.0f);
  EXPECT_EQ(lit.back.a, 0.25f);
  lit = light_one(state, {{0, 0, -1}});
  EXPECT_EQ(lit.front.r, 0.0f);
  EXPECT_EQ(lit.back.r, 0.0f);
  EXPECT_EQ(lit.back.g, 0.5f);
}

TEST(TwoSided, GivesEachFaceItsShininess) {
  LightingState state = one_highlight(false, {1, 0, 0}, 2);
  state.two_sided = true;
  state.material.back.shininess = 4;
  EXPECT_NEAR(light_one(state, {{1, 0, 0}}).front.r, 0.5, 1e-6);
  EXPECT_NEAR(light_one(state, {{-1, 0, 0}}).back.r, 0.25, 1e-6);
}

TEST(SeparateSpecular, MovesTheHighlightIntoTheSecondaryColor) {
  LightingState state = one_highlight(false, {0, 0, 1}, 3);
  state.lights[0].diffuse = {0.5f, 0.5f, 0.5f, 1};
  state.separate_specular = true;
  const Lit lit = light_one(state, {});
  EXPECT_EQ(lit.front.r, 0.5f);
  EXPECT_EQ(lit.specular_front.r, 1.0f);
  EXPECT_EQ(lit.specular_front.a, 0.0f);
}

TEST(ColorMaterial, LetsTheNamedParametersFollowTheColor) {
  LightingState state = one_highlight(false, {0, 0, 1}, 1);
  state.lights[0].diffuse = white;
  state.lights[0].specular = {0.125f, 0.125f, 0.125f, 1};
  state.material.front.emission = {0.0625f, 0, 0, 1};
  const Vertex vertex{{0, 0, 1}, {0, 0, 0, 1}, {0.5f, 0.25f, 0, 0.75f}};
  state.color_material_front = material_diffuse;
  Rgba color = light_one(state, vertex).front;
  EXPECT_EQ(color.r, 0.5f + 0.125f + 0.0625f);
  EXPECT_EQ(color.g, 0.25f + 0.125f);
  EXPECT_EQ(color.a, 0.75f);
  state.color_material_front = material_specular | material_emission;
  color = light_one(state, vertex).front;
  EXPECT_EQ(color.g, 1.0f);  // white diffuse
  state.lights[0].diffuse = {0, 0, 0, 1};
  color = light_one(state, vertex).front;
  EXPECT_EQ(color.r, 0.5f * 0.125f + 0.5f);
  EXPECT_EQ(color.g, 0.25f * 0.125f + 0.25f);
  EXPECT_EQ(color.a, 1.0f);
}

TEST(Lighting, OfAZeroNormalIsAmbientAlone) {
  LightingState state = one_highlight(true, {0, 0, 1}, 4);
  state.lights[0].diffuse = white;
  state.scene_ambient = {0.25f, 0.25f, 0.25f, 1};
  state.material.front.ambient = white;
  EXPECT_EQ(light_one(state, {{0, 0, 0}}).front.r, 0.25f);
}

TEST(Lighting, IsClampedOnceAtTheEnd) {
  LightingState state = one_light(false, {0, 0, 1});
  state.light_count = 2;
  state.lights[1] = state.lights[0];
  state.lights[1].diffuse = {-0.75f, -2, 0.5f, 1};  // negative light is legal
  const Rgba color = light_one(state, {}).front;
  EXPECT_EQ(color.r, 0.25f);
  EXPECT_EQ(color.g, 0.0f);
  EXPECT_EQ(color.b, 1.0f);
}

}  // namespace
}  // namespace gouraud::pipeline
