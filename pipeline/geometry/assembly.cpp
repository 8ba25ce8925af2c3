// Takes a range of vertices, gives its primitives [GL1.5 §2.6.1].
//
// A range that continues an earlier one yields what the uncut primitive would have yielded there: see PrimitiveRange
// for the vertices it repeats. `edges` knows the decomposition alone; apply_edge_flags() adds what the application says.
#include "pipeline/geometry/assembly.h"

#include <algorithm>
#include <cstddef>

namespace gouraud::pipeline {
namespace {

constexpr std::uint8_t edge_01 = 1, edge_12 = 2, edge_20 = 4, all_edges = 7;

/// Appends `count` default elements and returns the first.
template <class T>
T* append(std::vector<T>& list, std::int32_t count) {
  const std::size_t size = list.size();
  list.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
  return list.data() + size;
}

/// Vertex numbers below are relative to the range's first.
struct Indices {
  std::int32_t first;
  std::uint16_t operator()(std::int32_t i) const { return static_cast<std::uint16_t>(first + i); }
  AssembledTriangle triangle(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t provoking,
                             std::uint8_t edges, bool continues = false) const {
    const Indices& at = *this;
    return {{at(a), at(b), at(c)}, at(provoking), edges, continues};
  }
  AssembledLine line(std::int32_t a, std::int32_t b) const { return {{(*this)(a), (*this)(b)}, (*this)(b), false}; }
};

void assemble_points(Indices at, std::int32_t count, std::vector<AssembledPoint>& out) {
  AssembledPoint* point = append(out, count);
  for (std::int32_t i = 0; i < count; ++i) *point++ = {at(i), at(i), false};
}

/// Segments (i, i + 1) for i = first, first + step, ...
void assemble_lines(Indices at, std::int32_t count, std::int32_t first, std::int32_t step,
                    std::vector<AssembledLine>& out) {
  const std::int32_t segments = count - first < 2 ? 0 : (count - first - 2) / step + 1;
  AssembledLine* line = append(out, segments);
  for (std::int32_t k = 0; k < segments; ++k) *line++ = at.line(first + k * step, first + k * step + 1);
}

/// No edge joins the two vertices that a continued loop repeats.
void assemble_loop(Indices at, const PrimitiveRange& range, std::vector<AssembledLine>& out) {
  assemble_lines(at, range.count, range.begins ? 0 : 1, 1, out);
  if (range.ends && range.count >= 2) out.push_back(at.line(range.count - 1, 0));
}

void assemble_triangles(Indices at, std::int32_t count, std::vector<AssembledTriangle>& out) {
  AssembledTriangle* triangle = append(out, count / 3);
  for (std::int32_t i = 0; i + 2 < count; i += 3) *triangle++ = at.triangle(i, i + 1, i + 2, i + 2, all_edges);
}

/// Odd triangles have their first two vertices swapped, so that all turn the same way.
void assemble_triangle_strip(Indices at, std::int32_t count, std::vector<AssembledTriangle>& out) {
  AssembledTriangle* triangle = append(out, count - 2);
  for (std::int32_t i = 2; i < count; ++i) {
    const std::int32_t odd = i & 1;
    *triangle++ = at.triangle(i - 2 + odd, i - 1 - odd, i, i, all_edges);
  }
}

void assemble_fan(Indices at, std::int32_t count, std::vector<AssembledTriangle>& out) {
  AssembledTriangle* triangle = append(out, count - 2);
  for (std::int32_t i = 2; i < count; ++i) *triangle++ = at.triangle(0, i - 1, i, i, all_edges);
}

void assemble_quads(Indices at, std::int32_t count, QuadDiagonal diagonal, std::vector<AssembledTriangle>& out) {
  AssembledTriangle* triangle = append(out, count / 4 * 2);
  for (std::int32_t i = 0; i + 3 < count; i += 4) {
    const std::int32_t last = i + 3;
    if (diagonal == QuadDiagonal::from_0_to_2) {
      *triangle++ = at.triangle(i, i + 1, i + 2, last, edge_01 | edge_12);
      *triangle++ = at.triangle(i, i + 2, i + 3, last, edge_12 | edge_20, true);
    } else {
      *triangle++ = at.triangle(i, i + 1, i + 3, last, edge_01 | edge_20);
      *triangle++ = at.triangle(i + 1, i + 2, i + 3, last, edge_01 | edge_12, true);
    }
  }
}

/// Quad i / 2 has the vertices i, i + 1, i + 3, i + 2 in order. Its last specified vertex, i + 3, provokes.
void assemble_quad_strip(Indices at, std::int32_t count, bool far_half_first, std::vector<AssembledTriangle>& out) {
  AssembledTriangle* triangle = append(out, count < 4 ? 0 : (count - 2) / 2 * 2);
  for (std::int32_t i = 0; i + 3 < count; i += 2) {
    if (far_half_first) {
      *triangle++ = at.triangle(i + 2, i, i + 3, i + 3, edge_01 | edge_20);
      *triangle++ = at.triangle(i, i + 1, i + 3, i + 3, edge_01 | edge_12, true);
    } else {
      *triangle++ = at.triangle(i, i + 1, i + 3, i + 3, edge_01 | edge_12);
      *triangle++ = at.triangle(i, i + 3, i + 2, i + 3, edge_12 | edge_20, true);
    }
  }
}

/// A fan around vertex 0, which provokes. Besides the edge opposite to it, only the polygon's first and last triangle
/// have an edge of the polygon.
void assemble_polygon(Indices at, const PrimitiveRange& range, std::vector<AssembledTriangle>& out) {
  if (range.count < 3) return;
  const std::size_t size = out.size();
  AssembledTriangle* triangle = append(out, range.count - 2);
  for (std::int32_t i = 2; i < range.count; ++i) {
    *triangle++ = at.triangle(i - 1, i, 0, 0, edge_01, i > 2 || !range.begins);
  }
  if (range.begins) out[size].edges |= edge_20;
  if (range.ends) out.back().edges |= edge_12;
}

}  // namespace

bool is_clipped(const PrimitiveRange& range, const VertexBatch& batch, const ProcessedVertices& vertices) {
  const std::int32_t left_over = range.count % (range.mode == PrimitiveMode::quads ? 4 : 2);
  for (std::int32_t i = range.first; i < range.first + range.count - left_over; ++i) {
    const std::size_t vertex = range.indexed ? batch.elements[static_cast<std::size_t>(i)] : static_cast<std::size_t>(i);
    if (vertices.outcode[vertex] != 0) return true;
  }
  return false;
}

bool begins_quads(const VertexBatch& batch, std::size_t i) {
  const auto may_join = [](const PrimitiveRange& range) {
    return range.mode == PrimitiveMode::quads && !range.indexed && range.origin == PrimitiveOrigin::begin_end;
  };
  if (batch.primitives[i].mode != PrimitiveMode::quads) return false;
  return i == 0 || batch.primitives[i].moved || !may_join(batch.primitives[i - 1]) || !may_join(batch.primitives[i]);
}

bool are_quads_clipped(const VertexBatch& batch, const ProcessedVertices& vertices, std::size_t i) {
  const std::size_t begin = i;
  for (; i < batch.primitives.size() && batch.primitives[i].mode == PrimitiveMode::quads; ++i) {
    if (i > begin && begins_quads(batch, i)) break;
    if (is_clipped(batch.primitives[i], batch, vertices)) return true;
  }
  return false;
}

void apply_edge_flags(const PrimitiveRange& range, const std::uint8_t* edge_flag, std::vector<AssembledTriangle>& triangles) {
  if (range.mode != PrimitiveMode::triangles && range.mode != PrimitiveMode::quads && range.mode != PrimitiveMode::polygon) return;
  for (AssembledTriangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (edge_flag[triangle.vertex[i]] == 0) triangle.edges &= static_cast<std::uint8_t>(~(1u << i));
    }
  }
}

