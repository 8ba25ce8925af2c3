// Renderbuffers: pictures that only framebuffer objects use [ARB_framebuffer_object, "Renderbuffer Objects"].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: GL_INVALID_VALUE if n < 0. A name deleted is detached from the framebuffers that are bound.
void GenRenderbuffers(Context& context, GLsizei n, GLuint* renderbuffers);
void DeleteRenderbuffers(Context& context, GLsizei n, const GLuint* renderbuffers);
/// True once the name has been bound.
GLboolean IsRenderbuffer(Context& context, GLuint renderbuffer);

/// This one and all below: GL_INVALID_ENUM unless target is GL_RENDERBUFFER. GL_INVALID_OPERATION for a name that
/// GenRenderbuffers has not given; the EXT form takes any name.
void BindRenderbuffer(Context& context, GLenum target, GLuint renderbuffer);
void BindRenderbufferEXT(Context& context, GLenum target, GLuint renderbuffer);

/// GL_INVALID_ENUM for a format that nothing can be drawn into, GL_INVALID_VALUE for a size outside
/// [0, GL_MAX_RENDERBUFFER_SIZE] or samples outside [0, GL_MAX_SAMPLES], GL_INVALID_OPERATION without a renderbuffer.
/// The picture is all zero.
void RenderbufferStorage(Context& context, GLenum target, GLenum internalformat, GLsizei width, GLsizei height);
void RenderbufferStorageMultisample(Context& context, GLenum target, GLsizei samples, GLenum internalformat, GLsizei width,
                                    GLsizei height);

/// GL_INVALID_ENUM for an unknown pname, GL_INVALID_OPERATION without a renderbuffer.
void GetRenderbufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params);

}  // namespace gouraud::api
