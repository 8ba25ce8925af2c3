// ReadPixels [GL1.5 §4.3.2].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Writes nothing of pixels outside the target, and nothing at all if `pixels` is null. Signed, 16- and 32-bit and
/// packed types of colours and other types of depth and stencil than those of read_pixels.cpp are GL_INVALID_OPERATION
/// as yet, like commands that are not written.
void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels);

}  // namespace gouraud::api
