// Planes of depth and colour for records of several primitives, one a lane: included inside a kernel file, once per
// instruction set. Triangles and lines differ in their basis alone; see planes.h for the scalar form.
//
// What lanes have computed goes into the records by transposing: four values of every lane at a time, so that a record
// takes them in one piece.
#include <hwy/highway.h>

#include "pipeline/raster/triangle_lanes-inl.h"

#if defined(GOURAUD_PIPELINE_RASTER_PLANE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_RASTER_PLANE_LANES_INL_H_
#undef GOURAUD_PIPELINE_RASTER_PLANE_LANES_INL_H_
#else
#define GOURAUD_PIPELINE_RASTER_PLANE_LANES_INL_H_
#endif

#include <cstddef>
#include <cstring>
#include <limits>

#include "pipeline/raster/planes.h"
#include "pipeline/raster/record_group.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

using Lanes = RecordGroup::Lanes;
static_assert(max_lanes <= group_capacity);

/// The four floats of one struct a lane, widened.
struct Quad {
  V x, y, z, w;
};
HWY_INLINE Quad widened(const FloatQuad& q) {
  const D d;
  return {hn::PromoteTo(d, q.x), hn::PromoteTo(d, q.y), hn::PromoteTo(d, q.z), hn::PromoteTo(d, q.w)};
}

/// Four doubles or floats of each lane, one lane behind the other.
struct alignas(64) DoubleRows {
  double row[max_lanes][4];
};
struct alignas(64) FloatRows {
  float row[max_lanes][4];
};
HWY_INLINE void transpose(V a, V b, V c, V e, DoubleRows& out) { hn::StoreInterleaved4(a, b, c, e, D(), out.row[0]); }
HWY_INLINE void transpose(const V (&v)[4], FloatRows& out) {
  const F f;
  const auto narrow = [&](V x) HWY_ATTR { return hn::DemoteTo(f, x); };
  hn::StoreInterleaved4(narrow(v[0]), narrow(v[1]), narrow(v[2]), narrow(v[3]), f, out.row[0]);
}

/// A plane a lane, and how it is made; see planes.h for the scalar form.
struct Basis {
  V x0, y0, first_x, first_y, second_x, second_y;
};
struct PlaneLanes {
  V origin, dx, dy;
};
HWY_INLINE PlaneLanes make_plane(const Basis& basis, V value0, V rise1, V rise2) {
  const V dx = hn::Add(hn::Mul(basis.first_x, rise1), hn::Mul(basis.second_x, rise2));
  const V dy = hn::Add(hn::Mul(basis.first_y, rise1), hn::Mul(basis.second_y, rise2));
  const V half = set(0.5);
  const V back = hn::Add(hn::Mul(dx, hn::Sub(basis.x0, half)), hn::Mul(dy, hn::Sub(basis.y0, half)));
  return {hn::Sub(value0, back), dx, dy};
}
HWY_INLINE V slope(const PlaneLanes& plane) { return hn::Add(hn::Abs(plane.dx), hn::Abs(plane.dy)); }

/// Lanes [first, first + Lanes) of a group: the same four floats of vertex i, its window position or its colour.
template <class Part>
HWY_INLINE FloatQuad load_vertices(const RecordGroup& group, std::size_t first, std::size_t i, Part KeptVertex::*part) {
  static_assert(sizeof(Part) == 4 * sizeof(float));
  const KeptVertex* const* const vertices = group.vertex[i].data() + first;
  return load_quads(F(), [&](std::size_t lane) HWY_ATTR { return reinterpret_cast<const float*>(&(vertices[lane]->*part)); });
}

/// The plane of depth, in buffer units, and the range of the vertices.
struct DepthLanes {
  PlaneLanes plane;
  hn::Vec<F> minimum, maximum;
  std::uint64_t steep;
};
HWY_INLINE DepthLanes depth_of(const Basis& basis, const V (&window_z)[3], const PlaneTargets& targets) {
  V z[3];
  for (std::size_t i = 0; i < 3; ++i) {
    z[i] = hn::Mul(hn::Min(hn::Max(window_z[i], hn::Zero(D())), set(1)), set(targets.depth_scale));
  }
  const PlaneLanes plane = make_plane(basis, z[0], hn::Sub(z[1], z[0]), hn::Sub(z[2], z[0]));
  return {plane, hn::DemoteTo(F(), least(z[0], z[1], z[2])), hn::DemoteTo(F(), most(z[0], z[1], z[2])),
          bits_of(hn::Gt(slope(plane), set(steep_slope(targets))))};
}

