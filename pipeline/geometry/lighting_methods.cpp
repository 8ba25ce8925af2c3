// Takes eye-space positions and normals, lights and materials, gives clamped colours: the equations of [GL1.5 §2.14.1] as they stand in
// the book, one vertex, one face and one light after the other.
//
// power=libm: the exponents of highlights and spots by the C library's pow. Within half a unit in the last place of double, as the
// default's is within a few; the bits are those of the library that happens to be installed.
//
// highlight=reflection: the highlight is max(r . v, 0)^s with r the light's direction mirrored at the normal, in place of
// max(n . h, 0)^s with h half way between light and viewer. Phong's own; the angle that it measures is twice as large, so that the same
// exponent gives a highlight a quarter of the size, and there is none where light and viewer stand low on opposite sides.
// Sources: B. T. Phong, "Illumination for computer generated pictures", 1975; J. Blinn, "Models of light reflection for computer
// synthesized pictures", 1977, which is OpenGL's.
#include "pipeline/geometry/lighting_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gouraud::pipeline {
namespace {

using Vector = glm::dvec3;

Vector unit(const Vector& v) {
  const double length = std::sqrt(glm::dot(v, v));
  return length > 0 ? v / length : Vector(0);
}

Vector rgb(const glm::vec4& v) { return {v.x, v.y, v.z}; }

float clamped(double value) { return value > 0 ? static_cast<float>(std::min(value, 1.0)) : 0.0f; }
Rgba clamped(const Vector& color, double alpha) { return {clamped(color.x), clamped(color.y), clamped(color.z), clamped(alpha)}; }

/// A vertex as the lights see it.
struct Surface {
  Vector position, normal, to_viewer;
};

/// The material of a vertex: parameters that follow its colour have it.
Material tracked(Material material, std::uint8_t bits, const glm::vec4& color) {
  if ((bits & material_ambient) != 0) material.ambient = color;
  if ((bits & material_diffuse) != 0) material.diffuse = color;
  if ((bits & material_specular) != 0) material.specular = color;
  if ((bits & material_emission) != 0) material.emission = color;
  return material;
}

double highlight_base(HighlightMethod method, const Surface& surface, const Vector& to_light) {
  if (method == HighlightMethod::reflection) {
    const Vector mirrored = surface.normal * (2.0 * glm::dot(surface.normal, to_light)) - to_light;
    return glm::dot(mirrored, surface.to_viewer);
  }
  return glm::dot(surface.normal, unit(to_light + surface.to_viewer));
}

/// Adds one light [GL1.5 §2.14.1 eqs 2.1 to 2.5].
void add_light(const PreparedLight& light, HighlightMethod method, const Surface& surface, const Material& material, Vector& color,
               Vector& specular) {
  Vector to_light = Vector(light.position_eye);
  double strength = 1;
  if (light.positional) {
    const Vector way = to_light - surface.position;
    const double distance = std::sqrt(glm::dot(way, way));
    to_light = unit(way);
    const auto& k = light.attenuation;
    strength = 1 / std::max(k.x + distance * (k.y + distance * static_cast<double>(k.z)), 1e-100);
  }
  if (light.spot) {
    const double cosine = -glm::dot(to_light, Vector(light.spot_direction_eye));
    strength *= cosine >= static_cast<double>(light.spot_cutoff_cosine) ? std::pow(cosine, light.spot_exponent) : 0.0;
  }
  color += strength * rgb(material.ambient) * rgb(light.ambient);
  const double n_dot_l = glm::dot(surface.normal, to_light);
  if (!(n_dot_l > 0)) return;
  color += strength * n_dot_l * rgb(material.diffuse) * rgb(light.diffuse);
  const double base = highlight_base(method, surface, to_light);
  if (base > 0) specular += strength * std::pow(base, material.shininess) * rgb(material.specular) * rgb(light.specular);
}

void light_face(const LightingState& state, HighlightMethod method, const Surface& surface, const Material& material, Rgba& primary,
                Rgba& secondary) {
  Vector color = rgb(material.emission) + rgb(material.ambient) * rgb(state.scene_ambient), specular(0);
  for (std::size_t i = 0; i < state.light_count; ++i) add_light(state.lights[i], method, surface, material, color, specular);
  if (!state.separate_specular) {
    primary = clamped(color + specular, material.diffuse.w);
  } else {
    primary = clamped(color, material.diffuse.w);
    secondary = clamped(specular, 0);
  }
}

}  // namespace

void light_vertices(const LightingState& state, HighlightMethod highlight, const VertexBatch& batch, ProcessedVertices& out) {
  const bool positional = std::any_of(state.lights.begin(), state.lights.begin() + state.light_count, [](const PreparedLight& l) { return l.positional; });
  const bool has_position = state.light_count > 0 && (positional || state.local_viewer);
  const bool follows_color = (state.color_material_front | state.color_material_back) != material_none;
  const MaterialPair* material = &state.material;
  auto next = batch.material_runs.begin();
  for (std::int32_t vertex = 0; vertex < batch.count; ++vertex) {
    for (; next != batch.material_runs.end() && next->first <= vertex; ++next) material = &next->material;
    const auto i = static_cast<std::size_t>(vertex);
    Surface surface{Vector(0), Vector(0), Vector(0, 0, 1)};
    if (state.light_count > 0) surface.normal = {out.normal_eye[0][i], out.normal_eye[1][i], out.normal_eye[2][i]};
    if (has_position) {
      const double w = out.position_eye[3][i];
      surface.position = Vector(out.position_eye[0][i], out.position_eye[1][i], out.position_eye[2][i]) / (w != 0 ? w : 1.0);
      if (state.local_viewer) surface.to_viewer = unit(-surface.position);
    }
    glm::vec4 color(0);
    if (follows_color) color = {batch.color[0][i], batch.color[1][i], batch.color[2][i], batch.color[3][i]};
    light_face(state, highlight, surface, tracked(material->front, state.color_material_front, color), out.color_front[i], out.specular_front[i]);
    if (!state.two_sided) continue;
    surface.normal = -surface.normal;
    light_face(state, highlight, surface, tracked(material->back, state.color_material_back, color), out.color_back[i], out.specular_back[i]);
  }
}

}  // namespace gouraud::pipeline
