// Colours as pairs of 16-bit numbers, two channels a word, and their arithmetic; for kernels: included inside a kernel
// file, once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_CHANNEL_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_CHANNEL_PAIRS_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_CHANNEL_PAIRS_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_CHANNEL_PAIRS_INL_H_
#endif

#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Channels R and B (low half, high half), and G and A; a byte times 128 each.
struct ChannelPairs {
  IntVector even, odd;
};
inline constexpr std::int32_t pair_bits = 0x7F807F80;
inline constexpr std::int32_t pair_one = pair_bits;  ///< 255 in both halves
inline constexpr float pair_scale = 1.0f / (255.0f * 128.0f);

HWY_INLINE ChannelPairs pairs_of(IntVector word) {
  const IntVector bits = hn::Set(IntTag(), pair_bits);
  return {hn::And(hn::ShiftLeft<7>(word), bits), hn::And(hn::ShiftRight<1>(word), bits)};
}

/// The bytes of R, G, B, A, rounded.
HWY_INLINE IntVector bytes_of(const ChannelPairs& v) {
  const IntTag d;
  const IntVector half = hn::Set(d, 0x00400040), even_bytes = hn::Set(d, 0x00FF00FF);
  const IntVector even = hn::And(hn::ShiftRight<7>(hn::Add(v.even, half)), even_bytes);
  return hn::Or(even, hn::AndNot(even_bytes, hn::ShiftLeft<1>(hn::Add(v.odd, half))));
}

/// function(x, y) on both halves.
#if HWY_TARGET == HWY_SCALAR  // has no vectors of two halves
template <class Function>
HWY_INLINE IntVector for_halves(IntVector a, IntVector b, const Function& function) {
  const auto half = [](IntVector v, int shift) { return static_cast<std::int32_t>(static_cast<std::int16_t>(static_cast<std::uint32_t>(hn::GetLane(v)) >> shift)); };
  std::uint32_t out = 0;
  for (const int shift : {0, 16}) out |= (static_cast<std::uint32_t>(function(half(a, shift), half(b, shift))) & 0xFFFF) << shift;
  return hn::Set(IntTag(), static_cast<std::int32_t>(out));
}
#endif

/// a * b / 2^15 in both halves, rounded to nearest.
HWY_INLINE IntVector multiply_halves(IntVector a, IntVector b) {
#if HWY_TARGET == HWY_SCALAR
  return for_halves(a, b, [](std::int32_t x, std::int32_t y) { return (x * y + (1 << 14)) >> 15; });
#else
  const hn::Repartition<std::int16_t, IntTag> d16;
  return hn::BitCast(IntTag(), hn::MulFixedPoint15(hn::BitCast(d16, a), hn::BitCast(d16, b)));
#endif
}

/// a + (b - a) * weight in both halves; weights are 15-bit fractions.
HWY_INLINE IntVector lerp_pairs(IntVector a, IntVector b, IntVector weight) {
#if HWY_TARGET == HWY_SCALAR
  const auto sum = [](IntVector x, IntVector y) { return for_halves(x, y, [](std::int32_t u, std::int32_t v) { return u + v; }); };
  const auto difference = [](IntVector x, IntVector y) { return for_halves(x, y, [](std::int32_t u, std::int32_t v) { return u - v; }); };
  return sum(a, multiply_halves(difference(b, a), weight));
#else
  const hn::Repartition<std::int16_t, IntTag> d16;
  const auto from = hn::BitCast(d16, a);
  const auto rise = hn::BitCast(IntTag(), hn::Sub(hn::BitCast(d16, b), from));
  return hn::BitCast(IntTag(), hn::Add(from, hn::BitCast(d16, multiply_halves(rise, weight))));
#endif
}

HWY_INLINE ChannelPairs lerp(const ChannelPairs& a, const ChannelPairs& b, IntVector weight) {
  return {lerp_pairs(a.even, b.even, weight), lerp_pairs(a.odd, b.odd, weight)};
}

