// Generation of texture coordinates [GL1.5 §2.11.4, Table 6.17].
#pragma once

#include <array>

#include <GL/gl.h>
#include <glm/glm.hpp>

#include "api/state/limits.h"

namespace gouraud::api {

/// Of one coordinate.
struct TextureGeneration {
  bool enabled = false;
  GLenum mode = GL_EYE_LINEAR;
  glm::vec4 object_plane{0.0f};
  glm::vec4 eye_plane{0.0f};  ///< times the inverse of the modelview matrix of its time
  bool operator==(const TextureGeneration&) const = default;
};

/// Of one unit: s, t, r, q.
struct TextureGenerationUnit {
  TextureGenerationUnit() {
    coordinate[0].object_plane.x = coordinate[0].eye_plane.x = 1.0f;
    coordinate[1].object_plane.y = coordinate[1].eye_plane.y = 1.0f;
  }
  std::array<TextureGeneration, 4> coordinate;
  bool operator==(const TextureGenerationUnit&) const = default;
};

/// Part of attribute group TEXTURE_BIT.
struct TextureGenerationGroup {
  std::array<TextureGenerationUnit, max_texture_units> unit;
  bool operator==(const TextureGenerationGroup&) const = default;
};

}  // namespace gouraud::api
