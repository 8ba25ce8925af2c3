// "coverage=incremental": edge functions stepped from pixel to pixel.
//
// Takes integer edge functions, gives the pixels where none is negative. An edge function is linear: one pixel to the
// right it is larger by a, one up by b. Three additions a pixel in place of six multiplications; in integers nothing is
// lost on the way, so that the pixels are the default's (float steps: coverage=float_steps).
// Source: J. Pineda, "A parallel algorithm for polygon rasterization", 1988.
#include <array>
#include <cstddef>

#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {

void rasterize_incrementally(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const TileBox box = box_in_tile(primitive, tile_x, tile_y);
  std::array<std::int64_t, 3> row;
  for (std::size_t k = 0; k < 3; ++k) {
    const EdgeFunction& e = primitive.edges[k];
    row[k] = e.c + std::int64_t{e.a} * (tile_x + box.x0) + std::int64_t{e.b} * (tile_y + box.y0);
  }
  TilePixels pixels;
  for (std::int32_t y = box.y0; y < box.y1; ++y) {
    std::array<std::int64_t, 3> value = row;
    for (std::int32_t x = box.x0; x < box.x1; ++x) {
      if ((value[0] | value[1] | value[2]) >= 0) pixels.add(x, y);
      for (std::size_t k = 0; k < 3; ++k) value[k] += primitive.edges[k].a;
    }
    for (std::size_t k = 0; k < 3; ++k) row[k] += primitive.edges[k].b;
  }
  pixels.send(primitive, box, tile_x, tile_y, target);
}

}  // namespace gouraud::pipeline
