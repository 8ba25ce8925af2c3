// The user's clip planes [GL1.5 §2.12].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: GL_INVALID_ENUM for what is no clip plane. The plane is transformed by the inverse of the modelview matrix now.
/// choice: of a singular matrix the cofactors stand for the inverse, as with normals.
void ClipPlane(Context& context, GLenum plane, const GLdouble* equation);
/// In eye coordinates.
void GetClipPlane(Context& context, GLenum plane, GLdouble* equation);

}  // namespace gouraud::api
