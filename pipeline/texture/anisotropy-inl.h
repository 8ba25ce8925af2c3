// The footprints of a block's fragments in a texture [EXT_texture_filter_anisotropic]; for kernels: included inside a kernel
// file, once per instruction set. With the derivatives of [GL1.5 §3.8.8] in texels of the base level,
//   P_x = |(u_x, v_x)|, P_y = |(u_y, v_y)|, P_max and P_min the larger and the smaller,
//   N = min(ceil(P_max / P_min), max_anisotropy), lambda = log2(P_max / N),
// and the filter is the mean of N samples at lambda, i = 1 .. N, moved by (i / (N + 1) - 1/2) pixels along x if P_x > P_y,
// else along y.
// choice: moved along the tangent: by the derivative at the pixel's centre, which a horizon does not upset. A ratio that
// exceeds a whole number by less than 1/1024 counts as that number. max_anisotropy is rounded down.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_ANISOTROPY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_ANISOTROPY_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_ANISOTROPY_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_ANISOTROPY_INL_H_
#endif

#include <array>
#include <cstddef>

#include "pipeline/texture/lod-inl.h"
#include "pipeline/texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

inline constexpr float ratio_tie = 1.0f / 1024;

struct BlockFootprints {
  alignas(64) float lambda[64];    ///< before bias
  alignas(64) float probes[64];    ///< N: whole, 1 to max_anisotropy
  alignas(64) float along[3][64];  ///< what coordinate k changes by in a pixel along the longer side

  /// `size`: as BlockLod has it.
  HWY_INLINE BlockFootprints(const CoordinatePlanes& planes, const std::array<float, 3>& size, float max_anisotropy, PairRange pairs) {
    for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(FloatTag())) {
      measure(planes, size, max_anisotropy, lane);
    }
  }

 private:
  HWY_INLINE void measure(const CoordinatePlanes& planes, const std::array<float, 3>& size, float max_anisotropy, std::size_t lane) {
    const FloatTag d;
    const auto spread = [&](double v) HWY_ATTR { return hn::Set(d, static_cast<float>(v)); };
    const FloatVector column = hn::Load(d, pair_column + lane % pair_lanes);
    const FloatVector row = hn::Add(hn::Load(d, pair_row + lane % pair_lanes), hn::Set(d, static_cast<float>(lane / pair_lanes * 2)));
    const LocalPlane& q = planes.denominator;
    const FloatVector bottom = hn::Add(spread(q.value), hn::Add(hn::Mul(spread(q.dx), column), hn::Mul(spread(q.dy), row)));
    const FloatVector squared = hn::Mul(bottom, bottom);
    FloatVector ddx[3], ddy[3];
    FloatVector along_x = hn::Zero(d), along_y = hn::Zero(d);
    for (std::size_t k = 0; k < 3; ++k) {
      ddx[k] = ddy[k] = hn::Zero(d);
      if (size[k] == 0) continue;
      const LocalPlane& p = planes.numerator[k];
      const FloatVector change = spread(p.dx * q.dy - p.dy * q.dx), texels = hn::Set(d, size[k]);
      ddx[k] = hn::Div(hn::Add(spread(p.dx * q.value - p.value * q.dx), hn::Mul(change, row)), squared);
      ddy[k] = hn::Div(hn::Sub(spread(p.dy * q.value - p.value * q.dy), hn::Mul(change, column)), squared);
      const FloatVector x = hn::Mul(ddx[k], texels), y = hn::Mul(ddy[k], texels);
      along_x = hn::Add(along_x, hn::Mul(x, x));
      along_y = hn::Add(along_y, hn::Mul(y, y));
    }
    const FloatVector most = hn::Max(along_x, along_y), least = hn::Min(along_x, along_y);
    const FloatVector ratio = hn::Ceil(hn::Sub(hn::Sqrt(hn::Div(most, least)), hn::Set(d, ratio_tie)));
    // 0 / 0 is no number, and counts as 1.
    const FloatVector count = kept_between(ratio, 1.0f, max_anisotropy);
    hn::Store(count, d, probes + lane);
    hn::Store(hn::Sub(hn::Mul(hn::Set(d, 0.5f), log2(d, most)), log2(d, count)), d, lambda + lane);
    const auto longer_x = hn::Gt(along_x, along_y);
    for (std::size_t k = 0; k < 3; ++k) hn::Store(hn::IfThenElse(longer_x, ddx[k], ddy[k]), d, along[k] + lane);
  }
};

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
