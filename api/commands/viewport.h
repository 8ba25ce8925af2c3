// The viewport [GL1.5 §2.11.1].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_VALUE for a negative width or height; larger ones than max_target_size_px are clamped.
void Viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height);

/// Both are clamped to [0, 1]. choice: NaN counts as 0, as in all clamped parameters.
void DepthRange(Context& context, GLdouble n, GLdouble f);

/// [ARB_clip_control]. GL_INVALID_ENUM for an unknown origin or depth mode.
void ClipControl(Context& context, GLenum origin, GLenum depth);

}  // namespace gouraud::api
