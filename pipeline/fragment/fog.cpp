// Takes a block with colours and fog coordinates, gives colours f C + (1 - f) C_fog; alpha stays [GL1.5 §3.10]. The factor
// f is computed for every fragment (MESA-RULES 6) and clamped to [0, 1]; where it is not a number it is 0.
#include "pipeline/fragment/fog.h"

#include <cstddef>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/fog.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// [GL1.5 §3.10 eq 3.25]: (end - c) / (end - start).
struct Linear {
  float end, range;
  explicit Linear(const FogState& fog) : end(fog.end), range(fog.end - fog.start) {}
  HWY_INLINE FloatVector factor(FloatVector c) const {
    const FloatTag d;
    return hn::Div(hn::Sub(hn::Set(d, end), c), hn::Set(d, range));
  }
};
inline constexpr float log2_of_e = 1.44269504088896340736f;
/// [GL1.5 §3.10 eq 3.23]: exp(-density c).
struct Exp {
  float scale;
  explicit Exp(const FogState& fog) : scale(-fog.density * log2_of_e) {}
  HWY_INLINE FloatVector factor(FloatVector c) const { return exp2(FloatTag(), hn::Mul(c, hn::Set(FloatTag(), scale))); }
};
/// [GL1.5 §3.10 eq 3.24]: exp(-(density c)^2).
struct Exp2 {
  float density;
  explicit Exp2(const FogState& fog) : density(fog.density) {}
  HWY_INLINE FloatVector factor(FloatVector c) const {
    const FloatTag d;
    const FloatVector depth = hn::Mul(c, hn::Set(d, density));
    return exp2(d, hn::Mul(hn::Mul(depth, depth), hn::Set(d, -log2_of_e)));
  }
};

template <class Mode>
HWY_INLINE void blend_with_fog(FragmentBlock& block, float scale) {
  const FloatTag d;
  const RasterBinding& binding = *block.primitive->binding;
  const FogState& fog = binding.state.fog;
  const Mode mode(fog);
  const float* coordinate = block.varying[static_cast<std::size_t>(binding.varyings.fog_coordinate)].data();
  const FloatVector color[3] = {hn::Set(d, fog.color.x * scale), hn::Set(d, fog.color.y * scale), hn::Set(d, fog.color.z * scale)};
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(d)) {
    const FloatVector f = clamp_to_unit(d, mode.factor(hn::Load(d, coordinate + lane)));
    const FloatVector rest = hn::Sub(hn::Set(d, 1.0f), f);
    for (std::size_t k = 0; k < 3; ++k) {
      float* at = block.color[k].data() + lane;
      hn::Store(hn::Add(hn::Mul(hn::Load(d, at), f), hn::Mul(color[k], rest)), d, at);
    }
  }
}

template <class Mode>
void fog_8(FragmentBlock& block, const TileTarget&) { blend_with_fog<Mode>(block, 255.0f); }
template <class Mode>
void fog_16(FragmentBlock& block, const TileTarget&) { blend_with_fog<Mode>(block, 65535.0f); }
template <class Mode>
void fog_float(FragmentBlock& block, const TileTarget&) { blend_with_fog<Mode>(block, 1.0f); }

template <class Mode>
FragmentPass fog_pass_for(ColorFormat format) {
  switch (format) {
    case ColorFormat::rgba8: return fog_8<Mode>;
    case ColorFormat::rgba16: return fog_16<Mode>;
    case ColorFormat::rgba32f:
    case ColorFormat::none: break;
  }
  return fog_float<Mode>;
}

FragmentPass select_fog(FogMode mode, ColorFormat format) {
  switch (mode) {
    case FogMode::linear: return fog_pass_for<Linear>(format);
    case FogMode::exp2: return fog_pass_for<Exp2>(format);
    case FogMode::exp:
    case FogMode::none: break;
  }
  return fog_pass_for<Exp>(format);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass fog_pass(FogMode mode, ColorFormat format) { return GOURAUD_SIMD_PICK(select_fog)(mode, format); }
}  // namespace gouraud::pipeline
#endif
