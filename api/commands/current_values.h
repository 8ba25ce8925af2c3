// The current values that a vertex takes [GL1.5 §2.7, §2.6.2]. All are legal between Begin and End, none can fail but
// by a wrong texture unit; any float is kept as it is.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

inline void Normal3f(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  context.state.current.normal_object = glm::vec3(x, y, z);
}

inline void Color4f(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  context.state.current.color = glm::vec4(red, green, blue, alpha);
}

inline void SecondaryColor3f(Context& context, GLfloat red, GLfloat green, GLfloat blue) {
  context.state.current.secondary_color = glm::vec4(red, green, blue, 1.0f);
}

/// Texture unit 0.
inline void TexCoord4f(Context& context, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
  context.state.current.texture_coordinates[0] = glm::vec4(s, t, r, q);
}

/// GL_INVALID_ENUM unless `texture` is GL_TEXTUREi of a unit.
inline void MultiTexCoord4f(Context& context, GLenum texture, GLfloat s, GLfloat t, GLfloat r, GLfloat q) {
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit >= static_cast<GLenum>(max_texture_units)) {
    return context.record_error(GL_INVALID_ENUM, "glMultiTexCoord", "no such texture unit");
  }
  context.state.current.texture_coordinates[unit] = glm::vec4(s, t, r, q);
}

inline void FogCoordf(Context& context, GLfloat coordinate) {
  context.state.current.fog_coordinate = coordinate;
}

inline void EdgeFlag(Context& context, GLboolean flag) {
  context.state.current.edge_flag = flag != GL_FALSE;
}

inline void Indexf(Context& context, GLfloat index) {
  context.state.current.color_index = index;
}

}  // namespace gouraud::api
