// Takes a list's entries between Begin and End, gives a VertexRun; takes a VertexRun, gives vertices to the immediate
// batch [GL1.5 §2.6.1, §5.4].
#include "api/commands/vertex_run.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "api/commands/begin_end.h"
#include "api/commands/current_values.h"
#include "api/commands/shared_vertices.h"
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

/// The arrays of a run, and which of their vertices each vertex of the run is; empty: each its own.
struct RunArrays {
  std::vector<GLfloat> floats;
  std::vector<std::uint32_t> indices;
};

/// Vertices that are equal in all values that vary become one, if that makes the run a quarter shorter: lists that repeat
/// the corners of their quads are common, and each corner is then transformed and lit once.
void share_equal_vertices(Description& description, RunArrays& arrays) {
  VertexRun& run = description.run;
  const std::size_t count = run.count, columns = arrays.floats.size() / count;
  const auto starts_late = [](const RunAttribute& attribute) { return attribute.first > 0; };
  if (std::any_of(description.attributes.begin(), description.attributes.end(), starts_late)) return;

  const auto bits = [&](std::size_t column, std::size_t vertex) {
    return std::bit_cast<std::uint32_t>(arrays.floats[column * count + vertex]);
  };
  const auto hash = [&](std::uint32_t vertex) {
    std::uint64_t result = 0;
    for (std::size_t c = 0; c < columns; ++c) result = (result ^ bits(c, vertex)) * 0x9E3779B97F4A7C15u;
    return static_cast<std::size_t>(result ^ result >> 32);
  };
  const auto equal = [&](std::uint32_t a, std::uint32_t b) {
    for (std::size_t c = 0; c < columns; ++c) {
      if (bits(c, a) != bits(c, b)) return false;
    }
    return true;
  };
  std::unordered_map<std::uint32_t, std::uint32_t, decltype(hash), decltype(equal)> number_of(count / 2, hash, equal);
  std::vector<std::uint32_t> indices(count), kept;
  for (std::uint32_t vertex = 0; vertex < count; ++vertex) {
    const auto [found, is_new] = number_of.try_emplace(vertex, static_cast<std::uint32_t>(kept.size()));
    if (is_new) kept.push_back(vertex);
    indices[vertex] = found->second;
  }
  if (kept.size() > count / 4 * 3) return;

  std::vector<GLfloat> floats;
  floats.reserve(columns * kept.size());
  for (std::size_t c = 0; c < columns; ++c) {
    for (const std::uint32_t vertex : kept) floats.push_back(arrays.floats[c * count + vertex]);
  }
  run.distinct = static_cast<std::uint32_t>(kept.size());
  arrays.floats = std::move(floats);
  arrays.indices = std::move(indices);
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

std::size_t array_count(const VertexRun& run) {
  std::size_t arrays = 4;
  for (const RunAttribute& attribute : attributes_of(run)) {
    if (attribute.varies) arrays += info_of(attribute.tag).components;
  }
  return arrays;
}
const std::uint32_t* indices_of(const VertexRun& run) {
  return reinterpret_cast<const std::uint32_t*>(floats_of(run) + array_count(run) * run.distinct);
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

// The batch's next `count` vertices take what is current, in the attributes `unset` and in their edge flags.
void fill_unset(Context& context, std::uint32_t unset, std::size_t count) {
  pipeline::VertexBatch& batch = context.immediate.batch;
  const CurrentGroup& current = context.state.current;
  const auto to = static_cast<std::size_t>(batch.count);
  pipeline::for_each_attribute(batch, unset, [&](std::uint32_t attribute, auto& target) {
    const GLfloat* value = current_value(current, attribute);
    for (auto& component : target) std::fill_n(component.data() + to, count, *value++);
  });
  if (context.immediate.demand & pipeline::attribute_edge_flag) {
    std::fill_n(batch.edge_flag.data() + to, count, static_cast<std::uint8_t>(current.edge_flag));
  }
}

// Vertices [first, first + count), for which the batch has room.
void copy_block(Context& context, const VertexRun& run, std::size_t first, std::size_t count) {
  pipeline::VertexBatch& batch = context.immediate.batch;
  const CurrentGroup& current = context.state.current;
  const auto to = static_cast<std::size_t>(batch.count);
  Cursor arrays{floats_of(run), run.distinct};
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
  fill_unset(context, unset, count);
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

// One attribute of the run's vertices `elements`, into the batch's arrays from vertex `to` on.
template <class Arrays>
void gather_attribute(Arrays& target, std::size_t to, const RunAttribute& attribute, Cursor arrays,
                      std::span<const GLuint> elements) {
  for (std::size_t c = 0; c < target.size(); ++c) {
    GLfloat* const destination = target[c].data() + to;
    if (!attribute.varies) {
      std::fill_n(destination, elements.size(), attribute.own[c]);
      continue;
    }
    const GLfloat* const source = arrays.next();
    for (std::size_t i = 0; i < elements.size(); ++i) destination[i] = source[elements[i]];
  }
}

// The run's distinct vertices with these numbers, for which the batch has room.
void gather_block(Context& context, const VertexRun& run, std::span<const GLuint> elements) {
  pipeline::VertexBatch& batch = context.immediate.batch;
  const auto to = static_cast<std::size_t>(batch.count);
  Cursor arrays{floats_of(run), run.distinct};
  for (auto& component : batch.position_object) {
    const GLfloat* const source = arrays.next();
    for (std::size_t i = 0; i < elements.size(); ++i) component[to + i] = source[elements[i]];
  }
  std::uint32_t unset = context.immediate.demand;
  for (const RunAttribute& attribute : attributes_of(run)) {
    const AttributeInfo info = info_of(attribute.tag);
    pipeline::for_each_attribute(batch, context.immediate.demand & info.attribute, [&](std::uint32_t, auto& target) {
      gather_attribute(target, to, attribute, arrays, elements);
    });
    if (attribute.varies) arrays.array += info.components * arrays.count;
    unset &= ~info.attribute;
  }
  fill_unset(context, unset, elements.size());
  batch.count += static_cast<std::int32_t>(elements.size());
}

void copy_shared_vertices(Context& context, const VertexRun& run) {
  SharedVertices shared(context, [&](std::span<const GLuint> elements) { gather_block(context, run, elements); });
  if (shared.add({indices_of(run), run.count})) shared.finish();
}

// Between Begin and End of somebody else: the Begin fails, the vertices are theirs, and the End ends theirs.
void replay_one_by_one(Context& context, const VertexRun& run) {
  checked::Begin(context, run.mode);
  for (std::size_t vertex = 0; vertex < run.count; ++vertex) {
    Cursor arrays{floats_of(run) + (run.is_indexed() ? indices_of(run)[vertex] : vertex), run.distinct};
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
  Description description = describe(entries, mode);
  VertexRun& run = description.run;
  if (run.count < least_vertices) return false;
  RunArrays arrays{std::vector<GLfloat>(float_count(description)), {}};
  fill(entries, description, arrays.floats.data());
  run.distinct = run.count;
  share_equal_vertices(description, arrays);
  const auto bytes_of = [](const auto& values) { return values.size() * sizeof(values[0]); };
  const std::size_t bytes =
      sizeof(run) + run.attribute_count * sizeof(RunAttribute) + bytes_of(arrays.floats) + bytes_of(arrays.indices);
  if (bytes > DisplayList::max_payload_bytes) return false;
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
  std::memcpy(payload, arrays.floats.data(), bytes_of(arrays.floats));
  if (run.is_indexed()) std::memcpy(payload + bytes_of(arrays.floats), arrays.indices.data(), bytes_of(arrays.indices));
  return true;
}

void replay(Context& context, const VertexRun& run) {
  if (context.inside_begin_end()) return replay_one_by_one(context, run);
  if (!context.can_draw("glBegin")) return set_last(context, run);
  try {
    const pipeline::PrimitiveMode mode = primitive_mode(run.mode);
    run.is_indexed() ? context.begin_indexed_primitive(mode) : context.begin_primitive(mode);
    run.is_indexed() ? copy_shared_vertices(context, run) : copy_vertices(context, run);
  } catch (const std::bad_alloc&) {
    report_out_of_memory(context, "glCallList");
  }
  set_last(context, run);
  context.end_primitive();
}

}  // namespace gouraud::api
