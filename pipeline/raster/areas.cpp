// Takes shapes, gives the area that they share with pixels.
//
// Corners: an edge that runs up has its right side counted in every pixel beside it, one that runs down takes it away
// again; what is left in a pixel is the area of the shape there. The block is turned so that the longest edge is steep: in
// one row a steep edge crosses three pixels at most, and trapezia and triangles say what it leaves of them. Along any other
// the share of the pixel that lies to the right of it is a clamped line, whose mean over a stretch has a closed form.
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

/// The mean of unit_clamped between u0 and u1: `per_span` is 1 / (u1 - u0).
HWY_INLINE V mean_clamped(V u0, V u1, V per_span) {
  constexpr double steep_enough = 1e5;  // else rounding is larger than what is neglected
  const V mean = hn::Mul(hn::Sub(clamped_integral(u1), clamped_integral(u0)), per_span);
  const V middle = unit_clamped(hn::Mul(set(0.5), hn::Add(u0, u1)));
  // 1 beyond the edge, not what rounding makes of it.
  const auto simple = hn::Or(hn::Ge(hn::Min(u0, u1), set(1)), hn::Gt(hn::Abs(per_span), set(steep_enough)));
  return hn::IfThenElse(simple, middle, mean);
}

/// An edge that runs up, and how its right side counts; positions relative to the block.
struct Edge {
  Corner from, to;
  double sign, slope, bottom, top;

  HWY_INLINE Edge(const Corner& start, const Corner& end) : from(start), to(end), sign(start.y < end.y ? 1.0 : -1.0) {
    if (sign < 0) std::swap(from, to);
    slope = (to.x - from.x) / (to.y - from.y);
    bottom = HWY_MAX(from.y, 0.0);
    top = HWY_MIN(to.y, 8.0);
  }
  HWY_INLINE bool is_steep() const { return slope <= 1 && slope >= -1; }
};

/// Where an edge enters and leaves rows, one a lane; and their signed height.
struct Cuts {
  V height, x0, x1;

  HWY_INLINE Cuts(const Edge& edge, std::size_t row) {
    const V line = hn::Iota(D(), static_cast<double>(row)), bottom = set(edge.bottom), top = set(edge.top);
    const V y0 = hn::Min(hn::Max(line, bottom), top), y1 = hn::Max(hn::Min(hn::Add(line, set(1)), top), y0);
    const auto x_at = [&](V y) HWY_ATTR { return hn::Add(set(edge.from.x), hn::Mul(hn::Sub(y, set(edge.from.y)), set(edge.slope))); };
    height = hn::Mul(set(edge.sign), hn::Sub(y1, y0));
    x0 = x_at(y0);
    x1 = x_at(y1);
  }
};

/// What lies to the right of a steep edge: nothing of the pixels before `column`, `share` of that one, `next` of the one
/// after it, `height` of all others.
struct SteepShares {
  V column, share, next, height;

  SteepShares() = default;
  HWY_INLINE explicit SteepShares(const Cuts& cuts) : height(cuts.height) {
    const V left = hn::Min(cuts.x0, cuts.x1);
    column = hn::Floor(left);
    const V near = hn::Sub(left, column), far = hn::Sub(hn::Max(cuts.x0, cuts.x1), column);
    // Within one pixel the edge leaves a trapezium of it; else a triangle of the first, and all but a triangle of the next.
    const auto within = hn::Le(far, set(1));
    const V half_span = hn::Div(set(0.5), hn::IfThenElse(within, set(1), hn::Sub(far, near)));
    const V rest = hn::Sub(set(1), near), over = hn::Sub(far, set(1));
    const V part = hn::IfThenElse(within, hn::Sub(set(1), hn::Mul(set(0.5), hn::Add(near, far))), hn::Mul(hn::Mul(rest, rest), half_span));
    const V missing = hn::IfThenZeroElse(within, hn::Mul(hn::Mul(over, over), half_span));
    share = hn::Mul(height, part);
    next = hn::Mul(height, hn::Sub(set(1), missing));
  }
  HWY_INLINE V at(V pixel) const {
    const V beside = hn::IfThenElse(hn::Eq(pixel, hn::Add(column, set(1))), next, height);
    return hn::IfThenElseZero(hn::Ge(pixel, column), hn::IfThenElse(hn::Eq(pixel, column), share, beside));
  }
};

HWY_INLINE void add(V value, double* to) { hn::Store(hn::Add(hn::Load(D(), to), value), D(), to); }

/// Adds the area to the right of a steep edge: all rows at once, then row by row.
HWY_INLINE void add_steep(const Edge& edge, Areas& area) {
  const D d;
  alignas(64) double column[8], share[8], next[8], height[8];
  for (std::size_t row = 0; row < 8; row += hn::Lanes(d)) {
    const SteepShares shares(Cuts(edge, row));
    hn::Store(shares.column, d, column + row);
    hn::Store(shares.share, d, share + row);
    hn::Store(shares.next, d, next + row);
    hn::Store(shares.height, d, height + row);
  }
  for (auto row = static_cast<std::size_t>(edge.bottom); row < 8 && static_cast<double>(row) < edge.top; ++row) {
    SteepShares shares;
    shares.column = set(column[row]);
    shares.share = set(share[row]);
    shares.next = set(next[row]);
    shares.height = set(height[row]);
    for (std::size_t x = 0; x < 8; x += hn::Lanes(d)) {
      const auto left = static_cast<double>(x);
      if (column[row] >= left + static_cast<double>(hn::Lanes(d))) continue;
      const bool all_beyond = column[row] + 1 < left;
      add(all_beyond ? shares.height : shares.at(hn::Iota(d, left)), area.data() + 8 * row + x);
    }
  }
}

