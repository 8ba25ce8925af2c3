// Triangles [GL1.5 §3.5.1], several at a time, one a lane, in two steps: select those that draw something, and set up
// edges and planes. Facing and culling use the area of the snapped triangle, coverage its edge functions; planes use
// the unsnapped positions. Window y comes from the top (y_raster), is snapped
// there, and turned over. All arithmetic on snapped positions is exact: integers below 2^53, held in doubles.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "pipeline/raster/setup.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/triangle_setup.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, 8>;
using F = hn::Rebind<float, D>;
using V = hn::Vec<D>;
using Mask = hn::Mask<D>;
constexpr std::size_t max_lanes = 8;
using Lanes = double[max_lanes];

HWY_INLINE V set(double value) { return hn::Set(D(), value); }
HWY_INLINE V least(V a, V b, V c) { return hn::Min(hn::Min(a, b), c); }
HWY_INLINE V most(V a, V b, V c) { return hn::Max(hn::Max(a, b), c); }

/// The four floats of one struct a lane, widened.
struct Quad {
  V x, y, z, w;
};
HWY_INLINE Quad load_quad(const float* floats) {
  const F f;
  hn::Vec<F> x, y, z, w;
  hn::LoadInterleaved4(f, floats, x, y, z, w);
  const D d;
  return {hn::PromoteTo(d, x), hn::PromoteTo(d, y), hn::PromoteTo(d, z), hn::PromoteTo(d, w)};
}

