// Texture images that come compressed [GL1.5 §3.8.3], with EXT_texture_compression_s3tc.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All six: the errors of TexImage; GL_INVALID_ENUM for a format that is no specific compressed one of that dimension,
/// GL_INVALID_VALUE for an imageSize that is not the image's; those of check_unpack_array.
void CompressedTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLint border, GLsizei imageSize, const void* data);
void CompressedTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLint border, GLsizei imageSize, const void* data);
void CompressedTexImage3D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const void* data);

/// GL_INVALID_OPERATION if the image is not of this format, or the region not made of whole blocks.
void CompressedTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                             GLsizei imageSize, const void* data);
void CompressedTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                             GLsizei height, GLenum format, GLsizei imageSize, const void* data);
void CompressedTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                             GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize,
                             const void* data);

}  // namespace gouraud::api
