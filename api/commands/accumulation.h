// The accumulation buffer [GL1.5 §4.2.4].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Clamped to [-1, 1].
void ClearAccum(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);

/// GL_INVALID_ENUM for an unknown operation, GL_INVALID_OPERATION without an accumulation buffer.
void Accum(Context& context, GLenum op, GLfloat value);

}  // namespace gouraud::api
