// Texels x and x + 1 of two rows of a texture, for lanes that read along these rows; for kernels: included inside a kernel file,
// once per instruction set.
//
// Takes the places of the lanes' texels, gives the texels, or says that it cannot. A vector of 16 lanes is two rows of eight
// pixels. Where each of the two stays in one row of the texture and there within 16 texels (a level of detail takes fewer than
// two a pixel), as on walls, floors and sprites that stand upright, one load and one permutation do what a gather does. It pays:
// ten trilinear layers of the screen take 70 ms in place of 93. Leaves out smaller vectors.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_ROW_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_ROW_TEXELS_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_ROW_TEXELS_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_ROW_TEXELS_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/texture/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX3
inline constexpr bool reads_along_rows = true;

alignas(64) constexpr std::int32_t first_of_row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 8, 8, 8, 8, 8, 8, 8, 8};
alignas(64) constexpr std::int32_t last_of_row[16] = {7, 7, 7, 7, 7, 7, 7, 7, 15, 15, 15, 15, 15, 15, 15, 15};

/// `x` counts along a row; `low` and `high` are where the rows of texels begin. False if the lanes do not read along them, or
/// if a load would end behind texel `count`: then nothing has been read.
HWY_INLINE bool texels_along_rows(const std::byte* texels, std::int32_t count, IntVector x, IntVector low, IntVector high,
                                  TexelPair& low_texels, TexelPair& high_texels) {
  const IntTag d;
  const auto of_row = [&](IntVector v, const std::int32_t* lanes) HWY_ATTR {
    return hn::TableLookupLanes(v, hn::IndicesFromVec(d, hn::Load(d, lanes)));
  };
  const IntVector start = hn::Min(of_row(x, first_of_row), of_row(x, last_of_row));
  const IntVector first = hn::Sub(x, start), second = hn::Add(first, hn::Set(d, 1));
  const IntVector outside = hn::AndNot(hn::Set(d, 15), hn::Or(first, second)), other_row = hn::Xor(low, of_row(low, first_of_row));
  if (!hn::AllTrue(d, hn::Eq(hn::Or(outside, other_row), hn::Zero(d)))) return false;

  alignas(64) std::int32_t at_low[16], at_high[16];
  hn::Store(hn::Add(start, low), d, at_low);
  hn::Store(hn::Add(start, high), d, at_high);
  const std::int32_t last = HWY_MAX(HWY_MAX(at_low[0], at_low[8]), HWY_MAX(at_high[0], at_high[8]));
  if (last + 16 > count) return false;

  const auto* const words = reinterpret_cast<const std::int32_t*>(texels);
  const auto lower_half = hn::FirstN(d, 8);
  const auto first_index = hn::IndicesFromVec(d, first), second_index = hn::IndicesFromVec(d, second);
  const auto pair_of = [&](const std::int32_t* at) HWY_ATTR {
    const IntVector a = hn::LoadU(d, words + at[0]), b = hn::LoadU(d, words + at[8]);
    const auto pick = [&](const auto& index) HWY_ATTR {
      return hn::IfThenElse(lower_half, hn::TableLookupLanes(a, index), hn::TableLookupLanes(b, index));
    };
    return TexelPair{pick(first_index), pick(second_index)};
  };
  low_texels = pair_of(at_low);
  high_texels = pair_of(at_high);
  return true;
}
#else
inline constexpr bool reads_along_rows = false;
HWY_INLINE bool texels_along_rows(const std::byte*, std::int32_t, IntVector, IntVector, IntVector, TexelPair&, TexelPair&) { return false; }
#endif

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
