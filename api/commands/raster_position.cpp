// Takes a position and the current values, gives the current raster position and its associated data [GL1.5 §2.13].
#include "api/commands/raster_position.h"

#include "api/commands/begin_end.h"
#include "api/commands/clamped.h"
#include "api/commands/render_mode.h"
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

glm::vec4 opaque(const glm::vec4& color) {
  return glm::vec4(color.x, color.y, color.z, 1.0f);
}

constexpr StateRow rows[] = {
    {GL_CURRENT_RASTER_POSITION, ValueKind::real, 4,
     [](const Context& c, StateValue& v) { set(v, c.state.current.raster.position_window); }},
    {GL_CURRENT_RASTER_POSITION_VALID, ValueKind::boolean, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.current.raster.valid); }},
    {GL_CURRENT_RASTER_DISTANCE, ValueKind::real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.current.raster.distance); }},
    {GL_CURRENT_RASTER_COLOR, ValueKind::normalized, 4,
     [](const Context& c, StateValue& v) { set(v, c.state.current.raster.color); }},
    {GL_CURRENT_RASTER_INDEX, ValueKind::real, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.current.raster.color_index); }},
    {GL_CURRENT_RASTER_TEXTURE_COORDS, ValueKind::real, 4,
     [](const Context& c, StateValue& v) {
       set(v, c.state.current.raster.texture_coordinates[static_cast<std::size_t>(c.state.texture.active_unit)]);
     }},
};

}  // namespace

void RasterPos4f(Context& context, GLfloat x, GLfloat y, GLfloat z, GLfloat w) {
  const pipeline::DrawState state = raster_position_state(context.state, context.target_info());
  context.flush_vertices();  // the batch is free then
  const pipeline::Plan plan = pipeline::make_plan(state, {});
  Immediate& immediate = context.immediate;
  immediate.limit = 1;
  immediate.demand = plan.vertex_demand;
  Vertex4f(context, x, y, z, w);
  immediate.limit = 0;
  const pipeline::ProcessedVertex vertex = context.renderer().process_vertex(state, plan, immediate.batch);
  immediate.batch.clear();
  CurrentGroup& current = context.state.current;
  RasterPosition& raster = current.raster;
  raster.valid = vertex.inside;
  if (!vertex.inside) return;
  raster.position_window = glm::vec4(vertex.position_window.x, vertex.position_window.y, vertex.position_window.z, vertex.w_clip);
  raster.distance = vertex.eye_distance;
  raster.color = vertex.color;
  raster.secondary_color = opaque(state.lighting.enabled ? vertex.specular : clamped(current.secondary_color));
  raster.texture_coordinates = vertex.texture_coordinates;
  select_raster_position(context);
}

void WindowPos3f(Context& context, GLfloat x, GLfloat y, GLfloat z) {
  const double near = context.state.viewport.depth_near, far = context.state.viewport.depth_far;
  const double depth = clamped(static_cast<double>(z));
  CurrentGroup& current = context.state.current;
  RasterPosition& raster = current.raster;
  raster.position_window = glm::vec4(x, y, static_cast<float>(depth == 1.0 ? far : near + depth * (far - near)), 1.0f);
  raster.valid = true;
  raster.distance = 0.0f;
  raster.color = clamped(current.color);
  raster.secondary_color = opaque(clamped(current.secondary_color));
  raster.texture_coordinates = current.texture_coordinates;
  context.flush_vertices();
  select_raster_position(context);
}

std::span<const StateRow> raster_position_rows() {
  return rows;
}

}  // namespace gouraud::api