/// Nearest 1/256 pixel, ties to even, rounded in float as MESA-RULES 3 says.
HWY_INLINE V snap(V coordinate) {
  const F f;
  const auto shifted = hn::Sub(hn::DemoteTo(f, coordinate), hn::Set(f, 0.5f));
  return hn::PromoteTo(D(), hn::Round(hn::Mul(shifted, hn::Set(f, static_cast<float>(subpixels)))));
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

/// What setup has computed, an array of lanes each: the way from vectors into records.
struct alignas(64) Results {
  Lanes edge_c[3], edge_a[3], edge_b[3];
  Lanes z_origin, z_dx, z_dy, z_minimum, z_maximum;
  Lanes origin[5], dx[5], dy[5];
  Lanes minimum[4], maximum[4], inverse_w_minimum;
  std::uint64_t steep, constant, perspective, clamp;
};

HWY_INLINE std::uint64_t bits_of(Mask mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(D(), mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}

/// Positions in 1/256 pixel, y up, and twice the area: integers.
struct SnappedTriangles {
  V x[3], y[3], area;
};

/// `corners` holds the WindowVertices: first all vertices 0, then 1, then 2, max_lanes apart.
HWY_INLINE SnappedTriangles snap_triangles(const Quad (&corners)[3], std::int32_t target_height) {
  SnappedTriangles p;
  for (std::size_t i = 0; i < 3; ++i) {
    p.x[i] = snap(corners[i].x);
    p.y[i] = hn::Sub(set((target_height - 1.0) * subpixels), snap(corners[i].y));
  }
  p.area = hn::Sub(hn::Mul(hn::Sub(p.x[1], p.x[0]), hn::Sub(p.y[2], p.y[0])),
                   hn::Mul(hn::Sub(p.x[2], p.x[0]), hn::Sub(p.y[1], p.y[0])));
  return p;
}

/// What the selection finds out.
struct alignas(64) Selection {
  Lanes x0, y0, x1, y1;
  std::uint64_t alive, front, scissored;
};

/// Facing, culling and the box.
HWY_INLINE void select(const SetupState& state, const SnappedTriangles& p, Selection& out) {
  const D d;
  // Reject what no sample can hit; of smooth triangles, what no pixel can touch (snapping moved it by half a step).
  const V to_pixels = set(1.0 / subpixels), reach = set(state.polygons.smooth ? 0.5 * subpixels + 1 : 0.0);
  const auto first = [&](V low) HWY_ATTR { return hn::Ceil(hn::Mul(hn::Sub(low, reach), to_pixels)); };
  const auto end = [&](V high) HWY_ATTR { return hn::Add(hn::Floor(hn::Mul(hn::Add(high, reach), to_pixels)), set(1)); };
  const V x0 = first(least(p.x[0], p.x[1], p.x[2])), y0 = first(least(p.y[0], p.y[1], p.y[2]));
  const V x1 = end(most(p.x[0], p.x[1], p.x[2])), y1 = end(most(p.y[0], p.y[1], p.y[2]));
  const V cut_x0 = hn::Max(x0, set(state.scissor.x0)), cut_y0 = hn::Max(y0, set(state.scissor.y0));
  const V cut_x1 = hn::Min(x1, set(state.scissor.x1)), cut_y1 = hn::Min(y1, set(state.scissor.y1));
  hn::Store(cut_x0, d, out.x0);
  hn::Store(cut_y0, d, out.y0);
  hn::Store(cut_x1, d, out.x1);
  hn::Store(cut_y1, d, out.y1);
  out.scissored = bits_of(hn::Or(hn::Or(hn::Ne(x0, cut_x0), hn::Ne(y0, cut_y0)), hn::Or(hn::Ne(x1, cut_x1), hn::Ne(y1, cut_y1))));

  // Decide facing, cull.
  const V zero = hn::Zero(d);
  const std::uint64_t ccw = bits_of(hn::Gt(p.area, zero));
  out.front = state.front_face == FrontFace::ccw ? ccw : ~ccw;
  out.alive = bits_of(hn::And(hn::And(hn::Lt(cut_x0, cut_x1), hn::Lt(cut_y0, cut_y1)), hn::Ne(p.area, zero)));
  if (is_culled(state.cull, true)) out.alive &= ~out.front;
  if (is_culled(state.cull, false)) out.alive &= out.front;
}

/// Edge functions, positive inside. Left edges and horizontal bottom edges own the samples on them; the others lose
/// them by one unit (MESA-RULES 3). At pixel (i, j): 256 a i + 256 b j + c >= 0, which floor(c / 256) does not change.
HWY_INLINE void set_up_edges(const SnappedTriangles& p, Results& out) {
  const D d;
  const V zero = hn::Zero(d), one = set(1);
  const V sign = hn::IfThenElse(hn::Gt(p.area, zero), one, set(-1));
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    const V a = hn::Mul(sign, hn::Sub(p.y[from], p.y[to])), b = hn::Mul(sign, hn::Sub(p.x[to], p.x[from]));
    const Mask owns = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
    const V c = hn::Sub(hn::Neg(hn::Add(hn::Mul(a, p.x[from]), hn::Mul(b, p.y[from]))), hn::IfThenElse(owns, zero, one));
    hn::Store(a, d, out.edge_a[from]);
    hn::Store(b, d, out.edge_b[from]);
    hn::Store(hn::Floor(hn::Mul(c, set(1.0 / subpixels))), d, out.edge_c[from]);
  }
}

HWY_INLINE void set_up_depth(const SetupState& state, const Basis& basis, const V (&window_z)[3],
                             Results& out) {
  const D d;
  V z[3];
  for (std::size_t i = 0; i < 3; ++i) {
    z[i] = hn::Mul(hn::Min(hn::Max(window_z[i], hn::Zero(d)), set(1)), set(state.targets.depth_scale));
  }
  const PlaneLanes plane = make_plane(basis, z[0], hn::Sub(z[1], z[0]), hn::Sub(z[2], z[0]));
  hn::Store(plane.origin, d, out.z_origin);
  hn::Store(plane.dx, d, out.z_dx);
  hn::Store(plane.dy, d, out.z_dy);
  hn::Store(least(z[0], z[1], z[2]), d, out.z_minimum);
  hn::Store(most(z[0], z[1], z[2]), d, out.z_maximum);
  out.steep = bits_of(hn::Gt(slope(plane), set(steep_slope(state.targets))));
}

/// 1/w of the vertices, relative to the largest; all 1 where they are equal.
struct Weights {
  Mask perspective;
  V q[3];
  PlaneLanes plane;
  V lowest;
};
HWY_INLINE Weights weigh(const Basis& basis, const V (&inverse_w)[3], Results& out) {
  const D d;
  Weights w;
  w.perspective = hn::Or(hn::Ne(inverse_w[0], inverse_w[1]), hn::Ne(inverse_w[0], inverse_w[2]));
  const V largest = hn::Div(set(1), most(inverse_w[0], inverse_w[1], inverse_w[2]));
  for (std::size_t i = 0; i < 3; ++i) w.q[i] = hn::IfThenElse(w.perspective, hn::Mul(inverse_w[i], largest), set(1));
  w.plane = make_plane(basis, w.q[0], hn::Sub(w.q[1], w.q[0]), hn::Sub(w.q[2], w.q[0]));
  w.lowest = least(w.q[0], w.q[1], w.q[2]);
  hn::Store(w.plane.origin, d, out.origin[ColorRecord::inverse_w]);
  hn::Store(w.plane.dx, d, out.dx[ColorRecord::inverse_w]);
  hn::Store(w.plane.dy, d, out.dy[ColorRecord::inverse_w]);
  hn::Store(w.lowest, d, out.inverse_w_minimum);
  out.perspective = bits_of(w.perspective);
  return w;
}

/// Planes of the colours, or under perspective of their distance from vertex 0 weighted by 1/w; see planes.cpp.
HWY_INLINE void set_up_colors(const SetupState& state, const Basis& basis, const Weights& weights, const float* colors,
                              Results& out) {
  const D d;
  const V one = set(1), scale = set(state.targets.color_scale);
  const Mask perspective = weights.perspective;
  const V (&q)[3] = weights.q;

  V worst = hn::Zero(d);
  Mask varies = hn::Lt(one, one), over_one = varies;
  const Quad c[3] = {load_quad(colors), load_quad(colors + 4 * max_lanes), load_quad(colors + 8 * max_lanes)};
  const auto channel = [&](std::size_t k, V c0, V c1, V c2) HWY_ATTR {
    const V rise1 = hn::Mul(hn::Mul(hn::Sub(c1, c0), q[1]), scale), rise2 = hn::Mul(hn::Mul(hn::Sub(c2, c0), q[2]), scale);
    const V start = hn::IfThenElse(perspective, hn::Zero(d), hn::Mul(c0, scale));
    const PlaneLanes plane = make_plane(basis, start, rise1, rise2);
    hn::Store(plane.origin, d, out.origin[k]);
    hn::Store(plane.dx, d, out.dx[k]);
    hn::Store(plane.dy, d, out.dy[k]);
    const V high = most(c0, c1, c2);
    hn::Store(hn::Mul(hn::Min(least(c0, c1, c2), one), scale), d, out.minimum[k]);
    hn::Store(hn::Mul(hn::Min(high, one), scale), d, out.maximum[k]);
    over_one = hn::Or(over_one, hn::Gt(high, one));
    varies = hn::Or(varies, hn::Or(hn::Ne(c0, c1), hn::Ne(c0, c2)));
    worst = hn::Max(worst, slope(plane));
  };
  channel(0, c[0].x, c[1].x, c[2].x);
  channel(1, c[0].y, c[1].y, c[2].y);
  channel(2, c[0].z, c[1].z, c[2].z);
  channel(3, c[0].w, c[1].w, c[2].w);

  const V overshoot =
      hn::Div(hn::Mul(hn::Add(hn::Div(worst, scale), slope(weights.plane)), set(snap_overshoot)), weights.lowest);
  out.constant = ~bits_of(varies);
  out.clamp = bits_of(over_one) | ~bits_of(hn::Lt(overshoot, set(harmless_overshoot)));
}

HWY_INLINE void write_color(const SetupState& state, const Results& in, std::size_t lane, const float* colors, ColorRecord& out) {
  const float* c0 = colors + 4 * lane;
  if (state.flat || (in.constant >> lane & 1) != 0) {
    return make_constant_color({c0[0], c0[1], c0[2], c0[3]}, state.targets, out);
  }
  for (std::size_t k = 0; k < 5; ++k) {
    out.origin[k] = in.origin[k][lane];
    out.dx[k] = in.dx[k][lane];
    out.dy[k] = in.dy[k][lane];
  }
  for (std::size_t k = 5; k < 8; ++k) out.origin[k] = out.dx[k] = out.dy[k] = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    out.base[k] = c0[k] * state.targets.color_scale;
    out.minimum[k] = static_cast<float>(in.minimum[k][lane]);
    out.maximum[k] = static_cast<float>(in.maximum[k][lane]);
  }
  out.inverse_w_minimum = static_cast<float>(in.inverse_w_minimum[lane]);
  out.inverse_w_maximum = 1.0f;
  out.variation = (in.perspective >> lane & 1) != 0 ? ColorVariation::perspective : ColorVariation::affine;
  out.clamp = (in.clamp >> lane & 1) != 0 || state.polygons.smooth;  // smooth ones have fragments outside
}

