#include "conformance/oracle/assembly.h"

namespace gouraud::oracle {
namespace {

using pipeline::PrimitiveMode;
using pipeline::PrimitiveRange;

/// Collects the primitives of a range; vertex numbers are relative to the range's first.
class Assembler {
 public:
  explicit Assembler(int first) : first_(first) {}

  void point(int a) { add(1, {a, a, a}, a, 0); }
  void line(int a, int b) { add(2, {a, b, b}, b, 0); }
  void triangle(int a, int b, int c, int provoking, unsigned edges = 7, bool continues = false) {
    add(3, {a, b, c}, provoking, edges);
    primitives_.back().continues = continues;
  }
  std::vector<Primitive> take() { return std::move(primitives_); }

 private:
  void add(int count, std::array<int, 3> vertex, int provoking, unsigned edges) {
    for (int& v : vertex) v += first_;
    primitives_.push_back({count, vertex, first_ + provoking, edges});
  }

  int first_;
  std::vector<Primitive> primitives_;
};

constexpr unsigned edge_ab = 1, edge_bc = 2, edge_ca = 4;

/// A continued loop starts with the very first vertex and the last one so far; no edge joins them.
void assemble_loop(const PrimitiveRange& range, Assembler& out) {
  for (int i = range.begins ? 1 : 2; i < range.count; ++i) out.line(i - 1, i);
  if (range.ends && range.count >= 2) out.line(range.count - 1, 0);
}

void assemble_quads(const PrimitiveRange& range, bool diagonal_02, Assembler& out) {
  for (int i = 0; i + 3 < range.count; i += 4) {
    const int last = i + 3;
    if (diagonal_02) {
      out.triangle(i, i + 1, i + 2, last, edge_ab | edge_bc);
      out.triangle(i, i + 2, i + 3, last, edge_bc | edge_ca, true);
    } else {
      out.triangle(i, i + 1, i + 3, last, edge_ab | edge_ca);
      out.triangle(i + 1, i + 2, i + 3, last, edge_ab | edge_bc, true);
    }
  }
}

/// Quad i of a strip is (2i, 2i + 1, 2i + 3, 2i + 2).
void assemble_quad_strip(const PrimitiveRange& range, bool far_half_first, Assembler& out) {
  for (int i = 0; i + 3 < range.count; i += 2) {
    const int last = i + 3;
    if (far_half_first) out.triangle(i + 2, i, i + 3, last, edge_ab | edge_ca);
    out.triangle(i, i + 1, i + 3, last, edge_ab | edge_bc, far_half_first);
    if (!far_half_first) out.triangle(i, i + 3, i + 2, last, edge_bc | edge_ca, true);
  }
}

/// A fan around vertex 0: only the first and the last triangle have a second edge of the polygon.
void assemble_polygon(const PrimitiveRange& range, Assembler& out) {
  for (int i = 2; i < range.count; ++i) {
    const bool first = range.begins && i == 2, last = range.ends && i == range.count - 1;
    out.triangle(i - 1, i, 0, 0, edge_ab | (last ? edge_bc : 0) | (first ? edge_ca : 0), i > 2 || !range.begins);
  }
}

}  // namespace

std::vector<Primitive> assemble(const PrimitiveRange& range, QuadSplit split) {
  Assembler out(range.first);
  const int n = range.count;
  switch (range.mode) {
    case PrimitiveMode::points:
      for (int i = 0; i < n; ++i) out.point(i);
      break;
    case PrimitiveMode::lines:
      for (int i = 0; i + 1 < n; i += 2) out.line(i, i + 1);
      break;
    case PrimitiveMode::line_strip:
      for (int i = 1; i < n; ++i) out.line(i - 1, i);
      break;
    case PrimitiveMode::line_loop:
      assemble_loop(range, out);
      break;
    case PrimitiveMode::triangles:
      for (int i = 0; i + 2 < n; i += 3) out.triangle(i, i + 1, i + 2, i + 2);
      break;
    case PrimitiveMode::triangle_strip:
      for (int i = 2; i < n; ++i) {
        const int odd = i % 2;
        out.triangle(i - 2 + odd, i - 1 - odd, i, i);
      }
      break;
    case PrimitiveMode::triangle_fan:
      for (int i = 2; i < n; ++i) out.triangle(0, i - 1, i, i);
      break;
    case PrimitiveMode::quads:
      assemble_quads(range, split.diagonal_02, out);
      break;
    case PrimitiveMode::quad_strip:
      assemble_quad_strip(range, split.strips_far_half_first, out);
      break;
    case PrimitiveMode::polygon:
      assemble_polygon(range, out);
      break;
  }
  return out.take();
}

void resolve_elements(const pipeline::VertexBatch& batch, Primitive& primitive) {
  for (int& vertex : primitive.vertex) vertex = batch.elements[static_cast<std::size_t>(vertex)];
  primitive.provoking = batch.elements[static_cast<std::size_t>(primitive.provoking)];
}

}  // namespace gouraud::oracle
