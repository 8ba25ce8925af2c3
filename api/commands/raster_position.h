// The current raster position [GL1.5 §2.13].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Takes the position through the vertex stages. Outside the clip volume, or without a finite window position, the
/// raster position becomes invalid.
void RasterPos4f(Context& context, GLfloat x, GLfloat y, GLfloat z, GLfloat w);

/// Sets the window position itself; it is always valid. z is clamped to [0, 1] and mapped to the depth range.
void WindowPos3f(Context& context, GLfloat x, GLfloat y, GLfloat z);

}  // namespace gouraud::api