/// Moves the depths of a filled polygon; the test then keeps each in the buffer's range.
HWY_INLINE void offset_depth(const SetupState& state, DepthPlane& depth) {
  const double offset = depth_offset(state.polygons, state.targets, depth.dx, depth.dy, depth.maximum);
  const auto in_range = [&](double z) { return static_cast<float>(HWY_MIN(HWY_MAX(z + offset, 0.0), state.targets.depth_scale)); };
  depth.origin += offset;
  depth.minimum = in_range(depth.minimum);
  depth.maximum = in_range(depth.maximum);
}

HWY_INLINE void write_coverage_and_depth(const WaitingTriangle& triangle, const Results& in, std::size_t lane,
                                         PrimitiveRecord& out) {
  out.binding = triangle.state->binding;
  for (std::size_t k = 0; k < 3; ++k) {
    out.edges[k] = {static_cast<std::int64_t>(in.edge_c[k][lane]), static_cast<std::int32_t>(in.edge_a[k][lane]),
                    static_cast<std::int32_t>(in.edge_b[k][lane])};
  }
  out.x0 = triangle.x0;
  out.y0 = triangle.y0;
  out.x1 = triangle.x1;
  out.y1 = triangle.y1;
  out.scissored = triangle.scissored;
  out.is_polygon = true;
  out.back = triangle.back;
  out.depth = {in.z_origin[lane], in.z_dx[lane], in.z_dy[lane], static_cast<float>(in.z_minimum[lane]),
               static_cast<float>(in.z_maximum[lane]), (in.steep >> lane & 1) != 0};
  if (triangle.state->polygons.offset_fill) offset_depth(*triangle.state, out.depth);
}

