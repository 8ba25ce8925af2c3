// Copying between framebuffers [ARB_framebuffer_object, "Framebuffer Blitting"].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_VALUE for a bit that is no colour, depth or stencil buffer; GL_INVALID_ENUM for an unknown filter;
/// GL_INVALID_OPERATION for a linear filter of depth or stencil, for depths of different formats, and for multisampled
/// pictures if the rectangles' sizes differ. A buffer that one of the framebuffers lacks is left out.
void BlitFramebuffer(Context& context, GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0, GLint dstY0,
                     GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter);

}  // namespace gouraud::api
