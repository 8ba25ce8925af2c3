// "coverage=scanline": spans between walked edges.
//
// Takes the corners as floats, gives for each row the pixels from the left edge to the right one. An edge is walked from
// its lower end, row by row, by adding its slope: no work outside the triangle, and the natural way to interpolate along
// rows. Each row is different work, so that it does not vectorize, and small triangles are all preparation. Triangles
// that share an edge walk it alike, and so share no pixel; but the sum of many slopes in float drifts from the edge (a
// hundredth of a pixel over 10,000 rows), and corners are not snapped: a few pixels along edges are others than the
// default's, and where three edges meet in a point that lies inside a fourth (a T) there may be holes.
// Source: C. Wylie, G. Romney, D. Evans, A. Erdahl, "Half-tone perspective drawings by computer", 1967.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "pipeline/raster/method_triangle.h"
#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {
namespace {

struct Point {
  float x, y;
};

/// The first row or column whose centre is at or above the coordinate.
std::int32_t first_centre(float coordinate) { return static_cast<std::int32_t>(std::ceil(coordinate - 0.5f)); }

/// An edge on its way up: its x where it meets the centre of `row`.
class WalkedEdge {
 public:
  WalkedEdge(Point low, Point high) : row_(first_centre(low.y)), end_(first_centre(high.y)) {
    if (row_ >= end_) return;
    slope_ = (high.x - low.x) / (high.y - low.y);
    x_ = low.x + (static_cast<float>(row_) + 0.5f - low.y) * slope_;
  }
  std::int32_t row() const { return row_; }
  std::int32_t end() const { return end_; }
  float x() const { return x_; }
  void step() {
    x_ += slope_;
    ++row_;
  }

 private:
  std::int32_t row_, end_;
  float slope_ = 0, x_ = 0;
};

/// The spans between the long edge and one of the short ones.
void fill_between(WalkedEdge& whole, WalkedEdge part, const TileBox& box, std::int32_t tile_x, std::int32_t tile_y, TilePixels& pixels) {
  for (; part.row() < part.end() && whole.row() < tile_y + box.y1; part.step(), whole.step()) {
    const std::int32_t y = whole.row() - tile_y;
    if (y < box.y0) continue;
    const auto [left, right] = std::minmax({whole.x(), part.x()});
    const std::int32_t x0 = std::max(first_centre(left) - tile_x, box.x0), x1 = std::min(first_centre(right) - tile_x, box.x1);
    if (x0 < x1) pixels.add_span(x0, x1, y);
  }
}

}  // namespace

void rasterize_scanlines(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  std::array<Point, 3> p;
  for (std::size_t i = 0; i < 3; ++i) {
    const SmoothShape::Corner& corner = primitive.shape->corner[i];
    p[i] = {static_cast<float>(corner.x), static_cast<float>(corner.y)};
  }
  std::sort(p.begin(), p.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
  const TileBox box = box_in_tile(primitive, tile_x, tile_y);
  TilePixels pixels;
  WalkedEdge whole(p[0], p[2]);
  fill_between(whole, WalkedEdge(p[0], p[1]), box, tile_x, tile_y, pixels);
  fill_between(whole, WalkedEdge(p[1], p[2]), box, tile_x, tile_y, pixels);
  pixels.send(primitive, box, tile_x, tile_y, target);
}

}  // namespace gouraud::pipeline
