// Records that are written together, one a lane: of the triangles or lines of one state (plane_lanes-inl.h).
#pragma once

#include <array>
#include <cstddef>

#include "pipeline/raster/primitive.h"
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {

/// Most primitives that are set up together.
inline constexpr std::size_t group_capacity = 8;

struct RecordGroup {
  using Lanes = double[group_capacity];

  /// A group of none. `memory` is for the records: record_size bytes each, 64-byte aligned.
  RecordGroup(const SetupState& s, std::byte* memory) : state(&s), records(memory), record_bytes(record_size(s)) {}

  PrimitiveRecord& record(std::size_t i) const { return *reinterpret_cast<PrimitiveRecord*>(records + i * record_bytes); }
  ColorRecord& color(std::size_t i) const { return reinterpret_cast<ColoredPrimitive&>(record(i)).color; }
  /// So that lanes without a primitive compute something.
  void repeat_last() {
    for (auto& vertices : vertex) {
      for (std::size_t i = count; i < group_capacity; ++i) vertices[i] = vertices[count - 1];
    }
  }

  const SetupState* state;
  std::byte* records;
  std::size_t record_bytes, count = 0;
  std::array<std::array<const KeptVertex*, group_capacity>, 3> vertex;  ///< a line's last is its second again
};

}  // namespace gouraud::pipeline
