// DrawPixels, CopyPixels and PixelZoom [GL1.5 §3.6.4, §4.3.1, §4.3.3].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

void PixelZoom(Context& context, GLfloat xfactor, GLfloat yfactor);

/// Errors of check_unpack; GL_INVALID_OPERATION if the target lacks the buffer that the format is for. Nothing is drawn
/// while the raster position is invalid.
void DrawPixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels);

/// GL_INVALID_ENUM for an unknown type, GL_INVALID_VALUE for a negative size, GL_INVALID_OPERATION if a target lacks
/// the buffer. choice: nothing is drawn for pixels outside the target, which the specification leaves undefined.
void CopyPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type);

}  // namespace gouraud::api
