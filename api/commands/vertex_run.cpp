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

/// What there is to know of a value besides its tag.
struct AttributeInfo {
  std::uint32_t attribute;
  std::size_t components;
};

std::size_t index_of(ListTag tag) { return static_cast<std::size_t>(tag) - static_cast<std::size_t>(ListTag::normal); }

AttributeInfo info_of(ListTag tag) {
  switch (tag) {
    case ListTag::normal:
      return {pipeline::attribute_normal, 3};
    case ListTag::color:
      return {pipeline::attribute_color, 4};
    case ListTag::secondary_color:
      return {pipeline::attribute_secondary_color, 3};
    case ListTag::fog_coordinate:
      return {pipeline::attribute_fog_coordinate, 1};
    default: {
      const std::size_t unit = index_of(tag) - index_of(ListTag::texture_coordinates);
      return {pipeline::attribute_texture_coordinates(static_cast<int>(unit)), 4};
    }
  }
}

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

/// A run being made: every value that a run could set.
struct Description {
  VertexRun run;
  std::array<RunAttribute, run_attributes> attributes{};
  std::array<bool, run_attributes> changes{};
};

Description describe(std::span<const std::byte> entries, GLenum mode) {
  Description result;
  std::uint32_t& count = result.run.count;
  result.run.mode = mode;
  for_each_value(entries, [&](ListTag tag, const Values& values) {
    if (tag == ListTag::position) {
      ++count;
      return;
    }
    RunAttribute& attribute = result.attributes[index_of(tag)];
    bool& changes = result.changes[index_of(tag)];
    attribute.tag = tag;
    if (!changes) attribute.first = count;
    if (attribute.first == count) attribute.own = values;
    changes = true;
    attribute.last = values;
  });
  // A value varies if a vertex came between two of its changes, and another vertex after them.
  std::uint32_t vertex = 0;
  std::array<Values, run_attributes> current{};
  for_each_value(entries, [&](ListTag tag, const Values& values) {
    if (tag != ListTag::position) {
      current[index_of(tag)] = values;
      return;
    }
    for (std::size_t i = 0; i < run_attributes; ++i) {
      RunAttribute& attribute = result.attributes[i];
      if (!result.changes[i] || vertex < attribute.first) continue;
      attribute.varies |= std::memcmp(&current[i], &attribute.own, sizeof(Values)) != 0;
    }
    ++vertex;
  });
  for (const bool changes : result.changes) result.run.attribute_count += changes ? 1 : 0;
  return result;
}

std::size_t float_count(const Description& description) {
  std::size_t arrays = 4;
  for (const RunAttribute& attribute : description.attributes) {
    if (attribute.varies) arrays += info_of(attribute.tag).components;
  }
  return arrays * description.run.count;
}

void fill(std::span<const std::byte> entries, const Description& description, GLfloat* floats) {
  const std::size_t count = description.run.count;
  std::array<Values, run_attributes> current{};
  std::size_t vertex = 0;
  for_each_value(entries, [&](ListTag tag, const Values& values) {
    if (tag != ListTag::position) {
      current[index_of(tag)] = values;
      return;
    }
    GLfloat* array = floats + vertex;
    for (std::size_t c = 0; c < 4; ++c, array += count) *array = values[c];
    for (std::size_t i = 0; i < run_attributes; ++i) {
      const RunAttribute& attribute = description.attributes[i];
      if (!attribute.varies) continue;
      for (std::size_t c = 0; c < info_of(attribute.tag).components; ++c, array += count) *array = current[i][c];
    }
    ++vertex;
  });
}

std::span<const RunAttribute> attributes_of(const VertexRun& run) {
  return {reinterpret_cast<const RunAttribute*>(&run + 1), run.attribute_count};
}
const GLfloat* floats_of(const VertexRun& run) {
  return reinterpret_cast<const GLfloat*>(reinterpret_cast<const RunAttribute*>(&run + 1) + run.attribute_count);
}

