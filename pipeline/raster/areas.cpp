// Takes shapes, gives the area that they share with pixels.
//
// Corners: an edge that runs up has its left side counted in every pixel beside it, one that runs down takes it away
// again; what is left in a pixel is the area of the shape there. Along an edge the share of the pixel that lies to the
// right of it is a clamped line, whose mean over a stretch has a closed form.
// Discs: chords at the middle of strips, along whichever axis the circle is less steep on.
#include "pipeline/raster/areas.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/areas.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using V = hn::Vec<D>;
using Corner = SmoothShape::Corner;

HWY_INLINE V set(double value) { return hn::Set(D(), value); }
HWY_INLINE V unit_clamped(V value) { return hn::Min(hn::Max(value, hn::Zero(D())), set(1)); }

/// The integral of unit_clamped from 0 on.
HWY_INLINE V clamped_integral(V u) {
  const V inside = unit_clamped(u);
  return hn::Add(hn::Mul(hn::Mul(set(0.5), inside), inside), hn::Max(hn::Sub(u, set(1)), hn::Zero(D())));
}

/// The mean of unit_clamped between u0 and u1.
HWY_INLINE V mean_clamped(V u0, V u1) {
  constexpr double steep_enough = 1e-5;  // else rounding is larger than what is neglected
  const V span = hn::Sub(u1, u0);
  const V mean = hn::Div(hn::Sub(clamped_integral(u1), clamped_integral(u0)), span);
  const V middle = unit_clamped(hn::Mul(set(0.5), hn::Add(u0, u1)));
  return hn::IfThenElse(hn::Lt(hn::Abs(span), set(steep_enough)), middle, mean);
}

/// Adds the area to the right of an edge, signed by its direction; positions relative to the block.
HWY_INLINE void add_edge(Corner from, Corner to, Areas& area) {
  if (from.y == to.y) return;
  const double sign = from.y < to.y ? 1.0 : -1.0;
  if (sign < 0) std::swap(from, to);
  const double slope = (to.x - from.x) / (to.y - from.y);
  const double bottom = HWY_MAX(from.y, 0.0), top = HWY_MIN(to.y, 8.0);
  if (!(bottom < top)) return;
  const D d;
  const auto x_at = [&](double y) { return from.x + (y - from.y) * slope; };
  for (int row = static_cast<int>(bottom); row < 8 && row < top; ++row) {
    const double y0 = HWY_MAX(bottom, static_cast<double>(row)), y1 = HWY_MIN(top, row + 1.0);
    const double below = x_at(y0), above = x_at(y1);
    if (below >= 8 && above >= 8) continue;  // nothing of the block lies beyond
    const V height = set(sign * (y1 - y0)), x0 = set(below), x1 = set(above);
    for (std::size_t column = 0; column < 8; column += hn::Lanes(d)) {
      double* const pixels = area.data() + 8 * static_cast<std::size_t>(row) + column;
      const V end = hn::Iota(d, static_cast<double>(column + 1));
      const V share = hn::Mul(height, mean_clamped(hn::Sub(end, x0), hn::Sub(end, x1)));
      hn::Store(hn::Add(hn::Load(d, pixels), share), d, pixels);
    }
  }
}

void cover_corners(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  area.fill(0.0);
  const auto count = static_cast<std::size_t>(shape.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &from = shape.corner[i], &to = shape.corner[i + 1 < count ? i + 1 : 0];
    add_edge({from.x - x, from.y - y}, {to.x - x, to.y - y}, area);
  }
  for (double& a : area) a = a < 0 ? -a : a;
}

