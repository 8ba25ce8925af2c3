// Takes eye-space positions and normals, lights and materials, gives clamped primary and secondary colours of the front
// and, if two-sided, of the back [GL1.5 §2.14.1, §2.14.3, §2.14.6].
//
// Vertices of one material are a run; a run goes through the lights in blocks, one light after the other, so that what
// is constant (a light's place, its colours times the material's) is worked out once. light_kernels-inl.h adds a light.
// choice: vertices are divided by their eye w, as points of §2.14.1; w = 0, undefined there, counts as 1.
// Leaves out colour index lighting, and the choice between front and back, which setup makes.
#include "pipeline/geometry/lighting.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "pipeline/geometry/light_terms.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/geometry/lighting.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/geometry/light_kernels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

using FloatTag = hn::Rebind<float, LightTag>;

HWY_INLINE Triple widen(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}
HWY_INLINE Triple rgb(const glm::vec4& v) {
  return {v.x, v.y, v.z};
}
HWY_INLINE Triple operator*(const Triple& a, const Triple& b) {
  return {a[0] * b[0], a[1] * b[1], a[2] * b[2]};
}
HWY_INLINE Triple operator*(double s, const Triple& b) {
  return {s * b[0], s * b[1], s * b[2]};
}
HWY_INLINE Triple operator+(const Triple& a, const Triple& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
HWY_INLINE bool is_black(const Triple& c) {
  return c[0] == 0 && c[1] == 0 && c[2] == 0;
}

/// A run of vertices that share a material, and the lights as they concern it.
struct Run {
  const LightingState* state;
  const MaterialPair* material;
  Sums sums;
  std::size_t light_count;
  std::array<LightTerms, max_lights> lights;
  /// What the sums start from: ambient light of the scene and of directional lights; if fused, the whole colour that no
  /// vertex varies.
  Triple base;
  bool needs_position, needs_viewer;
};

/// Of a directional spot light, whose cone holds all vertices or none [GL1.5 §2.14.1 eq 2.5].
double directional_spot_factor(const PreparedLight& light) {
  const Triple to_light = widen(light.position_eye), axis = widen(light.spot_direction_eye);
  const double cosine = -(to_light[0] * axis[0] + to_light[1] * axis[1] + to_light[2] * axis[2]);
  if (!(cosine >= light.spot_cutoff_cosine)) return 0;
  return hn::GetLane(power(spread(cosine), make_exponent(light.spot_exponent)));
}

/// The half vector of a directional light for a viewer at infinity [GL1.5 §2.14.1 eq 2.3]; zero if it has no direction.
Triple distant_half_vector(const Triple& to_light) {
  const LightTag d;
  const Triple sum = to_light + Triple{0, 0, 1};
  const double squared = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
  return squared > 0 ? (1 / hn::GetLane(hn::Sqrt(hn::Set(d, squared)))) * sum : Triple{};
}

/// True if a highlight can show on the face.
bool reflects(const Material& material, std::uint8_t color_material, const Triple& light_specular) {
  return (color_material & material_specular) != 0 ? !is_black(light_specular)
                                                   : !is_black(rgb(material.specular) * light_specular);
}

/// What no material changes.
void prepare_light(const PreparedLight& light, LightTerms& terms) {
  terms.kind = !light.positional ? LightKind::directional : light.spot ? LightKind::spot : LightKind::positional;
  terms.position = widen(light.position_eye);
  terms.attenuation = widen(light.attenuation);
  terms.spot_direction = widen(light.spot_direction_eye);
  terms.spot_cutoff_cosine = light.spot_cutoff_cosine;
  terms.spot_exponent = make_exponent(light.spot_exponent);
  const bool directional = terms.kind == LightKind::directional;
  terms.half_vector = directional ? distant_half_vector(terms.position) : Triple{};
  terms.directional_spot_factor = directional && light.spot ? directional_spot_factor(light) : 1.0;
}

void apply_material(const PreparedLight& light, const LightingState& state, const MaterialPair& material, Sums sums,
                    LightTerms& terms) {
  terms.ambient = terms.directional_spot_factor * rgb(light.ambient);
  terms.diffuse = terms.directional_spot_factor * rgb(light.diffuse);
  terms.specular = terms.directional_spot_factor * rgb(light.specular);
  const bool shines = reflects(material.front, state.color_material_front, terms.specular) ||
                      (state.two_sided && reflects(material.back, state.color_material_back, terms.specular));
  terms.highlight = !shines              ? Highlight::none
                    : state.local_viewer ? Highlight::local_viewer
                                         : Highlight::distant_viewer;
  terms.shininess = make_exponent(material.front.shininess);
  terms.shininess_back = make_exponent(material.back.shininess);
  if (sums != Sums::fused) return;
  terms.ambient = terms.ambient * rgb(material.front.ambient);
  terms.diffuse = terms.diffuse * rgb(material.front.diffuse);
  terms.specular = terms.specular * rgb(material.front.specular);
}

void apply_material(const MaterialPair& material, Run& run) {
  const LightingState& state = *run.state;
  run.material = &material;
  run.base = rgb(state.scene_ambient);
  if (run.sums == Sums::fused) run.base = rgb(material.front.emission) + rgb(material.front.ambient) * run.base;
  run.needs_viewer = run.needs_position = false;
  for (std::size_t i = 0; i < run.light_count; ++i) {
    LightTerms& light = run.lights[i];
    apply_material(state.lights[i], state, material, run.sums, light);
    if (light.kind == LightKind::directional) run.base = run.base + light.ambient;
    run.needs_viewer = run.needs_viewer || light.highlight == Highlight::local_viewer;
    run.needs_position = run.needs_position || run.needs_viewer || light.kind != LightKind::directional;
  }
}

void prepare_lights(const LightingState& state, Run& run) {
  const bool fused = state.color_material_front == material_none && !state.separate_specular;
  run.state = &state;
  run.sums = state.two_sided ? Sums::two_sided : fused ? Sums::fused : Sums::split;
  run.light_count = state.light_count;
  for (std::size_t i = 0; i < run.light_count; ++i) prepare_light(state.lights[i], run.lights[i]);
}

/// Widens the inputs of vertices [first, first + count) and starts the sums.
void start_block(const Run& run, const ProcessedVertices& vertices, std::size_t first, std::size_t count,
                 LightBlock& block) {
  const LightTag d;
  const FloatTag f;
  const LightVector zero = hn::Zero(d), one = hn::Set(d, 1);
  const auto input = [&](const auto& rows, std::size_t k, std::size_t i)
                         HWY_ATTR { return hn::PromoteTo(d, hn::LoadU(f, &rows[k][first + i])); };
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    for (std::size_t k = 0; k < 3; ++k) hn::Store(hn::Set(d, run.base[k]), d, &block.ambient[k][i]);
    if (run.light_count == 0) continue;
    for (std::size_t k = 0; k < 3; ++k) hn::Store(input(vertices.normal_eye, k, i), d, &block.normal[k][i]);
    if (run.sums != Sums::fused) {
      for (LightBlock::Vectors* sum : {&block.diffuse[0], &block.specular[0], &block.diffuse[1], &block.specular[1]}) {
        for (auto& row : *sum) hn::Store(zero, d, &row[i]);
      }
    }
    if (!run.needs_position) continue;
    const LightVector w = input(vertices.position_eye, 3, i);
    const LightVector scale = hn::Div(one, hn::IfThenElse(hn::Eq(w, zero), one, w));
    Vector3 p{hn::Mul(input(vertices.position_eye, 0, i), scale), hn::Mul(input(vertices.position_eye, 1, i), scale),
              hn::Mul(input(vertices.position_eye, 2, i), scale)};
    hn::Store(p.x, d, &block.position[0][i]);
    hn::Store(p.y, d, &block.position[1][i]);
    hn::Store(p.z, d, &block.position[2][i]);
    if (!run.needs_viewer) continue;
    const LightVector towards = hn::Neg(hn::Div(one, at_least(d, hn::Sqrt(dot(p, p)), spread(least_distance))));
    hn::Store(hn::Mul(p.x, towards), d, &block.to_viewer[0][i]);
    hn::Store(hn::Mul(p.y, towards), d, &block.to_viewer[1][i]);
    hn::Store(hn::Mul(p.z, towards), d, &block.to_viewer[2][i]);
  }
}