void resolve_elements(const std::uint16_t* elements, AssembledPrimitives& primitives) {
  const auto resolve = [elements](std::uint16_t& vertex) { vertex = elements[vertex]; };
  for (AssembledTriangle& triangle : primitives.triangles) {
    for (std::uint16_t& vertex : triangle.vertex) resolve(vertex);
    resolve(triangle.provoking);
  }
  for (AssembledLine& line : primitives.lines) {
    for (std::uint16_t& vertex : line.vertex) resolve(vertex);
    resolve(line.provoking);
  }
  for (AssembledPoint& point : primitives.points) {
    resolve(point.vertex);
    resolve(point.provoking);
  }
}

void assemble(const PrimitiveRange& range, QuadSplit split, AssembledPrimitives& out) {
  const Indices at{range.indexed ? 0 : range.first};
  const std::int32_t count = range.count;
  switch (range.mode) {
    case PrimitiveMode::points:
      return assemble_points(at, count, out.points);
    case PrimitiveMode::lines:
      return assemble_lines(at, count, 0, 2, out.lines);
    case PrimitiveMode::line_strip:
      return assemble_lines(at, count, 0, 1, out.lines);
    case PrimitiveMode::line_loop:
      return assemble_loop(at, range, out.lines);
    case PrimitiveMode::triangles:
      return assemble_triangles(at, count, out.triangles);
    case PrimitiveMode::triangle_strip:
      return assemble_triangle_strip(at, count, out.triangles);
    case PrimitiveMode::triangle_fan:
      return assemble_fan(at, count, out.triangles);
    case PrimitiveMode::quads:
      return assemble_quads(at, count, split.diagonal, out.triangles);
    case PrimitiveMode::quad_strip:
      return assemble_quad_strip(at, count, split.strips_far_half_first, out.triangles);
    case PrimitiveMode::polygon:
      return assemble_polygon(at, range, out.triangles);
  }
}

}  // namespace gouraud::pipeline
