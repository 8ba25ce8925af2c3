#include "pipeline/geometry/outlines.h"

#include <algorithm>
#include <initializer_list>

namespace gouraud::pipeline {
namespace {

// How many vertices further the next polygon of the range begins.
std::int32_t step(PrimitiveMode mode) {
  switch (mode) {
    case PrimitiveMode::triangles:
      return 3;
    case PrimitiveMode::quads:
      return 4;
    case PrimitiveMode::quad_strip:
      return 2;
    default:
      return 1;
  }
}

}  // namespace

std::int32_t outline_count(const PrimitiveRange& range) {
  const std::int32_t count = range.count;
  switch (range.mode) {
    case PrimitiveMode::triangles:
      return count / 3;
    case PrimitiveMode::triangle_strip:
    case PrimitiveMode::triangle_fan:
      return std::max(count - 2, 0);
    case PrimitiveMode::quads:
      return count / 4;
    case PrimitiveMode::quad_strip:
      return std::max(count / 2 - 1, 0);
    case PrimitiveMode::polygon:
      return count >= 3 ? 1 : 0;
    default:
      return 0;
  }
}

void make_outline(const PrimitiveRange& range, std::int32_t number, const std::uint8_t* edge_flag, const std::uint16_t* elements,
                  Outline& out) {
  out.size = 0;
  const auto vertex = [&](std::int32_t i) { return range.indexed ? elements[i] : static_cast<std::uint16_t>(i); };
  const std::int32_t first = range.first + number * step(range.mode);
  const auto flagged = [&](std::int32_t i) { return edge_flag == nullptr || edge_flag[vertex(i)] != 0; };
  const auto take = [&](std::initializer_list<std::int32_t> vertices) {
    for (const std::int32_t i : vertices) out.add(vertex(i), true);
  };
  std::int32_t provoking = first;
  switch (range.mode) {
    case PrimitiveMode::triangle_strip: {  // odd triangles have their first two vertices swapped
      const std::int32_t odd = number & 1;
      take({first + odd, first + 1 - odd, first + 2});
      provoking = first + 2;
      break;
    }
    case PrimitiveMode::triangle_fan:
      take({range.first, first + 1, first + 2});
      provoking = first + 2;
      break;
    case PrimitiveMode::quad_strip:
      take({first, first + 1, first + 3, first + 2});
      provoking = first + 3;
      break;
    case PrimitiveMode::polygon:  // the edges to and from the first vertex are cuts where the polygon goes on
      for (std::int32_t i = 0; i < range.count; ++i) {
        const bool cut = (i == 0 && !range.begins) || (i == range.count - 1 && !range.ends);
        out.add(vertex(first + i), !cut && flagged(first + i));
      }
      break;
    default: {
      const std::int32_t size = step(range.mode);
      for (std::int32_t i = first; i < first + size; ++i) out.add(vertex(i), flagged(i));
      provoking = first + size - 1;
      break;
    }
  }
  out.provoking = vertex(provoking);
}

}  // namespace gouraud::pipeline