/// Planes of the varyings, or under perspective of their distance from vertex 0 weighted by 1/w, into the records; see
/// make_varying_planes. The same for every varying: nothing in here knows what they mean.
void set_up_varyings(const Basis& basis, const Weights& weights, const Results& in, const WaitingTriangle* const* triangles,
                     std::size_t count, std::byte* records, std::size_t record_bytes) {
  const D d;
  const F f;
  const SetupState& state = *triangles[0]->state;
  const auto varyings = static_cast<std::size_t>(state.binding->varyings.count);
  const std::size_t before = state.colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord);
  VaryingRecord* out[max_lanes];
  for (std::size_t lane = 0; lane < count; ++lane) {
    out[lane] = new (records + lane * record_bytes + before) VaryingRecord;
    constexpr std::size_t w = ColorRecord::inverse_w;
    *out[lane] = {in.origin[w][lane], in.dx[w][lane], in.dy[w][lane], static_cast<float>(in.inverse_w_minimum[lane]), 1.0f,
                  0, (in.perspective >> lane & 1) != 0, true};
  }

  const V infinity = set(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < varyings; ++k) {
    alignas(64) float values[3][max_lanes];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      const float* of_triangle = varyings_of(*triangles[HWY_MIN(lane, count - 1)]);
      for (std::size_t i = 0; i < 3; ++i) values[i][lane] = of_triangle[i * varyings + k];
    }
    V v[3];
    for (std::size_t i = 0; i < 3; ++i) v[i] = hn::PromoteTo(d, hn::Load(f, values[i]));
    const PlaneLanes plane =
        make_plane(basis, hn::IfThenZeroElse(weights.perspective, v[0]), hn::Mul(hn::Sub(v[1], v[0]), weights.q[1]),
                   hn::Mul(hn::Sub(v[2], v[0]), weights.q[2]));
    alignas(64) Lanes origin, dx, dy;
    hn::Store(plane.origin, d, origin);
    hn::Store(plane.dx, d, dx);
    hn::Store(plane.dy, d, dy);
    const Mask equal = hn::And(hn::Eq(v[0], v[1]), hn::Eq(v[0], v[2]));
    const Mask finite = hn::Lt(hn::Add(hn::Abs(plane.origin), slope(plane)), infinity);
    const std::uint64_t constant = bits_of(hn::Or(equal, hn::Not(finite)));
    for (std::size_t lane = 0; lane < count; ++lane) {
      auto& target = *new (reinterpret_cast<VaryingPlane*>(out[lane] + 1) + k) VaryingPlane;
      const float v0 = values[0][lane], v1 = values[1][lane], v2 = values[2][lane];
      if ((constant >> lane & 1) != 0) {
        target.base = target.minimum = target.maximum = std::isfinite(v0) ? v0 : 0.0f;
        out[lane]->constant |= std::uint64_t{1} << k;
      } else {
        target = {origin[lane], dx[lane], dy[lane], v0, HWY_MIN(HWY_MIN(v0, v1), v2), HWY_MAX(HWY_MAX(v0, v1), v2)};
      }
    }
  }
}