/// The share of the disc around (0, 0) in the unit square whose lower left corner is (x, y).
HWY_INLINE double disc_in_pixel(double x, double y, double radius) {
  constexpr std::size_t strips = 32;
  const auto magnitude = [](double value) { return value < 0 ? -value : value; };
  // Mirror, so that the square lies further up than to the right: strips are then cut where the circle is flat.
  x = magnitude(x + 0.5) - 0.5;
  y = magnitude(y + 0.5) - 0.5;
  if (x > y) std::swap(x, y);
  const double squared = radius * radius, far_x = x + 1.0, far_y = y + 1.0;
  const double near_x = HWY_MAX(x, 0.0), near_y = HWY_MAX(y, 0.0);
  if (far_x * far_x + far_y * far_y <= squared) return 1.0;
  if (near_x * near_x + near_y * near_y >= squared) return 0.0;
  // Strips of that part of the square's width over which the disc reaches into it.
  const double reach = std::sqrt(squared - near_y * near_y);
  const double left = HWY_MAX(x, -reach), width = HWY_MIN(far_x, reach) - left;
  const D d;
  alignas(64) double heights[strips];
  for (std::size_t strip = 0; strip < strips; strip += hn::Lanes(d)) {
    const V middle = hn::Div(hn::Iota(d, static_cast<double>(strip) + 0.5), set(strips));
    const V at = hn::Add(set(left), hn::Mul(set(width), middle));
    const V half_chord = hn::Sqrt(hn::Max(hn::Sub(set(squared), hn::Mul(at, at)), hn::Zero(d)));
    const V height = hn::Sub(hn::Min(set(far_y), half_chord), hn::Max(set(y), hn::Neg(half_chord)));
    hn::Store(hn::Max(height, hn::Zero(d)), d, heights + strip);
  }
  double area = 0;
  for (const double height : heights) area += height;
  return area * width / static_cast<double>(strips);
}

void cover_disc(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  const Corner& center = shape.corner[0];
  for (std::size_t lane = 0; lane < 64; ++lane) {
    const double left = x + static_cast<double>(lane % 8) - center.x, bottom = y + static_cast<double>(lane / 8) - center.y;
    area[lane] = disc_in_pixel(left, bottom, shape.radius);
  }
}

void cover(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  shape.corner_count == 0 ? cover_disc(shape, x, y, area) : cover_corners(shape, x, y, area);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
namespace {

using Corner = SmoothShape::Corner;

/// Calls visit(from, to) for the edges of a shape with corners.
template <class Visit>
void for_each_edge(const SmoothShape& shape, Visit visit) {
  const auto count = static_cast<std::size_t>(shape.corner_count);
  for (std::size_t i = 0; i < count; ++i) visit(shape.corner[i], shape.corner[i + 1 < count ? i + 1 : 0]);
}

}  // namespace

void areas_of(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  GOURAUD_SIMD_PICK(cover)(shape, x, y, area);
}

Stretch stretch_of(const SmoothShape& shape, std::int32_t y) {
  if (shape.corner_count == 0) return {shape.corner[0].x - shape.radius, shape.corner[0].x + shape.radius};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Stretch stretch{infinity, -infinity};
  const auto include = [&](double x) {
    stretch.x0 = std::min(stretch.x0, x);
    stretch.x1 = std::max(stretch.x1, x);
  };
  // The ends of that part of each edge which lies between; cut inside the edge's own range.
  for_each_edge(shape, [&](Corner from, Corner to) {
    if (from.y > to.y) std::swap(from, to);
    const double bottom = y, top = y + 8.0;
    if (to.y < bottom || from.y > top) return;
    const auto x_at = [&](double at) { return from.x + (to.x - from.x) * ((at - from.y) / (to.y - from.y)); };
    include(from.y < bottom ? x_at(bottom) : from.x);
    include(to.y > top ? x_at(top) : to.x);
  });
  return stretch;
}

BlockPlace place_of_block(const SmoothShape& shape, std::int32_t x, std::int32_t y) {
  if (shape.corner_count == 0) return BlockPlace::crossed;
  // Of each edge's function over the block the least and the largest value, with what rounding may do to them.
  bool all_left = true, all_right = true, beyond_left = false, beyond_right = false;
  for_each_edge(shape, [&](Corner from, Corner to) {
    const double dx = to.x - from.x, dy = to.y - from.y, reach = 4.0 * (std::abs(dx) + std::abs(dy));
    const double middle = dx * (y + 4.0 - from.y) - dy * (x + 4.0 - from.x), slack = reach * 1e-9;
    all_left &= middle - reach > slack;
    all_right &= middle + reach < -slack;
    beyond_right |= middle + reach < -slack;
    beyond_left |= middle - reach > slack;
  });
  if (all_left || all_right) return BlockPlace::inside;
  // Which side is the inner one, the corners do not tell: outside is what lies wholly beyond some edge on either.
  double twice_area = 0;
  for_each_edge(shape, [&](Corner from, Corner to) { twice_area += from.x * to.y - to.x * from.y; });
  return (twice_area > 0 ? beyond_right : beyond_left) ? BlockPlace::outside : BlockPlace::crossed;
}

}  // namespace gouraud::pipeline
#endif
