// Arithmetic on packed pixels, a byte a channel; for kernels: included inside a kernel file, once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_BYTE_MATH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_BYTE_MATH_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_BYTE_MATH_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_BYTE_MATH_INL_H_
#endif

#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Alpha in all four bytes.
HWY_INLINE IntVector alpha_of(IntVector pixel) {
  const hn::RebindToUnsigned<IntTag> du;
  auto a = hn::ShiftRight<24>(hn::BitCast(du, pixel));
  a = hn::Or(a, hn::ShiftLeft<8>(a));
  return hn::BitCast(IntTag(), hn::Or(a, hn::ShiftLeft<16>(a)));
}

/// Arithmetic on the four bytes of each word.
#if HWY_TARGET == HWY_SCALAR  // has no vectors of bytes
template <class Function>
HWY_INLINE IntVector for_bytes(IntVector a, IntVector b, const Function& function) {
  const auto x = static_cast<std::uint32_t>(hn::GetLane(a)), y = static_cast<std::uint32_t>(hn::GetLane(b));
  std::uint32_t out = 0;
  for (std::uint32_t shift = 0; shift < 32; shift += 8) out |= function(x >> shift & 0xFF, y >> shift & 0xFF) << shift;
  return hn::Set(IntTag(), static_cast<std::int32_t>(out));
}
using Byte = std::uint32_t;
HWY_INLINE IntVector byte_sum(IntVector a, IntVector b) {
  return for_bytes(a, b, [](Byte x, Byte y) { return HWY_MIN(x + y, 255u); });
}
HWY_INLINE IntVector byte_difference(IntVector a, IntVector b) {
  return for_bytes(a, b, [](Byte x, Byte y) { return x > y ? x - y : 0u; });
}
HWY_INLINE IntVector byte_min(IntVector a, IntVector b) {
  return for_bytes(a, b, [](Byte x, Byte y) { return HWY_MIN(x, y); });
}
HWY_INLINE IntVector byte_max(IntVector a, IntVector b) {
  return for_bytes(a, b, [](Byte x, Byte y) { return HWY_MAX(x, y); });
}
HWY_INLINE IntVector byte_product(IntVector a, IntVector b) {
  return for_bytes(a, b, [](Byte x, Byte y) {
    const Byte t = x * y + 128;
    return (t + (t >> 8)) >> 8;
  });
}
#else
using ByteTag = hn::Repartition<std::uint8_t, IntTag>;
HWY_INLINE hn::Vec<ByteTag> bytes(IntVector v) { return hn::BitCast(ByteTag(), v); }
HWY_INLINE IntVector words(hn::Vec<ByteTag> v) { return hn::BitCast(IntTag(), v); }
HWY_INLINE IntVector byte_sum(IntVector a, IntVector b) { return words(hn::SaturatedAdd(bytes(a), bytes(b))); }
HWY_INLINE IntVector byte_difference(IntVector a, IntVector b) { return words(hn::SaturatedSub(bytes(a), bytes(b))); }
HWY_INLINE IntVector byte_min(IntVector a, IntVector b) { return words(hn::Min(bytes(a), bytes(b))); }
HWY_INLINE IntVector byte_max(IntVector a, IntVector b) { return words(hn::Max(bytes(a), bytes(b))); }
/// round(a * b / 255), exactly.
HWY_INLINE IntVector byte_product(IntVector a, IntVector b) {
  const hn::Repartition<std::uint16_t, IntTag> d16;
  const auto rounded = [&](auto x, auto y) HWY_ATTR {
    const auto t = hn::Add(hn::Mul(x, y), hn::Set(d16, std::uint16_t{128}));
    return hn::ShiftRight<8>(hn::Add(t, hn::ShiftRight<8>(t)));
  };
  const auto low_byte = hn::Set(d16, std::uint16_t{0xFF});
  const auto a16 = hn::BitCast(d16, a), b16 = hn::BitCast(d16, b);
  const auto even = rounded(hn::And(a16, low_byte), hn::And(b16, low_byte));
  const auto odd = rounded(hn::ShiftRight<8>(a16), hn::ShiftRight<8>(b16));
  return hn::BitCast(IntTag(), hn::Or(even, hn::ShiftLeft<8>(odd)));
}
#endif

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
