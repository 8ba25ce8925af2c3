// "coverage=barycentric": a pixel is inside if the three triangles that it makes with the corners have the triangle's area.
//
// Takes the corners as floats, gives the pixels where the areas add up to within `epsilon` of the whole. As it is often
// taught: it needs no orientation and no sign. But rounding decides at edges, and no epsilon is right: with 0 pixels
// inside are lost, the more the smaller the triangle and the larger its coordinates; with more than 0 pixels outside are
// taken in, twice on shared edges. Four areas a pixel, in floats.
// Source: taught after A. F. Moebius, "Der barycentrische Calcul", 1827.
#include <array>
#include <cmath>

#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {
namespace {

struct Point {
  float x, y;
};

float area(Point a, Point b, Point c) { return 0.5f * std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)); }

}  // namespace

void rasterize_by_areas(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const MethodTriangle& triangle = method_triangle_of(primitive);
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) p[i] = {static_cast<float>(triangle.corner[i].x), static_cast<float>(triangle.corner[i].y)};
  const float whole = area(p[0], p[1], p[2]), most = triangle.epsilon * whole;
  send_pixels(primitive, tile_x, tile_y, target, [&](std::int32_t x, std::int32_t y) {
    const Point centre{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
    const float parts = area(centre, p[0], p[1]) + area(centre, p[1], p[2]) + area(centre, p[2], p[0]);
    return std::abs(parts - whole) <= most;
  });
}

}  // namespace gouraud::pipeline
