// Rect [GL1.5 §2.10].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// The polygon (x1, y1), (x2, y1), (x2, y2), (x1, y2).
void Rectf(Context& context, GLfloat x1, GLfloat y1, GLfloat x2, GLfloat y2);

}  // namespace gouraud::api
