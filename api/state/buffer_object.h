// Buffer objects: a block of bytes that vertex arrays and indices may lie in [GL1.5 §2.9, Tables 2.6 and 6.8].
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>

#include <GL/gl.h>

namespace gouraud::api {

struct FreeBytes {
  void operator()(std::byte* bytes) const { std::free(bytes); }
};

struct BufferObject {
  GLuint name = 0;
  std::unique_ptr<std::byte, FreeBytes> bytes;  ///< null if size_bytes is 0
  std::size_t size_bytes = 0;
  GLenum usage = GL_STATIC_DRAW;
  GLenum access = GL_READ_WRITE;
  bool mapped = false;
};

/// A binding; null is the name 0. It keeps the object alive, also after its name was deleted in another context.
using BufferBinding = std::shared_ptr<BufferObject>;

inline GLuint name_of(const BufferBinding& binding) {
  return binding != nullptr ? binding->name : 0;
}

}  // namespace gouraud::api
