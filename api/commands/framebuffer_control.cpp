#include "api/commands/framebuffer_control.h"

#include "api/commands/clamped.h"
#include "api/commands/render_mode.h"

namespace gouraud::api {

void Scissor(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
  if (width < 0 || height < 0) {
    return context.record_error(GL_INVALID_VALUE, "glScissor", "width or height is negative");
  }
  ScissorGroup& scissor = context.state.scissor;
  scissor.x = x;
  scissor.y = y;
  scissor.width_px = width;
  scissor.height_px = height;
  context.change(dirty_raster);
}

void DepthFunc(Context& context, GLenum func) {
  if (func - GL_NEVER > GL_ALWAYS - GL_NEVER) {
    return context.record_error(GL_INVALID_ENUM, "glDepthFunc", "func is unknown");
  }
  context.state.depth.func = func;
  context.change(dirty_raster);
}

void ColorMask(Context& context, GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha) {
  context.state.color_buffer.write_enabled = {red != GL_FALSE, green != GL_FALSE, blue != GL_FALSE, alpha != GL_FALSE};
  context.change(dirty_raster);
}

void DepthMask(Context& context, GLboolean flag) {
  context.state.depth.write_enabled = flag != GL_FALSE;
  context.change(dirty_raster);
}

void IndexMask(Context& context, GLuint mask) {
  context.state.color_buffer.index_write_mask = mask;
}

void ClearColor(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  context.state.color_buffer.clear_color = clamped(glm::vec4(red, green, blue, alpha));
}

void ClearDepth(Context& context, GLdouble depth) {
  context.state.depth.clear_value = clamped(depth);
}

void ClearStencil(Context& context, GLint s) {
  context.state.stencil.clear_value = s;
}

void ClearIndex(Context& context, GLfloat c) {
  context.state.color_buffer.clear_index = c;
}

void Clear(Context& context, GLbitfield mask) {
  constexpr GLbitfield buffers =
      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;
  if ((mask & ~buffers) != 0) return context.record_error(GL_INVALID_VALUE, "glClear", "mask has an unknown bit");
  if (renders_nothing(context) || !context.can_draw("glClear")) return;
  pipeline::ClearState clear = clear_state(context.state, context.target_info(), mask);
  if (context.draws_reversed_depth()) clear.clear_depth = 1.0 - clear.clear_depth;
  if (clear.scissor.empty() || !(clear.color || clear.depth || clear.stencil || clear.accum)) return;
  context.flush_vertices();
  context.renderer().clear(clear);
}

}  // namespace gouraud::api
