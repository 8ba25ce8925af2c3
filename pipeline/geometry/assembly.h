// Vertices to points, lines and triangles [GL1.5 §2.6.1].
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// Primitives by kind, each kind in drawing order. A range yields one kind only.
struct AssembledPrimitives {
  std::vector<AssembledTriangle> triangles;
  std::vector<AssembledLine> lines;
  std::vector<AssembledPoint> points;
};

/// Appends the primitives of a range; vertices that complete no primitive are dropped. Vertex indices are the batch's;
/// those of an indexed range count from its first element: resolve_elements() makes vertices of them.
/// Provoking vertices as [GL1.5 Table 2.12]: the last of a line, triangle or quad, the first of a polygon.
///
/// choice: smooth quads split into (0,1,2)+(0,2,3), flat ones into (0,1,3)+(1,2,3), as Mesa does in the plain case of
/// each (MESA-RULES 2.5); quad strips along the diagonal from first to last vertex; polygons into a fan (i-1, i, 0).
void assemble(const PrimitiveRange& range, ShadeModel shade_model, AssembledPrimitives& out);

/// Replaces each vertex number of an indexed range's primitives by the element that it counts.
void resolve_elements(const std::uint16_t* elements, AssembledPrimitives& primitives);

/// Takes the edges that begin at vertices with edge flag 0 from the boundary of the range's separate triangles, quads and
/// polygons; those of strips and fans all are boundary edges [GL1.5 §2.6.2]. (Mesa: flags of strips and fans count too.)
void apply_edge_flags(const PrimitiveRange& range, const std::uint8_t* edge_flag, std::vector<AssembledTriangle>& triangles);

}  // namespace gouraud::pipeline
