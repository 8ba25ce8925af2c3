// Scissor and depth test, write masks, clear values and Clear [GL1.5 §4.1.2, §4.1.6, §4.2.2, §4.2.3].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_VALUE for a negative width or height.
void Scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height);
/// GL_INVALID_ENUM for an unknown function.
void DepthFunc(Context& context, GLenum func);

void ColorMask(Context& context, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha);
void DepthMask(Context& context, GLboolean flag);
void IndexMask(Context& context, GLuint mask);

/// Colours and depth are clamped to [0, 1].
void ClearColor(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
void ClearDepth(Context& context, GLdouble depth);
void ClearStencil(Context& context, GLint s);
void ClearIndex(Context& context, GLfloat c);

/// GL_INVALID_VALUE for a bit that is no buffer, GL_INVALID_FRAMEBUFFER_OPERATION for an incomplete framebuffer. A buffer that the target lacks is left out.
void Clear(Context& context, GLbitfield mask);

}  // namespace gouraud::api
