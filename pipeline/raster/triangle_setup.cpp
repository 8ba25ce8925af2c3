// Triangles to records [GL1.5 §3.5.1], several at a time, one a lane, in two steps: depth (and edges, where the selection
// has not found the pixels already), and then, of those that are seen, colours and varyings. Edge functions stem from the
// snapped positions, planes from the unsnapped ones.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <new>

#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/raster/triangle_setup.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/triangle_basis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Edge functions, positive inside. Left edges and horizontal bottom edges own the samples on them; the others lose
/// them by one unit (MESA-RULES 3). At pixel (i, j): 256 a i + 256 b j + c >= 0, which floor(c / 256) does not change.
/// All arithmetic is exact: integers below 2^53, held in doubles.
HWY_INLINE void set_up_edges(const V (&x)[3], const V (&y)[3], const TriangleGroup& group, std::size_t first, std::uint64_t lanes) {
  const D d;
  const V zero = hn::Zero(d), one = set(1);
  const V area = hn::Sub(hn::Mul(hn::Sub(x[1], x[0]), hn::Sub(y[2], y[0])), hn::Mul(hn::Sub(x[2], x[0]), hn::Sub(y[1], y[0])));
  const V sign = hn::IfThenElse(hn::Gt(area, zero), one, set(-1));
  const bool fine = group.state->binding->samples_apart;
  for (std::size_t from = 0; from < 3; ++from) {
    const std::size_t to = (from + 1) % 3;
    const V a = hn::Mul(sign, hn::Sub(y[from], y[to])), b = hn::Mul(sign, hn::Sub(x[to], x[from]));
    const Mask owns = hn::Or(hn::Gt(a, zero), hn::And(hn::Eq(a, zero), hn::Gt(b, zero)));
    const V c = hn::Sub(hn::Neg(hn::Add(hn::Mul(a, x[from]), hn::Mul(b, y[from]))), hn::IfThenElse(owns, zero, one));
    alignas(64) Lanes lane_c;
    alignas(64) std::int32_t lane_a[max_lanes], lane_b[max_lanes];
    hn::Store(fine ? c : hn::Floor(hn::Mul(c, set(1.0 / subpixels))), d, lane_c);
    hn::Store(hn::DemoteTo(I(), a), I(), lane_a);
    hn::Store(hn::DemoteTo(I(), b), I(), lane_b);
    for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
      group.record(first + lane).edges[from] = {static_cast<std::int64_t>(lane_c[lane]), lane_a[lane], lane_b[lane]};
    }
  }
}

/// Moves the depths of a filled polygon; the test then keeps each in the buffer's range.
HWY_INLINE void offset_depth(const SetupState& state, DepthPlane& depth) {
  const double offset = depth_offset(state.polygons, state.targets, depth.dx, depth.dy, depth.maximum);
  const auto in_range = [&](double z) { return static_cast<float>(HWY_MIN(HWY_MAX(z + offset, 0.0), state.targets.depth_scale)); };
  depth.origin += offset;
  depth.minimum = in_range(depth.minimum);
  depth.maximum = in_range(depth.maximum);
}

/// Begins the records of `count` lanes from the first on. The box counts where there are edges.
HWY_INLINE void begin_records(const TriangleGroup& group, std::size_t first, std::size_t count) {
  for (std::size_t i = first; i < first + count; ++i) {
    PrimitiveRecord& record = begin_record(group, i);
    const WaitingTriangle& triangle = *group.triangle[i];
    if (triangle.small() && !group.edges_of_all) continue;
    record.x0 = triangle.x0;
    record.y0 = triangle.y0;
    record.x1 = triangle.x1;
    record.y1 = triangle.y1;
  }
}

/// The first step for at most max_lanes triangles.
HWY_INLINE void set_up_depths_of_lanes(TriangleGroup& group, std::size_t first) {
  const D d;
  const SetupState& state = *group.state;
  const std::size_t count = HWY_MIN(hn::Lanes(d), group.count - first);
  begin_records(group, first, count);

  const Corners corners = load_corners(group, first);
  std::uint64_t with_edges = 0;
  for (std::size_t lane = 0; lane < count; ++lane) {
    with_edges |= std::uint64_t{group.edges_of_all || !group.triangle[first + lane]->small()} << lane;
  }
  if (with_edges != 0) {
    const SnappedPlaces snapped = snap_places(corners, state.target_height_px);
    set_up_edges(snapped.x, snapped.y, group, first, with_edges);
  }
  const Basis basis = basis_of(corners, state.target_height_px);
  keep_basis(basis, corners, group, first);
  set_up_depth(basis, corners.z, group, first, count);
  for (std::size_t i = first; i < first + count && state.polygons.offset_fill; ++i) offset_depth(state, group.record(i).depth);
}

/// Whether fragments are of samples apart from the pixel's centre.
HWY_INLINE bool covers_samples(const SetupState& state) { return state.binding->samples_apart; }

/// The range in which fragments' 1/w is kept, relative to the largest vertex's. Where samples are apart the pixel's centre may
/// lie outside: there the plane goes on, so that the values are truly those of the centre, as long as it is above zero.
struct WeightRange {
  float lowest, highest;
};
HWY_INLINE WeightRange weight_range(const SetupState& state, double lowest_vertex) {
  const auto lowest = static_cast<float>(lowest_vertex);
  if (!covers_samples(state)) return {lowest, 1.0f};
  return {lowest * 0x1p-16f, std::numeric_limits<float>::max()};
}

