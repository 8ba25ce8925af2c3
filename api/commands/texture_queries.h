// Texture images and what is known of them [GL1.5 §6.1.3, §6.1.4].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All below: GL_INVALID_ENUM for a target that is none, GL_INVALID_VALUE for a level that is none.

/// Proxies as well. GL_INVALID_ENUM for an unknown pname; GL_INVALID_OPERATION for the compressed size of an image that is
/// not compressed.
void GetTexLevelParameterfv(Context& context, GLenum target, GLint level, GLenum pname, GLfloat* params);
void GetTexLevelParameteriv(Context& context, GLenum target, GLint level, GLenum pname, GLint* params);

/// The whole image, its border as well. GL_INVALID_ENUM for stencil or colour indices and for unknown formats and types;
/// GL_INVALID_OPERATION for depth of colours or the reverse. Those of check_pack. An image that is not there gives
/// nothing.
void GetTexImage(Context& context, GLenum target, GLint level, GLenum format, GLenum type, void* pixels);

/// GL_INVALID_OPERATION for an image that is not compressed.
void GetCompressedTexImage(Context& context, GLenum target, GLint level, void* img);

}  // namespace gouraud::api
