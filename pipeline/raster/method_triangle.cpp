// Takes a triangle that has been set up, gives it what the method needs, and the edges that the ownership asks for.
#include "pipeline/raster/method_triangle.h"

#include <cmath>
#include <cstddef>

namespace gouraud::pipeline {
namespace {

/// As triangle_setup.cpp snaps: nearest 1/256 pixel, ties to even, rounded in float.
std::int64_t snap(float coordinate) {
  return static_cast<std::int64_t>(std::nearbyint((coordinate - 0.5f) * static_cast<float>(subpixels)));
}

/// Edge functions of the snapped triangle, positive inside. The default's tie rule takes one unit from edges that do not
/// own their samples: here all own, or none does.
void set_edges(const MethodTriangle& triangle, OwnershipMethod ownership, PrimitiveRecord& record) {
  const auto& p = triangle.snapped;
  const std::int64_t area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  const std::int64_t sign = area > 0 ? 1 : -1;
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    const std::int64_t a = sign * (p[from].y - p[to].y), b = sign * (p[to].x - p[from].x);
    const bool top_left = a > 0 || (a == 0 && b > 0);
    const bool owns = ownership == OwnershipMethod::all || (ownership == OwnershipMethod::top_left && top_left);
    const std::int64_t c = -(a * p[from].x + b * p[from].y) - (owns ? 0 : 1);
    record.edges[from] = {c >> subpixel_bits, static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
  }
}

ShapeRasterizer rasterizer_of(CoverageMethod method) {
  switch (method) {
    case CoverageMethod::bounding_box: return rasterize_bounding_box;
    case CoverageMethod::incremental: return rasterize_incrementally;
    case CoverageMethod::blocks4:
    case CoverageMethod::blocks16:
    case CoverageMethod::blocks64: return block_rasterizer(method);
    case CoverageMethod::scanline: return rasterize_scanlines;
    case CoverageMethod::barycentric: return rasterize_by_areas;
    case CoverageMethod::float_edges: return rasterize_float_edges;
    case CoverageMethod::float_steps: return rasterize_float_steps;
    case CoverageMethod::homogeneous:  // set up by setup_homogeneous
    case CoverageMethod::blocks8: break;
  }
  return polygon_rasterizer();
}

}  // namespace

MethodTriangle method_triangle(const SetupState& state, const WaitingTriangle& triangle, const Methods& methods, PrimitiveRecord& record) {
  MethodTriangle result;
  static_cast<SmoothShape&>(result) = smooth_triangle(state, triangle);
  const std::int64_t top = (std::int64_t{state.target_height_px} - 1) * subpixels;
  for (std::size_t i = 0; i < 3; ++i) {
    const KeptVertex& vertex = vertex_of(triangle, i, kept_vertex_size(state));
    result.snapped[i] = {snap(vertex.window.x), top - snap(vertex.window.y_raster)};
    result.window[i] = &vertex.window;
    result.color[i] = &vertex.color;
    result.varyings[i] = varyings_of(vertex);
  }
  if (methods.ownership != OwnershipMethod::top_left) set_edges(result, methods.ownership, record);
  result.smooth = false;
  result.color_scale = state.targets.color_scale;
  result.epsilon = methods.epsilon;
  result.rasterize = rasterizer_of(methods.coverage);
  return result;
}

}  // namespace gouraud::pipeline
