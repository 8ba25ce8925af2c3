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

/// Modes that give triangles.
constexpr bool is_polygonal(PrimitiveMode mode) { return mode >= PrimitiveMode::triangles; }

/// Along which diagonal separate quads are split. The specification leaves it open; it shows where attributes are not
/// planar over the quad.
/// choice: Mesa's rule (MESA-RULES 2.5), since programs' reference pictures come from there: from vertex 1 to 3 if they
/// are flat, not filled, stippled, indexed or from a display list, or if a vertex of the quads that are drawn together
/// lies outside the clip volume; else from 0 to 2. Together are those of a DrawArrays, or of Begin/End pairs that follow
/// each other without another primitive or another matrix between.
enum class QuadDiagonal : std::uint8_t { from_0_to_2, from_1_to_3 };

/// How the quads of a range are split. A strip's always along the diagonal from its first to its last vertex; the halves
/// overlap where the quad is folded, so that their order shows.
/// choice: Mesa's again: (0,1,3)+(0,3,2), but (2,0,3)+(0,1,3) where they are not filled, stippled or clipped.
struct QuadSplit {
  QuadDiagonal diagonal = QuadDiagonal::from_0_to_2;
  bool strips_far_half_first = false;
};

/// Whether a vertex of the range's quads lies outside the clip volume; of quads or a strip of them.
bool is_clipped(const PrimitiveRange& range, const VertexBatch& batch, const ProcessedVertices& vertices);

/// Whether range `i` begins quads that are drawn together, and whether a vertex of those from range `i` on lies outside.
bool begins_quads(const VertexBatch& batch, std::size_t i);
bool are_quads_clipped(const VertexBatch& batch, const ProcessedVertices& vertices, std::size_t i);

/// Appends the primitives of a range; vertices that complete no primitive are dropped. Vertex indices are the batch's;
/// those of an indexed range count from its first element: resolve_elements() makes vertices of them.
/// Provoking vertices as [GL1.5 Table 2.12]: the last of a line, triangle or quad, the first of a polygon.
///
/// choice: quads split into (0,1,2)+(0,2,3) or (0,1,3)+(1,2,3), strips as above; polygons into a fan (i-1, i, 0), as Mesa does.
void assemble(const PrimitiveRange& range, QuadSplit split, AssembledPrimitives& out);

/// Replaces each vertex number of an indexed range's primitives by the element that it counts.
void resolve_elements(const std::uint16_t* elements, AssembledPrimitives& primitives);

/// Takes the edges that begin at vertices with edge flag 0 from the boundary of the range's separate triangles, quads and
/// polygons; those of strips and fans all are boundary edges [GL1.5 §2.6.2]. (Mesa: flags of strips and fans count too.)
void apply_edge_flags(const PrimitiveRange& range, const std::uint8_t* edge_flag, std::vector<AssembledTriangle>& triangles);

}  // namespace gouraud::pipeline
