// Takes vertex arrays and the numbers of their elements, gives vertices to immediate mode's batch [GL1.5 §2.8, §2.9].
// Blocks of every attribute that the draw demands are written to the batch at once; where edge flags are cleared,
// vertices go through Vertex, element by element.
// While a list is compiled the vertices go into it as Begin, values and End.
#include "api/commands/draw_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>

#include "api/commands/array_elements.h"
#include "api/commands/begin_end.h"
#include "api/commands/shared_vertices.h"
#include "api/snapshot/enums.h"

namespace gouraud::api {
namespace {

/// The arrays that a draw reads.
struct Sources {
  const char* command = nullptr;  ///< that draws from them, for errors
  std::uint32_t present = 0;  ///< bit n: array n
  std::array<ElementSource, array_count> arrays;
  bool has(int name) const { return (present >> name & 1u) != 0; }
  const ElementSource& at(int name) const { return arrays[static_cast<std::size_t>(name)]; }
};

// False, and an error is recorded, if one of the arrays is mapped.
bool collect(Context& context, const char* command, Sources& sources) {
  sources.command = command;
  for (int name = 0; name < array_count; ++name) {
    const VertexArray& array = context.state.vertex_arrays.at(name);
    if (!array.enabled || !is_readable(array)) continue;
    if (array.buffer != nullptr && array.buffer->mapped) {
      context.record_error(GL_INVALID_OPERATION, command, "an array lies in a mapped buffer");
      return false;
    }
    sources.present |= 1u << name;
    sources.arrays[static_cast<std::size_t>(name)] = element_source(array, name);
  }
  return true;
}

void set_current(CurrentGroup& current, int name, const std::array<float, 4>& value) {
  switch (name) {
    case array_normal:
      current.normal_object = glm::vec3(value[0], value[1], value[2]);
      break;
    case array_color:
      current.color = glm::vec4(value[0], value[1], value[2], value[3]);
      break;
    case array_secondary_color:
      current.secondary_color = glm::vec4(value[0], value[1], value[2], 1.0f);
      break;
    case array_index:
      current.color_index = value[0];
      break;
    case array_fog_coordinate:
      current.fog_coordinate = value[0];
      break;
    case array_edge_flag:
      current.edge_flag = value[0] != 0.0f;
      break;
    default:
      current.texture_coordinates[static_cast<std::size_t>(name - array_texture_coordinates)] =
          glm::vec4(value[0], value[1], value[2], value[3]);
      break;
  }
}

// The element's value in an array, widened to four floats.
std::array<float, 4> value_of(const Sources& sources, int name, GLuint element) {
  std::array<float, 4> value;
  sources.at(name).fetch(sources.at(name), {&element, 1}, {{&value[0], &value[1], &value[2], &value[3]}, 4});
  return value;
}

// One value of an element, as the command that gives it: while a list is open, that records it.
void call_value(int name, const std::array<float, 4>& v) {
  switch (name) {
    case array_vertex:
      return glVertex4f(v[0], v[1], v[2], v[3]);
    case array_normal:
      return glNormal3f(v[0], v[1], v[2]);
    case array_color:
      return glColor4f(v[0], v[1], v[2], v[3]);
    case array_secondary_color:
      return glSecondaryColor3f(v[0], v[1], v[2]);
    case array_index:
      return glIndexf(v[0]);
    case array_fog_coordinate:
      return glFogCoordf(v[0]);
    case array_edge_flag:
      return glEdgeFlag(v[0] != 0.0f ? GL_TRUE : GL_FALSE);
    default:
      return glMultiTexCoord4f(GL_TEXTURE0 + static_cast<GLenum>(name - array_texture_coordinates), v[0], v[1], v[2], v[3]);
  }
}

// A list takes the values that the arrays have now [GL1.5 §5.4].
void record_element(const Sources& sources, GLuint element) {
  for (int name = array_vertex + 1; name < array_count; ++name) {
    if (sources.has(name)) call_value(name, value_of(sources, name, element));
  }
  if (sources.has(array_vertex)) call_value(array_vertex, value_of(sources, array_vertex, element));
}

void append_element(Context& context, const Sources& sources, GLuint element) {
  for (int name = array_vertex + 1; name < array_count; ++name) {
    if (sources.has(name)) set_current(context.state.current, name, value_of(sources, name, element));
  }
  if (!sources.has(array_vertex)) return;
  const std::array<float, 4> position = value_of(sources, array_vertex, element);
  Vertex4f(context, position[0], position[1], position[2], position[3]);
}

int array_of(std::uint32_t attribute) {
  switch (attribute) {
    case pipeline::attribute_normal:
      return array_normal;
    case pipeline::attribute_color:
      return array_color;
    case pipeline::attribute_secondary_color:
      return array_secondary_color;
    case pipeline::attribute_fog_coordinate:
      return array_fog_coordinate;
    default:
      return array_texture_coordinates + std::countr_zero(attribute / pipeline::attribute_texture_coordinates_0);
  }
}

// One attribute of the batch's next elements.size() vertices: from its array, or the same value for all.
template <std::size_t components>
void append_attribute(std::array<std::array<float, pipeline::batch_stride>, components>& attribute, std::int32_t first,
                      const Sources& sources, int name, std::span<const GLuint> elements, const float* current) {
  ElementTarget target;
  target.count = static_cast<int>(components);
  for (std::size_t c = 0; c < components; ++c) target.values[c] = &attribute[c][static_cast<std::size_t>(first)];
  if (sources.has(name)) return sources.at(name).fetch(sources.at(name), elements, target);
  for (std::size_t c = 0; c < components; ++c) std::fill_n(target.values[c], elements.size(), current[c]);
}

// There is room for all of them.
void append_elements(Context& context, const Sources& sources, std::span<const GLuint> elements) {
  const CurrentGroup& current = context.state.current;
  const std::uint32_t demand = context.immediate.demand;
  if (sources.has(array_edge_flag) || !current.edge_flag) {
    for (const GLuint element : elements) append_element(context, sources, element);
    return;
  }
  pipeline::VertexBatch& batch = context.immediate.batch;
  append_attribute(batch.position_object, batch.count, sources, array_vertex, elements, nullptr);
  pipeline::for_each_attribute(batch, demand, [&](std::uint32_t attribute, auto& arrays) {
    const float* const value = current_value(current, attribute);
    append_attribute(arrays, batch.count, sources, array_of(attribute), elements, value);
  });
  if (demand & pipeline::attribute_edge_flag) {
    std::fill_n(&batch.edge_flag[static_cast<std::size_t>(batch.count)], elements.size(), std::uint8_t{1});
  }
  batch.count += static_cast<std::int32_t>(elements.size());
}

// Between Begin and End: `count` elements; `number(first, elements)` writes the numbers of the elements from the
// first-th on.
template <class Number>
void append_all(Context& context, const Sources& sources, std::uintptr_t count, Number number) {
  const Immediate& immediate = context.immediate;
  std::array<GLuint, pipeline::batch_capacity> elements;
  for (std::uintptr_t done = 0; done < count;) {
    if (immediate.batch.count >= immediate.limit && !context.make_room_for_vertex()) return;
    const auto room = static_cast<std::uintptr_t>(immediate.limit - immediate.batch.count);
    const std::span<GLuint> block(elements.data(), std::min(room, count - done));
    number(done, block);
    append_elements(context, sources, block);
    done += block.size();
  }
}

// The same where indices may name an element more than once.
template <class Number>
void append_shared(Context& context, const Sources& sources, std::uintptr_t count, Number number) {
  SharedVertices shared(context, [&](std::span<const GLuint> elements) { append_elements(context, sources, elements); });
  std::array<GLuint, pipeline::batch_capacity> elements;
  for (std::uintptr_t done = 0; done < count;) {
    const std::span<GLuint> block(elements.data(), std::min<std::uintptr_t>(elements.size(), count - done));
    number(done, block);
    if (!shared.add(block)) return;
    done += block.size();
  }
  shared.finish();
}

// The entries that `record` appends to the open list are one command there.
template <class Record>
void record_draw(Context& context, Record record) {
  ListCompiler& compiler = context.list_compiler;
  std::size_t offset = 0;
  try {
    offset = compiler.list.size();
    compiler.run_begin = ListCompiler::none;
    compiler.list.append(ListTag::draw, sizeof(std::uint64_t));
  } catch (const std::bad_alloc&) {
    compiler.out_of_memory = true;
    compiler.list = {};
  }
  record();
  if (compiler.out_of_memory) return;
  const std::uint64_t bytes = compiler.list.size() - offset - sizeof(ListEntry) - sizeof(std::uint64_t);
  compiler.list.rewrite(offset, &bytes, sizeof(bytes));
}

/// Whether elements may be named more than once.
enum class Elements : std::uint8_t { once, shared };

template <Elements kind, class Number>
void draw(Context& context, GLenum mode, const Sources& sources, std::uintptr_t count, Number number) {
  if (context.compiling()) {
    return record_draw(context, [&] {
      if (!sources.has(array_vertex) || count == 0) return;
      glBegin(mode);
      for (std::uintptr_t done = 0; done < count; ++done) {
        GLuint element;
        number(done, {&element, 1});
        record_element(sources, element);
      }
      glEnd();
    });
  }
  if (!sources.has(array_vertex) || count == 0) return;
  if (!context.can_draw(sources.command)) return;
  const CurrentGroup before = context.state.current;
  constexpr bool indexed = kind == Elements::shared;
  indexed ? context.begin_indexed_primitive(primitive_mode(mode)) : context.begin_primitive(primitive_mode(mode), pipeline::PrimitiveOrigin::arrays);
  try {
    indexed ? append_shared(context, sources, count, number) : append_all(context, sources, count, number);
  } catch (...) {  // no memory
    context.state.current = before;
    context.end_primitive();
    throw;
  }
  context.state.current = before;
  context.end_primitive();
}

bool is_mode(Context& context, GLenum mode, const char* command) {
  if (mode <= GL_POLYGON) return true;
  context.record_error(GL_INVALID_ENUM, command, "mode is no primitive mode");
  return false;
}

bool is_count(Context& context, GLsizei count, const char* command) {
  if (count >= 0) return true;
  context.record_error(GL_INVALID_VALUE, command, "count is negative");
  return false;
}

// choice: a negative count fails, and nothing is drawn, as Mesa has it and later specifications say.
bool are_counts(Context& context, const GLsizei* counts, GLsizei draws, const char* command) {
  return std::none_of(counts, counts + draws, [](GLsizei count) { return count < 0; }) || is_count(context, -1, command);
}

// first >= 0.
void draw_range(Context& context, GLenum mode, const Sources& sources, GLint first, GLsizei count) {
  const auto from = static_cast<GLuint>(first);
  auto length = static_cast<std::uintptr_t>(count);
  if (sources.has(array_vertex)) {
    const std::uintptr_t available = sources.at(array_vertex).available;
    length = from < available ? std::min(length, available - from) : 0;
  }
  draw<Elements::once>(context, mode, sources, length, [from](std::uintptr_t done, std::span<GLuint> elements) {
    for (std::size_t i = 0; i < elements.size(); ++i) elements[i] = from + static_cast<GLuint>(done + i);
  });
}

/// 0 for what is no type of indices.
std::uintptr_t index_bytes(GLenum type) {
  return type == GL_UNSIGNED_BYTE ? 1 : type == GL_UNSIGNED_SHORT ? 2 : type == GL_UNSIGNED_INT ? 4 : 0;
}

bool is_index_type(Context& context, GLenum type, const char* command) {
  if (index_bytes(type) != 0) return true;
  context.record_error(GL_INVALID_ENUM, command, "type is no type of indices");
  return false;
}

template <class T>
void draw_indexed(Context& context, GLenum mode, const Sources& sources, std::uintptr_t count, std::uintptr_t address) {
  draw<Elements::shared>(context, mode, sources, count, [address](std::uintptr_t done, std::span<GLuint> elements) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      T index;
      std::memcpy(&index, reinterpret_cast<const void*>(address + (done + i) * sizeof(T)), sizeof(T));
      elements[i] = index;
    }
  });
}

