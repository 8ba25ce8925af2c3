#include "api/commands/texture_generation.h"

#include <type_traits>

#include "api/commands/state_table.h"
#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

// Null, and an error is recorded, if there is no such coordinate.
TextureGeneration* find_coordinate(Context& context, GLenum coord, const char* command) {
  if (coord - GL_S < 4) {
    const auto unit = static_cast<std::size_t>(context.state.texture.active_unit);
    return &context.state.texture_generation.unit[unit].coordinate[coord - GL_S];
  }
  context.record_error(GL_INVALID_ENUM, command, "coord is no texture coordinate");
  return nullptr;
}

// SPHERE_MAP gives s and t, the maps of directions s, t and r.
bool has_mode(GLenum coord, GLfloat mode) {
  const auto is = [mode](GLenum name) { return mode == static_cast<GLfloat>(name); };
  if (is(GL_OBJECT_LINEAR) || is(GL_EYE_LINEAR)) return true;
  if (is(GL_SPHERE_MAP)) return coord == GL_S || coord == GL_T;
  return (is(GL_NORMAL_MAP) || is(GL_REFLECTION_MAP)) && coord != GL_Q;
}

template <class T>
void get(Context& context, GLenum coord, GLenum pname, T* params) {
  const TextureGeneration* const found = find_coordinate(context, coord, "glGetTexGen");
  if (found == nullptr) return;
  const auto store = [&](const glm::vec4& plane) {
    for (int i = 0; i < 4; ++i) {
      if constexpr (std::is_same_v<T, GLint>) {
        params[i] = to_integer(plane[i], ValueKind::real);
      } else {
        params[i] = plane[i];
      }
    }
  };
  switch (pname) {
    case GL_TEXTURE_GEN_MODE:
      params[0] = static_cast<T>(found->mode);
      break;
    case GL_OBJECT_PLANE:
      return store(found->object_plane);
    case GL_EYE_PLANE:
      return store(found->eye_plane);
    default:
      context.record_error(GL_INVALID_ENUM, "glGetTexGen", "pname is unknown");
  }
}

}  // namespace

void TexGenfv(Context& context, GLenum coord, GLenum pname, const GLfloat* params) {
  TextureGeneration* const found = find_coordinate(context, coord, "glTexGen");
  if (found == nullptr) return;
  switch (pname) {
    case GL_TEXTURE_GEN_MODE:
      if (!has_mode(coord, params[0])) {
        return context.record_error(GL_INVALID_ENUM, "glTexGen", "the coordinate has no such mode");
      }
      found->mode = static_cast<GLenum>(params[0]);
      break;
    case GL_OBJECT_PLANE:
      found->object_plane = glm::vec4(params[0], params[1], params[2], params[3]);
      break;
    case GL_EYE_PLANE:
      found->eye_plane = glm::vec4(
          to_eye(glm::dvec4(params[0], params[1], params[2], params[3]), context.state.matrices.modelview.top()));
      break;
    default:
      return context.record_error(GL_INVALID_ENUM, "glTexGen", "pname is unknown");
  }
  context.change(dirty_texture_coordinates);
}

void GetTexGenfv(Context& context, GLenum coord, GLenum pname, GLfloat* params) {
  get(context, coord, pname, params);
}

void GetTexGeniv(Context& context, GLenum coord, GLenum pname, GLint* params) {
  get(context, coord, pname, params);
}

void GetTexGendv(Context& context, GLenum coord, GLenum pname, GLdouble* params) {
  get(context, coord, pname, params);
}

}  // namespace gouraud::api
