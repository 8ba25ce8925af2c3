// Framebuffer objects: binding, attaching, completeness [ARB_framebuffer_object, "Framebuffer Objects"].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both: GL_INVALID_VALUE if n < 0. In place of a deleted framebuffer that is bound the window's is bound.
void GenFramebuffers(Context& context, GLsizei n, GLuint* framebuffers);
void DeleteFramebuffers(Context& context, GLsizei n, const GLuint* framebuffers);
/// True once the name has been bound.
GLboolean IsFramebuffer(Context& context, GLuint framebuffer);

/// This one and all below: GL_INVALID_ENUM unless target is GL_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER or GL_READ_FRAMEBUFFER.
/// GL_INVALID_OPERATION for a name that GenFramebuffers has not given; the EXT form takes any name.
void BindFramebuffer(Context& context, GLenum target, GLuint framebuffer);
void BindFramebufferEXT(Context& context, GLenum target, GLuint framebuffer);

/// The status; 0 on error.
GLenum CheckFramebufferStatus(Context& context, GLenum target);

/// GL_INVALID_OPERATION if the window's framebuffer is bound, if attachment is a colour attachment that there is not, or
/// if there is no such renderbuffer; GL_INVALID_ENUM for any other attachment or renderbuffertarget.
void FramebufferRenderbuffer(Context& context, GLenum target, GLenum attachment, GLenum renderbuffertarget,
                             GLuint renderbuffer);

/// GL_INVALID_ENUM for an unknown attachment or pname, GL_INVALID_OPERATION for a pname that nothing attached has.
void GetFramebufferAttachmentParameteriv(Context& context, GLenum target, GLenum attachment, GLenum pname,
                                         GLint* params);

/// The framebuffer object that target names; null, and an error is recorded, if it names none or the window's.
FramebufferObject* bound_object(Context& context, GLenum target, const char* command);
/// What the commands that attach something have in common.
void attach(Context& context, FramebufferObject& framebuffer, GLenum point, const Attachment& attachment,
            const char* command);
/// Takes the attachment from every point where it stands. The targets are not brought up to date.
void detach(FramebufferObject& framebuffer, const Attachment& attachment);

}  // namespace gouraud::api
