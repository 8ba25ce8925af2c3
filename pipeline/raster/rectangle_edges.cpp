#include "pipeline/raster/rectangle_edges.h"

#include <cmath>

namespace gouraud::pipeline {
namespace {

constexpr double unit = 1 << 23;

/// The constant of an edge that is a * x + b * y + c >= 0 in pixels, from the centre of pixel (0, 0).
std::int64_t fine_constant(double a, double b, double c) {
  const bool owns = a > 0 || (a == 0 && b > 0);
  return static_cast<std::int64_t>(owns ? std::floor(c * subpixels) : std::ceil(c * subpixels) - 1);
}

}  // namespace

RectangleEdges edges_of_rectangle(Point2 from, Point2 to, double width) {
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::sqrt(dx * dx + dy * dy);
  // Across, to the left of the way; along is (b, -a).
  const double a = std::nearbyint(-dy / length * unit), b = std::nearbyint(dx / length * unit);
  const double middle = a * (0.5 * (from.x + to.x) - 0.5) + b * (0.5 * (from.y + to.y) - 0.5), half = 0.5 * width * unit;
  const double begin = b * (from.x - 0.5) - a * (from.y - 0.5), end = b * (to.x - 0.5) - a * (to.y - 0.5);
  return {{fine_constant(a, b, half - middle), fine_constant(-a, -b, half + middle), fine_constant(b, -a, -begin), fine_constant(-b, a, end)},
          static_cast<std::int32_t>(a), static_cast<std::int32_t>(b)};
}

}  // namespace gouraud::pipeline