/// Selects among at most max_lanes triangles.
HWY_INLINE std::size_t select_group(const SetupState& state, const ProcessedVertices& vertices,
                                    const AssembledTriangle* triangles, std::size_t count, std::byte* out) {
  alignas(64) float window[3 * 4 * max_lanes];
  for (std::size_t lane = 0; lane < max_lanes; ++lane) {
    const AssembledTriangle& triangle = triangles[HWY_MIN(lane, count - 1)];
    for (std::size_t i = 0; i < 3; ++i) {
      std::memcpy(window + 4 * (i * max_lanes + lane), &vertices.window[triangle.vertex[i]], sizeof(WindowVertex));
    }
  }
  const Quad corners[3] = {load_quad(window), load_quad(window + 4 * max_lanes), load_quad(window + 8 * max_lanes)};
  Selection selection;
  select(state, snap_triangles(corners, state.target_height_px), selection);

  std::size_t selected = 0;
  const auto varyings = static_cast<std::size_t>(state.binding->varyings.count);
  const std::size_t bytes = waiting_size(state);
  for (std::uint64_t left = selection.alive & ((std::uint64_t{1} << count) - 1); left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
    auto& waiting = *reinterpret_cast<WaitingTriangle*>(out + selected++ * bytes);
    for (std::size_t i = 0; i < 3; ++i) waiting.window[i] = vertices.window[triangles[lane].vertex[i]];
    const bool back = waiting.back = (selection.front >> lane & 1) == 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint16_t vertex = triangles[lane].vertex[i], shading = state.flat ? triangles[lane].provoking : vertex;
      if (state.colors) waiting.color[i] = color_of_vertex(state, vertices, shading, back);
      if (varyings > 0) copy_varyings(state, vertices, vertex, shading, back, varyings_of(waiting) + i * varyings);
    }
    waiting.state = &state;
    waiting.x0 = static_cast<std::int16_t>(selection.x0[lane]);
    waiting.y0 = static_cast<std::int16_t>(selection.y0[lane]);
    waiting.x1 = static_cast<std::int16_t>(selection.x1[lane]);
    waiting.y1 = static_cast<std::int16_t>(selection.y1[lane]);
    waiting.scissored = (selection.scissored >> lane & 1) != 0;
  }
  return selected;
}

