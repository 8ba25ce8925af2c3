// Lights, light model and materials as the application gave them [GL1.5 §2.14, Tables 6.10 to 6.12].
#pragma once

#include <array>

#include <GL/gl.h>
#include <glm/glm.hpp>

#include "api/state/limits.h"

namespace gouraud::api {

/// Light i of Table 2.11: diffuse and specular are white for light 0 and black for all others.
struct Light {
  bool enabled = false;
  glm::vec4 ambient{0.0f, 0.0f, 0.0f, 1.0f};
  glm::vec4 diffuse{0.0f, 0.0f, 0.0f, 1.0f};
  glm::vec4 specular{0.0f, 0.0f, 0.0f, 1.0f};
  glm::vec4 position_eye{0.0f, 0.0f, 1.0f, 0.0f};
  glm::vec3 spot_direction_eye{0.0f, 0.0f, -1.0f};
  float spot_exponent = 0.0f;                                                                  ///< in [0, 128]
  float spot_cutoff_deg = 180.0f;                                                              ///< in [0, 90], or 180
  float constant_attenuation = 1.0f, linear_attenuation = 0.0f, quadratic_attenuation = 0.0f;  ///< not negative
  bool operator==(const Light&) const = default;
};

struct MaterialFace {
  glm::vec4 ambient{0.2f, 0.2f, 0.2f, 1.0f};
  glm::vec4 diffuse{0.8f, 0.8f, 0.8f, 1.0f};
  glm::vec4 specular{0.0f, 0.0f, 0.0f, 1.0f};
  glm::vec4 emission{0.0f, 0.0f, 0.0f, 1.0f};
  float shininess = 0.0f;                     ///< in [0, 128]
  glm::vec3 color_indexes{0.0f, 1.0f, 1.0f};  ///< ambient, diffuse, specular
  bool operator==(const MaterialFace&) const = default;
};

/// Attribute group LIGHTING_BIT.
struct LightingGroup {
  LightingGroup() { lights[0].diffuse = lights[0].specular = glm::vec4(1.0f); }

  GLenum shade_model = GL_SMOOTH;
  bool enabled = false;
  bool color_material_enabled = false;
  GLenum color_material_face = GL_FRONT_AND_BACK;
  GLenum color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
  /// While ColorMaterial is enabled the parameters that follow the current colour are brought up to date only where
  /// they are looked at: see sync_color_material.
  std::array<MaterialFace, 2> material;  ///< front, back
  glm::vec4 model_ambient{0.2f, 0.2f, 0.2f, 1.0f};
  bool model_local_viewer = false;
  bool model_two_side = false;
  GLenum model_color_control = GL_SINGLE_COLOR;
  std::array<Light, max_lights> lights;
  bool operator==(const LightingGroup&) const = default;
};

}  // namespace gouraud::api
