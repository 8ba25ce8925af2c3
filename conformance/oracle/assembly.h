// Takes a range of vertices, gives its points, lines and triangles as vertex numbers.
// [GL1.5 §2.6.1] and, for the vertex that colours a flat primitive, [GL1.5 §2.14.7 Table 2.12].
// choice: quads and polygons are split as MESA-RULES 2.5 says: quads as `diagonal_02` says, quad strips from their first
// to their last vertex, polygons as fans around the first vertex.
#pragma once

#include <array>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::oracle {

/// A point, line or triangle of 1, 2 or 3 batch vertices. `provoking` gives the colour of flat shading. Bit i of
/// `boundary_edges`: the edge from vertex i to the next is an edge of the polygon that was specified.
struct Primitive {
  int vertex_count = 0;
  std::array<int, 3> vertex{};
  int provoking = 0;
  unsigned boundary_edges = 7;
  bool continues = false;  ///< the same polygon as the triangle before
};

/// `diagonal_02`: quads are split from vertex 0 to 2; else from 1 to 3. Of an indexed range, vertices are elements: resolve_elements() replaces them by the vertices that they name.
std::vector<Primitive> assemble(const pipeline::PrimitiveRange& range, bool diagonal_02 = true);

void resolve_elements(const pipeline::VertexBatch& batch, Primitive& primitive);

}  // namespace gouraud::oracle
