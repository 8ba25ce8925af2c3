// Takes bytes, gives buffer objects that arrays, indices and pixels are read from
// [GL1.5 §2.9, Tables 2.6 to 2.8; §6.1.13] [ARB_pixel_buffer_object].
// A draw has copied what it needs when it returns, so a store may change or vanish at any time.
//
// choice: an object whose name is deleted keeps its contents as long as another context or a saved client attribute
// group has it bound: what is undefined there cannot read freed memory.
#include "api/commands/buffer_objects.h"

#include <cstring>
#include <limits>
#include <new>

namespace gouraud::api {
namespace {

BufferBinding* find_binding(Context& context, GLenum target) {
  VertexArrayGroup& group = context.state.vertex_arrays;
  switch (target) {
    case GL_PIXEL_PACK_BUFFER_ARB:
      return &context.state.pack_buffer;
    case GL_PIXEL_UNPACK_BUFFER_ARB:
      return &context.state.unpack_buffer;
    case GL_ARRAY_BUFFER:
      return &group.array_buffer;
    case GL_ELEMENT_ARRAY_BUFFER:
      return &group.element_array_buffer;
    default:
      return nullptr;
  }
}

// The object bound to target; null, and an error is recorded, if there is none.
BufferObject* bound(Context& context, GLenum target, const char* command) {
  const BufferBinding* const binding = find_binding(context, target);
  if (binding == nullptr) {
    context.record_error(GL_INVALID_ENUM, command, "target is unknown");
    return nullptr;
  }
  if (*binding == nullptr) context.record_error(GL_INVALID_OPERATION, command, "no buffer is bound");
  return binding->get();
}

bool is_usage(GLenum usage) {
  switch (usage) {
    case GL_STREAM_DRAW:
    case GL_STREAM_READ:
    case GL_STREAM_COPY:
    case GL_STATIC_DRAW:
    case GL_STATIC_READ:
    case GL_STATIC_COPY:
    case GL_DYNAMIC_DRAW:
    case GL_DYNAMIC_READ:
    case GL_DYNAMIC_COPY:
      return true;
    default:
      return false;
  }
}

// The object if [offset, offset + size) of its store may be copied; null, and an error is recorded, if not.
BufferObject* bound_range(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, const char* command) {
  BufferObject* const buffer = bound(context, target, command);
  if (buffer == nullptr) return nullptr;
  const auto store = static_cast<GLsizeiptr>(buffer->size_bytes);
  if (offset < 0 || size < 0 || offset > store || size > store - offset) {
    context.record_error(GL_INVALID_VALUE, command, "the range is not within the store");
    return nullptr;
  }
  if (buffer->mapped) {
    context.record_error(GL_INVALID_OPERATION, command, "the buffer is mapped");
    return nullptr;
  }
  return buffer;
}

void unbind(ClientAttributeGroups& groups, const BufferBinding& buffer) {
  if (groups.pack_buffer == buffer) groups.pack_buffer = nullptr;
  if (groups.unpack_buffer == buffer) groups.unpack_buffer = nullptr;
  VertexArrayGroup& group = groups.vertex_arrays;
  if (group.array_buffer == buffer) group.array_buffer = nullptr;
  if (group.element_array_buffer == buffer) group.element_array_buffer = nullptr;
  for (VertexArray& array : group.arrays) {
    if (array.buffer != buffer) continue;
    array.buffer = nullptr;
    array.lost_buffer = true;
  }
}

}  // namespace

void GenBuffers(Context& context, GLsizei n, GLuint* buffers) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glGenBuffers", "n is negative");
  context.buffer_names().generate(n, buffers);
}

void DeleteBuffers(Context& context, GLsizei n, const GLuint* buffers) {
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glDeleteBuffers", "n is negative");
  for (GLsizei i = 0; i < n; ++i) {
    if (const BufferBinding buffer = context.buffer_names().find(buffers[i])) {
      unbind(context.state, buffer);
      buffer->mapped = false;
    }
    context.buffer_names().remove(buffers[i]);
  }
}

GLboolean IsBuffer(Context& context, GLuint buffer) {
  return context.buffer_names().find(buffer) != nullptr ? GL_TRUE : GL_FALSE;
}

void BindBuffer(Context& context, GLenum target, GLuint buffer) {
  BufferBinding* const binding = find_binding(context, target);
  if (binding == nullptr) return context.record_error(GL_INVALID_ENUM, "glBindBuffer", "target is unknown");
  *binding = buffer != 0 ? context.buffer_names().find_or_create(buffer) : nullptr;
}

