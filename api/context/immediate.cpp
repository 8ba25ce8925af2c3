// Immediate mode's batches: takes vertices between Begin and End, gives full or finished batches to the renderer
// [GL1.5 §2.6.1]. How a primitive that is longer than a batch is cut stands at PrimitiveRange.
#include "api/context/immediate.h"

#include <array>
#include <bit>
#include <utility>

#include "api/context/context.h"
#include "api/snapshot/lighting_snapshot.h"

namespace gouraud::api {
namespace {

using pipeline::PrimitiveMode;
using pipeline::VertexBatch;

/// A Begin starts a new batch if less room than this is left: enough for any cut to carry its vertices over.
constexpr std::int32_t least_room = 12;

std::int32_t limit_of(PrimitiveMode mode, std::int32_t first) {
  const std::int32_t multiple = cut_multiple(mode);
  return first + (pipeline::batch_capacity - first) / multiple * multiple;
}

struct Carried {
  int count = 0;
  std::array<std::int32_t, 2> from{};  // vertices of the old batch
};

Carried vertices_to_carry(const pipeline::PrimitiveRange& range) {
  const std::int32_t last = range.first + range.count - 1;
  switch (range.mode) {
    case PrimitiveMode::line_strip:
      return {1, {last, 0}};
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::quad_strip:
      return {2, {last - 1, last}};
    case PrimitiveMode::triangle_fan:
    case PrimitiveMode::polygon:
    case PrimitiveMode::line_loop:
      return {2, {range.first, last}};
    default:
      return {};
  }
}

constexpr std::uint32_t mode_bit(PrimitiveMode mode) { return 1u << static_cast<unsigned>(mode); }
constexpr std::uint32_t line_modes =
    mode_bit(PrimitiveMode::lines) | mode_bit(PrimitiveMode::line_loop) | mode_bit(PrimitiveMode::line_strip);

// With the attributes that are kept. from >= to.
void move_vertex(VertexBatch& batch, std::uint32_t demand, std::int32_t from, std::int32_t to) {
  const auto move = [source = static_cast<std::size_t>(from), target = static_cast<std::size_t>(to)](auto& arrays) {
    for (auto& component : arrays) component[target] = component[source];
  };
  move(batch.position_object);
  pipeline::for_each_attribute(batch, demand, [&](std::uint32_t, auto& arrays) { move(arrays); });
  batch.edge_flag[static_cast<std::size_t>(to)] = batch.edge_flag[static_cast<std::size_t>(from)];
}

pipeline::MaterialPair material_at(const VertexBatch& batch, const pipeline::MaterialPair& first, std::int32_t vertex) {
  pipeline::MaterialPair result = first;
  for (const pipeline::MaterialRun& run : batch.material_runs) {
    if (run.first <= vertex) result = run.material;
  }
  return result;
}

// From the batch's next vertex on `material` applies.
void append_material(VertexBatch& batch, const pipeline::MaterialPair& material) {
  if (!batch.material_runs.empty() && batch.material_runs.back().first == batch.count) {
    batch.material_runs.back().material = material;
  } else {
    batch.material_runs.push_back({batch.count, material});
  }
}

}  // namespace

void append_transform(VertexBatch& batch, const pipeline::TransformState& before, const pipeline::TransformState& now) {
  if (batch.transform_runs.empty()) batch.transform_runs.push_back({0, before});
  if (batch.transform_runs.back().first == batch.count) {
    batch.transform_runs.back().transform = now;
  } else {
    batch.transform_runs.push_back({batch.count, now});
  }
}

bool differ_for(std::uint32_t modes, std::uint32_t parts, const pipeline::DrawState& a, const pipeline::DrawState& b) {
  if ((parts & ~dirty_assembly) != 0) return true;
  const bool polygons = (modes & ~(mode_bit(PrimitiveMode::points) | line_modes)) != 0;
  const auto draws = [&](std::uint32_t kind, pipeline::PolygonMode polygons_as) {
    const auto& [front, back] = std::pair(a.assembly.polygon_mode_front, a.assembly.polygon_mode_back);
    return (modes & kind) != 0 || (polygons && (front == polygons_as || back == polygons_as));
  };
  if (a.assembly != b.assembly) return true;
  if (draws(mode_bit(PrimitiveMode::points), pipeline::PolygonMode::point) && a.points != b.points) return true;
  if (draws(line_modes, pipeline::PolygonMode::line) && a.lines != b.lines) return true;
  return polygons && a.polygons != b.polygons;
}

void ElementSlots::clear() {
  if (++batch_number == 0) *this = {.batch_number = 1};
}

std::int32_t cut_multiple(PrimitiveMode mode) {
  switch (mode) {
    case PrimitiveMode::triangles:
      return 3;
    case PrimitiveMode::quads:
      return 4;
    case PrimitiveMode::lines:
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::quad_strip:
      return 2;
    default:
      return 1;
  }
}

void keep_more_attributes(VertexBatch& batch, std::uint32_t demand, const CurrentGroup& current) {
  constexpr std::uint32_t kept = pipeline::attribute_normal | pipeline::attribute_color;
  const auto i = static_cast<std::size_t>(batch.count);
  pipeline::for_each_attribute(batch, demand & ~kept, [&](std::uint32_t attribute, auto& arrays) {
    const float* value = current_value(current, attribute);
    for (auto& component : arrays) component[i] = *value++;
  });
  if (demand & pipeline::attribute_edge_flag) batch.edge_flag[i] = current.edge_flag;
}

const float* current_value(const CurrentGroup& current, std::uint32_t attribute) {
  switch (attribute) {
    case pipeline::attribute_normal:
      return &current.normal_object[0];
    case pipeline::attribute_color:
      return &current.color[0];
    case pipeline::attribute_secondary_color:
      return &current.secondary_color[0];
    case pipeline::attribute_fog_coordinate:
      return &current.fog_coordinate;
    default: {
      const auto unit = static_cast<std::size_t>(std::countr_zero(attribute / pipeline::attribute_texture_coordinates_0));
      return &current.texture_coordinates[unit][0];
    }
  }
}

void Context::draw_pending() {
  VertexBatch& batch = immediate.batch;
  if (batch.count > 0) {
    if (!batch.material_runs.empty() && batch.material_runs.back().first == batch.count) batch.material_runs.pop_back();
    if (traces_.plans) trace_plan();
    try {
      renderer_.draw(draw_state_, plan_, batch);
    } catch (...) {  // no memory: these vertices are lost, and the rest of an open primitive with them
      batch.clear();
      immediate.batch_modes = 0;
      immediate.limit = 0;
      throw;
    }
  }
  batch.clear();
  immediate.batch_modes = 0;
  draw_state_.lighting.material = immediate.material;
}

void Context::flush_vertices() {
  if (immediate.inside_begin_end) end_primitive();
  if (immediate.batch.count > 0) draw_pending();
}

void Context::begin_primitive(PrimitiveMode mode, pipeline::PrimitiveOrigin origin) {
  refresh();
  VertexBatch& batch = immediate.batch;
  if (plan_.draws && target() != nullptr) {
    if (batch.count > pipeline::batch_capacity - least_room) draw_pending();
    const bool moved = !batch.transform_runs.empty() && batch.transform_runs.back().first == batch.count;
    batch.primitives.push_back({mode, true, true, batch.count, 0, false, list_nesting > 0 ? pipeline::PrimitiveOrigin::display_list : origin, moved});
    immediate.batch_modes |= mode_bit(mode);
    immediate.limit = limit_of(mode, batch.count);
    immediate.demand = plan_.vertex_demand;
  }
  immediate.mode = mode;
  immediate.inside_begin_end = true;
}

void Context::begin_indexed_primitive(PrimitiveMode mode) {
  begin_primitive(mode);
  if (immediate.limit == 0) return;
  VertexBatch& batch = immediate.batch;
  immediate.limit = pipeline::batch_capacity;
  batch.primitives.back().indexed = true;
  batch.primitives.back().first = static_cast<std::int32_t>(batch.elements.size());
}

void Context::continue_indexed_primitive() {
  VertexBatch& batch = immediate.batch;
  pipeline::PrimitiveRange& range = batch.primitives.back();
  range.ends = false;
  range.count = static_cast<std::int32_t>(batch.elements.size()) - range.first;
  const pipeline::PrimitiveOrigin origin = range.origin;
  draw_pending();
  batch.primitives.push_back({immediate.mode, false, true, 0, 0, true, origin});
  immediate.batch_modes = mode_bit(immediate.mode);
}

void Context::end_primitive() {
  immediate.inside_begin_end = false;
  if (immediate.limit == 0) return;
  immediate.limit = 0;
  VertexBatch& batch = immediate.batch;
  pipeline::PrimitiveRange& range = batch.primitives.back();
  range.count = (range.indexed ? static_cast<std::int32_t>(batch.elements.size()) : batch.count) - range.first;
  if (range.count == 0) batch.primitives.pop_back();
}

bool Context::make_room_for_vertex() {
  if (immediate.limit == 0) return false;
  VertexBatch& batch = immediate.batch;
  batch.primitives.back().ends = false;
  batch.primitives.back().count = batch.count - batch.primitives.back().first;
  const Carried carried = vertices_to_carry(batch.primitives.back());
  std::array<pipeline::MaterialPair, 2> materials{};
  for (int i = 0; i < carried.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    materials[k] = material_at(batch, draw_state_.lighting.material, carried.from[k]);
  }
  const pipeline::PrimitiveOrigin origin = batch.primitives.back().origin;
  draw_pending();
  batch.primitives.push_back({immediate.mode, false, true, 0, 0, false, origin});
  immediate.batch_modes = mode_bit(immediate.mode);
  immediate.limit = limit_of(immediate.mode, 0);

  // The carried vertices keep their materials; then comes the one in force now.
  for (int i = 0; i < carried.count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (i == 0) {
      draw_state_.lighting.material = materials[0];
    } else if (materials[k] != materials[k - 1]) {
      append_material(batch, materials[k]);
    }
    move_vertex(batch, immediate.demand, carried.from[k], batch.count++);
  }
  if (carried.count > 0 && immediate.material != materials[static_cast<std::size_t>(carried.count - 1)]) {
    append_material(batch, immediate.material);
  }
  return true;
}

void Context::apply_material() {
  const pipeline::MaterialPair material = canonical_material(state.lighting, draw_state_.lighting);
  if (material == immediate.material) return;
  if (immediate.batch.count > 0) {
    append_material(immediate.batch, material);
  } else {
    draw_state_.lighting.material = material;
  }
  immediate.material = material;
}

}  // namespace gouraud::api
