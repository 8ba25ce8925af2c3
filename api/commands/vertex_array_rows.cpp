// Rows of [GL1.5 Tables 6.6 to 6.8]: vertex arrays and buffer bindings; and the depths of the attribute stacks.
#include "api/commands/state_rows.h"

namespace gouraud::api {
namespace {

using enum ValueKind;

const VertexArray& array_of(const Context& c, int name) {
  const VertexArrayGroup& group = c.state.vertex_arrays;
  return group.at(name == array_texture_coordinates ? name + group.client_active_unit : name);
}

template <int name>
void read_enabled(const Context& c, StateValue& v) {
  set(v, array_of(c, name).enabled);
}
template <int name>
void read_size(const Context& c, StateValue& v) {
  set(v, array_of(c, name).size);
}
template <int name>
void read_type(const Context& c, StateValue& v) {
  set(v, array_of(c, name).type);
}
template <int name>
void read_stride(const Context& c, StateValue& v) {
  set(v, array_of(c, name).stride);
}
template <int name>
void read_count(const Context& c, StateValue& v) {
  set(v, array_of(c, name).count);
}
template <int name>
void read_buffer(const Context& c, StateValue& v) {
  set(v, name_of(array_of(c, name).buffer));
}

constexpr StateRow rows[] = {
    {GL_VERTEX_ARRAY, boolean, 1, read_enabled<array_vertex>},
    {GL_VERTEX_ARRAY_SIZE, integer, 1, read_size<array_vertex>},
    {GL_VERTEX_ARRAY_TYPE, integer, 1, read_type<array_vertex>},
    {GL_VERTEX_ARRAY_STRIDE, integer, 1, read_stride<array_vertex>},
    {GL_VERTEX_ARRAY_COUNT_EXT, integer, 1, read_count<array_vertex>},
    {GL_VERTEX_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_vertex>},
    {GL_NORMAL_ARRAY, boolean, 1, read_enabled<array_normal>},
    {GL_NORMAL_ARRAY_TYPE, integer, 1, read_type<array_normal>},
    {GL_NORMAL_ARRAY_STRIDE, integer, 1, read_stride<array_normal>},
    {GL_NORMAL_ARRAY_COUNT_EXT, integer, 1, read_count<array_normal>},
    {GL_NORMAL_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_normal>},
    {GL_COLOR_ARRAY, boolean, 1, read_enabled<array_color>},
    {GL_COLOR_ARRAY_SIZE, integer, 1, read_size<array_color>},
    {GL_COLOR_ARRAY_TYPE, integer, 1, read_type<array_color>},
    {GL_COLOR_ARRAY_STRIDE, integer, 1, read_stride<array_color>},
    {GL_COLOR_ARRAY_COUNT_EXT, integer, 1, read_count<array_color>},
    {GL_COLOR_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_color>},
    {GL_SECONDARY_COLOR_ARRAY, boolean, 1, read_enabled<array_secondary_color>},
    {GL_SECONDARY_COLOR_ARRAY_SIZE, integer, 1, read_size<array_secondary_color>},
    {GL_SECONDARY_COLOR_ARRAY_TYPE, integer, 1, read_type<array_secondary_color>},
    {GL_SECONDARY_COLOR_ARRAY_STRIDE, integer, 1, read_stride<array_secondary_color>},
    {GL_SECONDARY_COLOR_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_secondary_color>},
    {GL_INDEX_ARRAY, boolean, 1, read_enabled<array_index>},
    {GL_INDEX_ARRAY_TYPE, integer, 1, read_type<array_index>},
    {GL_INDEX_ARRAY_STRIDE, integer, 1, read_stride<array_index>},
    {GL_INDEX_ARRAY_COUNT_EXT, integer, 1, read_count<array_index>},
    {GL_INDEX_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_index>},
    {GL_FOG_COORD_ARRAY, boolean, 1, read_enabled<array_fog_coordinate>},
    {GL_FOG_COORD_ARRAY_TYPE, integer, 1, read_type<array_fog_coordinate>},
    {GL_FOG_COORD_ARRAY_STRIDE, integer, 1, read_stride<array_fog_coordinate>},
    {GL_FOG_COORD_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_fog_coordinate>},
    {GL_EDGE_FLAG_ARRAY, boolean, 1, read_enabled<array_edge_flag>},
    {GL_EDGE_FLAG_ARRAY_STRIDE, integer, 1, read_stride<array_edge_flag>},
    {GL_EDGE_FLAG_ARRAY_COUNT_EXT, integer, 1, read_count<array_edge_flag>},
    {GL_EDGE_FLAG_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_edge_flag>},
    {GL_TEXTURE_COORD_ARRAY, boolean, 1, read_enabled<array_texture_coordinates>},
    {GL_TEXTURE_COORD_ARRAY_SIZE, integer, 1, read_size<array_texture_coordinates>},
    {GL_TEXTURE_COORD_ARRAY_TYPE, integer, 1, read_type<array_texture_coordinates>},
    {GL_TEXTURE_COORD_ARRAY_STRIDE, integer, 1, read_stride<array_texture_coordinates>},
    {GL_TEXTURE_COORD_ARRAY_COUNT_EXT, integer, 1, read_count<array_texture_coordinates>},
    {GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING, integer, 1, read_buffer<array_texture_coordinates>},
    {GL_CLIENT_ACTIVE_TEXTURE, integer, 1,
     [](const Context& c, StateValue& v) { set(v, GL_TEXTURE0 + c.state.vertex_arrays.client_active_unit); }},
    {GL_ARRAY_BUFFER_BINDING, integer, 1,
     [](const Context& c, StateValue& v) { set(v, name_of(c.state.vertex_arrays.array_buffer)); }},
    {GL_ELEMENT_ARRAY_BUFFER_BINDING, integer, 1,
     [](const Context& c, StateValue& v) { set(v, name_of(c.state.vertex_arrays.element_array_buffer)); }},
    {GL_PIXEL_PACK_BUFFER_BINDING_ARB, integer, 1,
     [](const Context& c, StateValue& v) { set(v, name_of(c.state.pack_buffer)); }},
    {GL_PIXEL_UNPACK_BUFFER_BINDING_ARB, integer, 1,
     [](const Context& c, StateValue& v) { set(v, name_of(c.state.unpack_buffer)); }},
    {GL_ARRAY_ELEMENT_LOCK_FIRST_EXT, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.vertex_arrays.lock_first); }},
    {GL_ARRAY_ELEMENT_LOCK_COUNT_EXT, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.state.vertex_arrays.lock_count); }},
    {GL_ATTRIB_STACK_DEPTH, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.attribute_stacks.server.size()); }},
    {GL_CLIENT_ATTRIB_STACK_DEPTH, integer, 1,
     [](const Context& c, StateValue& v) { set(v, c.attribute_stacks.client.size()); }},
};

}  // namespace

std::span<const StateRow> vertex_array_rows() {
  return rows;
}

}  // namespace gouraud::api
