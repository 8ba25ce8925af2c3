// Completeness and views of framebuffer objects [ARB_framebuffer_object, "Framebuffer Completeness"].
//
// choice: depth and stencil of different pictures are GL_FRAMEBUFFER_UNSUPPORTED, as in Mesa: a packed plane holds both.
// deviation: a draw or read buffer without a picture does not make a framebuffer incomplete, as the extension has it: Mesa
// (by ARB_ES2_compatibility) lets it pass, and programs that only want depth, or draw into one buffer and never read,
// rely on it. Nothing is drawn then, and to read is GL_INVALID_OPERATION.
#include "api/context/framebuffer_objects.h"

#include <algorithm>
#include <limits>

#include "pipeline/texture/attachable.h"

namespace gouraud::api {
namespace {

using pipeline::ColorFormat;
using pipeline::Surface;

template <class Renderable>
bool is_complete(const Attachment& attachment, Renderable renderable) {
  if (attachment.object_type() == GL_NONE) return true;
  if (attachment.texture != nullptr && attachment.texture->descriptions[attachment.face][attachment.level].blocks != nullptr) return false;
  const Surface surface = attachment.surface();
  return surface.width_px > 0 && surface.height_px > 0 && renderable(surface);
}

/// An image that could be drawn into, but not by this implementation: it is too large.
bool is_supported(const Attachment& attachment) {
  if (attachment.texture == nullptr) return true;
  const pipeline::Image& image = attachment.image();
  return image.empty() || attachment.layer >= image.depth || pipeline::is_attachable(image);
}

bool attachments_complete(const FramebufferObject& framebuffer) {
  const auto color = [](const Attachment& attachment) {
    return is_complete(attachment, [](const Surface& s) { return s.color_format != ColorFormat::none; });
  };
  return std::ranges::all_of(framebuffer.color, color) &&
         is_complete(framebuffer.depth, [](const Surface& s) { return s.has_depth; }) &&
         is_complete(framebuffer.stencil, [](const Surface& s) { return s.has_stencil; });
}

}  // namespace

const Attachment* FramebufferObject::color_attachment(GLenum buffer) const {
  return buffer == GL_NONE ? nullptr : &color[buffer - GL_COLOR_ATTACHMENT0];
}

pipeline::Surface Attachment::surface() const {
  if (renderbuffer != nullptr) return renderbuffer->surface;
  if (texture == nullptr || layer >= image().depth) return {};
  return pipeline::surface_of(image(), layer);
}

GLenum completeness(const FramebufferObject& framebuffer) {
  bool supported = true;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) { supported = supported && is_supported(attachment); });
  if (!supported) return GL_FRAMEBUFFER_UNSUPPORTED;
  if (!attachments_complete(framebuffer)) return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
  bool any = false, same_samples = true;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    same_samples = same_samples && (!any || attachment.samples() == samples_of(framebuffer));
    any = true;
  });
  if (!any) return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT;
  if (!same_samples) return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
  const bool both = framebuffer.depth.object_type() != GL_NONE && framebuffer.stencil.object_type() != GL_NONE;
  if (both && framebuffer.depth != framebuffer.stencil) return GL_FRAMEBUFFER_UNSUPPORTED;
  return GL_FRAMEBUFFER_COMPLETE;
}

pipeline::Framebuffer view_of(const FramebufferObject& framebuffer, GLenum buffer) {
  int width = std::numeric_limits<int>::max(), height = width;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    const Surface surface = attachment.surface();
    width = std::min(width, surface.width_px);
    height = std::min(height, surface.height_px);
  });
  const Attachment* const attachment = framebuffer.color_attachment(buffer);
  const Surface color = attachment != nullptr ? attachment->surface() : Surface{};
  const Surface depth = framebuffer.depth.surface(), stencil = framebuffer.stencil.surface();
  const auto given = [](const Surface& surface) { return surface.width_px > 0 ? &surface : nullptr; };
  return pipeline::Framebuffer(width, height, given(color), given(depth), given(stencil));
}

GLsizei samples_of(const FramebufferObject& framebuffer) {
  GLsizei samples = -1;
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    if (samples < 0) samples = attachment.samples();
  });
  return std::max(samples, 0);
}

}  // namespace gouraud::api
