// Takes a block with its colours, gives the block without the fragments that fail [GL1.5 §4.1.4].
#include "pipeline/fragment/alpha.h"

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/alpha.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Which outcomes of a comparison pass.
struct Passing {
  bool less, equal, greater;
};
HWY_INLINE Passing passing(CompareFunc func) {
  using enum CompareFunc;
  return {func == less || func == lequal || func == notequal || func == always,
          func == equal || func == lequal || func == gequal || func == always,
          func == greater || func == gequal || func == notequal || func == always};
}

/// The nearest integer, for floats in [0, 2^22].
HWY_INLINE FloatVector rounded(FloatVector v) {
  const FloatVector magic = hn::Set(FloatTag(), rounding_magic);
  return hn::Sub(hn::Add(v, magic), magic);
}

template <bool rounds>
HWY_INLINE void test(FragmentBlock& block, float scale) {
  const FloatTag d;
  const AlphaTestState& state = block.primitive->binding->state.alpha_test;
  const Passing pass = passing(state.func);
  const auto all_or_none = [](bool all) HWY_ATTR { return all ? ~std::uint64_t{0} : 0; };
  FloatVector reference = hn::Set(d, state.reference * scale);
  if constexpr (rounds) reference = rounded(reference);
  std::uint64_t below = 0, equal = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    FloatVector alpha = hn::Load(d, block.color[3].data() + lane);
    if constexpr (rounds) alpha = rounded(alpha);
    below |= bits_of(d, hn::Lt(alpha, reference)) << lane;
    equal |= bits_of(d, hn::Eq(alpha, reference)) << lane;
  }
  block.coverage &= (below & all_or_none(pass.less)) | (equal & all_or_none(pass.equal)) |
                    (~(below | equal) & all_or_none(pass.greater));
}

void alpha_test_8(FragmentBlock& block, const TileTarget&) { test<true>(block, 255.0f); }
void alpha_test_16(FragmentBlock& block, const TileTarget&) { test<false>(block, 65535.0f); }
void alpha_test_float(FragmentBlock& block, const TileTarget&) { test<false>(block, 1.0f); }

FragmentPass select(ColorFormat format) {
  switch (format) {
    case ColorFormat::rgba8: return alpha_test_8;
    case ColorFormat::rgba16: return alpha_test_16;
    case ColorFormat::rgba32f:
    case ColorFormat::none: break;
  }
  return alpha_test_float;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass alpha_test_pass(ColorFormat format) { return GOURAUD_SIMD_PICK(select)(format); }
}  // namespace gouraud::pipeline
#endif
