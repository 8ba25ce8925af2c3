// Takes a range of vertices, gives its points, lines and triangles as vertex numbers.
// [GL1.5 §2.6.1] and, for the vertex that colours a flat primitive, [GL1.5 §2.14.7 Table 2.12].
// choice: quads and polygons are split as MESA-RULES 2.5 says: quads as QuadSplit says, polygons as fans around the first
// vertex.
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

/// Quads from vertex 0 to 2, or from 1 to 3. Those of strips are split from their first to their last vertex; which half
/// comes first shows where they are folded.
struct QuadSplit {
  bool diagonal_02 = true;
  bool strips_far_half_first = false;
};

/// Of an indexed range, vertices are elements: resolve_elements() replaces them by the vertices that they name.
std::vector<Primitive> assemble(const pipeline::PrimitiveRange& range, QuadSplit split = {});

void resolve_elements(const pipeline::VertexBatch& batch, Primitive& primitive);

}  // namespace gouraud::oracle
