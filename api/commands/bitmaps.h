// Bitmap [GL1.5 §3.7].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_VALUE for a negative size; of a pixel buffer: see check_unpack. Draws nothing if `bitmap` is null or while
/// the raster position is invalid; a valid one moves on in any case.
void Bitmap(Context& context, GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove, GLfloat ymove,
            const GLubyte* bitmap);

}  // namespace gouraud::api