void set_last(Context& context, const VertexRun& run) {
  for (const RunAttribute& attribute : attributes_of(run)) {
    set_vertex_value(context.state.current, attribute.tag, attribute.last.data());
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
template <class Arrays>
void copy_attribute(Arrays& target, std::size_t to, const RunAttribute& attribute, Cursor arrays, std::size_t first,
                    std::size_t count, const GLfloat* before) {
  const std::size_t foreign = std::min<std::size_t>(attribute.first > first ? attribute.first - first : 0, count);
  for (std::size_t c = 0; c < target.size(); ++c) {
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
  Cursor arrays{floats_of(run), run.count};
  for (auto& component : batch.position_object) std::copy_n(arrays.next() + first, count, component.data() + to);

  // Values that the run sets, then those that it leaves as they are.
  std::uint32_t unset = context.immediate.demand;
  for (const RunAttribute& attribute : attributes_of(run)) {
    const AttributeInfo info = info_of(attribute.tag);
    pipeline::for_each_attribute(batch, context.immediate.demand & info.attribute, [&](std::uint32_t, auto& target) {
      copy_attribute(target, to, attribute, arrays, first, count, current_value(current, info.attribute));
    });
    if (attribute.varies) arrays.array += info.components * arrays.count;
    unset &= ~info.attribute;
  }
  pipeline::for_each_attribute(batch, unset, [&](std::uint32_t attribute, auto& target) {
    const GLfloat* value = current_value(current, attribute);
    for (auto& component : target) std::fill_n(component.data() + to, count, *value++);
  });
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
    Cursor arrays{floats_of(run) + vertex, run.count};
    Values position;
    for (GLfloat& component : position) component = *arrays.next();
    for (const RunAttribute& attribute : attributes_of(run)) {
      Values values = attribute.own;
      if (attribute.varies) {
        for (std::size_t c = 0; c < info_of(attribute.tag).components; ++c) values[c] = *arrays.next();
      }
      if (vertex >= attribute.first) set_vertex_value(context.state.current, attribute.tag, values.data());
    }
    checked::Vertex4f(context, position[0], position[1], position[2], position[3]);
  }
  set_last(context, run);
  checked::End(context);
}

}  // namespace

void set_vertex_value(CurrentGroup& current, ListTag tag, const GLfloat* v) {
  switch (tag) {
    case ListTag::normal:
      current.normal_object = glm::make_vec3(v);
      break;
    case ListTag::color:
      current.color = glm::make_vec4(v);
      break;
    case ListTag::secondary_color:
      current.secondary_color = glm::vec4(v[0], v[1], v[2], 1.0f);
      break;
    case ListTag::fog_coordinate:
      current.fog_coordinate = v[0];
      break;
    default:
      current.texture_coordinates[index_of(tag) - index_of(ListTag::texture_coordinates)] = glm::make_vec4(v);
      break;
  }
}

bool make_vertex_run(DisplayList& list, std::size_t begin, GLenum mode) {
  const auto entries = list.entries().subspan(begin);
  const Description description = describe(entries, mode);
  const VertexRun& run = description.run;
  std::vector<GLfloat> floats(float_count(description));
  const std::size_t bytes = sizeof(run) + run.attribute_count * sizeof(RunAttribute) + floats.size() * sizeof(GLfloat);
  if (run.count < least_vertices || bytes > DisplayList::max_payload_bytes) return false;
  fill(entries, description, floats.data());
  list.make_room(bytes);
  list.truncate(begin);
  std::byte* payload = list.append(ListTag::vertices, bytes);
  std::memcpy(payload, &run, sizeof(run));
  payload += sizeof(run);
  for (std::size_t i = 0; i < run_attributes; ++i) {
    if (!description.changes[i]) continue;
    std::memcpy(payload, &description.attributes[i], sizeof(RunAttribute));
    payload += sizeof(RunAttribute);
  }
  std::memcpy(payload, floats.data(), floats.size() * sizeof(GLfloat));
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