HWY_INLINE void store_colors(LightVector r, LightVector g, LightVector b, LightVector a, Rgba* out) {
  const LightTag d;
  const FloatTag f;
  const auto channel = [&](LightVector v) HWY_ATTR { return hn::DemoteTo(f, clamp_to_unit(d, v)); };
  hn::StoreInterleaved4(channel(r), channel(g), channel(b), channel(a), f, &out->r);
}

/// Split sums times the material of one face: constant, or the vertex's colour where ColorMaterial says so.
void finish_face(const Run& run, const LightBlock& block, std::size_t count, std::size_t face, const VertexBatch& batch,
                 std::size_t first, Rgba* primary, Rgba* secondary) {
  const LightTag d;
  const FloatTag f;
  const Material& material = face == 0 ? run.material->front : run.material->back;
  const std::uint8_t tracked = face == 0 ? run.state->color_material_front : run.state->color_material_back;
  const bool lit = run.light_count > 0, separate = run.state->separate_specular;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto parameter = [&](MaterialBits bit, const glm::vec4& constant, std::size_t k) HWY_ATTR {
      if ((tracked & bit) != 0) return hn::PromoteTo(d, hn::LoadU(f, &batch.color[k][first + i]));
      return hn::Set(d, static_cast<double>(constant[static_cast<int>(k)]));
    };
    LightVector color[3], specular[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const LightVector ambient =
          hn::Mul(parameter(material_ambient, material.ambient, k), hn::Load(d, &block.ambient[k][i]));
      color[k] = hn::Add(parameter(material_emission, material.emission, k), ambient);
      specular[k] = hn::Zero(d);
      if (!lit) continue;
      const LightVector diffuse = hn::Load(d, &block.diffuse[face][k][i]),
                        highlight = hn::Load(d, &block.specular[face][k][i]);
      color[k] = hn::Add(color[k], hn::Mul(parameter(material_diffuse, material.diffuse, k), diffuse));
      specular[k] = hn::Mul(parameter(material_specular, material.specular, k), highlight);
      if (!separate) color[k] = hn::Add(color[k], specular[k]);
    }
    store_colors(color[0], color[1], color[2], parameter(material_diffuse, material.diffuse, 3), primary + i);
    if (separate) store_colors(specular[0], specular[1], specular[2], hn::Zero(d), secondary + i);
  }
}

