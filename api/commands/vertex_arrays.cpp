// Takes array pointers, gives the vertex array state [GL1.5 §2.8, Tables 2.4 and 2.5; §2.9.1]. Reads no element.
#include "api/commands/vertex_arrays.h"

#include <cstdint>

namespace gouraud::api {
namespace {

// Sets of types, for Table 2.4.
enum TypeBits : unsigned {
  type_byte = 1,
  type_ubyte = 2,
  type_short = 4,
  type_ushort = 8,
  type_int = 16,
  type_uint = 32,
  type_float = 64,
  type_double = 128,
  type_coordinates = type_short | type_int | type_float | type_double,
  type_any = 255
};

unsigned type_bit(GLenum type) {
  if (type == GL_DOUBLE) return type_double;
  return type >= GL_BYTE && type <= GL_FLOAT ? 1u << (type - GL_BYTE) : 0u;
}

/// A row of Table 2.4.
struct Rules {
  const char* command;
  GLint least_size, greatest_size;
  unsigned types;
};

void set_pointer(Context& context, int name, const Rules& rules, VertexArray given) {
  if (given.size < rules.least_size || given.size > rules.greatest_size) {
    return context.record_error(GL_INVALID_VALUE, rules.command, "elements of this size are not supported");
  }
  if ((type_bit(given.type) & rules.types) == 0) {
    return context.record_error(GL_INVALID_ENUM, rules.command, "type is not supported");
  }
  if (given.stride < 0) return context.record_error(GL_INVALID_VALUE, rules.command, "stride is negative");
  VertexArrayGroup& group = context.state.vertex_arrays;
  given.enabled = group.at(name).enabled;
  given.buffer = group.array_buffer;
  group.at(name) = std::move(given);
}

VertexArray described(GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count = 0) {
  VertexArray array;
  array.size = size;
  array.type = type;
  array.stride = stride;
  array.count = count;
  array.pointer = pointer;
  return array;
}

void set_enabled(Context& context, GLenum array, bool enabled, const char* command) {
  VertexArray* const found = find_array(context.state.vertex_arrays, array);
  if (found == nullptr) return context.record_error(GL_INVALID_ENUM, command, "array is unknown");
  found->enabled = enabled;
}

/// A row of Table 2.5: how many floats (colours of bytes: one float's room) each part has; 0 if it is absent.
struct Interleaving {
  int texture = 0, color = 0, normal = 0, vertex = 0;
  bool ubyte_color = false;
};

constexpr Interleaving interleavings[] = {
    {0, 0, 0, 2}, {0, 0, 0, 3}, {0, 4, 0, 2, true}, {0, 4, 0, 3, true}, {0, 3, 0, 3}, {0, 0, 3, 3}, {0, 4, 3, 3},
    {2, 0, 0, 3}, {4, 0, 0, 4}, {2, 4, 0, 3, true}, {2, 3, 0, 3},       {2, 0, 3, 3}, {2, 4, 3, 3}, {4, 4, 3, 4},
};
static_assert(GL_T4F_C4F_N3F_V4F - GL_V2F + 1 == sizeof(interleavings) / sizeof(interleavings[0]));

}  // namespace

VertexArray* find_array(VertexArrayGroup& group, GLenum array) {
  switch (array) {
    case GL_VERTEX_ARRAY:
      return &group.at(array_vertex);
    case GL_NORMAL_ARRAY:
      return &group.at(array_normal);
    case GL_COLOR_ARRAY:
      return &group.at(array_color);
    case GL_SECONDARY_COLOR_ARRAY:
      return &group.at(array_secondary_color);
    case GL_INDEX_ARRAY:
      return &group.at(array_index);
    case GL_FOG_COORD_ARRAY:
      return &group.at(array_fog_coordinate);
    case GL_EDGE_FLAG_ARRAY:
      return &group.at(array_edge_flag);
    case GL_TEXTURE_COORD_ARRAY:
      return &group.at(array_texture_coordinates + group.client_active_unit);
    default:
      return nullptr;
  }
}

void VertexPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count) {
  set_pointer(context, array_vertex, {"glVertexPointer", 2, 4, type_coordinates},
              described(size, type, stride, pointer, count));
}

void NormalPointer(Context& context, GLenum type, GLsizei stride, const void* pointer, GLsizei count) {
  set_pointer(context, array_normal, {"glNormalPointer", 3, 3, type_byte | type_coordinates},
              described(3, type, stride, pointer, count));
}

void ColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count) {
  set_pointer(context, array_color, {"glColorPointer", 3, 4, type_any}, described(size, type, stride, pointer, count));
}

void SecondaryColorPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(context, array_secondary_color, {"glSecondaryColorPointer", 3, 3, type_any},
              described(size, type, stride, pointer));
}

void IndexPointer(Context& context, GLenum type, GLsizei stride, const void* pointer, GLsizei count) {
  set_pointer(context, array_index, {"glIndexPointer", 1, 1, type_ubyte | type_coordinates},
              described(1, type, stride, pointer, count));
}

void FogCoordPointer(Context& context, GLenum type, GLsizei stride, const void* pointer) {
  set_pointer(context, array_fog_coordinate, {"glFogCoordPointer", 1, 1, type_float | type_double},
              described(1, type, stride, pointer));
}

