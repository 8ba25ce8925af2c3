// Takes a block and its primitive's varying planes, gives the block with its varyings [GL1.5 §3.5.1 eq 3.6].
//
// A texture coordinate may run to thousands of repeats, so that float planes would be too coarse. The value at one lane
// of the block comes from the planes in double; the others add their float distance from it. In perspective, with s_0
// and w_0 the values there, s = s_0 + (dp - (s_0 - base) dw) / w: the distance is small, and so is its error.
#include "pipeline/fragment/varyings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/varyings.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE void fill(float value, float* lanes) {
  const FloatTag d;
  const FloatVector v = hn::Set(d, value);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) hn::Store(v, d, lanes + lane);
}

/// dx * column + dy * row of each lane, counted from the lane (x, y), is `first` in the first row pair and grows by
/// pair_step().
HWY_INLINE FloatVector first_distance(const BlockPlane& plane, float x, float y, std::size_t offset) {
  const FloatTag d;
  const FloatVector column = hn::Sub(hn::Load(d, pair_column + offset), hn::Set(d, x));
  const FloatVector row = hn::Sub(hn::Load(d, pair_row + offset), hn::Set(d, y));
  return hn::Add(hn::Mul(hn::Set(d, plane.dx), column), hn::Mul(hn::Set(d, plane.dy), row));
}

template <bool clamp, class Scale>
HWY_INLINE void store_lanes(const BlockPlane& plane, float x, float y, const VaryingPlane& varying, PairRange pairs,
                            const Scale& scale, float* lanes) {
  const FloatTag d;
  const FloatVector base = hn::Set(d, plane.base), step = pair_step(plane);
  const FloatVector low = hn::Set(d, varying.minimum), high = hn::Set(d, varying.maximum);
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    FloatVector distance = first_distance(plane, x, y, offset);
    for (std::size_t pair = 0; pair < pairs.first; ++pair) distance = hn::Add(distance, step);
    for (std::size_t pair = pairs.first; pair < pairs.end; ++pair, distance = hn::Add(distance, step)) {
      const std::size_t lane = pair * pair_lanes + offset;
      FloatVector value = hn::Add(base, scale(distance, lane));
      if constexpr (clamp) value = clamp_lanes(value, low, high);
      hn::Store(value, d, lanes + lane);
    }
  }
}

template <bool clamp>
HWY_INLINE void interpolate_affine(FragmentBlock& block, const VaryingRecord& record, std::size_t count, PairRange pairs) {
  const VaryingPlane* planes = planes_of(record);
  for (std::size_t k = 0; k < count; ++k) {
    const VaryingPlane& p = planes[k];
    float* lanes = block.varying[k].data();
    if ((record.constant >> k & 1) != 0) {
      fill(p.base, lanes);
      continue;
    }
    const BlockPlane plane{static_cast<float>((p.origin + p.dx * block.x) + p.dy * block.y), static_cast<float>(p.dx),
                           static_cast<float>(p.dy)};
    store_lanes<clamp>(plane, 0, 0, p, pairs, [](FloatVector distance, std::size_t) HWY_ATTR { return distance; }, lanes);
  }
}

template <bool clamp>
HWY_INLINE void interpolate_perspective(FragmentBlock& block, const VaryingRecord& record, std::size_t count, PairRange pairs) {
  const FloatTag d;
  // Start from the corner where 1/w is largest: wherever the primitive covers a lane, it is positive there.
  const std::int32_t corner_x = record.inverse_w_dx > 0 ? 7 : 0, corner_y = record.inverse_w_dy > 0 ? 7 : 0;
  const double x = block.x + corner_x, y = block.y + corner_y;
  const auto from_x = static_cast<float>(corner_x), from_y = static_cast<float>(corner_y);
  const double at_corner = (record.inverse_w_origin + record.inverse_w_dx * x) + record.inverse_w_dy * y;
  const double inverse_w = std::max(at_corner, static_cast<double>(record.inverse_w_minimum)), w = 1.0 / inverse_w;

  alignas(64) float lane_w[64];
  const BlockPlane plane_w{static_cast<float>(inverse_w), static_cast<float>(record.inverse_w_dx),
                           static_cast<float>(record.inverse_w_dy)};
  const FloatVector low = hn::Set(d, record.inverse_w_minimum), high = hn::Set(d, record.inverse_w_maximum);
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    FloatVector distance = first_distance(plane_w, from_x, from_y, offset);
    for (std::size_t pair = 0; pair < pairs.first; ++pair) distance = hn::Add(distance, pair_step(plane_w));
    for (std::size_t pair = pairs.first; pair < pairs.end; ++pair, distance = hn::Add(distance, pair_step(plane_w))) {
      FloatVector q = hn::Add(hn::Set(d, plane_w.base), distance);
      if constexpr (clamp) q = clamp_lanes(q, low, high);
      hn::Store(hn::Div(hn::Set(d, 1.0f), q), d, lane_w + pair * pair_lanes + offset);
    }
  }

  const VaryingPlane* planes = planes_of(record);
  for (std::size_t k = 0; k < count; ++k) {
    const VaryingPlane& p = planes[k];
    float* lanes = block.varying[k].data();
    if ((record.constant >> k & 1) != 0) {
      fill(p.base, lanes);
      continue;
    }
    const double from_base = ((p.origin + p.dx * x) + p.dy * y) * w;
    const BlockPlane plane{static_cast<float>(p.base + from_base), static_cast<float>(p.dx - from_base * record.inverse_w_dx),
                           static_cast<float>(p.dy - from_base * record.inverse_w_dy)};
    const auto scale = [&](FloatVector distance, std::size_t lane) HWY_ATTR {
      return hn::Mul(distance, hn::Load(d, lane_w + lane));
    };
    store_lanes<clamp>(plane, from_x, from_y, p, pairs, scale, lanes);
  }
}

template <LanesWanted wanted>
void interpolate_varyings(FragmentBlock& block, const TileTarget&) {
  const PrimitiveRecord& primitive = *block.primitive;
  const VaryingRecord& record = varyings_of(primitive);
  const auto count = static_cast<std::size_t>(primitive.binding->varyings.count);
  const PairRange pairs = wanted == LanesWanted::all ? PairRange{0, row_pairs} : covered_pairs(block.coverage);
  if (record.perspective) {
    record.clamp ? interpolate_perspective<true>(block, record, count, pairs)
                 : interpolate_perspective<false>(block, record, count, pairs);
  } else {
    record.clamp ? interpolate_affine<true>(block, record, count, pairs) : interpolate_affine<false>(block, record, count, pairs);
  }
}

FragmentPass select_varyings(LanesWanted wanted) {
  return wanted == LanesWanted::all ? interpolate_varyings<LanesWanted::all> : interpolate_varyings<LanesWanted::covered>;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass varying_interpolation_pass(LanesWanted wanted) { return GOURAUD_SIMD_PICK(select_varyings)(wanted); }
}  // namespace gouraud::pipeline
#endif
