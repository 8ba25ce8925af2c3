// Matrices and their stacks [GL1.5 §2.11.2]. Matrices are kept in float.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// GL_INVALID_ENUM unless MODELVIEW, PROJECTION or TEXTURE; there is no COLOR matrix without the imaging subset.
void MatrixMode(Context& context, GLenum mode);
/// GL_INVALID_ENUM unless `texture` is GL_TEXTUREi of a unit.
void ActiveTexture(Context& context, GLenum texture);

void LoadIdentity(Context& context);
/// `m`: 16 values, column by column.
void LoadMatrixf(Context& context, const GLfloat* m);
void MultMatrixf(Context& context, const GLfloat* m);
void Rotatef(Context& context, GLfloat angle, GLfloat x, GLfloat y, GLfloat z);
void Translatef(Context& context, GLfloat x, GLfloat y, GLfloat z);
void Scalef(Context& context, GLfloat x, GLfloat y, GLfloat z);
/// GL_INVALID_VALUE if zNear <= 0, zFar <= 0, or an extent is empty.
void Frustum(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
             GLdouble zFar);
/// GL_INVALID_VALUE if an extent is empty.
void Ortho(Context& context, GLdouble left, GLdouble right, GLdouble bottom, GLdouble top, GLdouble zNear,
           GLdouble zFar);

/// GL_STACK_OVERFLOW on a full stack.
void PushMatrix(Context& context);
/// GL_STACK_UNDERFLOW if only one matrix is left.
void PopMatrix(Context& context);

}  // namespace gouraud::api
