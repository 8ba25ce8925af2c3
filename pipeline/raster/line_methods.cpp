#include "pipeline/raster/line_methods.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace gouraud::pipeline {
namespace {

std::int32_t pixel_of(double coordinate) { return static_cast<std::int32_t>(std::floor(coordinate)); }

void walk_naively(Point2 a, Point2 b, std::vector<PixelPosition>& pixels) {
  const auto m = static_cast<float>((b.y - a.y) / (b.x - a.x));
  const std::int32_t last = pixel_of(b.x), step = a.x < b.x ? 1 : -1;
  if (!std::isfinite(m)) return pixels.push_back({last, pixel_of(b.y)});
  const auto offset = static_cast<float>(a.y - static_cast<double>(m) * a.x);
  const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);  // a steep line's m would carry it away
  for (std::int32_t x = pixel_of(a.x); x != last + step; x += step) {
    const float y = m * (static_cast<float>(x) + 0.5f) + offset;
    pixels.push_back({x, pixel_of(std::clamp<double>(y, low, high))});
  }
}

void walk_with_dda(Point2 a, Point2 b, std::vector<PixelPosition>& pixels) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const auto steps = static_cast<std::int32_t>(std::ceil(std::max(std::abs(dx), std::abs(dy))));
  if (steps == 0) return;
  const auto step_x = static_cast<float>(dx / steps), step_y = static_cast<float>(dy / steps);
  auto x = static_cast<float>(a.x), y = static_cast<float>(a.y);
  for (std::int32_t i = 0; i <= steps; ++i, x += step_x, y += step_y) {
    pixels.push_back({pixel_of(x), pixel_of(y)});
  }
}

void walk_as_bresenham(Point2 from, Point2 to, std::vector<PixelPosition>& pixels) {
  PixelPosition here{pixel_of(from.x), pixel_of(from.y)};
  const PixelPosition end{pixel_of(to.x), pixel_of(to.y)};
  const std::int32_t dx = std::abs(end.x - here.x), dy = std::abs(end.y - here.y);
  const std::int32_t step_x = here.x < end.x ? 1 : -1, step_y = here.y < end.y ? 1 : -1;
  std::int32_t error = dx - dy;
  for (;;) {
    pixels.push_back(here);
    if (here == end) return;
    const std::int32_t twice = 2 * error;
    if (twice > -dy) {
      error -= dy;
      here.x += step_x;
    }
    if (twice < dx) {
      error += dx;
      here.y += step_y;
    }
  }
}

}  // namespace

void walk_line(LineMethod method, Point2 a, Point2 b, std::vector<PixelPosition>& pixels) {
  switch (method) {
    case LineMethod::naive: return walk_naively(a, b, pixels);
    case LineMethod::dda: return walk_with_dda(a, b, pixels);
    case LineMethod::bresenham: return walk_as_bresenham(a, b, pixels);
    case LineMethod::diamond_exit:
    case LineMethod::coverage: break;
  }
}

}  // namespace gouraud::pipeline
