// Takes a block with textured colours and secondary colours, gives their sum, clamped; alpha stays [GL1.5 §3.9].
#include "pipeline/fragment/color_sum.h"

#include <cstddef>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/color_sum.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE void add_secondary(FragmentBlock& block, float scale) {
  const FloatTag d;
  const auto first = static_cast<std::size_t>(block.primitive->binding->varyings.secondary_color);
  const FloatVector one = hn::Set(d, scale);
  for (std::size_t k = 0; k < 3; ++k) {
    const float* secondary = block.varying[first + k].data();
    float* color = block.color[k].data();
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
      const FloatVector sum = hn::Add(hn::Load(d, color + lane), hn::Mul(hn::Load(d, secondary + lane), one));
      hn::Store(clamp_lanes(sum, hn::Zero(d), one), d, color + lane);
    }
  }
}

void color_sum_8(FragmentBlock& block, const TileTarget&) { add_secondary(block, 255.0f); }
void color_sum_16(FragmentBlock& block, const TileTarget&) { add_secondary(block, 65535.0f); }
void color_sum_float(FragmentBlock& block, const TileTarget&) { add_secondary(block, 1.0f); }

FragmentPass select_color_sum(ColorFormat format) {
  switch (format) {
    case ColorFormat::rgba8: return color_sum_8;
    case ColorFormat::rgba16: return color_sum_16;
    case ColorFormat::rgba32f:
    case ColorFormat::none: break;
  }
  return color_sum_float;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass color_sum_pass(ColorFormat format) { return GOURAUD_SIMD_PICK(select_color_sum)(format); }
}  // namespace gouraud::pipeline
#endif
