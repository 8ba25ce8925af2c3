// Interpolating a primitive's varyings over a block, for kernels: included inside a kernel file, once per instruction set.
//
// A texture coordinate may run to thousands of repeats, so that float planes would be too coarse. The value at one lane
// of the block comes from the planes in double; the others add their float distance from it. In perspective, with s_0
// and w_0 the values there, s = s_0 + (dp - (s_0 - base) dw) / w: the distance is small, and so is its error.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_VARYINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_VARYINGS_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_VARYINGS_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_VARYINGS_INL_H_
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"

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

/// The planes of a primitive in perspective at one block, counted from the corner where 1/w is largest: wherever the primitive
/// covers a lane, 1/w is positive there.
struct NearCorner {
  const VaryingRecord& record;
  float column, row;    ///< the corner's lane
  double x, y;          ///< its pixel
  double w;             ///< there
  BlockPlane inverse_w;

  HWY_INLINE NearCorner(const VaryingRecord& of, const FragmentBlock& block)
      : record(of), column(of.inverse_w_dx > 0 ? 7.0f : 0.0f), row(of.inverse_w_dy > 0 ? 7.0f : 0.0f),
        x(block.x + double{column}), y(block.y + double{row}) {
    const double at_corner = (record.inverse_w_origin + record.inverse_w_dx * x) + record.inverse_w_dy * y;
    const double nearest = std::max(at_corner, static_cast<double>(record.inverse_w_minimum));
    w = 1.0 / nearest;
    inverse_w = {static_cast<float>(nearest), static_cast<float>(record.inverse_w_dx), static_cast<float>(record.inverse_w_dy)};
  }
  /// base is the varying at the corner; the distance from there is to be multiplied by w.
  HWY_INLINE BlockPlane plane(const VaryingPlane& p) const {
    const double from_base = ((p.origin + p.dx * x) + p.dy * y) * w;
    return {static_cast<float>(p.base + from_base), static_cast<float>(p.dx - from_base * record.inverse_w_dx),
            static_cast<float>(p.dy - from_base * record.inverse_w_dy)};
  }
  HWY_INLINE FloatVector first(const BlockPlane& of, std::size_t offset) const { return first_distance(of, column, row, offset); }
  /// w of lanes that lie `distance` in inverse_w from the corner.
  template <bool clamp>
  HWY_INLINE FloatVector w_at(FloatVector distance) const {
    const FloatTag d;
    FloatVector q = hn::Add(hn::Set(d, inverse_w.base), distance);
    if constexpr (clamp) q = clamp_lanes(q, hn::Set(d, record.inverse_w_minimum), hn::Set(d, record.inverse_w_maximum));
    return hn::Div(hn::Set(d, 1.0f), q);
  }
};

template <bool clamp>
HWY_INLINE void interpolate_perspective(FragmentBlock& block, const VaryingRecord& record, std::size_t count, PairRange pairs) {
  const FloatTag d;
  const NearCorner corner(record, block);
  alignas(64) float lane_w[64];
  const FloatVector step = pair_step(corner.inverse_w);
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    FloatVector distance = corner.first(corner.inverse_w, offset);
    for (std::size_t pair = 0; pair < pairs.first; ++pair) distance = hn::Add(distance, step);
    for (std::size_t pair = pairs.first; pair < pairs.end; ++pair, distance = hn::Add(distance, step)) {
      hn::Store(corner.w_at<clamp>(distance), d, lane_w + pair * pair_lanes + offset);
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
    const auto scale = [&](FloatVector distance, std::size_t lane) HWY_ATTR {
      return hn::Mul(distance, hn::Load(d, lane_w + lane));
    };
    store_lanes<clamp>(corner.plane(p), corner.column, corner.row, p, pairs, scale, lanes);
  }
}

/// All varyings of the primitive, in these row pairs.
HWY_INLINE void interpolate(FragmentBlock& block, PairRange pairs) {
  const VaryingRecord& record = varyings_of(*block.primitive);
  const auto count = static_cast<std::size_t>(block.primitive->binding->varyings.count);
  if (record.perspective) {
    record.clamp ? interpolate_perspective<true>(block, record, count, pairs)
                 : interpolate_perspective<false>(block, record, count, pairs);
  } else {
    record.clamp ? interpolate_affine<true>(block, record, count, pairs) : interpolate_affine<false>(block, record, count, pairs);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
