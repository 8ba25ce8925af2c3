// Shared parts of the scenes that draw into framebuffer objects.
#pragma once

#include "gl_table.h"

namespace gouraud::conformance {

GLuint bind_framebuffer(const GlTable& gl);
/// A new square renderbuffer of the framebuffer in use.
GLuint attach_renderbuffer(const GlTable& gl, GLenum attachment, GLenum format, int samples, int side);
/// A ring over a ground of this colour, in a viewport of this size.
void draw_ring(const GlTable& gl, int side, float hue);

}  // namespace gouraud::conformance
