// The window's framebuffer has one colour buffer, the front left one; a framebuffer object has its attachments.
//
// choice: the back buffer is another name of the window's one buffer, as in Mesa's OSMesa.
// choice: the selection is the framebuffer's; PopAttrib restores that of the framebuffer which is bound then.
#include "api/commands/buffer_selection.h"

namespace gouraud::api {
namespace {

enum class Choice { exists, missing, unknown };

Choice choice_of(const FramebufferObject& framebuffer, GLenum buffer, bool draws) {
  if (buffer == GL_NONE) return Choice::exists;
  const bool is_attachment = buffer - GL_COLOR_ATTACHMENT0 <= GL_COLOR_ATTACHMENT15 - GL_COLOR_ATTACHMENT0;
  if (is_attachment) {
    const bool exists =
        !framebuffer.is_window() && buffer - GL_COLOR_ATTACHMENT0 < static_cast<GLenum>(max_color_attachments);
    return exists ? Choice::exists : Choice::missing;
  }
  const auto of_window = [&](bool exists) {
    return framebuffer.is_window() && exists ? Choice::exists : Choice::missing;
  };
  switch (buffer) {
    case GL_FRONT_AND_BACK:
      return draws ? of_window(true) : Choice::unknown;
    case GL_FRONT_LEFT:
    case GL_FRONT:
    case GL_LEFT:
    case GL_BACK_LEFT:
    case GL_BACK:
      return of_window(true);
    case GL_FRONT_RIGHT:
    case GL_BACK_RIGHT:
    case GL_RIGHT:
    case GL_AUX0:
    case GL_AUX1:
    case GL_AUX2:
    case GL_AUX3:
      return of_window(false);
    default:
      return Choice::unknown;
  }
}

void select(Context& context, FramebufferObject& framebuffer, GLenum FramebufferObject::*member, GLenum buffer,
            const char* command) {
  switch (choice_of(framebuffer, buffer, member == &FramebufferObject::draw_buffer)) {
    case Choice::unknown:
      return context.record_error(GL_INVALID_ENUM, command, "there is no such buffer in the GL");
    case Choice::missing:
      return context.record_error(GL_INVALID_OPERATION, command, "the framebuffer does not have this buffer");
    case Choice::exists:
      break;
  }
  if (framebuffer.*member == buffer) return;
  framebuffer.*member = buffer;
  context.update_targets();
}

}  // namespace

void restore_draw_buffer(Context& context, GLenum buffer) {
  select(context, *context.framebuffers.draw, &FramebufferObject::draw_buffer, buffer, "glPopAttrib");
}

void restore_read_buffer(Context& context, GLenum buffer) {
  select(context, *context.framebuffers.read, &FramebufferObject::read_buffer, buffer, "glPopAttrib");
}

void DrawBuffer(Context& context, GLenum buf) {
  select(context, *context.framebuffers.draw, &FramebufferObject::draw_buffer, buf, "glDrawBuffer");
}

void ReadBuffer(Context& context, GLenum src) {
  select(context, *context.framebuffers.read, &FramebufferObject::read_buffer, src, "glReadBuffer");
}

}  // namespace gouraud::api
