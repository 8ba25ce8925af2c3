// Takes two rows of 8-bit texels, gives the row of the next level of a mipmap: the box filter of images with even sizes,
// which nearly all are. Leaves out everything else (mipmaps.cpp).
//
// Bytes are summed in 16 bits, the even and the odd ones of a vector apart, so that a vector of four-channel texels takes
// two masks, two additions of rows and two of neighbours. It pays: 1024 x 1024 texels and all levels take 0.2 ms in place of 0.9.
#include "pipeline/texture/halved_rows.h"

#include <cstdint>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/halved_rows.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The channels of all texels from `first` on, one by one.
void halve_rest(const std::uint8_t* a, const std::uint8_t* b, std::size_t channels, std::size_t first, std::size_t width,
                std::uint8_t* out) {
  for (std::size_t i = first; i < width; ++i) {
    for (std::size_t c = 0; c < channels; ++c) {
      const std::size_t left = 2 * i * channels + c, right = left + channels;
      out[i * channels + c] = static_cast<std::uint8_t>((a[left] + a[right] + b[left] + b[right] + 2) >> 2);
    }
  }
}

#if HWY_TARGET == HWY_SCALAR  // has no vectors of bytes
template <class Pair>
std::size_t halve_vectors(const std::uint8_t*, const std::uint8_t*, std::size_t, std::uint8_t*) { return 0; }
#else

/// A vector of pairs of neighbours from both rows: the mean of each four in the low half of the pair.
template <class Pair>
HWY_INLINE hn::Vec<hn::ScalableTag<Pair>> mean_of_pairs(const std::uint8_t* a, const std::uint8_t* b) {
  const hn::ScalableTag<Pair> pairs;
  const hn::Repartition<std::uint8_t, decltype(pairs)> bytes;
  const hn::Repartition<std::uint16_t, decltype(pairs)> sums;
  const auto lower = hn::BitCast(sums, hn::LoadU(bytes, a)), upper = hn::BitCast(sums, hn::LoadU(bytes, b));
  const auto low_byte = hn::Set(sums, std::uint16_t{0xFF}), half = hn::Set(sums, std::uint16_t{2});
  const auto even = hn::Add(hn::And(lower, low_byte), hn::And(upper, low_byte));
  const auto odd = hn::Add(hn::ShiftRight<8>(lower), hn::ShiftRight<8>(upper));
  if constexpr (sizeof(Pair) == 2) {  // one channel: the neighbours are the even and the odd bytes
    return hn::ShiftRight<2>(hn::Add(hn::Add(even, odd), half));
  } else {
    constexpr int texel_bits = 4 * sizeof(Pair);
    const auto mean = [&](hn::Vec<decltype(sums)> sum) HWY_ATTR {
      const auto neighbour = hn::BitCast(sums, hn::ShiftRight<texel_bits>(hn::BitCast(pairs, sum)));
      return hn::ShiftRight<2>(hn::Add(hn::Add(sum, neighbour), half));
    };
    return hn::BitCast(pairs, hn::Or(mean(even), hn::ShiftLeft<8>(mean(odd))));
  }
}

/// Two vectors of pairs at a time, as long as there are; gives the number of texels made.
template <class Pair>
std::size_t halve_vectors(const std::uint8_t* a, const std::uint8_t* b, std::size_t width, std::uint8_t* out) {
  constexpr std::size_t channels = sizeof(Pair) / 2;
  const hn::ScalableTag<Pair> pairs;
  using Texel = hwy::UnsignedFromSize<channels>;
  const hn::Repartition<Texel, decltype(pairs)> texels;
  const hn::Repartition<std::uint8_t, decltype(pairs)> bytes;
  const std::size_t step = 2 * hn::Lanes(pairs), vector = hn::Lanes(bytes);
  std::size_t done = 0;
  for (; done + step <= width; done += step, a += 2 * vector, b += 2 * vector) {
    const auto first = mean_of_pairs<Pair>(a, b), second = mean_of_pairs<Pair>(a + vector, b + vector);
    const auto low_halves = hn::ConcatEven(texels, hn::BitCast(texels, second), hn::BitCast(texels, first));
    hn::StoreU(hn::BitCast(bytes, low_halves), bytes, out + done * channels);
  }
  return done;
}
#endif

void halve(const std::byte* lower, const std::byte* upper, int channels, int width, std::byte* out) {
  const auto* const a = reinterpret_cast<const std::uint8_t*>(lower);
  const auto* const b = reinterpret_cast<const std::uint8_t*>(upper);
  auto* const to = reinterpret_cast<std::uint8_t*>(out);
  const auto texels = static_cast<std::size_t>(width);
  const std::size_t done = channels == 4   ? halve_vectors<std::uint64_t>(a, b, texels, to)
                           : channels == 2 ? halve_vectors<std::uint32_t>(a, b, texels, to)
                                           : halve_vectors<std::uint16_t>(a, b, texels, to);
  halve_rest(a, b, static_cast<std::size_t>(channels), done, texels, to);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

void halve_rows_unorm8(const std::byte* lower, const std::byte* upper, int channels, int width, std::byte* out) {
  GOURAUD_SIMD_PICK(halve)(lower, upper, channels, width, out);
}

}  // namespace gouraud::pipeline
#endif
