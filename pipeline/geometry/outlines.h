// Vertices to whole polygons [GL1.5 §2.6.1], for those who want them uncut: selection and feedback.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// A polygon's vertices in order, and whether the edge from each to the next is a boundary edge. Room for a batch and
/// for the vertices that clipping makes.
struct Outline {
  static constexpr std::size_t capacity = processed_stride;
  std::uint16_t provoking = 0;
  std::size_t size = 0;
  std::array<std::uint16_t, capacity> vertex;
  std::array<bool, capacity> boundary;
  void add(std::uint16_t index, bool boundary_edge) {
    vertex[size] = index;
    boundary[size++] = boundary_edge;
  }
};

/// How many polygons the range makes; none of points and lines.
std::int32_t outline_count(const PrimitiveRange& range);

/// The `number`th of them. choice: of a polygon longer than a batch each range makes a polygon of its own.
/// `edge_flag`: by vertex, of separate triangles, quads and polygons; null: all are set [GL1.5 §2.6.2]. `elements`: the batch's,
/// for an indexed range. A range has at most batch_capacity vertices, give or take those of one primitive.
void make_outline(const PrimitiveRange& range, std::int32_t number, const std::uint8_t* edge_flag, const std::uint16_t* elements,
                  Outline& out);

}  // namespace gouraud::pipeline