/// Planes of the varyings of the first `count` lanes, or under perspective of their distance from vertex 0 weighted by
/// 1/w; see make_varying_planes. The same for every varying: nothing in here knows what they mean.
void set_up_varyings(const Basis& basis, const Weights& weights, const TriangleGroup& group, std::size_t first, std::size_t count) {
  const D d;
  const F f;
  const SetupState& state = *group.state;
  const auto varyings = static_cast<std::size_t>(state.binding->varyings.count);
  const std::size_t before = state.colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord);
  DoubleRows inverse_w;
  transpose(weights.plane.origin, weights.plane.dx, weights.plane.dy, weights.lowest, inverse_w);
  const std::uint64_t perspective = bits_of(weights.perspective);
  VaryingRecord* out[max_lanes];
  for (std::size_t lane = 0; lane < count; ++lane) {
    out[lane] = new (group.records + (first + lane) * group.record_bytes + before) VaryingRecord;
    const double (&w)[4] = inverse_w.row[lane];
    const WeightRange range = weight_range(state, w[3]);
    *out[lane] = {w[0], w[1], w[2], range.lowest, range.highest, 0, (perspective >> lane & 1) != 0, true};
  }

  const V infinity = set(std::numeric_limits<double>::infinity());
  for (std::size_t k = 0; k < varyings; ++k) {
    alignas(64) float values[3][max_lanes];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
      for (std::size_t i = 0; i < 3; ++i) values[i][lane] = varyings_of(*group.vertex[i][first + lane])[k];
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

void set_up_constant_colors(const TriangleGroup& group, std::size_t first, std::uint64_t lanes) {
  for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
    const std::size_t i = first + static_cast<std::size_t>(__builtin_ctzll(left));
    make_constant_color(group.vertex[0][i]->color, group.state->targets, group.color(i));
  }
}

/// Smooth triangles have fragments outside of their edges, and so have those that cover a sample and not the pixel's centre.
void clamp_colors(const TriangleGroup& group, std::size_t first, std::uint64_t lanes) {
  for (std::uint64_t left = lanes; left != 0; left &= left - 1) {
    ColorRecord& color = group.color(first + static_cast<std::size_t>(__builtin_ctzll(left)));
    color.clamp = color.variation != ColorVariation::constant;
    if (color.variation != ColorVariation::perspective) continue;
    const WeightRange range = weight_range(*group.state, color.inverse_w_minimum);
    color.inverse_w_minimum = range.lowest;
    color.inverse_w_maximum = range.highest;
  }
}

/// The second step for at most max_lanes triangles.
HWY_INLINE void set_up_colors_of_lanes(const TriangleGroup& group, std::size_t first, std::uint64_t lanes) {
  const D d;
  const SetupState& state = *group.state;
  const bool varyings = state.binding->varyings.count > 0;
  if (state.colors && state.flat) set_up_constant_colors(group, first, lanes);
  if (!varyings && (!state.colors || state.flat)) return;
  const auto part = [&](std::size_t k) HWY_ATTR { return hn::Load(d, group.basis[k] + first); };
  const auto inverse_w = [&](std::size_t i) HWY_ATTR { return hn::Load(d, group.inverse_w[i] + first); };
  const Basis basis{part(0), part(1), part(2), part(3), part(4), part(5)};
  const Weights weights = weigh(basis, {inverse_w(0), inverse_w(1), inverse_w(2)});
  if (state.colors && !state.flat) set_up_colors(basis, weights, group, first, lanes);
  const bool leaves_edges = state.polygons.smooth || covers_samples(state);
  if (state.colors && leaves_edges) clamp_colors(group, first, lanes);
  if (varyings) set_up_varyings(basis, weights, group, first, HWY_MIN(hn::Lanes(d), group.count - first));
}

void depths_of(TriangleGroup& group) {
  group.repeat_last();
  for (std::size_t i = 0; i < group.count; i += hn::Lanes(D())) set_up_depths_of_lanes(group, i);
}

void colors_of(const TriangleGroup& group, std::uint32_t triangles) {
  const std::size_t lanes = hn::Lanes(D());
  for (std::size_t i = 0; i < group.count; i += lanes) {
    const std::uint64_t wanted = triangles >> i & ((std::uint64_t{1} << lanes) - 1);
    if (wanted != 0) set_up_colors_of_lanes(group, i, wanted);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

double depth_offset(const PolygonState& state, const PlaneTargets& targets, double dx, double dy, double largest_depth) {
  // A float in [0, 1] has 24 bits: a step at z is 2^-23 of the power of two below.
  const double step = targets.depth_is_float ? std::ldexp(1.0, std::ilogb(std::max(largest_depth, 0x1p-125)) - 23) : 1.0;
  const double most = targets.depth_scale;
  const double offset = state.offset_factor * std::max(std::abs(dx), std::abs(dy)) + state.offset_units * (offset_unit * step) +
                        state.offset_bias * most;
  // Written so that what is no number moves nothing.
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

SmoothShape smooth_triangle(const SetupState& state, const WaitingTriangle& triangle) {
  SmoothShape shape;
  shape.corner_count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex& vertex = vertex_of(triangle, i, kept_vertex_size(state)).window;
    shape.corner[i] = {vertex.x, static_cast<double>(state.target_height_px) - vertex.y_raster};
  }
  return shape;
}

void set_up_depths(TriangleGroup& group) { GOURAUD_SIMD_PICK(depths_of)(group); }

void set_up_colors(const TriangleGroup& group, std::uint32_t triangles) { GOURAUD_SIMD_PICK(colors_of)(group, triangles); }

void set_up_triangle(const SetupState& state, const WaitingTriangle& triangle, std::byte* record) {
  TriangleGroup group(state, record);
  group.edges_of_all = true;
  group.add(triangle);
  set_up_depths(group);
  set_up_colors(group, 1);
}

}  // namespace gouraud::pipeline
#endif
