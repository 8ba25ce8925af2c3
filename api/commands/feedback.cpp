// Takes primitives, pass-through tokens and raster positions, gives the feedback array [GL1.5 §5.3].
#include "api/commands/feedback.h"

#include "api/commands/render_mode.h"

namespace gouraud::api {
namespace {

bool has_color(GLenum type) {
  return type != GL_2D && type != GL_3D;
}

void put(ReportBuffer<GLfloat>& buffer, const glm::vec4& v) {
  for (const float component : {v.x, v.y, v.z, v.w}) buffer.put(component);
}

// [GL1.5 Table 5.2].
void put_vertex(FeedbackState& feedback, const pipeline::ReportedVertex& vertex) {
  ReportBuffer<GLfloat>& buffer = feedback.buffer;
  buffer.put(vertex.position_window.x);
  buffer.put(vertex.position_window.y);
  if (feedback.type != GL_2D) buffer.put(vertex.position_window.z);
  if (feedback.type == GL_4D_COLOR_TEXTURE) buffer.put(vertex.w_clip);
  if (has_color(feedback.type)) put(buffer, vertex.color);
  if (feedback.type == GL_3D_COLOR_TEXTURE || feedback.type == GL_4D_COLOR_TEXTURE) {
    put(buffer, vertex.texture_coordinates);
  }
}

void put_token(FeedbackState& feedback, GLenum token) {
  feedback.buffer.put(static_cast<GLfloat>(token));
}

class FeedbackReceiver : public pipeline::PrimitiveReceiver {
 public:
  explicit FeedbackReceiver(FeedbackState& feedback) : feedback_(feedback) {}
  void point(const pipeline::ReportedVertex& vertex) override {
    put_token(feedback_, GL_POINT_TOKEN);
    put_vertex(feedback_, vertex);
  }
  void line(const pipeline::ReportedVertex& from, const pipeline::ReportedVertex& to, bool starts) override {
    put_token(feedback_, starts ? GL_LINE_RESET_TOKEN : GL_LINE_TOKEN);
    put_vertex(feedback_, from);
    put_vertex(feedback_, to);
  }
  void polygon(std::span<const pipeline::ReportedVertex> vertices) override {
    put_token(feedback_, GL_POLYGON_TOKEN);
    feedback_.buffer.put(static_cast<GLfloat>(vertices.size()));
    for (const pipeline::ReportedVertex& vertex : vertices) put_vertex(feedback_, vertex);
  }

 private:
  FeedbackState& feedback_;
};

}  // namespace

std::unique_ptr<pipeline::PrimitiveReceiver> make_feedback_receiver(Context& context) {
  return std::make_unique<FeedbackReceiver>(context.state.render_mode.feedback);
}

void FeedbackBuffer(Context& context, GLsizei size, GLenum type, GLfloat* buffer) {
  RenderModeState& state = context.state.render_mode;
  if (state.mode == GL_FEEDBACK) {
    return context.record_error(GL_INVALID_OPERATION, "glFeedbackBuffer", "in feedback mode");
  }
  if (size < 0) return context.record_error(GL_INVALID_VALUE, "glFeedbackBuffer", "size is negative");
  if (type < GL_2D || type > GL_4D_COLOR_TEXTURE) {
    return context.record_error(GL_INVALID_ENUM, "glFeedbackBuffer", "type is unknown");
  }
  state.feedback.buffer = {.memory = buffer, .size = size, .specified = true};
  state.feedback.type = type;
}

void PassThrough(Context& context, GLfloat token) {
  if (context.state.render_mode.mode != GL_FEEDBACK) return;
  context.flush_vertices();
  FeedbackState& feedback = context.state.render_mode.feedback;
  put_token(feedback, GL_PASS_THROUGH_TOKEN);
  feedback.buffer.put(token);
}

void report_raster_position(Context& context, GLenum token) {
  if (context.state.render_mode.mode != GL_FEEDBACK) return;
  context.flush_vertices();
  FeedbackState& feedback = context.state.render_mode.feedback;
  const RasterPosition& raster = context.state.current.raster;
  put_token(feedback, token);
  const glm::vec4& p = raster.position_window;
  put_vertex(feedback, {glm::vec3(p.x, p.y, p.z), p.w, raster.color, raster.texture_coordinates[0]});
}

}  // namespace gouraud::api
