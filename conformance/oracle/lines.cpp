// Lines of width 1 by the diamond-exit rule as it is written, and points of size 1 [GL1.5 §3.3.1, §3.4.1].
//
// In the coordinates u = x + y, v = x - y a diamond is a square: |u - uf| < 1/2 and |v - vf| < 1/2. The line is moved
// by
// (-e, -e^2), so u by -(e + e^2) and v by -(e - e^2), for an e smaller than any other number. The times at which it is
// between the square's sides form an open interval for u and one for v; it meets the square if both overlap within
// [0, 1]. Times are exact: (n + e1 e + e2 e^2) / d.
#include <algorithm>
#include <cmath>

#include "conformance/oracle/rasterize.h"

namespace gouraud::oracle {
namespace {

/// (n + e1 e + e2 e^2) / d with d > 0 and e infinitely small.
struct Time {
  Integer n = 0, e1 = 0, e2 = 0, d = 1;
};

bool operator<(const Time& a, const Time& b) {
  const Integer difference_n = a.n * b.d - b.n * a.d;
  if (difference_n != 0) return difference_n < 0;
  const Integer difference_e1 = a.e1 * b.d - b.e1 * a.d;
  if (difference_e1 != 0) return difference_e1 < 0;
  return a.e2 * b.d < b.e2 * a.d;
}

struct Interval {
  Time begin, end;  ///< open
  bool empty = false;
};

constexpr Time before_all{-1, 0, 0, 1}, after_all{2, 0, 0, 1};

/// When position + time * direction - (e + sign e^2) is between -half and half.
Interval time_inside(Integer position, Integer direction, int sign, Integer half) {
  if (direction == 0) {
    const bool inside = position > -half && position <= half;  // less an infinitely small amount
    return {before_all, after_all, !inside};
  }
  // time = (side - position + e + sign e^2) / direction for the two sides.
  const Integer s = direction > 0 ? 1 : -1;
  const auto time_at = [&](Integer side) { return Time{s * (side - position), s, s * sign, s * direction}; };
  return direction > 0 ? Interval{time_at(-half), time_at(half)} : Interval{time_at(half), time_at(-half)};
}

bool contains_end(Integer u, Integer v, Integer half) {
  return u > -half && u <= half && v > -half && v <= half;
}

/// The line's colour where it is t of the way [GL1.5 §3.4.1 eq 3.4]. With t beyond the ends the weights' sum may
/// vanish: the nearer end's colour then.
Color color_at(const std::array<WindowVertex, 2>& ends, const std::array<Color, 2>& colors, double t) {
  const double weight_a = (1 - t) * ends[0].w_inverse, weight_b = t * ends[1].w_inverse, sum = weight_a + weight_b;
  if (sum <= 0) return colors[t < 0.5 ? 0 : 1];
  Color out;
  for (std::size_t i = 0; i < 4; ++i) {
    const double a = colors[0][i], b = colors[1][i];
    out[i] = a == b ? a : (weight_a * a + weight_b * b) / sum;
  }
  return out;
}

/// Centres before the start or behind the end have, as the equations say, colours beyond those of the end points. In
/// perspective they may be far beyond: legal is all from there to the end's own colour (PixelFlags), or any colour of
/// the line if the equation has none.
void bound_extrapolation(const std::array<WindowVertex, 2>& ends, const std::array<Color, 2>& colors, double t,
                         Fragment& fragment) {
  fragment.extrapolated = true;
  const bool beyond_horizon = (1 - t) * ends[0].w_inverse + t * ends[1].w_inverse <= 0;
  const Color& end = colors[t < 0.5 ? 0 : 1];
  const Color& other = beyond_horizon ? colors[t < 0.5 ? 1 : 0] : fragment.color;
  for (std::size_t i = 0; i < 4; ++i) {
    fragment.color_lowest[i] = std::min(end[i], other[i]);
    fragment.color_highest[i] = std::max(end[i], other[i]);
  }
}

/// Colour and depth of the line at a pixel's centre [GL1.5 §3.4.1 eqs 3.3-3.5].
void make_fragment(const FragmentSink& sink, const std::array<WindowVertex, 2>& ends, int x, int y) {
  const auto& [a, b] = ends;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared_length = dx * dx + dy * dy;
  const double t = squared_length > 0 ? ((x + 0.5 - a.x) * dx + (y + 0.5 - a.y) * dy) / squared_length : 0.0;

  Fragment fragment;
  fragment.x = x;
  fragment.y = y;
  const std::array<Color, 2> colors{color_of(sink, sink.flat_colors ? *sink.flat_colors : a.colors),
                                    color_of(sink, sink.flat_colors ? *sink.flat_colors : b.colors)};
  fragment.color = fragment.color_lowest = fragment.color_highest = color_at(ends, colors, t);
  if ((t < 0 || t > 1) && a.w_inverse != b.w_inverse) bound_extrapolation(ends, colors, t, fragment);
  fragment.depth = a.z == b.z ? a.z : (1 - t) * a.z + t * b.z;
  const double slack = a.z == b.z ? 0.0 : sink.depth_slack;
  fragment.depth_lowest = fragment.depth - slack;
  fragment.depth_highest = fragment.depth + slack;
  write_fragment(*sink.picture, sink.state, fragment);
}

}  // namespace

bool exits_diamond(const SubpixelPoint& a, const SubpixelPoint& b, int x, int y, int subpixel_bits) {
  const Integer half = Integer{1} << (subpixel_bits - 1);
  const Integer ax = a.x - (std::int64_t{x} << subpixel_bits), ay = a.y - (std::int64_t{y} << subpixel_bits);
  const Integer bx = b.x - (std::int64_t{x} << subpixel_bits), by = b.y - (std::int64_t{y} << subpixel_bits);
  if (contains_end(bx + by, bx - by, half)) return false;
  const Interval u = time_inside(ax + ay, (bx + by) - (ax + ay), +1, half);
  const Interval v = time_inside(ax - ay, (bx - by) - (ax - ay), -1, half);
  if (u.empty || v.empty) return false;
  const Time begin = std::max(u.begin, v.begin), end = std::min(u.end, v.end);
  return begin < end && begin < Time{1, 0, 0, 1} && Time{0, 0, 0, 1} < end;
}

void rasterize_line(const FragmentSink& sink, const std::array<WindowVertex, 2>& vertices) {
  const SubpixelPoint &a = vertices[0].snapped, &b = vertices[1].snapped;
  if (a == b) return;
  // Walk the columns (rows, if the line is steep) and ask the five pixels around the line in each.
  const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
  const double unit = std::ldexp(1.0, -sink.subpixel_bits);
  const double major_a = static_cast<double>(steep ? a.y : a.x) * unit,
               minor_a = static_cast<double>(steep ? a.x : a.y) * unit;
  const double major_b = static_cast<double>(steep ? b.y : b.x) * unit,
               minor_b = static_cast<double>(steep ? b.x : b.y) * unit;
  const double slope = (minor_b - minor_a) / (major_b - major_a);
  const pipeline::PixelRect& box = sink.state.scissor;
  const double box_begin = steep ? box.y0 : box.x0, box_end = steep ? box.y1 : box.x1;
  const int first = static_cast<int>(std::max(std::floor(std::min(major_a, major_b)) - 1, box_begin));
  const int last = static_cast<int>(std::min(std::ceil(std::max(major_a, major_b)) + 1, box_end - 1));
  for (int major = first; major <= last; ++major) {
    const auto middle = static_cast<int>(std::lround(minor_a + slope * (major - major_a)));
    for (int minor = middle - 2; minor <= middle + 2; ++minor) {
      const int x = steep ? minor : major, y = steep ? major : minor;
      if (exits_diamond(a, b, x, y, sink.subpixel_bits)) make_fragment(sink, vertices, x, y);
    }
  }
}

std::array<int, 2> pixel_of_point(double x, double y, int subpixel_bits) {
  const double subpixels = std::ldexp(1.0, subpixel_bits);
  const double snapped_x = std::floor(x * subpixels + 0.5), snapped_y = std::ceil(y * subpixels - 0.5);
  return {static_cast<int>(std::floor(snapped_x / subpixels)), static_cast<int>(std::floor(snapped_y / subpixels))};
}

void rasterize_point(const FragmentSink& sink, const WindowVertex& vertex) {
  const auto [x, y] = pixel_of_point(vertex.x, vertex.y, sink.subpixel_bits);
  Fragment fragment;
  fragment.x = x;
  fragment.y = y;
  fragment.color = color_of(sink, sink.flat_colors ? *sink.flat_colors : vertex.colors);
  fragment.color_lowest = fragment.color_highest = fragment.color;
  fragment.depth = fragment.depth_lowest = fragment.depth_highest = vertex.z;
  write_fragment(*sink.picture, sink.state, fragment);
}

}  // namespace gouraud::oracle