void TexCoordPointer(Context& context, GLint size, GLenum type, GLsizei stride, const void* pointer, GLsizei count) {
  set_pointer(context, array_texture_coordinates + context.state.vertex_arrays.client_active_unit,
              {"glTexCoordPointer", 1, 4, type_coordinates}, described(size, type, stride, pointer, count));
}

void EdgeFlagPointer(Context& context, GLsizei stride, const void* pointer, GLsizei count) {
  set_pointer(context, array_edge_flag, {"glEdgeFlagPointer", 1, 1, type_ubyte},
              described(1, GL_UNSIGNED_BYTE, stride, pointer, count));
}

void InterleavedArrays(Context& context, GLenum format, GLsizei stride, const void* pointer) {
  if (format < GL_V2F || format > GL_T4F_C4F_N3F_V4F) {
    return context.record_error(GL_INVALID_ENUM, "glInterleavedArrays", "format is unknown");
  }
  if (stride < 0) return context.record_error(GL_INVALID_VALUE, "glInterleavedArrays", "stride is negative");
  const Interleaving& parts = interleavings[format - GL_V2F];
  const int color_floats = parts.ubyte_color ? 1 : parts.color;
  if (stride == 0) stride = 4 * (parts.texture + color_floats + parts.normal + parts.vertex);

  VertexArrayGroup& group = context.state.vertex_arrays;
  for (const ArrayName name : {array_edge_flag, array_index, array_secondary_color, array_fog_coordinate}) {
    group.at(name).enabled = false;
  }
  auto address = reinterpret_cast<std::uintptr_t>(pointer);
  const auto place = [&](int name, int size, GLenum type, int floats) {
    group.at(name).enabled = size > 0;
    if (size == 0) return;
    set_pointer(context, name, {"glInterleavedArrays", 1, 4, type_any},
                described(size, type, stride, reinterpret_cast<const void*>(address)));
    address += 4 * static_cast<std::uintptr_t>(floats);
  };
  place(array_texture_coordinates + group.client_active_unit, parts.texture, GL_FLOAT, parts.texture);
  place(array_color, parts.color, parts.ubyte_color ? GL_UNSIGNED_BYTE : GL_FLOAT, color_floats);
  place(array_normal, parts.normal, GL_FLOAT, parts.normal);
  place(array_vertex, parts.vertex, GL_FLOAT, parts.vertex);
}

void EnableClientState(Context& context, GLenum array) {
  set_enabled(context, array, true, "glEnableClientState");
}

void DisableClientState(Context& context, GLenum array) {
  set_enabled(context, array, false, "glDisableClientState");
}

void ClientActiveTexture(Context& context, GLenum texture) {
  const GLenum unit = texture - GL_TEXTURE0;
  if (unit >= static_cast<GLenum>(max_texture_units)) {
    return context.record_error(GL_INVALID_ENUM, "glClientActiveTexture", "no such texture unit");
  }
  context.state.vertex_arrays.client_active_unit = static_cast<int>(unit);
}

void GetPointerv(Context& context, GLenum pname, void** params) {
  const VertexArrayGroup& group = context.state.vertex_arrays;
  const auto give = [&](int name) { *params = const_cast<void*>(group.at(name).pointer); };
  switch (pname) {
    case GL_FEEDBACK_BUFFER_POINTER:
      *params = context.state.render_mode.feedback.buffer.memory;
      return;
    case GL_SELECTION_BUFFER_POINTER:
      *params = context.state.render_mode.selection.buffer.memory;
      return;
    case GL_VERTEX_ARRAY_POINTER:
      return give(array_vertex);
    case GL_NORMAL_ARRAY_POINTER:
      return give(array_normal);
    case GL_COLOR_ARRAY_POINTER:
      return give(array_color);
    case GL_SECONDARY_COLOR_ARRAY_POINTER:
      return give(array_secondary_color);
    case GL_INDEX_ARRAY_POINTER:
      return give(array_index);
    case GL_FOG_COORD_ARRAY_POINTER:
      return give(array_fog_coordinate);
    case GL_EDGE_FLAG_ARRAY_POINTER:
      return give(array_edge_flag);
    case GL_TEXTURE_COORD_ARRAY_POINTER:
      return give(array_texture_coordinates + group.client_active_unit);
    default:
      return context.record_error(GL_INVALID_ENUM, "glGetPointerv", "pname is unknown");
  }
}

void LockArraysEXT(Context& context, GLint first, GLsizei count) {
  VertexArrayGroup& group = context.state.vertex_arrays;
  if (first < 0 || count <= 0) return context.record_error(GL_INVALID_VALUE, "glLockArraysEXT", "not a range");
  if (group.lock_count != 0) return context.record_error(GL_INVALID_OPERATION, "glLockArraysEXT", "locked already");
  group.lock_first = first;
  group.lock_count = count;
}

void UnlockArraysEXT(Context& context) {
  VertexArrayGroup& group = context.state.vertex_arrays;
  if (group.lock_count == 0) return context.record_error(GL_INVALID_OPERATION, "glUnlockArraysEXT", "not locked");
  group.lock_first = group.lock_count = 0;
}

}  // namespace gouraud::api
