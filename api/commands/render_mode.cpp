// The mode itself: what comes of primitives [GL1.5 §5.2, §5.3].
#include "api/commands/render_mode.h"

#include <utility>

#include "api/commands/feedback.h"
#include "api/commands/selection.h"
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

// Ends the mode; what it has to say.
GLint leave(RenderModeState& state) {
  GLint result = 0;
  if (state.mode == GL_SELECT) {
    SelectionState& selection = state.selection;
    write_hit_record(selection);
    result = selection.buffer.overflown ? -1 : selection.records;
    selection.buffer.restart();
    selection.records = selection.depth = 0;
  } else if (state.mode == GL_FEEDBACK) {
    ReportBuffer<GLfloat>& buffer = state.feedback.buffer;
    result = buffer.overflown ? -1 : buffer.count;
    buffer.restart();
  }
  return result;
}

std::unique_ptr<pipeline::PrimitiveReceiver> make_receiver(Context& context, GLenum mode) {
  if (mode == GL_SELECT) return make_selection_receiver(context);
  return mode == GL_FEEDBACK ? make_feedback_receiver(context) : nullptr;
}

constexpr StateRow rows[] = {
    {GL_RENDER_MODE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.render_mode.mode); }},
    {GL_NAME_STACK_DEPTH, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.render_mode.selection.depth); }},
    {GL_SELECTION_BUFFER_SIZE, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.render_mode.selection.buffer.size); }},
    {GL_FEEDBACK_BUFFER_SIZE, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.render_mode.feedback.buffer.size); }},
    {GL_FEEDBACK_BUFFER_TYPE, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.render_mode.feedback.type); }},
};

}  // namespace

GLint RenderMode(Context& context, GLenum mode) {
  RenderModeState& state = context.state.render_mode;
  if (mode != GL_RENDER && mode != GL_SELECT && mode != GL_FEEDBACK) {
    context.record_error(GL_INVALID_ENUM, "glRenderMode", "mode is unknown");
    return 0;
  }
  const bool has_buffer = mode == GL_RENDER || (mode == GL_SELECT ? state.selection.buffer.specified
                                                                  : state.feedback.buffer.specified);
  if (!has_buffer) {
    context.record_error(GL_INVALID_OPERATION, "glRenderMode", "the mode has no buffer");
    return 0;
  }
  context.flush_vertices();
  auto receiver = make_receiver(context, mode);
  const GLint result = leave(state);
  state.mode = mode;
  context.renderer().set_receiver(receiver.get());
  context.primitive_receiver = std::move(receiver);
  context.change(dirty_all);
  return result;
}

void SelectBuffer(Context& context, GLsizei size, GLuint* buffer) {
  RenderModeState& state = context.state.render_mode;
  if (state.mode == GL_SELECT) {
    return context.record_error(GL_INVALID_OPERATION, "glSelectBuffer", "in selection mode");
  }
  if (size < 0) return context.record_error(GL_INVALID_VALUE, "glSelectBuffer", "size is negative");
  state.selection.buffer = {.memory = buffer, .size = size, .specified = true};
}

std::span<const StateRow> render_mode_rows() {
  return rows;
}

}  // namespace gouraud::api
