// Names and opens display lists, and executes them: an entry after the other, as if each command were called now
// [GL1.5 §5.4].
#include "api/commands/display_lists.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <utility>

#include "api/commands/begin_end.h"
#include "api/commands/current_values.h"
#include "api/commands/state_rows.h"
#include "api/commands/vertex_run.h"
#include "checked.h"
#include "records.h"

namespace gouraud::api {
namespace {

const std::byte* execute_entry(Context& context, ListEntry entry, const std::byte* payload);

// The entry behind the PixelStore, which holds for it alone.
const std::byte* execute_with_pixel_store(Context& context, const std::byte* payload, const std::byte* next) {
  const PixelStore now = std::exchange(context.state.unpack, *reinterpret_cast<const PixelStore*>(payload));
  BufferBinding buffer = std::exchange(context.state.unpack_buffer, nullptr);  // what was in it is in the list
  const auto* const entry = reinterpret_cast<const ListEntry*>(next);
  const std::byte* const end = execute_entry(context, *entry, next + sizeof(ListEntry));
  context.state.unpack = now;
  context.state.unpack_buffer = std::move(buffer);
  return end;
}

// A draw is one command: between Begin and End it does nothing but fail [GL1.5 §2.6.3].
// choice: the current values that it leaves indeterminate [GL1.5 §2.8] stay as they were, as Mesa has it.
const std::byte* execute_draw(Context& context, const std::byte* payload, const std::byte* next) {
  const std::byte* const end = next + *reinterpret_cast<const std::uint64_t*>(payload);
  if (context.inside_begin_end()) {
    context.record_error(GL_INVALID_OPERATION, "glCallList", "a draw from vertex arrays between glBegin and glEnd");
    return end;
  }
  if (!context.can_draw("a draw from vertex arrays")) return end;
  const CurrentGroup before = context.state.current;
  while (next != end) next = execute_entry(context, *reinterpret_cast<const ListEntry*>(next), next + sizeof(ListEntry));
  context.state.current = before;
  return end;
}

// Gives the address of the entry that follows.
const std::byte* execute_entry(Context& context, ListEntry entry, const std::byte* payload) {
  const std::byte* const next = payload + entry.payload_bytes;
  const auto* const v = reinterpret_cast<const GLfloat*>(payload);
  switch (entry.tag) {
    case ListTag::position:
      checked::Vertex4f(context, v[0], v[1], v[2], v[3]);
      return next;
    case ListTag::vertices:
      replay(context, *reinterpret_cast<const VertexRun*>(payload));
      return next;
    case ListTag::draw:
      return execute_draw(context, payload, next);
    case ListTag::with_pixel_store:
      return execute_with_pixel_store(context, payload, next);
    default:
      if (is_vertex_value(entry.tag)) {
        set_vertex_value(context.state.current, entry.tag, v);
        return next;
      }
      records::execute(context, static_cast<records::Opcode>(entry.tag), payload);
      return next;
  }
}

void execute_list(Context& context, GLuint name) {
  if (context.list_nesting >= max_list_nesting) return;
  const std::shared_ptr<const DisplayList> list = context.display_lists->find(name);
  if (list == nullptr) return;
  ++context.list_nesting;
  const std::span<const std::byte> entries = list->entries();
  for (const std::byte* at = entries.data(); at != entries.data() + entries.size();) {
    at = execute_entry(context, *reinterpret_cast<const ListEntry*>(at), at + sizeof(ListEntry));
  }
  --context.list_nesting;
}

template <class T>
T element(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof(value));
  return value;
}

// Negative offsets count downwards from the base: names are computed modulo 2^32.
GLuint list_offset(GLenum type, const std::byte* at) {
  const auto byte = [at](int i) { return std::to_integer<GLuint>(at[i]); };
  switch (type) {
    case GL_BYTE:
      return static_cast<GLuint>(element<GLbyte>(at));
    case GL_UNSIGNED_BYTE:
      return byte(0);
    case GL_SHORT:
      return static_cast<GLuint>(element<GLshort>(at));
    case GL_UNSIGNED_SHORT:
      return element<GLushort>(at);
    case GL_INT:
    case GL_UNSIGNED_INT:
      return element<GLuint>(at);
    case GL_FLOAT: {
      const auto value = static_cast<double>(element<GLfloat>(at));
      const bool fits = value > -2147483649.0 && value < 4294967296.0;  // else the name 0 + base; NaN as well
      return fits ? static_cast<GLuint>(static_cast<long long>(value)) : 0u;
    }
    case GL_2_BYTES:
      return byte(0) << 8 | byte(1);
    case GL_3_BYTES:
      return byte(0) << 16 | byte(1) << 8 | byte(2);
    default:
      return byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
  }
}

constexpr StateRow rows[] = {
    {GL_LIST_BASE, ValueKind::integer, 1, [](const Context& c, StateValue& v) { set(v, c.state.list.base); }},
    {GL_LIST_INDEX, ValueKind::integer, 1, [](const Context& c, StateValue& v) { set(v, c.list_compiler.name); }},
    {GL_LIST_MODE, ValueKind::integer, 1, [](const Context& c, StateValue& v) { set(v, c.list_compiler.mode); }},
};

}  // namespace

