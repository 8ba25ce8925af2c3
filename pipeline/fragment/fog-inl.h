// The fog's factor and its colour over lanes, for kernels: included inside a kernel file, once per instruction set. The
// factor f is computed for every fragment (MESA-RULES 6) and clamped to [0, 1]; where it is not a number it is 0.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_FOG_INL_H_
#endif

#include <cstddef>

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
    return hn::Div(hn::Sub(hn::Set(d, end), c), hn::Set(d, range));
  }
};
inline constexpr float log2_of_e = 1.44269504088896340736f;
/// [GL1.5 §3.10 eq 3.23]: exp(-density c).
struct ExpFog {
  float scale;
  explicit ExpFog(const FogState& fog) : scale(-fog.density * log2_of_e) {}
  HWY_INLINE FloatVector factor(FloatVector c) const { return exp2(FloatTag(), hn::Mul(c, hn::Set(FloatTag(), scale))); }
};
/// [GL1.5 §3.10 eq 3.24]: exp(-(density c)^2).
struct Exp2Fog {
  float density;
  explicit Exp2Fog(const FogState& fog) : density(fog.density) {}
  HWY_INLINE FloatVector factor(FloatVector c) const {
    const FloatTag d;
    const FloatVector depth = hn::Mul(c, hn::Set(d, density));
    return exp2(d, hn::Mul(hn::Mul(depth, depth), hn::Set(d, -log2_of_e)));
  }
};

/// f C + (1 - f) C_fog of a block's lanes; colours are scaled as the target's.
template <class Mode>
class FogOverBlock {
 public:
  HWY_INLINE FogOverBlock(const FragmentBlock& block, float scale)
      : mode_(block.primitive->binding->state.fog),
        coordinate_(block.varying[static_cast<std::size_t>(block.primitive->binding->varyings.fog_coordinate)].data()) {
    const glm::vec3& color = block.primitive->binding->state.fog.color;
    for (int k = 0; k < 3; ++k) color_[k] = color[k] * scale;
  }
  HWY_INLINE void blend(std::size_t lane, FloatVector& r, FloatVector& g, FloatVector& b) const {
    const FloatTag d;
    const FloatVector f = clamp_to_unit(d, mode_.factor(hn::Load(d, coordinate_ + lane)));
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
  const float* coordinate_;
  float color_[3];
};

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
