// Where vertex arrays lie, and which are enabled [GL1.5 §2.8, §2.9.1, Tables 6.6 to 6.8].
#pragma once

#include <array>
#include <cstddef>

#include <GL/gl.h>

#include "api/state/buffer_object.h"
#include "api/state/limits.h"

namespace gouraud::api {

/// Places in VertexArrayGroup::arrays; texture coordinates of unit u are at array_texture_coordinates + u.
enum ArrayName : int {
  array_vertex,
  array_normal,
  array_color,
  array_secondary_color,
  array_index,
  array_fog_coordinate,
  array_edge_flag,
  array_texture_coordinates,
  array_count = array_texture_coordinates + max_texture_units
};

struct VertexArray {
  bool enabled = false;
  GLint size = 4;                 ///< values in an element
  GLenum type = GL_FLOAT;         ///< of an edge flag: GL_UNSIGNED_BYTE
  GLsizei stride = 0;             ///< bytes, as given: 0 if elements follow each other
  GLsizei count = 0;              ///< elements, as EXT_vertex_array was told; else 0
  const void* pointer = nullptr;  ///< an offset into `buffer` if there is one
  BufferBinding buffer;
  /// The buffer was deleted, so that `pointer` is an offset into nothing.
  bool lost_buffer = false;
  bool operator==(const VertexArray&) const = default;
};

/// Client attribute group CLIENT_VERTEX_ARRAY_BIT.
struct VertexArrayGroup {
  VertexArrayGroup() {
    at(array_normal).size = at(array_secondary_color).size = 3;
    at(array_index).size = at(array_fog_coordinate).size = at(array_edge_flag).size = 1;
    at(array_edge_flag).type = GL_UNSIGNED_BYTE;
  }
  VertexArray& at(int name) { return arrays[static_cast<std::size_t>(name)]; }
  const VertexArray& at(int name) const { return arrays[static_cast<std::size_t>(name)]; }

  std::array<VertexArray, array_count> arrays;
  int client_active_unit = 0;  ///< in [0, max_texture_units)
  BufferBinding array_buffer, element_array_buffer;
  /// EXT_compiled_vertex_array; not locked if count is 0.
  GLint lock_first = 0;
  GLsizei lock_count = 0;
  bool operator==(const VertexArrayGroup&) const = default;
};

}  // namespace gouraud::api
