#include "conformance/oracle/smooth.h"

#include <algorithm>
#include <cmath>

namespace gouraud::oracle {
namespace {

/// The part of an outline where a x + b y + c >= 0.
Outline clipped(const Outline& in, double a, double b, double c) {
  Outline out;
  const auto distance = [&](const Place& p) { return a * p.x + b * p.y + c; };
  for (std::size_t i = 0; i < in.size(); ++i) {
    const Place &here = in[i], &next = in[(i + 1) % in.size()];
    const double d = distance(here), d_next = distance(next);
    if (d >= 0) out.push_back(here);
    if ((d >= 0) != (d_next >= 0)) {
      const double t = d / (d - d_next);
      out.push_back({here.x + t * (next.x - here.x), here.y + t * (next.y - here.y)});
    }
  }
  return out;
}

double signed_area(const Outline& outline) {
  double area = 0;
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const Place &o = outline[0], &p = outline[i - 1], &q = outline[i];
    area += 0.5 * ((p.x - o.x) * (q.y - o.y) - (q.x - o.x) * (p.y - o.y));
  }
  return area;
}

/// The area of the disc of this radius around (0, 0) between x = 0 and x, and between y = 0 and y; odd in both.
double disc_in_corner(double x, double y, double radius) {
  const double sign = (x < 0 ? -1.0 : 1.0) * (y < 0 ? -1.0 : 1.0);
  x = std::min(std::abs(x), radius);
  y = std::min(std::abs(y), radius);
  const double squared = radius * radius;
  if (x * x + y * y <= squared) return sign * x * y;
  // Up to where the circle comes down to y it is a rectangle, from there on the circle itself.
  const auto integral = [&](double at) {
    return 0.5 * (at * std::sqrt(std::max(squared - at * at, 0.0)) + squared * std::asin(std::min(at / radius, 1.0)));
  };
  const double meets = std::sqrt(squared - y * y);
  return sign * (meets * y + integral(x) - integral(meets));
}

}  // namespace

Outline clipped_to_pixel(Outline outline, int x, int y) {
  outline = clipped(outline, 1, 0, -x);
  outline = clipped(outline, -1, 0, x + 1.0);
  outline = clipped(outline, 0, 1, -y);
  return clipped(outline, 0, -1, y + 1.0);
}

double area_of(const Outline& outline) {
  return std::abs(signed_area(outline));
}

Place centroid_of(const Outline& outline) {
  const double whole = signed_area(outline);
  Place sum;
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const double share = signed_area({outline[0], outline[i - 1], outline[i]}) / whole / 3;
    sum.x += share * (outline[0].x + outline[i - 1].x + outline[i].x);
    sum.y += share * (outline[0].y + outline[i - 1].y + outline[i].y);
  }
  return sum;
}

double disc_in_pixel(const Place& center, double radius, int x, int y) {
  const double x0 = x - center.x, y0 = y - center.y, x1 = x0 + 1, y1 = y0 + 1;
  return disc_in_corner(x1, y1, radius) - disc_in_corner(x0, y1, radius) - disc_in_corner(x1, y0, radius) +
         disc_in_corner(x0, y0, radius);
}

}  // namespace gouraud::oracle
