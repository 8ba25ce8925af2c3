// Texture objects: names, bindings, priorities [GL1.5 §3.8.12].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_VALUE if n < 0.
void GenTextures(Context& context, GLsizei n, GLuint* textures);
void DeleteTextures(Context& context, GLsizei n, const GLuint* textures);
/// True once the name has been bound.
GLboolean IsTexture(Context& context, GLuint texture);

/// Makes the object if there is none of that name. GL_INVALID_ENUM for an unknown target, GL_INVALID_OPERATION for an
/// object of another target.
void BindTexture(Context& context, GLenum target, GLuint texture);

/// Every texture is resident. Both: GL_INVALID_VALUE if n < 0; the first one also for a name that is none, or zero.
GLboolean AreTexturesResident(Context& context, GLsizei n, const GLuint* textures, GLboolean* residences);
void PrioritizeTextures(Context& context, GLsizei n, const GLuint* textures, const GLfloat* priorities);

}  // namespace gouraud::api
