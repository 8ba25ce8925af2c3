// Takes two rows of sRGB-encoded bytes, gives the row of the next level of a mipmap; see halved_rows.cpp.
//
// A byte's linear value is a whole number of 2^-28, looked up, so that sums are exact. Where a sum lies among the bytes says a
// table of 4096 stretches and one comparison: no two bytes begin in one stretch. Vectors would not be quicker: they look
// tables up lane by lane, and a power takes longer. 1024 x 1024 texels and all levels take 1.1 ms in place of 300.
#include "pipeline/texture/halved_srgb_rows.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "pipeline/texture/texel_access.h"

namespace gouraud::pipeline {
namespace {

constexpr int stretch_bits = 18, stretches = 1 << (30 - stretch_bits);

/// Of four values, to half a unit each: so that a mean exactly between two bytes, which dark ones can have, is the upper one.
constexpr std::uint32_t rounding = 2;

struct Tables {
  std::array<std::uint32_t, 256> linear{};  ///< of bytes, in units of 2^-28
  std::array<std::uint32_t, 256> next{};    ///< the least sum of four, in units of 2^-30 of their mean, that is byte i + 1
  std::array<std::uint8_t, stretches + 1> first{};  ///< the byte where a stretch of sums begins

  Tables() {
    for (std::size_t i = 0; i < 256; ++i) {
      const auto byte = static_cast<double>(i);
      linear[i] = static_cast<std::uint32_t>(std::nearbyint(std::ldexp(linear_of_srgb(byte / 255.0), 28)));
      next[i] = i == 255 ? ~std::uint32_t{0} : static_cast<std::uint32_t>(std::ceil(std::ldexp(linear_of_srgb((byte + 0.5) / 255.0), 30))) - rounding;
    }
    std::uint8_t byte = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (i << stretch_bits >= next[byte]) ++byte;
      first[i] = byte;
    }
  }

  std::uint8_t encoded(std::uint32_t sum) const {
    const std::uint8_t byte = first[sum >> stretch_bits];
    return static_cast<std::uint8_t>(byte + (sum >= next[byte] ? 1 : 0));
  }
};

template <std::size_t channels, std::size_t encoded>
void halve(const Tables& tables, const std::uint8_t* a, const std::uint8_t* b, std::size_t width, std::uint8_t* out) {
  for (std::size_t i = 0; i < width; ++i, a += 2 * channels, b += 2 * channels, out += channels) {
    for (std::size_t c = 0; c < channels; ++c) {
      const std::size_t right = c + channels;
      if (c < encoded) {
        out[c] = tables.encoded(tables.linear[a[c]] + tables.linear[a[right]] + tables.linear[b[c]] + tables.linear[b[right]]);
      } else {
        out[c] = static_cast<std::uint8_t>((a[c] + a[right] + b[c] + b[right] + 2) >> 2);
      }
    }
  }
}

}  // namespace

void halve_rows_srgb8(const std::byte* lower, const std::byte* upper, int channels, int width, std::byte* out) {
  static const Tables tables;
  const auto* const a = reinterpret_cast<const std::uint8_t*>(lower);
  const auto* const b = reinterpret_cast<const std::uint8_t*>(upper);
  auto* const to = reinterpret_cast<std::uint8_t*>(out);
  const auto texels = static_cast<std::size_t>(width);
  if (channels == 4) return halve<4, 3>(tables, a, b, texels, to);
  if (channels == 2) return halve<2, 1>(tables, a, b, texels, to);
  halve<1, 1>(tables, a, b, texels, to);
}

}  // namespace gouraud::pipeline
