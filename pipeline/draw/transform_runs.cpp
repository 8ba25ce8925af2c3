#include "pipeline/draw/transform_runs.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>

namespace gouraud::pipeline {
namespace {

/// Copies vertices [first, first + part.count) of all attributes: which of them are valid, the plan knows.
void copy_vertices(const VertexBatch& batch, std::size_t first, VertexBatch& part) {
  const auto copy = [&](const auto& from, auto& to) {
    for (std::size_t c = 0; c < from.size(); ++c) std::copy_n(from[c].data() + first, part.count, to[c].data());
  };
  copy(batch.position_object, part.position_object);
  copy(batch.normal_object, part.normal_object);
  copy(batch.color, part.color);
  copy(batch.secondary_color, part.secondary_color);
  copy(batch.fog_coordinate, part.fog_coordinate);
  for (std::size_t unit = 0; unit < max_texture_units; ++unit) {
    copy(batch.texture_coordinates[unit], part.texture_coordinates[unit]);
  }
  std::copy_n(batch.edge_flag.data() + first, part.count, part.edge_flag.data());
}

/// The material of vertex `first`, and the changes up to `end`.
void copy_materials(const VertexBatch& batch, std::int32_t first, std::int32_t end, DrawState& state, VertexBatch& part) {
  for (const MaterialRun& run : batch.material_runs) {
    if (run.first <= first) state.lighting.material = run.material;
    if (run.first > first && run.first < end) part.material_runs.push_back({run.first - first, run.material});
  }
}

/// The primitives from `next` on that have their vertices before `end`; `next` is the first that has not.
void copy_primitives(const VertexBatch& batch, std::int32_t first, std::int32_t end, std::size_t& next, VertexBatch& part) {
  const auto first_vertex = [&](const PrimitiveRange& range) -> std::int32_t {
    return range.indexed && range.count > 0 ? batch.elements[static_cast<std::size_t>(range.first)] : range.indexed ? first : range.first;
  };
  for (; next < batch.primitives.size() && first_vertex(batch.primitives[next]) < end; ++next) {
    PrimitiveRange range = batch.primitives[next];
    if (range.indexed) {
      const auto* const elements = batch.elements.data() + range.first;
      range.first = static_cast<std::int32_t>(part.elements.size());
      std::transform(elements, elements + range.count, std::back_inserter(part.elements),
                     [first](std::uint16_t vertex) { return static_cast<std::uint16_t>(vertex - first); });
    } else {
      range.first -= first;
    }
    range.moved = false;
    part.primitives.push_back(range);
  }
}

}  // namespace

void split_transform_runs(const DrawState& state, const VertexBatch& batch,
                          const std::function<void(const DrawState&, const VertexBatch&)>& visit) {
  if (batch.transform_runs.empty()) return visit(state, batch);
  const auto part = std::make_unique<VertexBatch>();
  std::size_t next_primitive = 0;
  for_each_transform(state.transform, batch, [&](const TransformState& transform, std::size_t first, std::size_t end) {
    if (first == end) return;
    const auto from = static_cast<std::int32_t>(first), to = static_cast<std::int32_t>(end);
    part->clear();
    part->count = to - from;
    DrawState state_of_part = state;
    state_of_part.transform = transform;
    copy_vertices(batch, first, *part);
    copy_materials(batch, from, to, state_of_part, *part);
    copy_primitives(batch, from, to, next_primitive, *part);
    visit(state_of_part, *part);
  });
}

}  // namespace gouraud::pipeline