void BufferData(Context& context, GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
  constexpr auto command = "glBufferData";
  BufferObject* const buffer = bound(context, target, command);
  if (buffer == nullptr) return;
  if (!is_usage(usage)) return context.record_error(GL_INVALID_ENUM, command, "usage is unknown");
  if (size < 0) return context.record_error(GL_INVALID_VALUE, command, "size is negative");
  if (size > std::numeric_limits<GLint>::max()) throw std::bad_alloc();
  const auto size_bytes = static_cast<std::size_t>(size);
  decltype(buffer->bytes) fresh;
  if (size_bytes > 0) {
    fresh.reset(static_cast<std::byte*>(std::calloc(size_bytes, 1)));
    if (fresh == nullptr) throw std::bad_alloc();
    if (data != nullptr) std::memcpy(fresh.get(), data, size_bytes);
  }
  buffer->bytes = std::move(fresh);
  buffer->size_bytes = size_bytes;
  buffer->usage = usage;
  buffer->access = GL_READ_WRITE;
  buffer->mapped = false;
}

void BufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, const void* data) {
  BufferObject* const buffer = bound_range(context, target, offset, size, "glBufferSubData");
  if (buffer == nullptr || size == 0 || data == nullptr) return;
  std::memmove(buffer->bytes.get() + offset, data, static_cast<std::size_t>(size));
}

void GetBufferSubData(Context& context, GLenum target, GLintptr offset, GLsizeiptr size, void* data) {
  const BufferObject* const buffer = bound_range(context, target, offset, size, "glGetBufferSubData");
  if (buffer == nullptr || size == 0 || data == nullptr) return;
  std::memmove(data, buffer->bytes.get() + offset, static_cast<std::size_t>(size));
}

void* MapBuffer(Context& context, GLenum target, GLenum access) {
  constexpr auto command = "glMapBuffer";
  BufferObject* const buffer = bound(context, target, command);
  if (buffer == nullptr) return nullptr;
  const auto refuse = [&](GLenum error, const char* message) {
    context.record_error(error, command, message);
    return nullptr;
  };
  if (access != GL_READ_ONLY && access != GL_WRITE_ONLY && access != GL_READ_WRITE) {
    return refuse(GL_INVALID_ENUM, "access is unknown");
  }
  if (buffer->mapped) return refuse(GL_INVALID_OPERATION, "the buffer is mapped already");
  if (buffer->size_bytes == 0) return refuse(GL_OUT_OF_MEMORY, "the buffer is empty");
  buffer->access = access;
  buffer->mapped = true;
  return buffer->bytes.get();
}

GLboolean UnmapBuffer(Context& context, GLenum target) {
  constexpr auto command = "glUnmapBuffer";
  BufferObject* const buffer = bound(context, target, command);
  if (buffer == nullptr) return GL_FALSE;
  if (!buffer->mapped) {
    context.record_error(GL_INVALID_OPERATION, command, "the buffer is not mapped");
    return GL_FALSE;
  }
  buffer->mapped = false;
  return GL_TRUE;
}

void GetBufferParameteriv(Context& context, GLenum target, GLenum pname, GLint* params) {
  constexpr auto command = "glGetBufferParameteriv";
  const BufferObject* const buffer = bound(context, target, command);
  if (buffer == nullptr) return;
  switch (pname) {
    case GL_BUFFER_SIZE:
      *params = static_cast<GLint>(buffer->size_bytes);
      break;
    case GL_BUFFER_USAGE:
      *params = static_cast<GLint>(buffer->usage);
      break;
    case GL_BUFFER_ACCESS:
      *params = static_cast<GLint>(buffer->access);
      break;
    case GL_BUFFER_MAPPED:
      *params = buffer->mapped ? GL_TRUE : GL_FALSE;
      break;
    default:
      context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
      break;
  }
}

void GetBufferPointerv(Context& context, GLenum target, GLenum pname, void** params) {
  constexpr auto command = "glGetBufferPointerv";
  const BufferObject* const buffer = bound(context, target, command);
  if (buffer == nullptr) return;
  if (pname != GL_BUFFER_MAP_POINTER) return context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
  *params = buffer->mapped ? buffer->bytes.get() : nullptr;
}

}  // namespace gouraud::api
