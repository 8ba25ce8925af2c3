// Levels of textures as attachments of framebuffer objects, and their mipmaps [ARB_framebuffer_object].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All four: the errors of FramebufferRenderbuffer for target and attachment. If texture is not 0: GL_INVALID_OPERATION
/// if there is no such texture or textarget is not its target, GL_INVALID_VALUE for a level, a slice or a layer that no
/// texture has. textarget is GL_TEXTURE_1D; GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE_ARB or a face of a cube map;
/// GL_TEXTURE_3D; the fourth takes three-dimensional textures.
void FramebufferTexture1D(Context& context, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level);
void FramebufferTexture2D(Context& context, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level);
void FramebufferTexture3D(Context& context, GLenum target, GLenum attachment, GLenum textarget, GLuint texture, GLint level,
                          GLint zoffset);
void FramebufferTextureLayer(Context& context, GLenum target, GLenum attachment, GLuint texture, GLint level, GLint layer);

/// GL_INVALID_ENUM for a target without mipmaps, GL_INVALID_OPERATION for a cube map whose faces differ.
void GenerateMipmap(Context& context, GLenum target);

}  // namespace gouraud::api
