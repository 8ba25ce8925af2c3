// Renderbuffers and framebuffer objects as a context keeps them [ARB_framebuffer_object], and the views of them that the
// pipeline draws into and reads from.
#pragma once

#include <array>
#include <memory>

#include <GL/gl.h>

#include "api/context/object_names.h"
#include "api/state/limits.h"
#include "api/state/texture.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::api {

/// Contexts share renderbuffers.
struct Renderbuffer {
  GLuint name = 0;
  GLenum internal_format = GL_RGBA;  ///< as it was asked for
  GLsizei samples = 0;
  pipeline::Surface surface;
};

/// What stands at one attachment point of a framebuffer object: a renderbuffer, or one image of a texture.
struct Attachment {
  std::shared_ptr<Renderbuffer> renderbuffer;
  TextureBinding texture;
  std::size_t face = 0, level = 0;
  GLint layer = 0;  ///< of a three-dimensional texture

  GLenum object_type() const { return renderbuffer != nullptr ? GL_RENDERBUFFER : texture != nullptr ? GL_TEXTURE : GL_NONE; }
  GLuint object_name() const { return renderbuffer != nullptr ? renderbuffer->name : name_of(texture); }
  /// The texture's image; not for a renderbuffer.
  pipeline::Image& image() const { return texture->texture->faces[face][level]; }
  /// The picture attached; without size if there is none.
  pipeline::Surface surface() const;
  GLsizei samples() const { return renderbuffer != nullptr ? renderbuffer->samples : 0; }
  bool operator==(const Attachment&) const = default;
};

/// A framebuffer object, or, under name 0, the window system's framebuffer, which has no attachment points. Contexts do
/// not share them.
struct FramebufferObject {
  GLuint name = 0;
  GLenum draw_buffer = GL_COLOR_ATTACHMENT0, read_buffer = GL_COLOR_ATTACHMENT0;
  std::array<Attachment, max_color_attachments> color;
  Attachment depth, stencil;

  bool is_window() const { return name == 0; }
  /// The attachment that a draw or read buffer names; null for GL_NONE.
  const Attachment* color_attachment(GLenum buffer) const;
};

/// Whether the framebuffer object (not the window's) can be drawn into: GL_FRAMEBUFFER_COMPLETE, or the first of the
/// reasons why not.
GLenum completeness(const FramebufferObject& framebuffer);

/// Calls visit(attachment) for every attachment point in use.
template <class Visit>
void for_each_attachment(const FramebufferObject& framebuffer, Visit visit) {
  for (const Attachment& attachment : framebuffer.color) {
    if (attachment.object_type() != GL_NONE) visit(attachment);
  }
  if (framebuffer.depth.object_type() != GL_NONE) visit(framebuffer.depth);
  if (framebuffer.stencil.object_type() != GL_NONE) visit(framebuffer.stencil);
}

/// What a complete framebuffer object's pictures look like to the pipeline, with `buffer` (its draw or its read buffer)
/// as the colour. It has the size that all attachments have in common.
pipeline::Framebuffer view_of(const FramebufferObject& framebuffer, GLenum buffer);

/// The samples of each pixel of a complete framebuffer object; 0 if it is not multisampled.
GLsizei samples_of(const FramebufferObject& framebuffer);

}  // namespace gouraud::api
