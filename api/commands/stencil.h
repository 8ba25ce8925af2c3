// The stencil test [GL1.5 §4.1.5, §4.2.2], of one side or of both: EXT_stencil_two_side, ATI_separate_stencil.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// These three set the active side (ActiveStencilFaceEXT); of FRONT, also the back side of ATI_separate_stencil.
/// GL_INVALID_ENUM for an unknown function or operation.
void StencilFunc(Context& context, GLenum func, GLint ref, GLuint mask);
void StencilOp(Context& context, GLenum fail, GLenum zfail, GLenum zpass);
void StencilMask(Context& context, GLuint mask);

/// GL_INVALID_ENUM unless FRONT or BACK.
void ActiveStencilFaceEXT(Context& context, GLenum face);

/// GL_INVALID_ENUM for an unknown face, function or operation.
void StencilFuncSeparateATI(Context& context, GLenum frontfunc, GLenum backfunc, GLint ref, GLuint mask);
void StencilOpSeparateATI(Context& context, GLenum face, GLenum sfail, GLenum dpfail, GLenum dppass);

}  // namespace gouraud::api
