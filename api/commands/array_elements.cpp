// Takes a vertex array and the numbers of elements, gives their values as floats [GL1.5 §2.8, Table 2.4].
//
// choice: an element that does not lie wholly within its buffer object, undefined by the specification, has only bytes
// of value zero; llvmpipe's has too.
#include "api/commands/array_elements.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "api/registry/conversions.h"

namespace gouraud::api {
namespace {

alignas(32) constexpr std::array<std::byte, 32> zeros{};

template <class T, int size, bool normalized>
void fetch(const ElementSource& source, std::span<const GLuint> elements, const ElementTarget& target) {
  static_assert(sizeof(T) * size <= zeros.size());
  const auto zero_address = reinterpret_cast<std::uintptr_t>(zeros.data());
  const int given = std::min(size, target.count);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const std::uintptr_t element = elements[i];
    const std::uintptr_t address =
        element < source.available ? source.address + element * source.stride_bytes : zero_address;
    std::array<T, size> values;
    std::memcpy(values.data(), reinterpret_cast<const void*>(address), sizeof values);
    for (int c = 0; c < given; ++c) {
      const T value = values[static_cast<std::size_t>(c)];
      target.values[static_cast<std::size_t>(c)][i] = normalized ? to_component(value) : to_float(value);
    }
  }
  for (int c = given; c < target.count; ++c) {
    std::fill_n(target.values[static_cast<std::size_t>(c)], elements.size(), c == 3 ? 1.0f : 0.0f);
  }
}

using Fetch = decltype(ElementSource::fetch);

template <class T>
Fetch fetch_of(GLint size, bool normalized) {
  constexpr Fetch functions[2][4] = {{fetch<T, 1, false>, fetch<T, 2, false>, fetch<T, 3, false>, fetch<T, 4, false>},
                                     {fetch<T, 1, true>, fetch<T, 2, true>, fetch<T, 3, true>, fetch<T, 4, true>}};
  return functions[normalized ? 1 : 0][size - 1];
}

struct Format {
  std::uintptr_t value_bytes;
  Fetch fetch;
};

Format format_of(GLenum type, GLint size, bool normalized) {
  switch (type) {
    case GL_BYTE:
      return {1, fetch_of<GLbyte>(size, normalized)};
    case GL_UNSIGNED_BYTE:
      return {1, fetch_of<GLubyte>(size, normalized)};
    case GL_SHORT:
      return {2, fetch_of<GLshort>(size, normalized)};
    case GL_UNSIGNED_SHORT:
      return {2, fetch_of<GLushort>(size, normalized)};
    case GL_INT:
      return {4, fetch_of<GLint>(size, normalized)};
    case GL_UNSIGNED_INT:
      return {4, fetch_of<GLuint>(size, normalized)};
    case GL_DOUBLE:
      return {8, fetch_of<GLdouble>(size, normalized)};
    default:
      return {4, fetch_of<GLfloat>(size, normalized)};
  }
}

}  // namespace

bool is_readable(const VertexArray& array) {
  return array.buffer != nullptr || (array.pointer != nullptr && !array.lost_buffer);
}

ElementSource element_source(const VertexArray& array, int name) {
  const bool normalized = name == array_normal || name == array_color || name == array_secondary_color;
  const Format format = format_of(array.type, array.size, normalized);
  const std::uintptr_t element_bytes = format.value_bytes * static_cast<std::uintptr_t>(array.size);
  ElementSource source;
  source.fetch = format.fetch;
  source.stride_bytes = array.stride != 0 ? static_cast<std::uintptr_t>(array.stride) : element_bytes;
  source.address = reinterpret_cast<std::uintptr_t>(array.pointer);
  source.available = std::numeric_limits<std::uintptr_t>::max();
  if (array.buffer != nullptr) {
    const std::uintptr_t offset = source.address, size = array.buffer->size_bytes;
    const bool any = offset <= size && size - offset >= element_bytes;
    source.available = any ? (size - offset - element_bytes) / source.stride_bytes + 1 : 0;
    source.address += reinterpret_cast<std::uintptr_t>(array.buffer->bytes.get());
  }
  return source;
}

std::uintptr_t indices_within(const BufferObject& buffer, std::uintptr_t offset, std::uintptr_t index_bytes) {
  return offset < buffer.size_bytes ? (buffer.size_bytes - offset) / index_bytes : 0;
}

}  // namespace gouraud::api
