// Takes depths as they are stored, gives floats. The division is exact to the last bit, so that all ones give 1.
#include "pipeline/framebuffer/depth_values.h"

#include <cstdint>
#include <cstring>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/framebuffer/depth_values.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::RebindToSigned<FloatTag>;

/// load(i) gives the depths from i on as integers; they are divided by `most`.
template <class Word, class Load>
HWY_INLINE void convert(const std::byte* in, std::size_t count, std::byte* out, float most, std::uint32_t bits, [[maybe_unused]] const Load& load) {
  std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR  // knows no memory that is not aligned
  const FloatTag d;
  auto* const to = reinterpret_cast<float*>(out);
  for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) hn::StoreU(hn::Div(hn::ConvertTo(d, load(i)), hn::Set(d, most)), d, to + i);
#endif
  for (; i < count; ++i) {
    Word word;
    std::memcpy(&word, in + i * sizeof(Word), sizeof word);
    const float depth = static_cast<float>(static_cast<std::int32_t>(word & bits)) / most;
    std::memcpy(out + i * sizeof depth, &depth, sizeof depth);
  }
}

void convert_z16(const std::byte* in, std::size_t count, std::byte* out) {
  const hn::Rebind<std::uint16_t, IntTag> narrow;
  convert<std::uint16_t>(in, count, out, 65535.0f, 0xFFFF, [&](std::size_t i) HWY_ATTR {
    return hn::PromoteTo(IntTag(), hn::LoadU(narrow, reinterpret_cast<const std::uint16_t*>(in) + i));
  });
}

void convert_z24s8(const std::byte* in, std::size_t count, std::byte* out) {
  convert<std::uint32_t>(in, count, out, 16777215.0f, 0xFFFFFF, [&](std::size_t i) HWY_ATTR {
    return hn::And(hn::LoadU(IntTag(), reinterpret_cast<const std::int32_t*>(in) + i), hn::Set(IntTag(), 0xFFFFFF));
  });
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
void depths_of_z16(const std::byte* in, std::size_t count, std::byte* out) { GOURAUD_SIMD_PICK(convert_z16)(in, count, out); }
void depths_of_z24s8(const std::byte* in, std::size_t count, std::byte* out) { GOURAUD_SIMD_PICK(convert_z24s8)(in, count, out); }
void depths_of_z32(const std::byte* in, std::size_t count, std::byte* out) {
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t word;
    std::memcpy(&word, in + i * sizeof word, sizeof word);
    const auto depth = static_cast<float>(word / 4294967295.0);
    std::memcpy(out + i * sizeof depth, &depth, sizeof depth);
  }
}
}  // namespace gouraud::pipeline
#endif
