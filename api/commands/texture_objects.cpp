// Takes names, gives texture objects [GL1.5 §3.8.12].
//
// choice: an object whose name is deleted lives on where another context has it bound, as buffer objects do.
#include "api/commands/texture_objects.h"

#include "api/commands/clamped.h"
#include "api/commands/texture_targets.h"

namespace gouraud::api {

void GenTextures(Context& context, GLsizei n, GLuint* textures) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glGenTextures", "n is negative");
  context.texture_names().generate(n, textures);
}

void DeleteTextures(Context& context, GLsizei n, const GLuint* textures) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glDeleteTextures", "n is negative");
  for (GLsizei i = 0; i < n; ++i) {
    if (const TextureBinding texture = context.texture_names().find(textures[i])) context.unbind_texture(texture);
    context.texture_names().remove(textures[i]);
  }
}

GLboolean IsTexture(Context& context, GLuint texture) {
  return context.texture_names().find(texture) != nullptr ? GL_TRUE : GL_FALSE;
}

void BindTexture(Context& context, GLenum target, GLuint texture) {
  constexpr auto command = "glBindTexture";
  const auto bound_target = texture_target(target);
  if (!bound_target) return context.record_error(GL_INVALID_ENUM, command, "target is unknown");
  TextureBinding& binding = active_unit(context).binding[index_of(*bound_target)];
  if (texture == 0) {
    binding = context.default_texture(*bound_target);
  } else {
    TextureBinding object = context.texture_names().find_or_create(texture, *bound_target);
    if (object->target != *bound_target) {
      return context.record_error(GL_INVALID_OPERATION, command, "the texture is of another target");
    }
    binding = std::move(object);
  }
  context.change(dirty_textures);
}

GLboolean AreTexturesResident(Context& context, GLsizei n, const GLuint* textures, GLboolean*) {
  constexpr auto command = "glAreTexturesResident";
  if (n < 0) {
    context.record_error(GL_INVALID_VALUE, command, "n is negative");
    return GL_FALSE;
  }
  for (GLsizei i = 0; i < n; ++i) {
    if (context.texture_names().find(textures[i]) != nullptr) continue;
    context.record_error(GL_INVALID_VALUE, command, "a name is not that of a texture");
    return GL_FALSE;
  }
  return GL_TRUE;
}

void PrioritizeTextures(Context& context, GLsizei n, const GLuint* textures, const GLfloat* priorities) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glPrioritizeTextures", "n is negative");
  for (GLsizei i = 0; i < n; ++i) {
    if (const TextureBinding texture = context.texture_names().find(textures[i])) {
      texture->parameters.priority = clamped(priorities[i]);
    }
  }
}

}  // namespace gouraud::api
