// "coverage=bounding_box": three edge functions, evaluated anew at every pixel of the triangle's box.
//
// Takes integer edge functions, gives the pixels where none is negative. The definition of coverage written down: the
// same pixels as the default, in two multiplications an edge and a pixel, inside and outside of the triangle alike. A
// thin diagonal triangle fills little of its box, and pays for all of it.
// Source: J. Pineda, "A parallel algorithm for polygon rasterization", 1988, without his increments.
#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {

void rasterize_bounding_box(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const auto value = [](const EdgeFunction& e, std::int64_t x, std::int64_t y) { return e.a * x + e.b * y + e.c; };
  const auto& edges = primitive.edges;
  send_pixels(primitive, tile_x, tile_y, target, [&](std::int32_t x, std::int32_t y) {
    return value(edges[0], x, y) >= 0 && value(edges[1], x, y) >= 0 && value(edges[2], x, y) >= 0;
  });
}

}  // namespace gouraud::pipeline
