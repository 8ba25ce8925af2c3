// choice: the specification's rule, a pixel's centre inside the zoomed rectangle or on its left or bottom boundary. Mesa
// rounds the raster position instead: 10.5 goes to 11, not to 10 (MESA-RULES 9).
#include "pipeline/raster/pixel_rectangle.h"

#include <algorithm>
#include <cmath>

namespace gouraud::pipeline {
namespace {

struct Axis {
  double origin, zoom;
  std::int32_t first;

  /// Where source n begins; exact as long as origin and zoom * n share 53 bits.
  double border(double n) const { return origin + zoom * (first + n); }
  bool holds(double n, double center) const {
    return zoom > 0 ? border(n) <= center && center < border(n + 1) : border(n + 1) <= center && center < border(n);
  }
  /// The source that holds a centre; the quotient may have been rounded over a border.
  double source_at(double center) const {
    const double quotient = (center - origin) / zoom - first;
    const double n = std::floor(quotient);
    for (const double candidate : {n, n - 1, n + 1}) {
      if (holds(candidate, center)) return candidate;
    }
    return -1;
  }
};

std::int32_t clamped_to(double value, std::int32_t low, std::int32_t high) {
  return value > low ? (value < high ? static_cast<std::int32_t>(value) : high) : low;  // NaN gives low
}

}  // namespace

AxisMap map_axis(double origin, double zoom, std::int32_t first, std::int32_t count, std::int32_t low, std::int32_t high) {
  if (!std::isfinite(origin) || !std::isfinite(zoom) || zoom == 0 || count <= 0 || low >= high) return {};
  const Axis axis{origin, zoom, first};
  const double one_end = axis.border(0), other_end = axis.border(count);

  // The first pixel whose centre is at or beyond a border is ceil(border - 1/2).
  AxisMap map;
  map.begin = clamped_to(std::ceil(std::min(one_end, other_end) - 0.5), low, high);
  map.end = clamped_to(std::ceil(std::max(one_end, other_end) - 0.5), low, high);
  if (map.empty()) return {};
  map.first_source = static_cast<std::int32_t>(std::clamp(axis.source_at(map.begin + 0.5), 0.0, count - 1.0));
  if (zoom == 1) return map;
  map.source.resize(static_cast<std::size_t>(map.end - map.begin));
  for (std::int32_t i = map.begin; i < map.end; ++i) {
    const double n = axis.source_at(i + 0.5);
    map.source[static_cast<std::size_t>(i - map.begin)] = static_cast<std::int32_t>(std::clamp(n, 0.0, count - 1.0));
  }
  return map;
}

SourceRange visible_sources(const AxisMap& axis) {
  if (axis.empty()) return {};
  const std::int32_t a = axis.source_of(axis.begin), b = axis.source_of(axis.end - 1);
  return {std::min(a, b), std::max(a, b) + 1};
}

}  // namespace gouraud::pipeline
