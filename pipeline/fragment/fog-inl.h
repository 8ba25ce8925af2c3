// The fog's factor and its colour over lanes, for kernels: included inside a kernel file, once per instruction set. The
// factor f is computed for every fragment (MESA-RULES 6) and clamped to [0, 1]; where linear fog's is not a number it is 0.
// Coordinates are finite.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_
#endif

#include <cmath>
#include <cstddef>
#include <limits>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// [GL1.5 §3.10 eq 3.25]: (end - c) / (end - start).
struct LinearFog {
  float end, range;
  explicit LinearFog(const FogState& fog) : end(fog.end), range(fog.end - fog.start) {}
  HWY_INLINE FloatVector factor(FloatVector c) const {
    const FloatTag d;
    return clamp_to_unit(d, hn::Div(hn::Sub(hn::Set(d, end), c), hn::Set(d, range)));
  }
};

inline constexpr float log2_of_e = 1.44269504088896340736f;
/// A density that is infinite or no number hides all but the eye: so does this one, and coordinates times it are numbers.
inline float finite_density(const FogState& fog) { return std::isfinite(fog.density) ? fog.density : std::numeric_limits<float>::max() / 2; }
/// 2^x for x up to 0; below the range it is the lowest power.
HWY_INLINE FloatVector power_of_two(FloatVector x) {
  const FloatTag d;
  return exp2_of_range(d, hn::Max(x, hn::Set(d, ElementaryTraits<float>::exp2_lowest)));
}

/// [GL1.5 §3.10 eq 3.23]: exp(-density c).
struct ExpFog {
  float scale;
  explicit ExpFog(const FogState& fog) : scale(-finite_density(fog) * log2_of_e) {}
  HWY_INLINE FloatVector factor(FloatVector c) const {
    const FloatTag d;
    return power_of_two(hn::Min(hn::Mul(c, hn::Set(d, scale)), hn::Zero(d)));
  }
};
/// [GL1.5 §3.10 eq 3.24]: exp(-(density c)^2).
struct Exp2Fog {
  float scale;
  explicit Exp2Fog(const FogState& fog) : scale(finite_density(fog) * root_log2_of_e) {}
  HWY_INLINE FloatVector factor(FloatVector c) const {
    const FloatTag d;
    const FloatVector depth = hn::Mul(c, hn::Set(d, scale));
    return power_of_two(hn::Neg(hn::Mul(depth, depth)));
  }
  static constexpr float root_log2_of_e = 1.20112240878644976f;
};

/// f C + (1 - f) C_fog of lanes; colours are scaled as the target's.
template <class Mode>
class FogBlend {
 public:
  HWY_INLINE FogBlend(const FogState& fog, float scale) : mode_(fog), color_{fog.color.x * scale, fog.color.y * scale, fog.color.z * scale} {}
  HWY_INLINE void blend(FloatVector coordinate, FloatVector& r, FloatVector& g, FloatVector& b) const {
    const FloatTag d;
    const FloatVector f = mode_.factor(coordinate);
    const FloatVector rest = hn::Sub(hn::Set(d, 1.0f), f);
    const auto channel = [&](FloatVector value, float fog) HWY_ATTR {
      return hn::Add(hn::Mul(value, f), hn::Mul(hn::Set(d, fog), rest));
    };
    r = channel(r, color_[0]);
    g = channel(g, color_[1]);
    b = channel(b, color_[2]);
  }

 private:
  Mode mode_;
  float color_[3];
};

/// Which varying of the block's primitive the fog coordinate is.
HWY_INLINE std::size_t fog_coordinate(const FragmentBlock& block) {
  return static_cast<std::size_t>(block.primitive->binding->varyings.fog_coordinate);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