// All arguments are valid.
void draw_list(Context& context, GLenum mode, const Sources& sources, GLsizei count, GLenum type, const void* indices) {
  auto address = reinterpret_cast<std::uintptr_t>(indices);
  auto length = static_cast<std::uintptr_t>(count);
  const BufferBinding& buffer = context.state.vertex_arrays.element_array_buffer;
  if (buffer != nullptr) {
    length = std::min(length, indices_within(*buffer, address, index_bytes(type)));
    address += reinterpret_cast<std::uintptr_t>(buffer->bytes.get());
  } else if (indices == nullptr) {
    return;
  }
  switch (type) {
    case GL_UNSIGNED_BYTE:
      return draw_indexed<GLubyte>(context, mode, sources, length, address);
    case GL_UNSIGNED_SHORT:
      return draw_indexed<GLushort>(context, mode, sources, length, address);
    default:
      return draw_indexed<GLuint>(context, mode, sources, length, address);
  }
}

// The arrays, and that the indices can be read.
bool collect_indexed(Context& context, const char* command, Sources& sources) {
  const BufferBinding& buffer = context.state.vertex_arrays.element_array_buffer;
  if (buffer != nullptr && buffer->mapped) {
    context.record_error(GL_INVALID_OPERATION, command, "the indices lie in a mapped buffer");
    return false;
  }
  return collect(context, command, sources);
}