std::size_t select_all(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle* triangles,
                       std::size_t count, std::byte* out) {
  const std::size_t lanes = hn::Lanes(D()), bytes = waiting_size(state);
  std::size_t selected = 0;
  for (std::size_t i = 0; i < count; i += lanes) {
    selected += select_group(state, vertices, triangles + i, HWY_MIN(lanes, count - i), out + selected * bytes);
  }
  return selected;
}

/// Sets up at most max_lanes triangles.
HWY_INLINE void set_up_group(const WaitingTriangle* const* triangles, std::size_t count, std::byte* records) {
  const D d;
  const SetupState& state = *triangles[0]->state;
  alignas(64) float window[3 * 4 * max_lanes], colors[3 * 4 * max_lanes];
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    const WaitingTriangle& triangle = *triangles[HWY_MIN(lane, count - 1)];
    for (std::size_t i = 0; i < 3; ++i) {
      std::memcpy(window + 4 * (i * max_lanes + lane), &triangle.window[i], sizeof(WindowVertex));
      std::memcpy(colors + 4 * (i * max_lanes + lane), &triangle.color[i], sizeof(Rgba));
    }
  }
  const Quad corners[3] = {load_quad(window), load_quad(window + 4 * max_lanes), load_quad(window + 8 * max_lanes)};
  const SnappedTriangles p = snap_triangles(corners, state.target_height_px);
  Results results;
  set_up_edges(p, results);

  // The basis of all planes. Where the unsnapped triangle has no area its plane is not defined; the snapped one's stands in.
  V x[3], y[3];
  const auto area_of = [&]() HWY_ATTR {
    return hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])), hn::Mul(hn::Sub(x[2], x[0]), hn::Sub(y[1], y[0])));
  };
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = corners[i].x;
    y[i] = hn::Sub(set(state.target_height_px), corners[i].y);
  }
  const Mask no_area = hn::Eq(area_of(), hn::Zero(d));
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = hn::IfThenElse(no_area, hn::Add(hn::Mul(p.x[i], set(1.0 / subpixels)), set(0.5)), x[i]);
    y[i] = hn::IfThenElse(no_area, hn::Add(hn::Mul(p.y[i], set(1.0 / subpixels)), set(0.5)), y[i]);
  }
  const V scale = hn::Div(set(1), area_of());
  const Basis basis{x[0], y[0], hn::Mul(hn::Sub(y[2], y[0]), scale), hn::Mul(hn::Sub(x[0], x[2]), scale),
                    hn::Mul(hn::Sub(y[0], y[1]), scale), hn::Mul(hn::Sub(x[1], x[0]), scale)};

  // Lay the planes, write the records.
  set_up_depth(state, basis, {corners[0].z, corners[1].z, corners[2].z}, results);
  const bool varyings = state.binding->varyings.count > 0, planes_of_color = state.colors && !state.flat;
  const std::size_t bytes = record_size(state);
  if (planes_of_color || varyings) {
    const Weights weights = weigh(basis, {corners[0].w, corners[1].w, corners[2].w}, results);
    if (planes_of_color) set_up_colors(state, basis, weights, colors, results);
    if (varyings) set_up_varyings(basis, weights, results, triangles, count, records, bytes);
  }
  for (std::size_t lane = 0; lane < count; ++lane) {
    if (state.colors) {
      auto* primitive = new (records + lane * bytes) ColoredPrimitive;
      write_coverage_and_depth(*triangles[lane], results, lane, primitive->record);
      write_color(state, results, lane, colors, primitive->color);
    } else {
      auto* record = new (records + lane * bytes) PrimitiveRecord;
      write_coverage_and_depth(*triangles[lane], results, lane, *record);
    }
  }
}