HWY_INLINE void set_up_depth(const Basis& basis, const V (&window_z)[3], const RecordGroup& group, std::size_t first,
                             std::size_t count) {
  const D d;
  const DepthLanes depth_lanes = depth_of(basis, window_z, group.state->targets);
  const PlaneLanes& plane = depth_lanes.plane;
  // Both ends of the range are floats: together they are as long as a double.
  const hn::RebindToUnsigned<D> bits;
  const auto word = [&](hn::Vec<F> value) HWY_ATTR { return hn::PromoteTo(bits, hn::BitCast(hn::RebindToUnsigned<F>(), value)); };
  const V range = hn::BitCast(d, hn::Or(word(depth_lanes.minimum), hn::ShiftLeft<32>(word(depth_lanes.maximum))));
  DoubleRows rows;
  transpose(plane.origin, plane.dx, plane.dy, range, rows);
  static_assert(offsetof(DepthPlane, dx) == 8 && offsetof(DepthPlane, dy) == 16 && offsetof(DepthPlane, minimum) == 24 &&
                offsetof(DepthPlane, maximum) == 28);
  for (std::size_t lane = 0; lane < count; ++lane) {
    DepthPlane& depth = group.record(first + lane).depth;
    std::memcpy(static_cast<void*>(&depth), rows.row[lane], sizeof rows.row[lane]);
    depth.steep = (depth_lanes.steep >> lane & 1) != 0;
  }
}

/// 1/w of the vertices, relative to the largest; all 1 where they are equal.
struct Weights {
  Mask perspective;
  V q[3];
  PlaneLanes plane;
  V lowest;
};
HWY_INLINE Weights weigh(const Basis& basis, const V (&inverse_w)[3]) {
  Weights w;
  w.perspective = hn::Or(hn::Ne(inverse_w[0], inverse_w[1]), hn::Ne(inverse_w[0], inverse_w[2]));
  const V largest = hn::Div(set(1), most(inverse_w[0], inverse_w[1], inverse_w[2]));
  for (std::size_t i = 0; i < 3; ++i) w.q[i] = hn::IfThenElse(w.perspective, hn::Mul(inverse_w[i], largest), set(1));
  w.plane = make_plane(basis, w.q[0], hn::Sub(w.q[1], w.q[0]), hn::Sub(w.q[2], w.q[0]));
  w.lowest = least(w.q[0], w.q[1], w.q[2]);
  return w;
}

