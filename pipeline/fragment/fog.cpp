// Takes a block with colours and fog coordinates, gives colours f C + (1 - f) C_fog; alpha stays [GL1.5 §3.10].
#include "pipeline/fragment/fog.h"

#include <cstddef>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/fog.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/fog-inl.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

template <class Mode>
HWY_INLINE void blend_with_fog(FragmentBlock& block, float scale) {
  const FloatTag d;
  const FogBlend<Mode> fog(block.primitive->binding->state.fog, scale);
  const float* const coordinate = block.varying[fog_coordinate(block)].data();
  float* const red = block.color[0].data();
  float* const green = block.color[1].data();
  float* const blue = block.color[2].data();
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(d)) {
    FloatVector r = hn::Load(d, red + lane), g = hn::Load(d, green + lane), b = hn::Load(d, blue + lane);
    fog.blend(hn::Load(d, coordinate + lane), r, g, b);
    hn::Store(r, d, red + lane);
    hn::Store(g, d, green + lane);
    hn::Store(b, d, blue + lane);
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
    case FogMode::linear: return fog_pass_for<LinearFog>(format);
    case FogMode::exp2: return fog_pass_for<Exp2Fog>(format);
    case FogMode::exp:
    case FogMode::none: break;
  }
  return fog_pass_for<ExpFog>(format);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass fog_pass(FogMode mode, ColorFormat format) { return GOURAUD_SIMD_PICK(select_fog)(mode, format); }
}  // namespace gouraud::pipeline
#endif
