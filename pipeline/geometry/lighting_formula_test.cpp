// Lighting against the formula of [GL1.5 §2.14.1] in plain double, for every combination of features.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "pipeline/geometry/lighting.h"
#include "pipeline/geometry/test_support.h"

namespace gouraud::pipeline {
namespace {

constexpr glm::vec4 white(1, 1, 1, 1);

struct Reference {
  double primary[4] = {}, secondary[3] = {};
  double magnitude = 0;  ///< of the largest channel's terms
};

double dot(const double (&a)[3], const double (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
void normalize(double (&v)[3]) {
  const double length = std::sqrt(dot(v, v));
  for (double& x : v) x = length > 0 ? x / length : 0;
}

Reference reference(const LightingState& state, const Material& material, const ProcessedVertices& vertices,
                    std::size_t i, double side) {
  Reference out;
  double n[3], p[3], terms[3] = {};
  for (std::size_t k = 0; k < 3; ++k) {
    n[k] = side * vertices.normal_eye[k][i];
    p[k] = vertices.position_eye[k][i] / static_cast<double>(vertices.position_eye[3][i]);
  }
  const auto add = [&](double* sum, double factor, const glm::vec4& a, const glm::vec4& b) {
    for (int k = 0; k < 3; ++k) {
      const double term = factor * static_cast<double>(a[k]) * static_cast<double>(b[k]);
      sum[k] += term;
      terms[k] += std::abs(term);
      out.magnitude = std::max(out.magnitude, terms[k]);
    }
  };
  add(out.primary, 1, material.emission, white);
  add(out.primary, 1, material.ambient, state.scene_ambient);
  out.primary[3] = material.diffuse.w;
  for (std::size_t l = 0; l < state.light_count; ++l) {
    const PreparedLight& light = state.lights[l];
    double vp[3], h[3], axis[3];
    for (int k = 0; k < 3; ++k) {
      vp[k] = light.position_eye[k] - (light.positional ? p[k] : 0);
      axis[k] = -light.spot_direction_eye[k];
      h[k] = state.local_viewer ? -p[k] : k == 2 ? 1 : 0;
    }
    double strength = 1;
    if (light.positional) {
      const double distance = std::sqrt(dot(vp, vp));
      strength =
          1 / (light.attenuation[0] + light.attenuation[1] * distance + light.attenuation[2] * distance * distance);
      normalize(vp);
    }
    if (light.spot) {
      const double cosine = dot(vp, axis);
      strength *= cosine >= light.spot_cutoff_cosine ? std::pow(cosine, light.spot_exponent) : 0;
    }
    normalize(h);
    for (int k = 0; k < 3; ++k) h[k] += vp[k];
    normalize(h);
    const double n_dot_vp = std::max(dot(n, vp), 0.0);
    add(out.primary, strength, material.ambient, light.ambient);
    add(out.primary, strength * n_dot_vp, material.diffuse, light.diffuse);
    const double highlight = n_dot_vp > 0 ? std::pow(std::max(dot(n, h), 0.0), material.shininess) : 0;
    add(state.separate_specular ? out.secondary : out.primary, strength * highlight, material.specular, light.specular);
  }
  return out;
}

enum Feature : unsigned {
  positional = 1,
  attenuated = 2,
  spot = 4,
  specular = 8,
  local_viewer = 16,
  two_sided = 32,
  separate = 64,
  color_material = 128,
  whole_exponents = 256,
  every_feature = 511
};

LightingState random_state(unsigned features, Numbers& number) {
  const auto has = [features](Feature f) { return (features & f) != 0; };
  const auto color = [&] {
    return glm::vec4(std::abs(number()), std::abs(number()), std::abs(number()), std::abs(number())) * 0.4f;
  };
  const auto exponent = [&] {
    return has(whole_exponents) ? static_cast<float>(number.below(129)) : 64 + 64 * number();
  };
  LightingState state;
  state.enabled = true;
  state.two_sided = has(two_sided);
  state.local_viewer = has(local_viewer);
  state.separate_specular = has(separate);
  state.scene_ambient = color();
  state.light_count = static_cast<std::uint8_t>(1 + number.below(max_lights));
  for (PreparedLight& light : state.lights) {
    light.ambient = color();
    light.diffuse = color();
    if (has(specular)) light.specular = color();
    light.positional = has(positional) && number.below(4) != 0;
    light.position_eye = {number(), number(), number()};
    if (light.positional) light.position_eye *= 10.0f;
    if (!light.positional) light.position_eye *= 1 / glm::length(light.position_eye);
    if (has(attenuated) && light.positional)
      light.attenuation = {std::abs(number()), std::abs(number()), std::abs(number())};
    light.spot = has(spot);
    if (!light.spot) continue;
    light.spot_direction_eye = {number(), number(), number()};
    light.spot_direction_eye *= 1 / glm::length(light.spot_direction_eye);
    light.spot_cutoff_cosine = std::abs(number());
    light.spot_exponent = exponent();
  }
  for (Material* m : {&state.material.front, &state.material.back}) {
    if (m == &state.material.back && !has(two_sided)) continue;
    *m = {color(), color(), has(specular) ? color() : glm::vec4(0), color() * 0.2f, exponent()};
  }
  if (has(color_material)) {
    state.color_material_front = static_cast<std::uint8_t>(number.below(16));
    state.color_material_back = static_cast<std::uint8_t>(has(two_sided) ? number.below(16) : 0);
  }
  return state;
}

void fill_eye_space(ProcessedVertices& vertices, std::int32_t count, Numbers& number) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    glm::vec3 n(number(), number(), number());
    n *= 1 / glm::length(n);
    for (std::size_t k = 0; k < 3; ++k) vertices.normal_eye[k][i] = n[static_cast<int>(k)];
    for (std::size_t k = 0; k < 4; ++k) vertices.position_eye[k][i] = k == 3 ? 1.0f + 0.5f * number() : 5 * number();
  }
}

Material tracked(Material material, std::uint8_t bits, const VertexBatch& batch, std::size_t i) {
  const glm::vec4 color(batch.color[0][i], batch.color[1][i], batch.color[2][i], batch.color[3][i]);
  if ((bits & material_ambient) != 0) material.ambient = color;
  if ((bits & material_diffuse) != 0) material.diffuse = color;
  if ((bits & material_specular) != 0) material.specular = color;
  if ((bits & material_emission) != 0) material.emission = color;
  return material;
}

void expect_near(const Rgba& got, const double* expected, double alpha, double magnitude) {
  const float channels[4] = {got.r, got.g, got.b, got.a};
  for (std::size_t k = 0; k < 4; ++k) {
    const double want = std::clamp(k == 3 ? alpha : expected[k], 0.0, 1.0);
    EXPECT_NEAR(channels[k], want, 1e-6 * magnitude + 6e-8 * want) << "channel " << k;
  }
}

TEST(Lighting, EqualsTheFormulaForEveryCombinationOfFeatures) {
  constexpr std::int32_t count = 40;
  const auto batch = random_batch(1, count);
  const auto vertices = blank_vertices();
  for (unsigned features = 0; features <= every_feature; ++features) {
    SCOPED_TRACE("features " + std::to_string(features));
    Numbers number(features + 1);
    const LightingState state = random_state(features, number);
    fill_eye_space(*vertices, count, number);
    light_vertices(state, *batch, *vertices);
    for (std::size_t i = 0; i < count && !testing::Test::HasFailure(); ++i) {
      const Reference front =
          reference(state, tracked(state.material.front, state.color_material_front, *batch, i), *vertices, i, 1);
      expect_near(vertices->color_front[i], front.primary, front.primary[3], front.magnitude);
      if (state.separate_specular) expect_near(vertices->specular_front[i], front.secondary, 0, front.magnitude);
      if (!state.two_sided) continue;
      const Reference back =
          reference(state, tracked(state.material.back, state.color_material_back, *batch, i), *vertices, i, -1);
      expect_near(vertices->color_back[i], back.primary, back.primary[3], back.magnitude);
      if (state.separate_specular) expect_near(vertices->specular_back[i], back.secondary, 0, back.magnitude);
    }
  }
}

TEST(Highlight, OfShininess128IsExactToAMillionth) {
  const auto batch = random_batch(2, 1000);
  const auto vertices = blank_vertices();
  for (const float shininess : {128.0f, 127.0f, 127.5f}) {
    for (const bool positional_light : {false, true}) {
      LightingState state;
      state.enabled = true;
      state.material.front = {{0, 0, 0, 1}, {0, 0, 0, 1}, white, {0, 0, 0, 1}, shininess};
      state.light_count = 1;
      state.lights[0].specular = white;
      state.lights[0].positional = positional_light;
      state.lights[0].position_eye = positional_light ? glm::vec3(3, 5, 2) : glm::vec3(0.48f, 0.6f, 0.64f);
      Numbers number(3);
      fill_eye_space(*vertices, batch->count, number);
      for (std::size_t i = 0; i < 1000; ++i) {  // near the half vector, where the highlight is
        glm::vec3 n = glm::vec3(0.3f, 0.5f, 0.8f) + 0.2f * glm::vec3(number(), number(), number());
        n *= 1 / glm::length(n);
        for (std::size_t k = 0; k < 3; ++k) vertices->normal_eye[k][i] = n[static_cast<int>(k)];
      }
      light_vertices(state, *batch, *vertices);
      for (std::size_t i = 0; i < 1000; ++i) {
        const double want = reference(state, state.material.front, *vertices, i, 1).primary[0];
        if (want < 1e-30) continue;
        ASSERT_LE(std::abs(vertices->color_front[i].r / want - 1), 1e-7) << i;
      }
    }
  }
}

TEST(MaterialRuns, LightEachVertexWithTheMaterialInForce) {
  const auto batch = random_batch(4, 200);
  const auto together = blank_vertices(), alone = blank_vertices();
  Numbers number(5);
  LightingState state = random_state(positional | specular | two_sided | separate | color_material, number);
  fill_eye_space(*together, 200, number);
  alone->normal_eye = together->normal_eye;
  alone->position_eye = together->position_eye;
  for (std::int32_t first : {0, 1, 2, 9, 10, 70, 71, 199}) {
    batch->material_runs.push_back({first, random_state(specular | two_sided, number).material});
  }
  light_vertices(state, *batch, *together);
  const std::vector<MaterialRun> runs = std::move(batch->material_runs);
  batch->material_runs.clear();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    state.material = runs[r].material;
    light_vertices(state, *batch, *alone);
    const std::int32_t end = r + 1 < runs.size() ? runs[r + 1].first : 200;
    for (auto i = static_cast<std::size_t>(runs[r].first); i < static_cast<std::size_t>(end); ++i) {
      ASSERT_EQ(std::memcmp(&together->color_front[i], &alone->color_front[i], sizeof(Rgba)), 0) << i;
      ASSERT_EQ(std::memcmp(&together->color_back[i], &alone->color_back[i], sizeof(Rgba)), 0) << i;
      ASSERT_EQ(std::memcmp(&together->specular_back[i], &alone->specular_back[i], sizeof(Rgba)), 0) << i;
    }
  }
}

TEST(Lighting, GivesTheSameBitsOnEveryTargetAndColorsInRangeForAnyInput) {
  const auto batch = random_batch(6, 301, true);
  const auto first = blank_vertices(), out = blank_vertices();
  for (unsigned features = 0; features <= every_feature; features += 3) {
    SCOPED_TRACE("features " + std::to_string(features));
    Numbers number(features, features % 2 == 1);
    const LightingState state = random_state(features, number);
    Numbers wild(features, true);
    for (std::size_t i = 0; i < 301; ++i) {
      for (std::size_t k = 0; k < 3; ++k) first->normal_eye[k][i] = wild();
      for (std::size_t k = 0; k < 4; ++k) first->position_eye[k][i] = wild();
    }
    out->normal_eye = first->normal_eye;
    out->position_eye = first->position_eye;
    light_vertices(state, *batch, *first);
    for (std::size_t i = 0; i < 301; ++i) {
      for (const Rgba& c :
           {first->color_front[i], first->color_back[i], first->specular_front[i], first->specular_back[i]}) {
        for (const float channel : {c.r, c.g, c.b, c.a}) ASSERT_TRUE(channel >= 0 && channel <= 1) << channel;
      }
    }
    for_each_target([&] {
      light_vertices(state, *batch, *out);
      ASSERT_TRUE(same_bits(out->color_front, first->color_front, 301));
      ASSERT_TRUE(!state.two_sided || same_bits(out->color_back, first->color_back, 301));
      ASSERT_TRUE(!state.separate_specular || same_bits(out->specular_front, first->specular_front, 301));
      ASSERT_TRUE(!state.two_sided || !state.separate_specular ||
                  same_bits(out->specular_back, first->specular_back, 301));
    });
  }
}

}  // namespace
}  // namespace gouraud::pipeline
