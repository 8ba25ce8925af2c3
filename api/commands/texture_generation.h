// Generation of texture coordinates [GL1.5 §2.11.4], of the active texture unit.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All: GL_INVALID_ENUM for an unknown coordinate or parameter; a mode that the coordinate does not have is one, too.
/// Eye planes are transformed by the inverse of the modelview matrix now.
void TexGenfv(Context& context, GLenum coord, GLenum pname, const GLfloat* params);

void GetTexGenfv(Context& context, GLenum coord, GLenum pname, GLfloat* params);
void GetTexGeniv(Context& context, GLenum coord, GLenum pname, GLint* params);
void GetTexGendv(Context& context, GLenum coord, GLenum pname, GLdouble* params);

}  // namespace gouraud::api
