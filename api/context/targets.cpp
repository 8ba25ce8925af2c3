// Which framebuffer a context draws into and reads from, as the pipeline sees it.
#include <utility>

#include "api/context/context.h"
#include "pipeline/texture/attachable.h"

namespace gouraud::api {

GLenum Context::framebuffer_status(const FramebufferObject& framebuffer) const {
  if (!framebuffer.is_window()) return completeness(framebuffer);
  return window_ != nullptr ? GL_FRAMEBUFFER_COMPLETE : GL_FRAMEBUFFER_UNDEFINED;
}

// Images that are drawn into lie in tiles, also after a program has specified them anew.
void Context::tile_attachments(const FramebufferObject& framebuffer) {
  for_each_attachment(framebuffer, [&](const Attachment& attachment) {
    if (attachment.texture == nullptr) return;
    pipeline::Image& image = attachment.image();
    if (image.tiles != nullptr || !pipeline::is_attachable(image)) return;
    finish_rendering();
    if (pipeline::wide_format(image.format) != image.format) pipeline::widen(*attachment.texture->texture);
    pipeline::put_into_tiles(image);
    change(dirty_textures);
  });
}

// Pending vertices were given for the old target, which is still the renderer's: its views keep what was attached alive.
void Context::update_targets() {
  const FramebufferObject &draw = *framebuffers.draw, &read = *framebuffers.read;
  tile_attachments(draw);
  tile_attachments(read);
  read_complete_ = read.is_window() || completeness(read) == GL_FRAMEBUFFER_COMPLETE;
  if (!read.is_window() && read_complete_) {
    read_view_ = view_of(read, read.read_buffer);
    read_target_ = &read_view_;
  } else if (read.is_window() && window_ != nullptr && read.read_buffer == GL_NONE) {
    read_view_ = *window_;
    read_view_.color_format = pipeline::ColorFormat::none;
    read_view_.color = {};
    read_target_ = &read_view_;
  } else {
    read_target_ = read.is_window() ? window_.get() : nullptr;
  }

  draw_complete_ = draw.is_window() || completeness(draw) == GL_FRAMEBUFFER_COMPLETE;
  pipeline::Framebuffer view;
  if (!draw.is_window() && draw_complete_) view = view_of(draw, draw.draw_buffer);
  pipeline::Framebuffer* const next = draw.is_window() ? window_.get() : draw_complete_ ? &draw_view_ : nullptr;
  change(dirty_raster);  // the draw buffer may be GL_NONE now
  if (next == target() && (next != &draw_view_ || view == draw_view_)) return;
  flush_vertices();
  const bool drew = renderer_.take_dirty();
  if (target() != nullptr && target() == window_.get()) window_dirty_ |= drew;
  renderer_.set_target(nullptr);
  draw_view_ = std::move(view);
  renderer_.set_target(next);
  change(dirty_all);
}

bool Context::take_window_dirty() {
  const bool drew = target() == window_.get() && renderer_.take_dirty();
  return std::exchange(window_dirty_, false) || drew;
}

bool Context::can_draw(const char* command) {
  if (!draw_complete_) record_error(GL_INVALID_FRAMEBUFFER_OPERATION, command, "the draw framebuffer is incomplete");
  return draw_complete_;
}

bool Context::can_blit_from(const char* command) {
  if (!read_complete_) record_error(GL_INVALID_FRAMEBUFFER_OPERATION, command, "the read framebuffer is incomplete");
  return read_complete_;
}

bool Context::can_read(const char* command) {
  if (!can_blit_from(command)) return false;
  const bool multisampled = samples_of(*framebuffers.read) > 0;
  if (multisampled) record_error(GL_INVALID_OPERATION, command, "the read framebuffer is multisampled");
  return !multisampled;
}

}  // namespace gouraud::api
