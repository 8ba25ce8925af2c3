// Takes a block and its primitive's varying planes, gives the block with its varyings [GL1.5 §3.5.1 eq 3.6].
#include "pipeline/fragment/varyings.h"

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/varyings.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/varyings-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

template <LanesWanted wanted>
void interpolate_varyings(FragmentBlock& block, const TileTarget&) {
  interpolate(block, wanted == LanesWanted::all ? PairRange{0, row_pairs} : covered_pairs(block.coverage));
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
