// Takes a list's entries between Begin and End, gives a VertexRun; takes a VertexRun, gives vertices to the immediate
// batch [GL1.5 §2.6.1, §5.4].
#include "api/commands/vertex_run.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <span>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "api/commands/begin_end.h"
#include "api/commands/current_values.h"
#include "api/snapshot/enums.h"
#include "checked.h"

namespace gouraud::api {
namespace {

/// A shorter run takes less room and time as single entries.
constexpr std::uint32_t least_vertices = 8;

struct AttributeInfo {
  ListTag tag;
  RunAttribute VertexRun::*attribute;
  std::size_t components;
};

// In the order of their arrays.
constexpr AttributeInfo attributes[] = {{ListTag::normal, &VertexRun::normal, 3},
                                        {ListTag::color, &VertexRun::color, 4},
                                        {ListTag::texture_coordinates, &VertexRun::texture_coordinates, 4}};
using Values = std::array<GLfloat, 4>;

// Calls visit(tag, values) for each entry behind the Begin.
template <class Visit>
void for_each_value(std::span<const std::byte> entries, Visit visit) {
  bool is_begin = true;
  for (std::size_t at = 0; at < entries.size();) {
    ListEntry entry;
    std::memcpy(&entry, &entries[at], sizeof(entry));
    at += sizeof(entry);
    if (!is_begin) {
      Values values;
      std::memcpy(&values, &entries[at], sizeof(values));
      visit(entry.tag, values);
    }
    is_begin = false;
    at += entry.payload_bytes;
  }
}

const AttributeInfo& info_of(ListTag tag) {
  return *std::find_if(std::begin(attributes), std::end(attributes), [=](const auto& info) { return info.tag == tag; });
}

VertexRun describe(std::span<const std::byte> entries, GLenum mode) {
  VertexRun run;
  run.mode = mode;
  for_each_value(entries, [&](ListTag tag, const Values& values) {
    if (tag == ListTag::position) {
      ++run.count;
      return;
    }
    RunAttribute& attribute = run.*info_of(tag).attribute;
    if (!attribute.changes) attribute.first = run.count;
    if (attribute.first == run.count) attribute.own = values;
    attribute.changes = true;
    attribute.last = values;
  });
  // A value varies if a vertex came between two of its changes, and another vertex after them.
  std::uint32_t vertex = 0;
  Values current[std::size(attributes)]{};
  for_each_value(entries, [&](ListTag tag, const Values& values) {
    if (tag != ListTag::position) {
      current[&info_of(tag) - attributes] = values;
      return;
    }
    for (std::size_t i = 0; i < std::size(attributes); ++i) {
      RunAttribute& attribute = run.*attributes[i].attribute;
      if (!attribute.changes || vertex < attribute.first) continue;
      attribute.varies |= std::memcmp(&current[i], &attribute.own, sizeof(Values)) != 0;
    }
    ++vertex;
  });
  for (const AttributeInfo& info : attributes) {
    RunAttribute& attribute = run.*info.attribute;
    if (!attribute.changes) attribute.first = run.count;
  }
  return run;
}

std::size_t float_count(const VertexRun& run) {
  std::size_t arrays = 4;
  for (const AttributeInfo& info : attributes) arrays += (run.*info.attribute).varies ? info.components : 0;
  return arrays * run.count;
}

void fill(std::span<const std::byte> entries, const VertexRun& run, GLfloat* floats) {
  const std::size_t count = run.count;
  Values current[std::size(attributes)]{};
  std::size_t vertex = 0;
  for_each_value(entries, [&](ListTag tag, const Values& values) {
    if (tag != ListTag::position) {
      current[&info_of(tag) - attributes] = values;
      return;
    }
    GLfloat* array = floats + vertex;
    for (std::size_t c = 0; c < 4; ++c, array += count) *array = values[c];
    for (std::size_t i = 0; i < std::size(attributes); ++i) {
      if (!(run.*attributes[i].attribute).varies) continue;
      for (std::size_t c = 0; c < attributes[i].components; ++c, array += count) *array = current[i][c];
    }
    ++vertex;
  });
}

void set_current(Context& context, ListTag tag, const Values& v) {
  if (tag == ListTag::normal) Normal3f(context, v[0], v[1], v[2]);
  if (tag == ListTag::color) Color4f(context, v[0], v[1], v[2], v[3]);
  if (tag == ListTag::texture_coordinates) TexCoord4f(context, v[0], v[1], v[2], v[3]);
}

void set_last(Context& context, const VertexRun& run) {
  for (const AttributeInfo& info : attributes) {
    const RunAttribute& attribute = run.*info.attribute;
    if (attribute.changes) set_current(context, info.tag, attribute.last);
  }
}

/// A run's arrays, seen from one of them.
struct Cursor {
  const GLfloat* array;
  std::size_t count;
  const GLfloat* next() {
    const GLfloat* const result = array;
    array += count;
    return result;
  }
};

// The run's vertices [first, first + count) of one attribute into the batch's arrays from vertex `to` on. `before` is
// what vertices have that come before the attribute's first own value.
template <std::size_t components>
void copy_attribute(pipeline::VertexArray<static_cast<int>(components)>& target, std::size_t to,
                    const RunAttribute& attribute, Cursor arrays, std::size_t first, std::size_t count,
                    const GLfloat* before) {
  const std::size_t foreign = std::min<std::size_t>(attribute.first > first ? attribute.first - first : 0, count);
  for (std::size_t c = 0; c < components; ++c) {
    GLfloat* const destination = target[c].data() + to;
    std::fill_n(destination, foreign, before[c]);
    if (attribute.varies) {
      std::copy_n(arrays.next() + first + foreign, count - foreign, destination + foreign);
    } else {
      std::fill_n(destination + foreign, count - foreign, attribute.own[c]);
    }
  }
}

// Vertices [first, first + count), for which the batch has room.
void copy_block(Context& context, const VertexRun& run, std::size_t first, std::size_t count) {
  pipeline::VertexBatch& batch = context.immediate.batch;
  const CurrentGroup& current = context.state.current;
  const auto to = static_cast<std::size_t>(batch.count);
  Cursor arrays{reinterpret_cast<const GLfloat*>(&run + 1), run.count};
  for (auto& component : batch.position_object) std::copy_n(arrays.next() + first, count, component.data() + to);
  if (context.immediate.demand & pipeline::attribute_normal) {
    copy_attribute<3>(batch.normal_object, to, run.normal, arrays, first, count, glm::value_ptr(current.normal_object));
  }
  if (run.normal.varies) arrays.array += 3 * arrays.count;
  if (context.immediate.demand & pipeline::attribute_color) {
    copy_attribute<4>(batch.color, to, run.color, arrays, first, count, glm::value_ptr(current.color));
  }
  if (context.immediate.demand & pipeline::attribute_edge_flag) {
    std::fill_n(batch.edge_flag.data() + to, count, static_cast<std::uint8_t>(current.edge_flag));
  }
  batch.count += static_cast<std::int32_t>(count);
}

void copy_vertices(Context& context, const VertexRun& run) {
  for (std::size_t first = 0; first < run.count;) {
    Immediate& immediate = context.immediate;
    if (immediate.batch.count >= immediate.limit && !context.make_room_for_vertex()) return;
    const auto room = static_cast<std::size_t>(immediate.limit - immediate.batch.count);
    const std::size_t count = std::min(room, run.count - first);
    copy_block(context, run, first, count);
    first += count;
  }
}

// Between Begin and End of somebody else: the Begin fails, the vertices are theirs, and the End ends theirs.
void replay_one_by_one(Context& context, const VertexRun& run) {
  checked::Begin(context, run.mode);
  for (std::size_t vertex = 0; vertex < run.count; ++vertex) {
    Cursor arrays{reinterpret_cast<const GLfloat*>(&run + 1) + vertex, run.count};
    Values position;
    for (GLfloat& component : position) component = *arrays.next();
    for (const AttributeInfo& info : attributes) {
      const RunAttribute& attribute = run.*info.attribute;
      Values values = attribute.own;
      if (attribute.varies) {
        for (std::size_t c = 0; c < info.components; ++c) values[c] = *arrays.next();
      }
      if (vertex >= attribute.first) set_current(context, info.tag, values);
    }
    checked::Vertex4f(context, position[0], position[1], position[2], position[3]);
  }
  set_last(context, run);
  checked::End(context);
}

}  // namespace

bool make_vertex_run(DisplayList& list, std::size_t begin, GLenum mode) {
  const auto entries = list.entries().subspan(begin);
  const VertexRun run = describe(entries, mode);
  const std::size_t bytes = sizeof(run) + float_count(run) * sizeof(GLfloat);
  if (run.count < least_vertices || bytes > DisplayList::max_payload_bytes) return false;
  std::vector<GLfloat> floats(float_count(run));
  fill(entries, run, floats.data());
  list.make_room(bytes);
  list.truncate(begin);
  std::byte* const payload = list.append(ListTag::vertices, bytes);
  std::memcpy(payload, &run, sizeof(run));
  std::memcpy(payload + sizeof(run), floats.data(), floats.size() * sizeof(GLfloat));
  return true;
}

void replay(Context& context, const VertexRun& run) {
  if (context.inside_begin_end()) return replay_one_by_one(context, run);
  if (!context.can_draw("glBegin")) return set_last(context, run);
  try {
    context.begin_primitive(primitive_mode(run.mode));
    copy_vertices(context, run);
  } catch (const std::bad_alloc&) {
    report_out_of_memory(context, "glCallList");
  }
  set_last(context, run);
  context.end_primitive();
}

}  // namespace gouraud::api
