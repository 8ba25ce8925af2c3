// Selection and feedback [GL1.5 §5.2, §5.3].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// What the old mode has to say: in selection the number of hit records, in feedback that of values, -1 if the buffer
/// was too small; else 0. GL_INVALID_ENUM for an unknown mode; GL_INVALID_OPERATION for one that has no buffer.
GLint RenderMode(Context& context, GLenum mode);

/// GL_INVALID_OPERATION in selection mode, GL_INVALID_VALUE if the size is negative.
void SelectBuffer(Context& context, GLsizei size, GLuint* buffer);
/// GL_INVALID_OPERATION in feedback mode, GL_INVALID_VALUE if the size is negative, GL_INVALID_ENUM for an unknown type.
void FeedbackBuffer(Context& context, GLsizei size, GLenum type, GLfloat* buffer);
/// Into the feedback array, in feedback mode.
void PassThrough(Context& context, GLfloat token);

/// The name stack; all do nothing outside of selection mode. GL_INVALID_OPERATION to load onto an empty stack,
/// GL_STACK_OVERFLOW and GL_STACK_UNDERFLOW.
void InitNames(Context& context);
void LoadName(Context& context, GLuint name);
void PushName(Context& context, GLuint name);
void PopName(Context& context);

/// True if nothing may reach the framebuffer now: the mode is not GL_RENDER.
inline bool renders_nothing(const Context& context) {
  return context.state.render_mode.mode != GL_RENDER;
}
/// For bitmaps and pixel rectangles, whose errors have been checked and whose raster position is valid: puts `token`
/// (GL_BITMAP_TOKEN, GL_DRAW_PIXEL_TOKEN, GL_COPY_PIXEL_TOKEN) and the raster position into the feedback array, in
/// feedback mode. The caller draws only if !renders_nothing().
void report_raster_position(Context& context, GLenum token);
/// For RasterPos and WindowPos: a valid raster position is a hit, in selection mode.
void select_raster_position(Context& context);

}  // namespace gouraud::api
