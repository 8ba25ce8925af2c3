// ReadPixels [GL1.5 §4.3.2].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Writes nothing of pixels outside the target, and nothing at all if `pixels` is null without a pack buffer.
void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels);

}  // namespace gouraud::api
