#include "conformance/chart/pareto.h"

#include <algorithm>

namespace gouraud::chart {

bool beats(const Point& better, const Point& point, const Resolution& resolution) {
  return better.time < point.time * (1 - resolution.time_share) && better.error < point.error - resolution.error;
}

bool is_faster_and_as_accurate(const Point& better, const Point& point, const Resolution& resolution) {
  return better.time < point.time * (1 - resolution.time_share) && better.error <= point.error + resolution.error;
}

std::vector<bool> front(const std::vector<Point>& points) {
  std::vector<bool> result;
  for (const Point& point : points) {
    result.push_back(std::ranges::none_of(points, [&](const Point& other) {
      const bool no_worse = other.time <= point.time && other.error <= point.error;
      return no_worse && (other.time < point.time || other.error < point.error);
    }));
  }
  return result;
}

std::vector<std::string> beaten_by(const Point& point, const std::vector<Point>& points, const Resolution& resolution) {
  std::vector<std::string> names;
  for (const Point& other : points) {
    if (beats(other, point, resolution)) names.push_back(other.name);
  }
  return names;
}

}  // namespace gouraud::chart
