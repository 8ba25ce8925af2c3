// Reads the elements of vertex arrays as floats, a block at a time [GL1.5 §2.8, §2.9.1].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <GL/gl.h>

#include "api/state/vertex_arrays.h"

namespace gouraud::api {

/// Where the values of a block go: component c of element i to values[c][i], for c < count. Components that the array
/// does not have are 0, the fourth 1.
struct ElementTarget {
  std::array<float*, 4> values{};
  int count = 0;
};

/// An array ready to be read. Nothing is read of elements from `available` on: their bytes are taken to be 0.
struct ElementSource {
  std::uintptr_t address = 0;  ///< of element 0
  std::uintptr_t stride_bytes = 0;
  std::uintptr_t available = 0;
  void (*fetch)(const ElementSource& source, std::span<const GLuint> elements, const ElementTarget& target) = nullptr;
};

/// True if there is memory to read: in a buffer object, or at an address that is not null.
bool is_readable(const VertexArray& array);

/// For a readable array. Normals and colours are converted by Table 2.9; of client memory any element may be read.
ElementSource element_source(const VertexArray& array, int name);

/// How many indices of so many bytes lie in the buffer from `offset` on.
std::uintptr_t indices_within(const BufferObject& buffer, std::uintptr_t offset, std::uintptr_t index_bytes);

}  // namespace gouraud::api
