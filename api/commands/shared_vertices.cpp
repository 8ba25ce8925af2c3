// Takes elements, gives vertices and their places in the batch. An open hash table with linear probing says where an
// element stands; a new batch makes all its slots stale at once.
#include "api/commands/shared_vertices.h"

#include <utility>

#include "api/commands/render_mode.h"

namespace gouraud::api {
namespace {

using pipeline::PrimitiveMode;

/// Indices that one range of a primitive may have: their numbers fit 16 bits, and what is assembled of them stays small.
constexpr std::size_t most_indices = 8192;
/// In feedback and selection a polygon is clipped as a whole, and clipping needs room.
constexpr std::size_t most_indices_reported = pipeline::batch_capacity;

}  // namespace

SharedVertices::SharedVertices(Context& context, Append append)
    : context_(context), append_(std::move(append)), multiple_(cut_multiple(context.immediate.mode)) {
  context.immediate.element_slots.clear();
}

bool SharedVertices::is_full() const {
  const pipeline::VertexBatch& batch = context_.immediate.batch;
  const auto indices = batch.elements.size() - static_cast<std::size_t>(batch.primitives.back().first);
  return batch.count + static_cast<std::int32_t>(fresh_count_) + multiple_ > pipeline::batch_capacity || indices >= (renders_nothing(context_) ? most_indices_reported : most_indices);
}

inline void SharedVertices::add_one(GLuint element) {
  pipeline::VertexBatch& batch = context_.immediate.batch;
  constexpr GLuint golden_ratio = 0x9E3779B9u;
  ElementSlots& slots = context_.immediate.element_slots;
  const std::uint16_t valid = slots.batch_number;
  std::size_t at = element * golden_ratio >> (32 - ElementSlots::bits);
  while (slots.slot[at].batch_number == valid && slots.slot[at].element != element) at = (at + 1) % slots.slot.size();
  if (slots.slot[at].batch_number != valid) {
    slots.slot[at] = {element, valid, static_cast<std::uint16_t>(batch.count + static_cast<std::int32_t>(fresh_count_))};
    fresh_[fresh_count_++] = element;
  }
  batch.elements.push_back(slots.slot[at].vertex);
}

bool SharedVertices::add(std::span<const GLuint> elements) {
  if (context_.immediate.limit == 0) return false;
  if (elements.empty()) return true;
  if (!any_) first_ = elements[0];
  any_ = true;
  for (const GLuint element : elements) {
    if (until_cut_ == 0) {
      until_cut_ = multiple_;
      if (is_full()) start_next_batch();
      if (context_.immediate.limit == 0) return false;
    }
    --until_cut_;
    add_one(element);
    last_ = {last_[1], element};
  }
  return true;
}

void SharedVertices::append_fresh() {
  if (fresh_count_ > 0) append_({fresh_.data(), std::exchange(fresh_count_, 0)});
}

// As PrimitiveRange says, a continued range repeats what assembly still needs.
void SharedVertices::start_next_batch() {
  append_fresh();
  context_.continue_indexed_primitive();
  context_.immediate.element_slots.clear();
  switch (context_.immediate.mode) {
    case PrimitiveMode::line_strip:
      return add_one(last_[1]);
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::quad_strip:
      add_one(last_[0]);
      return add_one(last_[1]);
    case PrimitiveMode::triangle_fan:
    case PrimitiveMode::polygon:
    case PrimitiveMode::line_loop:
      add_one(first_);
      return add_one(last_[1]);
    default:
      return;
  }
}

}  // namespace gouraud::api
