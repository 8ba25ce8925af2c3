// The environment of the active texture unit [GL1.5 §3.8.13], with ARB_texture_env_crossbar and ARB_point_sprite.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All TexEnv commands. GL_INVALID_ENUM for an unknown target, pname or value; GL_INVALID_VALUE for a scale that is not
/// 1, 2 or 4.
void TexEnvfv(Context& context, GLenum target, GLenum pname, const GLfloat* params);

/// Both: GL_INVALID_ENUM for an unknown target or pname.
void GetTexEnvfv(Context& context, GLenum target, GLenum pname, GLfloat* params);
void GetTexEnviv(Context& context, GLenum target, GLenum pname, GLint* params);

}  // namespace gouraud::api
