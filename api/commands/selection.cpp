// The name stack and the hit records [GL1.5 §5.2].
#include "api/commands/selection.h"

#include <algorithm>
#include <cmath>

#include "api/commands/render_mode.h"

namespace gouraud::api {
namespace {

void hit(SelectionState& selection, float depth) {
  selection.hit = true;
  selection.nearest = std::min(selection.nearest, depth);
  selection.farthest = std::max(selection.farthest, depth);
}

/// Hits are all that it wants of primitives.
class SelectionReceiver : public pipeline::PrimitiveReceiver {
 public:
  explicit SelectionReceiver(SelectionState& selection) : selection_(selection) {}
  void point(const pipeline::ReportedVertex& vertex) override { hit(selection_, vertex.position_window.z); }
  void line(const pipeline::ReportedVertex& from, const pipeline::ReportedVertex& to, bool) override {
    point(from);
    point(to);
  }
  void polygon(std::span<const pipeline::ReportedVertex> vertices) override {
    for (const pipeline::ReportedVertex& vertex : vertices) point(vertex);
  }

 private:
  SelectionState& selection_;
};

GLuint depth_value(float depth) {
  return static_cast<GLuint>(std::floor(static_cast<double>(depth) * 4294967295.0 + 0.5));
}

// The selection state for a command of the name stack: null outside of selection mode.
SelectionState* selecting(Context& context) {
  if (context.state.render_mode.mode != GL_SELECT) return nullptr;
  context.flush_vertices();
  return &context.state.render_mode.selection;
}

}  // namespace

std::unique_ptr<pipeline::PrimitiveReceiver> make_selection_receiver(Context& context) {
  return std::make_unique<SelectionReceiver>(context.state.render_mode.selection);
}

void write_hit_record(SelectionState& selection) {
  if (!selection.hit) return;
  selection.buffer.put(static_cast<GLuint>(selection.depth));
  selection.buffer.put(depth_value(selection.nearest));
  selection.buffer.put(depth_value(selection.farthest));
  for (int i = 0; i < selection.depth; ++i) selection.buffer.put(selection.names[static_cast<std::size_t>(i)]);
  ++selection.records;
  selection.hit = false;
  selection.nearest = 1.0f;
  selection.farthest = 0.0f;
}

void InitNames(Context& context) {
  SelectionState* const selection = selecting(context);
  if (selection == nullptr) return;
  write_hit_record(*selection);
  selection->depth = 0;
}

void LoadName(Context& context, GLuint name) {
  SelectionState* const selection = selecting(context);
  if (selection == nullptr) return;
  if (selection->depth == 0) return context.record_error(GL_INVALID_OPERATION, "glLoadName", "the stack is empty");
  write_hit_record(*selection);
  selection->names[static_cast<std::size_t>(selection->depth - 1)] = name;
}

void PushName(Context& context, GLuint name) {
  SelectionState* const selection = selecting(context);
  if (selection == nullptr) return;
  if (selection->depth == max_name_stack_depth) {
    return context.record_error(GL_STACK_OVERFLOW, "glPushName", "the stack is full");
  }
  write_hit_record(*selection);
  selection->names[static_cast<std::size_t>(selection->depth++)] = name;
}

void PopName(Context& context) {
  SelectionState* const selection = selecting(context);
  if (selection == nullptr) return;
  if (selection->depth == 0) return context.record_error(GL_STACK_UNDERFLOW, "glPopName", "the stack is empty");
  write_hit_record(*selection);
  --selection->depth;
}

void select_raster_position(Context& context) {
  if (context.state.render_mode.mode != GL_SELECT || !context.state.current.raster.valid) return;
  hit(context.state.render_mode.selection, context.state.current.raster.position_window.z);
}

}  // namespace gouraud::api