void finish_block(const Run& run, const LightBlock& block, std::size_t count, const VertexBatch& batch,
                  std::size_t first, ProcessedVertices& out) {
  if (run.sums != Sums::fused) {
    finish_face(run, block, count, 0, batch, first, &out.color_front[first], &out.specular_front[first]);
    if (run.sums == Sums::two_sided) {
      finish_face(run, block, count, 1, batch, first, &out.color_back[first], &out.specular_back[first]);
    }
    return;
  }
  const LightVector alpha = spread(run.material->front.diffuse.w);
  for (std::size_t i = 0; i < count; i += hn::Lanes(LightTag())) {
    const Vector3 color = load(block.ambient, i);
    store_colors(color.x, color.y, color.z, alpha, &out.color_front[first + i]);
  }
}

void light_run(Run& run, const MaterialPair& material, const VertexBatch& batch, std::size_t first, std::size_t end,
               LightBlock& block, ProcessedVertices& out) {
  if (first >= end) return;
  apply_material(material, run);
  while (first < end) {
    const std::size_t count = std::min(end - first, light_block_size);
    start_block(run, out, first, count, block);
    for (std::size_t i = 0; i < run.light_count; ++i) kernel_for(run.lights[i], run.sums)(run.lights[i], count, block);
    finish_block(run, block, count, batch, first, out);
    first += count;
  }
}

/// Ascending runs: a run's last vector may overwrite the first vertices of the next.
void light(const LightingState& state, const VertexBatch& batch, ProcessedVertices& out) {
  Run run;
  LightBlock block;
  prepare_lights(state, run);
  const auto count = static_cast<std::size_t>(batch.count);
  const MaterialPair* material = &state.material;
  std::size_t first = 0;
  for (const MaterialRun& next : batch.material_runs) {
    const std::size_t end = std::min(static_cast<std::size_t>(next.first), count);
    light_run(run, *material, batch, first, end, block, out);
    material = &next.material;
    first = end;
  }
  light_run(run, *material, batch, first, count, block, out);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
void light_vertices(const LightingState& state, const VertexBatch& batch, ProcessedVertices& out) {
  GOURAUD_SIMD_PICK(light)(state, batch, out);
}
}  // namespace gouraud::pipeline
#endif
