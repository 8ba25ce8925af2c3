// Takes a block of a smooth primitive with its colours, gives it with alpha times coverage [GL1.5 §3.11].
#include "pipeline/fragment/coverage.h"

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/coverage.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

void apply_coverage(FragmentBlock& block, const TileTarget&) {
  if (block.primitive->shape == nullptr || !block.primitive->shape->smooth) return;
  const FloatTag d;
  float* alpha = block.color[3].data();
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    hn::Store(hn::Mul(hn::Load(d, alpha + lane), hn::Load(d, block.pixel_coverage.data() + lane)), d, alpha + lane);
  }
}

FragmentPass select_coverage() { return apply_coverage; }

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass coverage_pass() { return GOURAUD_SIMD_PICK(select_coverage)(); }
}  // namespace gouraud::pipeline
#endif
