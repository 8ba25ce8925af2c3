// Texture images from the framebuffer [GL1.5 §3.8.2].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: the errors of TexImage, but GL_INVALID_ENUM for an unknown internal format and for 1 to 4; GL_INVALID_OPERATION
/// if the framebuffer lacks what is to be copied. Texels from outside the framebuffer are zero.
void CopyTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                    GLint border);
void CopyTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                    GLsizei height, GLint border);

/// All: the errors of TexSubImage, and GL_INVALID_OPERATION as above. Texels for which the framebuffer has no pixel keep
/// their values.
void CopyTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width);
void CopyTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y,
                       GLsizei width, GLsizei height);
void CopyTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                       GLint x, GLint y, GLsizei width, GLsizei height);

}  // namespace gouraud::api
