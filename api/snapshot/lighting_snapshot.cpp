#include "api/snapshot/lighting_snapshot.h"

#include <cmath>

#include "api/snapshot/enums.h"
#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

// Light colours count by red, green and blue: the lit alpha is the material's diffuse alpha [GL1.5 §2.14.1].
glm::vec4 without_alpha(const glm::vec4& color, float alpha) {
  return glm::vec4(color.x, color.y, color.z, alpha);
}
bool is_black(const glm::vec4& color) {
  return color.x == 0.0f && color.y == 0.0f && color.z == 0.0f;
}

glm::vec3 unit_vector(const glm::vec3& v) {
  const glm::dvec3 wide(v);
  const double length = std::sqrt((wide.x * wide.x + wide.y * wide.y) + wide.z * wide.z);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(wide / length) : glm::vec3(0.0f);
}

bool any_light(const pipeline::LightingState& lighting, glm::vec4 pipeline::PreparedLight::*color) {
  for (int i = 0; i < lighting.light_count; ++i) {
    if (!is_black(lighting.lights[static_cast<std::size_t>(i)].*color)) return true;
  }
  return false;
}

// The parameters that can show: without specular light anywhere, say, the specular reflectance cannot.
std::uint8_t visible_parameters(const pipeline::LightingState& lighting) {
  std::uint8_t bits = pipeline::material_diffuse | pipeline::material_emission;  // diffuse: its alpha always shows
  if (any_light(lighting, &pipeline::PreparedLight::specular)) bits |= pipeline::material_specular;
  if (!is_black(lighting.scene_ambient) || any_light(lighting, &pipeline::PreparedLight::ambient)) {
    bits |= pipeline::material_ambient;
  }
  return bits;
}

std::uint8_t followed_parameters(const LightingGroup& group, GLenum face) {
  const bool applies = group.color_material_enabled &&
                       (group.color_material_face == face || group.color_material_face == GL_FRONT_AND_BACK);
  return applies ? material_bits(group.color_material_parameter) : std::uint8_t{pipeline::material_none};
}

pipeline::Material canonical_face(const MaterialFace& face, std::uint8_t shown) {
  pipeline::Material result;
  if (shown & pipeline::material_ambient) result.ambient = without_alpha(face.ambient, 1.0f);
  if (shown & pipeline::material_diffuse) result.diffuse = face.diffuse;
  if (shown & pipeline::material_specular) result.specular = without_alpha(face.specular, 1.0f);
  if (shown & pipeline::material_emission) result.emission = without_alpha(face.emission, 1.0f);
  return result;
}

}  // namespace

pipeline::PreparedLight prepare_light(const Light& light) {
  pipeline::PreparedLight result;
  result.ambient = without_alpha(light.ambient, 0.0f);
  result.diffuse = without_alpha(light.diffuse, 0.0f);
  result.specular = without_alpha(light.specular, 0.0f);
  const glm::vec3 xyz(light.position_eye.x, light.position_eye.y, light.position_eye.z);
  result.positional = light.position_eye.w != 0.0f;
  if (result.positional) {
    result.position_eye = xyz / light.position_eye.w;
    result.attenuation = glm::vec3(light.constant_attenuation, light.linear_attenuation, light.quadratic_attenuation);
  } else {
    result.position_eye = unit_vector(xyz);
  }
  // "If the cutoff is 180 the light is no spot" holds for directional lights too: then the vector to the light is the
  // same everywhere, and so is the spot factor [GL1.5 §2.14.1 eq 2.5].
  result.spot = light.spot_cutoff_deg != 180.0f;
  if (result.spot) {
    result.spot_direction_eye = unit_vector(light.spot_direction_eye);
    constexpr double rad_per_deg = 3.14159265358979323846 / 180.0;
    result.spot_cutoff_cosine = light.spot_cutoff_deg == 90.0f
                                    ? 0.0f
                                    : static_cast<float>(sine_cosine(light.spot_cutoff_deg * rad_per_deg).cosine);
    result.spot_exponent = light.spot_exponent;
  }
  return result;
}

void update_lighting(const LightingGroup& group, bool colors_matter, pipeline::CullMode cull,
                     pipeline::LightingState& result) {
  const pipeline::MaterialPair material = result.material;
  result = {};
  result.material = material;
  if (!group.enabled || !colors_matter) return;

  result.enabled = true;
  const bool back_drawn = cull == pipeline::CullMode::none || cull == pipeline::CullMode::front;
  result.two_sided = group.model_two_side && back_drawn;
  result.scene_ambient = without_alpha(group.model_ambient, 0.0f);
  for (const Light& light : group.lights) {
    if (!light.enabled || (is_black(light.ambient) && is_black(light.diffuse) && is_black(light.specular))) continue;
    result.lights[result.light_count++] = prepare_light(light);
  }

  // The viewer and the separate colour matter only to specular light.
  const std::uint8_t visible = visible_parameters(result);
  if (visible & pipeline::material_specular) {
    result.local_viewer = group.model_local_viewer;
    result.separate_specular = group.model_color_control == GL_SEPARATE_SPECULAR_COLOR;
  }
  result.color_material_front = followed_parameters(group, GL_FRONT) & visible;
  if (result.two_sided) result.color_material_back = followed_parameters(group, GL_BACK) & visible;
}

pipeline::MaterialPair canonical_material(const LightingGroup& group, const pipeline::LightingState& lighting) {
  pipeline::MaterialPair result;
  if (!lighting.enabled) return result;
  const std::uint8_t visible = visible_parameters(lighting);
  const bool specular = (visible & pipeline::material_specular) != 0;
  result.front = canonical_face(group.material[0], visible & ~lighting.color_material_front);
  if (specular) result.front.shininess = group.material[0].shininess;
  result.back = result.front;
  if (lighting.two_sided) {
    result.back = canonical_face(group.material[1], visible & ~lighting.color_material_back);
    if (specular) result.back.shininess = group.material[1].shininess;
  }
  return result;
}

}  // namespace gouraud::api