void draw_elements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices,
                   const char* command) {
  if (!is_mode(context, mode, command) || !is_count(context, count, command) ||
      !is_index_type(context, type, command)) {
    return;
  }
  Sources sources;
  if (collect_indexed(context, command, sources)) draw_list(context, mode, sources, count, type, indices);
}

}  // namespace

void ArrayElement(Context& context, GLint i) {
  if (i < 0) return context.record_error(GL_INVALID_VALUE, "glArrayElement", "i is negative");
  Sources sources;
  if (!collect(context, "glArrayElement", sources)) return;
  if (context.compiling()) return record_element(sources, static_cast<GLuint>(i));
  append_element(context, sources, static_cast<GLuint>(i));
}

void DrawArrays(Context& context, GLenum mode, GLint first, GLsizei count) {
  constexpr auto command = "glDrawArrays";
  if (!is_mode(context, mode, command) || !is_count(context, count, command)) return;
  if (first < 0) return context.record_error(GL_INVALID_VALUE, command, "first is negative");
  Sources sources;
  if (collect(context, command, sources)) draw_range(context, mode, sources, first, count);
}

void MultiDrawArrays(Context& context, GLenum mode, const GLint* first, const GLsizei* count, GLsizei drawcount) {
  constexpr auto command = "glMultiDrawArrays";
  if (!is_mode(context, mode, command) || !is_count(context, drawcount, command) ||
      !are_counts(context, count, drawcount, command)) {
    return;
  }
  Sources sources;
  if (!collect(context, command, sources)) return;
  for (GLsizei i = 0; i < drawcount; ++i) {
    if (count[i] == 0) continue;
    if (first[i] < 0) {
      context.record_error(GL_INVALID_VALUE, command, "first is negative");
    } else {
      draw_range(context, mode, sources, first[i], count[i]);
    }
  }
}

void DrawElements(Context& context, GLenum mode, GLsizei count, GLenum type, const void* indices) {
  draw_elements(context, mode, count, type, indices, "glDrawElements");
}

void DrawRangeElements(Context& context, GLenum mode, GLuint start, GLuint end, GLsizei count, GLenum type,
                       const void* indices) {
  constexpr auto command = "glDrawRangeElements";
  if (end < start) return context.record_error(GL_INVALID_VALUE, command, "end lies before start");
  draw_elements(context, mode, count, type, indices, command);
}

void MultiDrawElements(Context& context, GLenum mode, const GLsizei* count, GLenum type, const void* const* indices,
                       GLsizei drawcount) {
  constexpr auto command = "glMultiDrawElements";
  if (!is_mode(context, mode, command) || !is_count(context, drawcount, command) ||
      !is_index_type(context, type, command) || !are_counts(context, count, drawcount, command)) {
    return;
  }
  Sources sources;
  if (!collect_indexed(context, command, sources)) return;
  for (GLsizei i = 0; i < drawcount; ++i) {
    if (count[i] > 0) draw_list(context, mode, sources, count[i], type, indices[i]);
  }
}

}  // namespace gouraud::api