void NewList(Context& context, GLuint list, GLenum mode) {
  if (list == 0) return context.record_error(GL_INVALID_VALUE, "glNewList", "0 is no list's name");
  if (mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE) {
    return context.record_error(GL_INVALID_ENUM, "glNewList", "mode is unknown");
  }
  if (context.compiling()) return context.record_error(GL_INVALID_OPERATION, "glNewList", "a list is open");
  context.list_compiler = {};
  context.list_compiler.name = list;
  context.list_compiler.mode = mode;
  context.compiling_changed();
}

void EndList(Context& context) {
  if (!context.compiling()) return context.record_error(GL_INVALID_OPERATION, "glEndList", "without glNewList");
  ListCompiler finished = std::exchange(context.list_compiler, {});
  context.compiling_changed();
  if (finished.out_of_memory) throw std::bad_alloc();
  finished.list.shrink_to_fit();
  context.display_lists->store(finished.name, std::move(finished.list));
}

void CallList(Context& context, GLuint list) {
  if (list == 0) return context.record_error(GL_INVALID_VALUE, "glCallList", "0 is no list's name");
  execute_list(context, list);
}

std::size_t list_offset_bytes(GLenum type) {
  switch (type) {
    case GL_BYTE:
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_SHORT:
    case GL_UNSIGNED_SHORT:
    case GL_2_BYTES:
      return 2;
    case GL_3_BYTES:
      return 3;
    case GL_INT:
    case GL_UNSIGNED_INT:
    case GL_FLOAT:
    case GL_4_BYTES:
      return 4;
    default:
      return 0;
  }
}

void CallLists(Context& context, GLsizei n, GLenum type, const void* lists) {
  const std::size_t bytes = list_offset_bytes(type);
  if (bytes == 0) return context.record_error(GL_INVALID_ENUM, "glCallLists", "type is unknown");
  if (n < 0) return context.record_error(GL_INVALID_VALUE, "glCallLists", "n is negative");
  if (lists == nullptr) return;
  // choice: the base at the beginning holds for all offsets, even if one of the lists changes it.
  const GLuint base = context.state.list.base;
  const auto* at = static_cast<const std::byte*>(lists);
  for (GLsizei i = 0; i < n; ++i, at += bytes) execute_list(context, base + list_offset(type, at));
}

void ListBase(Context& context, GLuint base) {
  context.state.list.base = base;
}

GLuint GenLists(Context& context, GLsizei range) {
  if (range < 0) {
    context.record_error(GL_INVALID_VALUE, "glGenLists", "range is negative");
    return 0;
  }
  return range > 0 ? context.display_lists->generate(static_cast<GLuint>(range)) : 0;
}

void DeleteLists(Context& context, GLuint list, GLsizei range) {
  if (range < 0) return context.record_error(GL_INVALID_VALUE, "glDeleteLists", "range is negative");
  const auto count = static_cast<GLuint>(range);
  if (count == 0) return;
  const GLuint to_the_end = std::numeric_limits<GLuint>::max() - list;
  context.display_lists->erase(list, list + std::min(count - 1, to_the_end));
}

GLboolean IsList(Context& context, GLuint list) {
  return context.display_lists->is_list(list) ? GL_TRUE : GL_FALSE;
}

std::span<const StateRow> display_list_rows() {
  return rows;
}

}  // namespace gouraud::api