/// The same of any edge.
HWY_INLINE void add_flat(const Edge& edge, Areas& area) {
  const D d;
  const auto x_at = [&](double y) { return edge.from.x + (y - edge.from.y) * edge.slope; };
  for (int row = static_cast<int>(edge.bottom); row < 8 && row < edge.top; ++row) {
    const double y0 = HWY_MAX(edge.bottom, static_cast<double>(row)), y1 = HWY_MIN(edge.top, row + 1.0);
    const double below = x_at(y0), above = x_at(y1);
    if (below >= 8 && above >= 8) continue;  // nothing of the block lies beyond
    const V height = set(edge.sign * (y1 - y0)), x0 = set(below), x1 = set(above), per_span = set(1.0 / (below - above));
    for (std::size_t column = 0; column < 8; column += hn::Lanes(d)) {
      const V end = hn::Iota(d, static_cast<double>(column + 1));
      const V share = mean_clamped(hn::Sub(end, x0), hn::Sub(end, x1), per_span);
      add(hn::Mul(height, share), area.data() + 8 * static_cast<std::size_t>(row) + column);
    }
  }
}

/// Adds the area above an edge whose x and y have been exchanged: what are rows to it are the block's columns, its lanes.
HWY_INLINE void add_turned(const Edge& edge, Areas& area) {
  const D d;
  for (std::size_t x = 0; x < 8; x += hn::Lanes(d)) {
    const Cuts cuts(edge, x);
    if (edge.is_steep()) {
      const SteepShares shares(cuts);
      const double least = hn::GetLane(hn::MinOfLanes(d, shares.column)), most = hn::GetLane(hn::MaxOfLanes(d, shares.column));
      const int first = static_cast<int>(HWY_MIN(HWY_MAX(least, 0.0), 8.0)), behind = static_cast<int>(HWY_MIN(HWY_MAX(most + 2, 0.0), 8.0));
      for (int y = first; y < behind; ++y) add(shares.at(set(y)), area.data() + 8 * y + x);
      for (int y = behind; y < 8; ++y) add(shares.height, area.data() + 8 * y + x);
      continue;
    }
    const V per_span = hn::Div(set(1), hn::Sub(cuts.x0, cuts.x1));
    for (std::size_t y = 0; y < 8; ++y) {
      const V end = set(static_cast<double>(y + 1));
      add(hn::Mul(cuts.height, mean_clamped(hn::Sub(end, cuts.x0), hn::Sub(end, cuts.x1), per_span)), area.data() + 8 * y + x);
    }
  }
}

/// Whether the longest edge is wider than high.
HWY_INLINE bool is_flat(const SmoothShape& shape) {
  const auto magnitude = [](double value) { return value < 0 ? -value : value; };
  double width = 0, height = 0;
  const auto count = static_cast<std::size_t>(shape.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &from = shape.corner[i], &to = shape.corner[i + 1 < count ? i + 1 : 0];
    const double w = magnitude(to.x - from.x), h = magnitude(to.y - from.y);
    if (w + h <= width + height) continue;
    width = w;
    height = h;
  }
  return width > height;
}

void cover_corners(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  const D d;
  const bool turned = is_flat(shape);
  const auto corner = [&](std::size_t i) {
    const Corner at{shape.corner[i].x - x, shape.corner[i].y - y};
    return turned ? Corner{at.y, at.x} : at;
  };
  area.fill(0.0);
  const auto count = static_cast<std::size_t>(shape.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    const Corner from = corner(i), to = corner(i + 1 < count ? i + 1 : 0);
    if (from.y == to.y || !(HWY_MIN(from.y, to.y) < 8 && HWY_MAX(from.y, to.y) > 0)) continue;
    const Edge edge(from, to);
    if (turned) add_turned(edge, area);
    else if (edge.is_steep()) add_steep(edge, area);
    else add_flat(edge, area);
  }
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) hn::Store(hn::Abs(hn::Load(d, area.data() + lane)), d, area.data() + lane);
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

std::uint64_t shares(const SmoothShape& shape, std::int32_t x, std::int32_t y, std::array<float, 64>& coverage) {
  const D d;
  const hn::Rebind<float, D> df;
  Areas area;
  cover(shape, x, y, area);
  std::uint64_t covered = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const V share = hn::Load(d, area.data() + lane);
    hn::StoreU(hn::DemoteTo(df, hn::Min(share, set(1))), df, coverage.data() + lane);
    std::uint64_t bits = 0;
    hn::StoreMaskBits(d, hn::Ge(share, set(least_coverage)), reinterpret_cast<std::uint8_t*>(&bits));
    covered |= bits << lane;
  }
  return covered;
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

std::uint64_t shares_of(const SmoothShape& shape, std::int32_t x, std::int32_t y, std::array<float, 64>& coverage) {
  return GOURAUD_SIMD_PICK(shares)(shape, x, y, coverage);
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
