// Drawing from vertex arrays [GL1.5 §2.8, §2.9].
//
// choice: what a draw takes from arrays does not stay in the current values; the specification leaves them open.
// choice: an enabled array at a null address is not read: the current value stands for it, and without a vertex array
// nothing is drawn.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All: GL_INVALID_OPERATION if an enabled array or the indices lie in a mapped buffer object.

/// Legal between Begin and End. GL_INVALID_VALUE if i < 0.
void ArrayElement(Context& context, GLint i);

/// GL_INVALID_ENUM for an unknown mode, GL_INVALID_VALUE if first < 0 or count < 0.
/// choice: a draw ends where the vertex array's buffer object ends.
void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count);
/// Ranges with count <= 0 are skipped; GL_INVALID_VALUE if drawcount < 0.
void MultiDrawArrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count, GLsizei drawcount);

/// GL_INVALID_ENUM for an unknown mode or type, GL_INVALID_VALUE if count < 0.
/// choice: a draw ends where the indices' buffer object ends.
void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices);
/// Also GL_INVALID_VALUE if end < start. choice: the range is not made use of.
void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices);
/// Lists with count <= 0 are skipped; GL_INVALID_VALUE if drawcount < 0.
void MultiDrawElements(Context& context, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                       GLsizei drawcount);

}  // namespace gouraud::api
