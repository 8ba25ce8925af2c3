// PixelStore [GL1.5 §3.6.1]. Where the pixels of an image lie is client_pixels.h's.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

void PixelStorei(Context& context, GLenum pname, GLint param);

}  // namespace gouraud::api
