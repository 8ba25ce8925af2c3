// Alpha test, blending and logical operation [GL1.5 §4.1.4, §4.1.8, §4.1.10].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// The reference is clamped to [0, 1]. GL_INVALID_ENUM for an unknown function.
void AlphaFunc(Context& context, GLenum func, GLfloat ref);

/// GL_INVALID_ENUM for an unknown factor; SRC_ALPHA_SATURATE is none for the destination [GL1.5 Table 4.1].
void BlendFunc(Context& context, GLenum sfactor, GLenum dfactor);
void BlendFuncSeparate(Context& context, GLenum sfactorRGB, GLenum dfactorRGB, GLenum sfactorAlpha, GLenum dfactorAlpha);

/// GL_INVALID_ENUM for an unknown equation. GL_LOGIC_OP is one: blending is then the logical operation [EXT_blend_logic_op].
void BlendEquation(Context& context, GLenum mode);
/// Another equation for alpha than for R, G and B [EXT_blend_equation_separate].
void BlendEquationSeparateEXT(Context& context, GLenum modeRGB, GLenum modeAlpha);

/// Clamped to [0, 1].
void BlendColor(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);

/// GL_INVALID_ENUM for an unknown operation.
void LogicOp(Context& context, GLenum opcode);

}  // namespace gouraud::api
