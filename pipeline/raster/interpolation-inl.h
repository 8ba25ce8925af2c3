// Evaluating planes over a block, for kernels: included inside a kernel file, once per instruction set.
//
// The same arithmetic in the same order on every target: a lane in the first two rows of a block has the value
//   base + (dx * column + dy * row),
// where base is the plane at lane 0, computed in double and rounded to float; every further pair of rows adds 2 * dy.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_RASTER_INTERPOLATION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_RASTER_INTERPOLATION_INL_H_
#undef GOURAUD_PIPELINE_RASTER_INTERPOLATION_INL_H_
#else
#define GOURAUD_PIPELINE_RASTER_INTERPOLATION_INL_H_
#endif

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Up to 16 lanes: two rows of a block. Kernels walk a block in four row pairs of 16 / Lanes vectors.
using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::CappedTag<std::int32_t, 16>;
using FloatVector = hn::Vec<FloatTag>;
using IntVector = hn::Vec<IntTag>;
using FloatMask = hn::Mask<FloatTag>;

inline constexpr std::size_t row_pairs = 4;
inline constexpr std::size_t pair_lanes = 16;

alignas(64) constexpr float pair_column[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr float pair_row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};

/// A plane at one block: scalars, before it is spread over lanes.
struct BlockPlane {
  float base, dx, dy;
};

/// The plane's value in lanes [offset, offset + Lanes) of the first row pair.
HWY_INLINE FloatVector first_pair(const BlockPlane& plane, std::size_t offset) {
  const FloatTag d;
  return hn::Add(hn::Set(d, plane.base), hn::Add(hn::Mul(hn::Set(d, plane.dx), hn::Load(d, pair_column + offset)),
                                                 hn::Mul(hn::Set(d, plane.dy), hn::Load(d, pair_row + offset))));
}

/// What a value grows by from one row pair to the next.
HWY_INLINE FloatVector pair_step(const BlockPlane& plane) { return hn::Set(FloatTag(), 2.0f * plane.dy); }

/// The bits of `coverage` for the vector at lane `first_lane`.
HWY_INLINE std::uint64_t lane_bits(std::uint64_t coverage, std::size_t first_lane) {
  return coverage >> first_lane & ((std::uint64_t{1} << hn::Lanes(FloatTag())) - 1);
}

/// The row pairs [first, end) of a block that hold covered lanes. Empty coverage gives [0, 4).
struct PairRange {
  std::size_t first, end;
};
HWY_INLINE PairRange covered_pairs(std::uint64_t coverage) {
  const std::uint64_t lanes = coverage != 0 ? coverage : ~std::uint64_t{0};
  return {static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(lanes)) / pair_lanes,
          (63 - static_cast<std::size_t>(hwy::Num0BitsAboveMS1Bit_Nonzero64(lanes))) / pair_lanes + 1};
}

/// So many blocks have a word of pair bits.
inline constexpr std::size_t word_blocks = 64 / row_pairs;

/// Bit 4 * block + pair: set if the row pair holds pixels. `coverage` is of word_blocks blocks, 64-byte aligned.
HWY_INLINE std::uint64_t find_pairs(const std::uint64_t* coverage) {
  const hn::CappedTag<std::uint16_t, 32> d;
  static_assert(pair_lanes == 16);
  const auto* halves = reinterpret_cast<const std::uint16_t*>(coverage);
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < word_blocks * row_pairs; i += hn::Lanes(d)) {
    std::uint64_t found = 0;
    hn::StoreMaskBits(d, hn::Ne(hn::Load(d, halves + i), hn::Zero(d)), reinterpret_cast<std::uint8_t*>(&found));
    bits |= found << i;
  }
  return bits;
}

HWY_INLINE bool all_lanes(std::uint64_t bits) { return bits == (std::uint64_t{1} << hn::Lanes(FloatTag())) - 1; }

/// The mask whose lane i is bit i. (Through one word: byte stores followed by a wider load would stall.)
template <class D>
HWY_INLINE hn::Mask<D> mask_of(D d, std::uint64_t bits) {
  return hn::LoadMaskBits(d, reinterpret_cast<const std::uint8_t*>(&bits));
}

template <class D>
HWY_INLINE std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}

/// Adding it to a float of magnitude below 2^22 leaves the nearest integer (ties to even) in the low bits: the sum's
/// bits are rounding_bits plus that integer. Cheaper than a conversion that is defined for every float.
inline constexpr float rounding_magic = 12582912.0f;  // 1.5 * 2^23
inline constexpr std::int32_t rounding_bits = 0x4B400000;

/// The same for floats in [0, 2^23): the bits are 0x4B000000 plus the integer, so shifting left by 8 or more drops all
/// but the integer.
inline constexpr float rounding_magic_positive = 8388608.0f;  // 2^23
inline constexpr std::int32_t rounding_bits_positive = 0x4B000000;

HWY_INLINE IntVector bits_after_adding(float magic, FloatVector v) {
  return hn::BitCast(IntTag(), hn::Add(v, hn::Set(FloatTag(), magic)));
}

/// One byte a channel, from floats in [0, 255] (give or take what rounding forgives): R, G, B with 0 for A, and A with 0 for them.
HWY_INLINE IntVector pack_rgb8(FloatVector r, FloatVector g, FloatVector b) {
  const auto byte = [](FloatVector v) HWY_ATTR { return bits_after_adding(rounding_magic_positive, v); };
  const IntVector low = hn::Or(hn::Xor(byte(r), hn::Set(IntTag(), rounding_bits_positive)), hn::ShiftLeft<8>(byte(g)));
  return hn::Or(low, hn::ShiftLeft<16>(byte(b)));
}
HWY_INLINE IntVector pack_alpha8(FloatVector a) { return hn::ShiftLeft<24>(bits_after_adding(rounding_magic_positive, a)); }
HWY_INLINE IntVector pack_unorm8(FloatVector r, FloatVector g, FloatVector b, FloatVector a) {
  return hn::Or(pack_rgb8(r, g, b), pack_alpha8(a));
}

/// Clamp with a defined result for NaN: the lower bound.
HWY_INLINE FloatVector clamp_lanes(FloatVector v, FloatVector low, FloatVector high) {
  return hn::Min(hn::Max(v, low), high);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
