// Takes a block with its colours, gives the block without the fragments whose alpha leaves this sample out, or with opaque
// ones [GL1.5 §4.1.3]. The colours are those of the sample's own place, and so is the alpha.
#include "pipeline/fragment/sample_alpha.h"

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/sample_alpha.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE void apply_alpha(FragmentBlock& block, const TileTarget& target, float scale) {
  const FloatTag d;
  const RasterState& state = block.primitive->binding->state;
  if (state.alpha_to_coverage != 0) {
    const float least = (static_cast<float>(target.sample) + 0.5f) / static_cast<float>(state.alpha_to_coverage) * scale;
    std::uint64_t covered = 0;
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
      covered |= bits_of(d, hn::Ge(hn::Load(d, block.color[3].data() + lane), hn::Set(d, least))) << lane;
    }
    block.coverage &= covered;
  }
  if (state.alpha_to_one) block.color[3].fill(scale);
}

void sample_alpha_8(FragmentBlock& block, const TileTarget& target) { apply_alpha(block, target, 255.0f); }
void sample_alpha_16(FragmentBlock& block, const TileTarget& target) { apply_alpha(block, target, 65535.0f); }
void sample_alpha_float(FragmentBlock& block, const TileTarget& target) { apply_alpha(block, target, 1.0f); }

FragmentPass select_sample_alpha(ColorFormat format) {
  switch (format) {
    case ColorFormat::rgba8: return sample_alpha_8;
    case ColorFormat::rgba16: return sample_alpha_16;
    case ColorFormat::rgba32f:
    case ColorFormat::none: break;
  }
  return sample_alpha_float;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass sample_alpha_pass(ColorFormat format) { return GOURAUD_SIMD_PICK(select_sample_alpha)(format); }
}  // namespace gouraud::pipeline
#endif
