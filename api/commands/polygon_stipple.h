// The pattern of the polygon stipple [GL1.5 §3.5.2, §6.1.6], in client memory under the pixel store parameters, or in a
// pixel buffer object.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: the errors of check_unpack and check_pack; a null pointer without a buffer does nothing.
void PolygonStipple(Context& context, const GLubyte* mask);
void GetPolygonStipple(Context& context, GLubyte* mask);

}  // namespace gouraud::api
