// Rows of [GL1.5 Tables 6.5, 6.9 to 6.12]: current values, matrices, viewport, lighting.
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

const auto& texture_stack(const Context& context) {
  return context.state.matrices.texture[static_cast<std::size_t>(context.state.texture.active_unit)];
}

constexpr StateRow rows[] = {
    // Current values [GL1.5 Table 6.5]
    {GL_CURRENT_COLOR, normalized, 4, [](const Context& c, StateValue& v) { set(v, c.state.current.color); }},
    {GL_CURRENT_SECONDARY_COLOR, normalized, 4,
     [](const Context& c, StateValue& v) { set(v, c.state.current.secondary_color); }},
    {GL_CURRENT_INDEX, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.current.color_index); }},
    {GL_CURRENT_NORMAL, normalized, 3, [](const Context& c, StateValue& v) { set(v, c.state.current.normal_object); }},
    {GL_CURRENT_FOG_COORD, real, 1, [](const Context& c, StateValue& v) { set(v, c.state.current.fog_coordinate); }},
    {GL_CURRENT_TEXTURE_COORDS, real, 4,
     [](const Context& c, StateValue& v) {
       set(v, c.state.current.texture_coordinates[static_cast<std::size_t>(c.state.texture.active_unit)]);
     }},
    {GL_EDGE_FLAG, boolean, 1, [](const Context& c, StateValue& v) { set(v, c.state.current.edge_flag); }},
    {GL_ACTIVE_TEXTURE, integer, 1,
     [](const Context& c, StateValue& v) { set(v, GL_TEXTURE0 + c.state.texture.active_unit); }},

    // Transformation [GL1.5 Table 6.9]
    {GL_MATRIX_MODE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.transform.matrix_mode); }},
    {GL_MODELVIEW_MATRIX, real, 16, [](const Context& c, StateValue& v) { set(v, c.state.matrices.modelview.top()); }},
    {GL_PROJECTION_MATRIX, real, 16,
     [](const Context& c, StateValue& v) { set(v, c.state.matrices.projection.top()); }},
    {GL_TEXTURE_MATRIX, real, 16, [](const Context& c, StateValue& v) { set(v, texture_stack(c).top()); }},
    {GL_TRANSPOSE_MODELVIEW_MATRIX, real, 16,
     [](const Context& c, StateValue& v) { set(v, glm::transpose(c.state.matrices.modelview.top())); }},
    {GL_TRANSPOSE_PROJECTION_MATRIX, real, 16,
     [](const Context& c, StateValue& v) { set(v, glm::transpose(c.state.matrices.projection.top())); }},
    {GL_TRANSPOSE_TEXTURE_MATRIX, real, 16,
     [](const Context& c, StateValue& v) { set(v, glm::transpose(texture_stack(c).top())); }},
    {GL_MODELVIEW_STACK_DEPTH, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.matrices.modelview.depth); }},
    {GL_PROJECTION_STACK_DEPTH, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.matrices.projection.depth); }},
    {GL_TEXTURE_STACK_DEPTH, integer, 1, [](const Context& c, StateValue& v) { set(v, texture_stack(c).depth); }},
    {GL_CLIP_ORIGIN, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.transform.clip_origin); }},
    {GL_CLIP_DEPTH_MODE, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.transform.clip_depth_mode); }},
    {GL_VIEWPORT, integer, 4,
     [](const Context& c, StateValue& v) {
       const ViewportGroup& viewport = c.state.viewport;
       set(v, viewport.x, viewport.y, viewport.width_px, viewport.height_px);
     }},
    {GL_DEPTH_RANGE, normalized, 2,
     [](const Context& c, StateValue& v) { set(v, c.state.viewport.depth_near, c.state.viewport.depth_far); }},

    // Coloring and lighting [GL1.5 Tables 6.10 and 6.11]
    {GL_SHADE_MODEL, integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.lighting.shade_model); }},
    {GL_COLOR_MATERIAL_FACE, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.lighting.color_material_face); }},
    {GL_COLOR_MATERIAL_PARAMETER, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.lighting.color_material_parameter); }},
    {GL_LIGHT_MODEL_AMBIENT, normalized, 4,
     [](const Context& c, StateValue& v) { set(v, c.state.lighting.model_ambient); }},
    {GL_LIGHT_MODEL_LOCAL_VIEWER, boolean, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.lighting.model_local_viewer); }},
    {GL_LIGHT_MODEL_TWO_SIDE, boolean, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.lighting.model_two_side); }},
    {GL_LIGHT_MODEL_COLOR_CONTROL, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.lighting.model_color_control); }},
};

}  // namespace

std::span<const StateRow> vertex_state_rows() {
  return rows;
}

}  // namespace gouraud::api
