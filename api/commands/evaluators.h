// Evaluators [GL1.5 §5.1].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All four: GL_INVALID_ENUM for an unknown target; GL_INVALID_VALUE for u1 == u2 (v1 == v2), a stride below the values
/// of a point, an order outside [1, max_eval_order], or no points; GL_INVALID_OPERATION unless texture unit 0 is active.
/// choice: domains are compared as the floats that are kept.
void Map1f(Context& context, GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order, const GLfloat* points);
void Map1d(Context& context, GLenum target, GLdouble u1, GLdouble u2, GLint stride, GLint order,
           const GLdouble* points);
void Map2f(Context& context, GLenum target, GLfloat u1, GLfloat u2, GLint ustride, GLint uorder, GLfloat v1,
           GLfloat v2, GLint vstride, GLint vorder, const GLfloat* points);
void Map2d(Context& context, GLenum target, GLdouble u1, GLdouble u2, GLint ustride, GLint uorder, GLdouble v1,
           GLdouble v2, GLint vstride, GLint vorder, const GLdouble* points);

/// Both: GL_INVALID_VALUE unless there is a segment.
void MapGrid1f(Context& context, GLint un, GLfloat u1, GLfloat u2);
void MapGrid2f(Context& context, GLint un, GLfloat u1, GLfloat u2, GLint vn, GLfloat v1, GLfloat v2);

/// A vertex from the enabled maps. The current values stay as they are.
void EvalCoord1f(Context& context, GLfloat u);
void EvalCoord2f(Context& context, GLfloat u, GLfloat v);
void EvalPoint1(Context& context, GLint i);
void EvalPoint2(Context& context, GLint i, GLint j);

/// Both: GL_INVALID_ENUM for an unknown mode.
void EvalMesh1(Context& context, GLenum mode, GLint i1, GLint i2);
void EvalMesh2(Context& context, GLenum mode, GLint i1, GLint i2, GLint j1, GLint j2);

/// GL_INVALID_ENUM for an unknown target or query.
void GetMapfv(Context& context, GLenum target, GLenum query, GLfloat* v);
void GetMapdv(Context& context, GLenum target, GLenum query, GLdouble* v);
void GetMapiv(Context& context, GLenum target, GLenum query, GLint* v);

}  // namespace gouraud::api
