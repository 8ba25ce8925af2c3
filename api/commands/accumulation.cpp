#include "api/commands/accumulation.h"

#include "api/commands/render_mode.h"

namespace gouraud::api {
namespace {

// NaN gives 0.
float clamped_to_signed_unit(float value) {
  return value >= 1.0f ? 1.0f : value <= -1.0f ? -1.0f : value == value ? value : 0.0f;
}

}  // namespace

void ClearAccum(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  context.state.accum.clear_value = {clamped_to_signed_unit(red), clamped_to_signed_unit(green), clamped_to_signed_unit(blue),
                                     clamped_to_signed_unit(alpha)};
}

void Accum(Context& context, GLenum op, GLfloat value) {
  constexpr auto command = "glAccum";
  if (op != GL_ACCUM && op != GL_LOAD && op != GL_ADD && op != GL_MULT && op != GL_RETURN) {
    return context.record_error(GL_INVALID_ENUM, command, "op is unknown");
  }
  if (!context.can_draw(command)) return;
  const TargetInfo target = context.target_info();
  if (!target.accumulates) return context.record_error(GL_INVALID_OPERATION, command, "there is no accumulation buffer");
  if (renders_nothing(context)) return;
  const pipeline::AccumState accum = accum_state(context.state, target, op, value);
  if (accum.scissor.empty() || (op == GL_RETURN && accum.color_write_mask == 0)) return;
  context.flush_vertices();
  context.renderer().accumulate(accum);
}

}  // namespace gouraud::api
