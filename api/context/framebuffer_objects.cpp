// Completeness and views of framebuffer objects [ARB_framebuffer_object, "Framebuffer Completeness"].
//
// choice: depth and stencil of different pictures are GL_FRAMEBUFFER_UNSUPPORTED, as in Mesa: a packed plane holds both.
// choice: a draw or read buffer without a picture makes a framebuffer incomplete, as the extension says; Mesa, which also
// has ARB_ES2_compatibility, lets it pass.
#include "api/context/framebuffer_objects.h"

#include <algorithm>
#include <limits>

namespace gouraud::api {
namespace {

using pipeline::ColorFormat;
using pipeline::Surface;

/// Calls visit(attachment) for every attachment point in use.
template <class Visit>
void for_each_attachment(const FramebufferObject& framebuffer, Visit visit) {
  for (const Attachment& attachment : framebuffer.color) {
    if (attachment.object_type() != GL_NONE) visit(attachment);
  }
  if (framebuffer.depth.object_type() != GL_NONE) visit(framebuffer.depth);
  if (framebuffer.stencil.object_type() != GL_NONE) visit(framebuffer.stencil);
}

template <class Renderable>
bool is_complete(const Attachment& attachment, Renderable renderable) {
  if (attachment.object_type() == GL_NONE) return true;
  const Surface* const surface = attachment.surface();
  return surface != nullptr && surface->width_px > 0 && surface->height_px > 0 && renderable(*surface);
}

bool attachments_complete(const FramebufferObject& framebuffer) {
  const auto color = [](const Attachment& attachment) {
    return is_complete(attachment, [](const Surface& s) { return s.color_format != ColorFormat::none; });
  };
  return std::ranges::all_of(framebuffer.color, color) &&
         is_complete(framebuffer.depth, [](const Surface& s) { return s.has_depth; }) &&
         is_complete(framebuffer.stencil, [](const Surface& s) { return s.has_stencil; });
}

bool names_nothing(const FramebufferObject& framebuffer, GLenum buffer) {
  const Attachment* const attachment = framebuffer.color_attachment(buffer);
  return attachment != nullptr && attachment->object_type() == GL_NONE;
}

}  // namespace

const Attachment* FramebufferObject::color_attachment(GLenum buffer) const {
  return buffer == GL_NONE ? nullptr : &color[buffer - GL_COLOR_ATTACHMENT0];
}

GLenum completeness(const FramebufferObject& framebuffer) {
  if (!attachments_complete(framebuffer)) return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
  bool any = false, same_samples = true;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    same_samples = same_samples && (!any || attachment.samples() == samples_of(framebuffer));
    any = true;
  });
  if (!any) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
  if (names_nothing(framebuffer, framebuffer.draw_buffer)) return GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER;
  if (names_nothing(framebuffer, framebuffer.read_buffer)) return GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER;
  if (!same_samples) return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
  const bool both = framebuffer.depth.object_type() != GL_NONE && framebuffer.stencil.object_type() != GL_NONE;
  if (both && framebuffer.depth != framebuffer.stencil) return GL_FRAMEBUFFER_UNSUPPORTED;
  return GL_FRAMEBUFFER_COMPLETE;
}

pipeline::Framebuffer view_of(const FramebufferObject& framebuffer, GLenum buffer) {
  int width = std::numeric_limits<int>::max(), height = width;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    width = std::min(width, attachment.surface()->width_px);
    height = std::min(height, attachment.surface()->height_px);
  });
  const Attachment* const color = framebuffer.color_attachment(buffer);
  return pipeline::Framebuffer(width, height, color != nullptr ? color->surface() : nullptr,
                               framebuffer.depth.surface(), framebuffer.stencil.surface());
}

GLsizei samples_of(const FramebufferObject& framebuffer) {
  GLsizei samples = -1;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    if (samples < 0) samples = attachment.samples();
  });
  return std::max(samples, 0);
}

}  // namespace gouraud::api
