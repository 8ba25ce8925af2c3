// Texture images from client memory [GL1.5 §3.8.1, §3.8.2].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All six: GL_INVALID_ENUM for an unknown target, format or type; GL_INVALID_VALUE for a level, border, size or internal
/// format that is none; GL_INVALID_OPERATION for a depth format without a depth image or the reverse, for depth in three
/// dimensions or on a cube, and for a packed type of another format. Those of check_unpack. GL_OUT_OF_MEMORY.
/// A proxy that does not fit is no error: all its values are 0.
void TexImage1D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border,
                GLenum format, GLenum type, const void* pixels);
void TexImage2D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLint border, GLenum format, GLenum type, const void* pixels);
void TexImage3D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels);

/// GL_INVALID_OPERATION if there is no image, GL_INVALID_VALUE for a region that is not within it, border included.
void TexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                   GLenum type, const void* pixels);
void TexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels);
void TexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                   GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* pixels);

}  // namespace gouraud::api
