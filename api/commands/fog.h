// Fog [GL1.5 §3.10].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_ENUM for an unknown parameter, mode or coordinate source, GL_INVALID_VALUE for a negative density.
void Fogfv(Context& context, GLenum pname, const GLfloat* params);

}  // namespace gouraud::api
