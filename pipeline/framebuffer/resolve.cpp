// Takes the bytes of four samples, gives their averages: sums of 16 bits, (s + 1 + the bit above the half) / 4.
#include "pipeline/framebuffer/resolve.h"

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/framebuffer/resolve.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// As many bytes from each sample as a vector holds sums, at a time. Returns where it ended.
template <class Words>
HWY_INLINE std::size_t average(Words words, const std::byte* const (&samples)[max_samples], std::byte* out, std::size_t from, std::size_t size) {
  const hn::Rebind<std::uint8_t, Words> bytes;
  const auto at = [&](std::size_t k, std::size_t i) HWY_ATTR {
    return hn::PromoteTo(words, hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(samples[k] + i)));
  };
  const auto one = hn::Set(words, 1);
  for (; from + hn::Lanes(bytes) <= size; from += hn::Lanes(bytes)) {
    const auto sum = hn::Add(hn::Add(at(0, from), at(1, from)), hn::Add(at(2, from), at(3, from)));
    const auto to_even = hn::And(hn::ShiftRight<2>(sum), one);
    const auto mean = hn::ShiftRight<2>(hn::Add(hn::Add(sum, one), to_even));
    hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(hn::RebindToSigned<Words>(), mean)), bytes, reinterpret_cast<std::uint8_t*>(out + from));
  }
  return from;
}

void average_bytes(const std::byte* const (&samples)[max_samples], std::byte* out, std::size_t size) {
  const std::size_t done = average(hn::CappedTag<std::uint16_t, 32>(), samples, out, 0, size);
  average(hn::CappedTag<std::uint16_t, 4>(), samples, out, done, size);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
static_assert(max_samples == 4, "a sum is divided by 4");
ByteAverager byte_averager() { return GOURAUD_SIMD_PICK(average_bytes); }
}  // namespace gouraud::pipeline
#endif
