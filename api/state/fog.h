// Fog and colour sum [GL1.5 §3.9, §3.10, Table 6.8].
#pragma once

#include <GL/gl.h>
#include <glm/glm.hpp>

namespace gouraud::api {

/// Attribute group FOG_BIT.
struct FogGroup {
  bool enabled = false;
  bool color_sum_enabled = false;
  GLenum mode = GL_EXP;
  float density = 1.0f;  ///< not negative
  float start = 0.0f, end = 1.0f;
  float index = 0.0f;  ///< of colour index mode: kept, but there is no such mode
  glm::vec4 color{0.0f};  ///< in [0, 1]
  GLenum coordinate_source = GL_FRAGMENT_DEPTH;
  bool operator==(const FogGroup&) const = default;
};

}  // namespace gouraud::api