/// A weight in [0, 1] as a 15-bit fraction in both halves; what would round to 1 is the largest that fits. A NaN's bits do
/// not become a negative number.
HWY_INLINE IntVector pair_weight(FloatVector weight) {
  const IntTag d;
  const IntVector fraction = bits_after_adding(rounding_magic_positive, hn::Mul(weight, hn::Set(FloatTag(), 32768.0f)));
#if HWY_TARGET == HWY_SCALAR
  const IntVector low = hn::Min(hn::And(fraction, hn::Set(d, 0xFFFF)), hn::Set(d, 0x7FFF));
#else
  const hn::Repartition<std::uint16_t, IntTag> d16;  // the upper half becomes 0
  const IntVector low = hn::BitCast(d, hn::Min(hn::BitCast(d16, fraction), hn::BitCast(d16, hn::Set(d, 0x7FFF))));
#endif
  return hn::Or(low, hn::ShiftLeft<16>(low));
}

/// Colours to multiply with: 0 to 1 as 0 to 32768, so that 1 and 1/2 are exact.
struct FactorPairs {
  IntVector even, odd;
};
/// v * 256 / 255, at most 1/2 off.
HWY_INLINE FactorPairs factors_from(const ChannelPairs& v) {
  const auto fixed = [](IntVector pair) HWY_ATTR {
    const IntVector rounded = hn::Add(pair, hn::Set(IntTag(), 0x00800080));
    return hn::Add(pair, hn::And(hn::ShiftRight<8>(rounded), hn::Set(IntTag(), 0x00FF00FF)));
  };
  return {fixed(v.even), fixed(v.odd)};
}

/// A channel in [0, 1] as a factor: to nearest, but so that with it 255 becomes the byte that the channel alone becomes.
HWY_INLINE std::int32_t factor_of(float channel) {
  const FloatTag d;
  const FloatVector value = hn::Set(d, channel);
  const auto to_nearest = [&](float most) HWY_ATTR {
    return hn::GetLane(bits_after_adding(rounding_magic, hn::Mul(value, hn::Set(d, most)))) - rounding_bits;
  };
  // product() gives 32640 f / 2^15, rounded down, and bytes_of() the nearest multiple of 128.
  constexpr std::int64_t full = 128 * 255;
  const auto least = [](std::int64_t sum) { return static_cast<std::int32_t>(((sum << 15) + full - 1) / full); };
  const std::int64_t byte = to_nearest(255.0f);
  const std::int32_t lowest = byte == 0 ? 0 : least(128 * byte - 64), highest = byte == 255 ? 32768 : least(128 * byte + 64) - 1;
  const std::int32_t nearest = to_nearest(32768.0f);
  return nearest < lowest ? lowest : nearest > highest ? highest : nearest;
}
HWY_INLINE FactorPairs factors_of(float r, float g, float b, float a) {
  const IntTag d;
  const auto pair = [&](float low, float high) HWY_ATTR {
    return hn::Set(d, static_cast<std::int32_t>(static_cast<std::uint32_t>(factor_of(low)) | static_cast<std::uint32_t>(factor_of(high)) << 16));
  };
  return {pair(r, b), pair(g, a)};
}

/// Rounded down.
HWY_INLINE ChannelPairs product(const ChannelPairs& a, const FactorPairs& b) {
  const auto multiplied = [](IntVector x, IntVector y) HWY_ATTR {
#if HWY_TARGET == HWY_SCALAR
    return for_halves(x, y, [](std::int32_t u, std::int32_t v) { return u * (v & 0xFFFF) >> 15; });
#else
    const hn::Repartition<std::uint16_t, IntTag> d16;
    return hn::BitCast(IntTag(), hn::MulHigh(hn::BitCast(d16, hn::Add(x, x)), hn::BitCast(d16, y)));
#endif
  };
  return {multiplied(a.even, b.even), multiplied(a.odd, b.odd)};
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