/// Planes of the colours of the lanes whose bit is set, or under perspective of their distance from vertex 0 weighted by
/// 1/w; see planes.cpp. Returns the lanes whose planes are finite.
HWY_INLINE std::uint64_t set_up_colors(const Basis& basis, const Weights& weights, const RecordGroup& group, std::size_t first,
                              std::uint64_t lanes) {
  const D d;
  const SetupState& state = *group.state;
  const V one = set(1), scale = set(state.targets.color_scale);
  const Mask perspective = weights.perspective;
  const V (&q)[3] = weights.q;

  FloatQuad floats[3];
  Quad c[3];
  for (std::size_t i = 0; i < 3; ++i) {
    floats[i] = load_vertices(group, first, i, &KeptVertex::color);
    c[i] = widened(floats[i]);
  }
  const auto differ = [&](V c0, V c1, V c2) HWY_ATTR { return hn::Or(hn::Ne(c0, c1), hn::Ne(c0, c2)); };
  const Mask varies = hn::Or(hn::Or(differ(c[0].x, c[1].x, c[2].x), differ(c[0].y, c[1].y, c[2].y)),
                             hn::Or(differ(c[0].z, c[1].z, c[2].z), differ(c[0].w, c[1].w, c[2].w)));
  const std::uint64_t varying = bits_of(varies);
  if ((varying & lanes) == 0) {  // where no light falls
    for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
      const std::size_t i = first + static_cast<std::size_t>(__builtin_ctzll(left));
      make_constant_color(group.vertex[0][i]->color, state.targets, group.color(i));
    }
    return lanes;
  }
  V worst = hn::Zero(d);
  Mask over_one = hn::Lt(one, one);
  PlaneLanes plane[4];
  V minimum[4], maximum[4];
  const auto channel = [&](std::size_t k, V c0, V c1, V c2) HWY_ATTR {
    const V rise1 = hn::Mul(hn::Mul(hn::Sub(c1, c0), q[1]), scale), rise2 = hn::Mul(hn::Mul(hn::Sub(c2, c0), q[2]), scale);
    const V start = hn::IfThenElse(perspective, hn::Zero(d), hn::Mul(c0, scale));
    plane[k] = make_plane(basis, start, rise1, rise2);
    const V high = most(c0, c1, c2);
    minimum[k] = hn::Mul(hn::Min(least(c0, c1, c2), one), scale);
    maximum[k] = hn::Mul(hn::Min(high, one), scale);
    over_one = hn::Or(over_one, hn::Gt(high, one));
    worst = hn::Max(worst, slope(plane[k]));
  };
  channel(0, c[0].x, c[1].x, c[2].x);
  channel(1, c[0].y, c[1].y, c[2].y);
  channel(2, c[0].z, c[1].z, c[2].z);
  channel(3, c[0].w, c[1].w, c[2].w);

  const V overshoot =
      hn::Div(hn::Mul(hn::Add(hn::Div(worst, scale), slope(weights.plane)), set(snap_overshoot)), weights.lowest);
  const std::uint64_t in_perspective = bits_of(perspective);
  const std::uint64_t clamp = bits_of(over_one) | ~bits_of(hn::Lt(overshoot, set(harmless_overshoot)));

  DoubleRows origin, dx, dy, inverse_w;
  FloatRows low, high, base;
  transpose(plane[0].origin, plane[1].origin, plane[2].origin, plane[3].origin, origin);
  transpose(plane[0].dx, plane[1].dx, plane[2].dx, plane[3].dx, dx);
  transpose(plane[0].dy, plane[1].dy, plane[2].dy, plane[3].dy, dy);
  transpose(weights.plane.origin, weights.plane.dx, weights.plane.dy, weights.lowest, inverse_w);
  transpose(minimum, low);
  transpose(maximum, high);
  const F f;
  const auto scale_f = hn::Set(f, state.targets.color_scale);
  hn::StoreInterleaved4(hn::Mul(floats[0].x, scale_f), hn::Mul(floats[0].y, scale_f), hn::Mul(floats[0].z, scale_f),
                        hn::Mul(floats[0].w, scale_f), f, base.row[0]);
  for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
    ColorRecord& out = group.color(first + lane);
    if ((varying >> lane & 1) == 0) {
      make_constant_color(group.vertex[0][first + lane]->color, state.targets, out);
      continue;
    }
    std::memcpy(out.origin.data(), origin.row[lane], sizeof out.origin);
    std::memcpy(out.dx.data(), dx.row[lane], sizeof out.dx);
    std::memcpy(out.dy.data(), dy.row[lane], sizeof out.dy);
    out.inverse_w_origin = inverse_w.row[lane][0];
    out.inverse_w_dx = inverse_w.row[lane][1];
    out.inverse_w_dy = inverse_w.row[lane][2];
    std::memcpy(out.base.data(), base.row[lane], sizeof out.base);
    std::memcpy(out.minimum.data(), low.row[lane], sizeof out.minimum);
    std::memcpy(out.maximum.data(), high.row[lane], sizeof out.maximum);
    out.inverse_w_minimum = static_cast<float>(inverse_w.row[lane][3]);
    out.inverse_w_maximum = 1.0f;
    out.variation = (in_perspective >> lane & 1) != 0 ? ColorVariation::perspective : ColorVariation::affine;
    out.clamp = (clamp >> lane & 1) != 0;
  }
  return bits_of(hn::Lt(overshoot, set(std::numeric_limits<double>::infinity())));
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
