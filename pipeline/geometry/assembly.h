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

/// Along which diagonal separate quads are split. The specification leaves it open; it shows where attributes are not
/// planar over the quad.
/// choice: Mesa's rule (MESA-RULES 2.5), since programs' reference pictures come from there: from vertex 1 to 3 if they
/// are flat, not filled, stippled, indexed or from a display list, or if a vertex of the quads that are drawn together
/// lies outside the clip volume; else from 0 to 2.
enum class QuadDiagonal : std::uint8_t { from_0_to_2, from_1_to_3 };

/// Whether a vertex of range `i`, or of the quads that follow without another primitive between, lies outside.
bool are_quads_clipped(const VertexBatch& batch, const ProcessedVertices& vertices, std::size_t i);

/// Appends the primitives of a range; vertices that complete no primitive are dropped. Vertex indices are the batch's;
/// those of an indexed range count from its first element: resolve_elements() makes vertices of them.
/// Provoking vertices as [GL1.5 Table 2.12]: the last of a line, triangle or quad, the first of a polygon.
///
/// choice: quads split into (0,1,2)+(0,2,3) or (0,1,3)+(1,2,3); quad strips along the diagonal from first to last vertex;
/// polygons into a fan (i-1, i, 0), as Mesa does.
void assemble(const PrimitiveRange& range, QuadDiagonal diagonal, AssembledPrimitives& out);

/// Replaces each vertex number of an indexed range's primitives by the element that it counts.
void resolve_elements(const std::uint16_t* elements, AssembledPrimitives& primitives);

/// Takes the edges that begin at vertices with edge flag 0 from the boundary of the range's separate triangles, quads and
/// polygons; those of strips and fans all are boundary edges [GL1.5 §2.6.2]. (Mesa: flags of strips and fans count too.)
void apply_edge_flags(const PrimitiveRange& range, const std::uint8_t* edge_flag, std::vector<AssembledTriangle>& triangles);

}  // namespace gouraud::pipeline
