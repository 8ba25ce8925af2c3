// choice: pixels outside the read framebuffer, undefined by the extension, leave the draw framebuffer as it is.
// choice: between a framebuffer and itself rows are copied in ascending order; overlaps are undefined by the extension.
#include "api/commands/blit_framebuffer.h"

#include <cstdint>

namespace gouraud::api {
namespace {

struct Refusal {
  GLenum error = GL_NO_ERROR;
  const char* message = nullptr;
};

std::int64_t extent(std::int32_t from, std::int32_t to) {
  const std::int64_t signed_extent = std::int64_t{to} - from;
  return signed_extent < 0 ? -signed_extent : signed_extent;
}

bool same_size(const pipeline::BlitRect& a, const pipeline::BlitRect& b) {
  return extent(a.x0, a.x1) == extent(b.x0, b.x1) && extent(a.y0, a.y1) == extent(b.y0, b.y1);
}

Refusal refusal_of_arguments(GLbitfield mask, GLenum filter) {
  if ((mask & ~(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)) != 0) {
    return {GL_INVALID_VALUE, "mask has an unknown bit"};
  }
  if (filter != GL_NEAREST && filter != GL_LINEAR) return {GL_INVALID_ENUM, "filter is unknown"};
  if (filter == GL_LINEAR && (mask & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT)) != 0) {
    return {GL_INVALID_OPERATION, "depth and stencil are not interpolated"};
  }
  return {};
}

Refusal refusal_of_pictures(const pipeline::Framebuffer& source, const pipeline::Framebuffer& destination,
                            const pipeline::Blit& blit) {
  const bool both_have_depth = source.has_depth && destination.has_depth;
  if (blit.depth && both_have_depth && source.depth_format != destination.depth_format) {
    return {GL_INVALID_OPERATION, "the depth formats differ"};
  }
  const bool multisampled = source.samples > 1 || destination.samples > 1;
  if (multisampled && !same_size(blit.source, blit.destination)) {
    return {GL_INVALID_OPERATION, "a multisampled picture is not scaled"};
  }
  return {};
}

}  // namespace

void BlitFramebuffer(Context& context, GLint srcX0, GLint srcY0, GLint srcX1, GLint srcY1, GLint dstX0, GLint dstY0,
                     GLint dstX1, GLint dstY1, GLbitfield mask, GLenum filter) {
  constexpr auto command = "glBlitFramebuffer";
  const Refusal arguments = refusal_of_arguments(mask, filter);
  if (arguments.error != GL_NO_ERROR) return context.record_error(arguments.error, command, arguments.message);
  if (!context.can_draw(command) || !context.can_blit_from(command)) return;
  if (context.target() == nullptr || context.read_target() == nullptr) return;
  const pipeline::Framebuffer &source = *context.read_target(), &destination = *context.target();

  pipeline::Blit blit{{srcX0, srcY0, srcX1, srcY1}, {dstX0, dstY0, dstX1, dstY1}};
  blit.scissor = writable_rect(context.state, context.target_info());
  blit.color = (mask & GL_COLOR_BUFFER_BIT) != 0 && context.target_info().color_channels != 0;
  blit.depth = (mask & GL_DEPTH_BUFFER_BIT) != 0;
  blit.stencil = (mask & GL_STENCIL_BUFFER_BIT) != 0;
  blit.linear = filter == GL_LINEAR;
  const Refusal pictures = refusal_of_pictures(source, destination, blit);
  if (pictures.error != GL_NO_ERROR) return context.record_error(pictures.error, command, pictures.message);

  context.finish_rendering();
  context.renderer().blit(source, blit);
}

}  // namespace gouraud::api