void set_up(const WaitingTriangle* const* triangles, std::size_t count, std::byte* records) {
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t i = 0; i < count; i += lanes) {
    set_up_group(triangles + i, HWY_MIN(lanes, count - i), records + i * record_size(*triangles[0]->state));
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

double depth_offset(const PolygonState& state, const PlaneTargets& targets, double dx, double dy, double largest_depth) {
  // A float in [0, 1] has 24 bits: a step at z is 2^-23 of the power of two below.
  const double step = targets.depth_is_float ? std::ldexp(1.0, std::ilogb(std::max(largest_depth, 0x1p-125)) - 23) : 1.0;
  const double offset = state.offset_factor * std::max(std::abs(dx), std::abs(dy)) + state.offset_units * (offset_unit * step);
  // Written so that what is no number moves nothing.
  const double most = targets.depth_scale;
  return offset > 0 ? std::min(offset, most) : offset < 0 ? std::max(offset, -most) : 0.0;
}

double depth_offset(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  const WindowVertex &v0 = vertices.window[triangle.vertex[0]], &v1 = vertices.window[triangle.vertex[1]],
                     &v2 = vertices.window[triangle.vertex[2]];
  const double x1 = static_cast<double>(v1.x) - v0.x, y1 = static_cast<double>(v0.y_raster) - v1.y_raster;
  const double x2 = static_cast<double>(v2.x) - v0.x, y2 = static_cast<double>(v0.y_raster) - v2.y_raster;
  const double z1 = static_cast<double>(v1.z) - v0.z, z2 = static_cast<double>(v2.z) - v0.z;
  const double area = x1 * y2 - x2 * y1;
  const double scale = area != 0 ? state.targets.depth_scale / area : 0.0;
  const double largest = std::max({v0.z, v1.z, v2.z}) * state.targets.depth_scale;
  return depth_offset(state.polygons, state.targets, (z1 * y2 - z2 * y1) * scale, (x1 * z2 - x2 * z1) * scale, largest);
}

SmoothShape smooth_triangle(const WaitingTriangle& triangle) {
  SmoothShape shape;
  shape.corner_count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex& vertex = triangle.window[i];
    shape.corner[i] = {vertex.x, static_cast<double>(triangle.state->target_height_px) - vertex.y_raster};
  }
  return shape;
}

bool is_culled(CullMode cull, bool front) {
  return cull == CullMode::front_and_back || cull == (front ? CullMode::front : CullMode::back);
}

void copy_varyings(const SetupState& state, const ProcessedVertices& vertices, std::uint16_t index, std::uint16_t shading,
                   bool back, float* out) {
  const VaryingLayout& layout = state.binding->varyings;
  const auto count = static_cast<std::size_t>(layout.of_vertices());
  for (std::size_t k = 0; k < count; ++k) out[k] = vertices.varying[k][index];
  if (layout.secondary_color < 0) return;
  const Rgba& secondary = back && state.two_sided ? vertices.specular_back[shading] : vertices.specular_front[shading];
  float* const target = out + layout.secondary_color;
  target[0] = secondary.r;
  target[1] = secondary.g;
  target[2] = secondary.b;
}

double front_area(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  std::array<double, 3> x, y;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex& vertex = vertices.window[triangle.vertex[i]];
    x[i] = vertex.x;
    y[i] = static_cast<double>(state.target_height_px) - vertex.y_raster;
  }
  const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
  return state.front_face == FrontFace::ccw ? area : -area;
}

bool faces_front(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle) {
  return front_area(state, vertices, triangle) > 0.0;
}

std::size_t select_triangles(const SetupState& state, const ProcessedVertices& vertices,
                             std::span<const AssembledTriangle> triangles, std::byte* out) {
  return GOURAUD_SIMD_PICK(select_all)(state, vertices, triangles.data(), triangles.size(), out);
}

void setup_triangles(std::span<const WaitingTriangle* const> triangles, std::byte* records) {
  GOURAUD_SIMD_PICK(set_up)(triangles.data(), triangles.size(), records);
}

}  // namespace gouraud::pipeline
#endif
