// Which colour buffer is written and which is read [GL1.5 §4.2.1, §4.3.2] [ARB_framebuffer_object].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: GL_INVALID_ENUM for what is no buffer, GL_INVALID_OPERATION for a buffer that the bound framebuffer does not
/// have. GL_NONE draws no colours, or reads none.
void DrawBuffer(Context& context, GLenum buf);
void ReadBuffer(Context& context, GLenum src);

/// What PopAttrib does with a draw or read buffer that PushAttrib has saved: the errors are DrawBuffer's and ReadBuffer's.
void restore_draw_buffer(Context& context, GLenum buffer);
void restore_read_buffer(Context& context, GLenum buffer);

}  // namespace gouraud::api
