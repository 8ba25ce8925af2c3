// Takes the records of the entry points, puts them into the open list [GL1.5 §5.4]: vertices and their values in one
// canonical form, whole runs of them as a VertexRun, other commands as they are, with a copy of the client memory.
// Draws from vertex arrays are taken apart into vertices at once.
// Images are list_images.h's.
#include <cstring>
#include <new>
#include <span>
#include <utility>

#include "api/commands/display_lists.h"
#include "api/commands/list_images.h"
#include "api/commands/vertex_run.h"
#include "records.h"

namespace gouraud::api {
namespace {

using records::Length;
using records::Opcode;
using records::VertexValue;

// [GL1.5 §5.4]: textures that only ask whether they would fit are asked for at once.
bool is_proxy(Opcode opcode, const void* record) {
  switch (opcode) {
    case Opcode::TexImage1D:
      return static_cast<const records::TexImage1D*>(record)->target == GL_PROXY_TEXTURE_1D;
    case Opcode::TexImage2D: {
      const GLenum target = static_cast<const records::TexImage2D*>(record)->target;
      return target == GL_PROXY_TEXTURE_2D || target == GL_PROXY_TEXTURE_CUBE_MAP;
    }
    case Opcode::TexImage3D:
      return static_cast<const records::TexImage3D*>(record)->target == GL_PROXY_TEXTURE_3D;
    default:
      return false;
  }
}

// These read client memory now: their handlers record what they find there, vertex by vertex.
bool reads_arrays(Opcode opcode) {
  switch (opcode) {
    case Opcode::ArrayElement:
    case Opcode::DrawArrays:
    case Opcode::DrawElements:
    case Opcode::DrawRangeElements:
    case Opcode::MultiDrawArrays:
    case Opcode::MultiDrawElements:
      return true;
    default:
      return false;
  }
}

// With `texture` a unit's name.
ListTag tag_of(const VertexValue& value) {
  switch (value.kind) {
    case VertexValue::Kind::position:
      return ListTag::position;
    case VertexValue::Kind::normal:
      return ListTag::normal;
    case VertexValue::Kind::color:
      return ListTag::color;
    case VertexValue::Kind::secondary_color:
      return ListTag::secondary_color;
    case VertexValue::Kind::fog_coordinate:
      return ListTag::fog_coordinate;
    default:
      return texture_coordinates_tag(value.texture - GL_TEXTURE0);
  }
}

// How many floats or doubles a control point of this map has [GL1.5 Table 5.1]; 0 for an unknown map.
std::size_t values_of_point(GLenum target) {
  const GLenum kind1 = target - GL_MAP1_COLOR_4, kind2 = target - GL_MAP2_COLOR_4;
  if (kind1 < map_kinds) return static_cast<std::size_t>(map_components[kind1]);
  return kind2 < map_kinds ? static_cast<std::size_t>(map_components[kind2]) : 0;
}

// A stride or an order that the command refuses gives no memory.
std::size_t steps(GLint stride, GLint order) {
  return stride > 0 && order > 0 ? static_cast<std::size_t>(stride) * static_cast<std::size_t>(order - 1) : 0;
}

template <class Record>
std::size_t map_1_values(const void* record) {
  const auto& r = *static_cast<const Record*>(record);
  const std::size_t components = values_of_point(r.target);
  return components == 0 || r.order <= 0 ? 0 : steps(r.stride, r.order) + components;
}

template <class Record>
std::size_t map_2_values(const void* record) {
  const auto& r = *static_cast<const Record*>(record);
  const std::size_t components = values_of_point(r.target);
  if (components == 0 || r.uorder <= 0 || r.vorder <= 0) return 0;
  return steps(r.ustride, r.uorder) + steps(r.vstride, r.vorder) + components;
}

std::size_t map_values(Opcode opcode, const void* record) {
  switch (opcode) {
    case Opcode::Map1f:
      return map_1_values<records::Map1f>(record);
    case Opcode::Map1d:
      return map_1_values<records::Map1d>(record);
    case Opcode::Map2f:
      return map_2_values<records::Map2f>(record);
    default:
      return map_2_values<records::Map2d>(record);
  }
}

// The bytes that a pointer of the record leads to; 0 if the command will not read them.
std::size_t memory_bytes(const records::ClientMemory& memory, const void* record) {
  switch (memory.length) {
    case Length::elements: {
      GLsizei count;
      std::memcpy(&count, static_cast<const std::byte*>(record) + memory.count_offset, sizeof(count));
      return count > 0 ? static_cast<std::size_t>(count) * memory.element_bytes : 0;
    }
    case Length::list_names: {
      const auto& r = *static_cast<const records::CallLists*>(record);
      return r.n > 0 ? static_cast<std::size_t>(r.n) * list_offset_bytes(r.type) : 0;
    }
    case Length::map_points:
      return map_values(memory.opcode, record) * memory.element_bytes;
    default:
      return 0;
  }
}

std::span<const records::ClientMemory> memory_of(Opcode opcode) {
  const auto* const end = records::client_memory + records::client_memory_count;
  const auto* first = records::client_memory;
  while (first != end && first->opcode < opcode) ++first;
  const auto* last = first;
  while (last != end && last->opcode == opcode) ++last;
  return {first, last};
}

// The PixelStore for the image, then the command with its copy.
void append_pixel_command(Context& context, DisplayList& list, Opcode opcode, const void* record, std::size_t bytes) {
  const KeptImage kept = keep_image(context, list, opcode, record);
  if (!kept.compiled) return;
  const records::ClientMemory& pointer = memory_of(opcode)[0];
  std::memcpy(list.append(ListTag::with_pixel_store, sizeof(PixelStore)), &kept.store, sizeof(PixelStore));
  std::byte* const copy = list.append(static_cast<ListTag>(opcode), bytes);
  std::memcpy(copy, record, bytes);
  std::memcpy(copy + pointer.pointer_offset, &kept.memory, sizeof(kept.memory));
}

void append_command(Context& context, DisplayList& list, Opcode opcode, const void* record, std::size_t bytes) {
  if (reads_pixels(opcode)) return append_pixel_command(context, list, opcode, record, bytes);
  std::byte* const copy = list.append(static_cast<ListTag>(opcode), bytes);
  std::memcpy(copy, record, bytes);
  for (const records::ClientMemory& part : memory_of(opcode)) {
    const void* pointer;
    std::memcpy(&pointer, copy + part.pointer_offset, sizeof(pointer));
    const std::size_t size = memory_bytes(part, record);
    const void* const kept = pointer != nullptr && size > 0 ? list.keep(pointer, size) : nullptr;
    std::memcpy(copy + part.pointer_offset, &kept, sizeof(kept));
  }
}

void append(Context& context, Opcode opcode, const void* record, std::size_t bytes) {
  ListCompiler& compiler = context.list_compiler;
  const VertexValue value = records::vertex_value(opcode, record);
  const bool names_a_unit = value.texture - GL_TEXTURE0 < static_cast<GLenum>(max_texture_units);
  if (value.kind != VertexValue::Kind::none && names_a_unit) {
    std::memcpy(compiler.list.append(tag_of(value), sizeof(value.components)), value.components,
                sizeof(value.components));
    return;
  }
  const std::size_t run_begin = std::exchange(compiler.run_begin, ListCompiler::none);
  if (opcode == Opcode::End && run_begin != ListCompiler::none &&
      make_vertex_run(compiler.list, run_begin, compiler.run_mode)) {
    return;
  }
  const std::size_t offset = compiler.list.size();
  append_command(context, compiler.list, opcode, record, bytes);
  if (opcode == Opcode::Begin) {
    const GLenum mode = static_cast<const records::Begin*>(record)->mode;
    if (mode <= GL_POLYGON) compiler.run_begin = offset;
    compiler.run_mode = mode;
  }
}

/// A draw between Begin and End, which is executed as it is compiled.
bool fails_now(const Context& context, Opcode opcode) {
  return opcode != Opcode::ArrayElement && context.list_compiler.mode == GL_COMPILE_AND_EXECUTE && context.inside_begin_end();
}

// Its handler is not called, and so records nothing: a draw without vertices fails again each time that the list is called.
void append_empty_draw(ListCompiler& compiler) {
  const std::size_t offset = compiler.list.size();
  compiler.run_begin = ListCompiler::none;
  compiler.list.append(ListTag::draw, sizeof(std::uint64_t));
  const std::uint64_t bytes = 0;
  compiler.list.rewrite(offset, &bytes, sizeof(bytes));
}

}  // namespace

bool append_record(Context& context, Opcode opcode, const void* record, std::size_t bytes) noexcept {
  ListCompiler& compiler = context.list_compiler;
  if (is_proxy(opcode, record)) return true;
  try {
    if (reads_arrays(opcode)) {
      if (fails_now(context, opcode) && !compiler.out_of_memory) append_empty_draw(compiler);
      records::execute(context, opcode, record);
      return false;
    }
    if (!compiler.out_of_memory) append(context, opcode, record, bytes);
  } catch (const std::bad_alloc&) {
    compiler.out_of_memory = true;
    compiler.list = {};
  }
  return compiler.mode == GL_COMPILE_AND_EXECUTE;
}

}  // namespace gouraud::api
