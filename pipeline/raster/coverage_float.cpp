// "coverage=float_edges", "coverage=float_steps": edge functions in single precision, of corners that are not snapped.
//
// Take the corners as floats, give the pixels inside three edges, with the top-left rule for values that are exactly 0.
// float_edges evaluates each function at each pixel: neighbours compute the negative of each other's value, and so share
// no pixel, but c = x0 y1 - x1 y0 loses bits with the size of the coordinates: the edge is not where it should be. (At 2^13 a
// unit in the last place of c is 8: an edge a pixel long is off by pixels.)
// float_steps adds from pixel to pixel instead: every addition rounds, neighbours round differently since their boxes
// begin elsewhere, and the errors add up along a row: holes and double hits. In integers (coverage=incremental) neither happens.
// Source: J. Pineda, "A parallel algorithm for polygon rasterization", 1988, as it is done without a second thought.
#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {
namespace {

struct FloatEdge {
  float a, b, c;
  float at(float x, float y) const { return (a * x + b * y) + c; }
  bool inside(float value) const { return value > 0 || (value == 0 && (a > 0 || (a == 0 && b > 0))); }
};

std::array<FloatEdge, 3> float_edges(const SmoothShape& shape) {
  std::array<float, 3> x, y;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = static_cast<float>(shape.corner[i].x);
    y[i] = static_cast<float>(shape.corner[i].y);
  }
  const float area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]), sign = area < 0 ? -1.0f : 1.0f;
  std::array<FloatEdge, 3> edges;
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    edges[from] = {sign * (y[from] - y[to]), sign * (x[to] - x[from]), sign * (x[from] * y[to] - x[to] * y[from])};
  }
  return edges;
}

}  // namespace

void rasterize_float_edges(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const std::array<FloatEdge, 3> edges = float_edges(*primitive.shape);
  send_pixels(primitive, tile_x, tile_y, target, [&](std::int32_t x, std::int32_t y) {
    const float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
    return std::all_of(edges.begin(), edges.end(), [&](const FloatEdge& e) { return e.inside(e.at(px, py)); });
  });
}

void rasterize_float_steps(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const std::array<FloatEdge, 3> edges = float_edges(*primitive.shape);
  const TileBox box = box_in_tile(primitive, tile_x, tile_y);
  // The steps begin where the triangle does, not where the tile does.
  std::int32_t first_x = tile_x + box.x0, first_y = tile_y + box.y0;
  for (std::size_t i = 0; i < 3; ++i) {
    first_x = std::min(first_x, static_cast<std::int32_t>(std::floor(primitive.shape->corner[i].x)));
    first_y = std::min(first_y, static_cast<std::int32_t>(std::floor(primitive.shape->corner[i].y)));
  }
  std::array<float, 3> row;
  for (std::size_t k = 0; k < 3; ++k) {
    row[k] = edges[k].at(static_cast<float>(first_x) + 0.5f, static_cast<float>(first_y) + 0.5f);
    for (std::int32_t y = first_y; y < tile_y + box.y0; ++y) row[k] += edges[k].b;
  }
  TilePixels pixels;
  for (std::int32_t y = box.y0; y < box.y1; ++y) {
    std::array<float, 3> value = row;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::int32_t x = first_x; x < tile_x + box.x0; ++x) value[k] += edges[k].a;
    }
    for (std::int32_t x = box.x0; x < box.x1; ++x) {
      if (edges[0].inside(value[0]) && edges[1].inside(value[1]) && edges[2].inside(value[2])) pixels.add(x, y);
      for (std::size_t k = 0; k < 3; ++k) value[k] += edges[k].a;
    }
    for (std::size_t k = 0; k < 3; ++k) row[k] += edges[k].b;
  }
  pixels.send(primitive, box, tile_x, tile_y, target);
}

}  // namespace gouraud::pipeline
