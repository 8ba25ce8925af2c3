// Parameters of the bound texture object [GL1.5 §3.8.4 Table 3.19, §6.1.3].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All TexParameter commands. GL_INVALID_ENUM for an unknown target, pname or value, and for what a rectangle has not:
/// mipmaps and repetition. GL_INVALID_VALUE for a negative level, another base level than 0 of a rectangle, an
/// anisotropy below 1.
void TexParameterfv(Context& context, GLenum target, GLenum pname, const GLfloat* params);

/// Both: GL_INVALID_ENUM for an unknown target or pname.
void GetTexParameterfv(Context& context, GLenum target, GLenum pname, GLfloat* params);
void GetTexParameteriv(Context& context, GLenum target, GLenum pname, GLint* params);

}  // namespace gouraud::api
