#include "pipeline/texture/texel_access.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace gouraud::pipeline {
namespace {

template <class Word>
Word load(const std::byte* from, std::size_t index = 0) {
  Word word;
  std::memcpy(&word, from + index * sizeof(Word), sizeof(Word));
  return word;
}

template <class Word>
void store(Word word, std::byte* to, std::size_t index = 0) {
  std::memcpy(to + index * sizeof(Word), &word, sizeof(Word));
}

template <class Word>
Texel load_unorm(const std::byte* texel, std::size_t count) {
  constexpr double largest = static_cast<Word>(~Word{0});
  Texel out{};
  for (std::size_t k = 0; k < count; ++k) out[k] = static_cast<float>(load<Word>(texel, k) / largest);
  return out;
}

constexpr std::array<float, 256> unorm8_values = [] {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<float>(static_cast<double>(i) / 255.0);
  return table;
}();
template <>
Texel load_unorm<std::uint8_t>(const std::byte* texel, std::size_t count) {
  Texel out{};
  for (std::size_t k = 0; k < count; ++k) out[k] = unorm8_values[load<std::uint8_t>(texel, k)];
  return out;
}

/// NaN becomes 0.
double unit(float value) { return value > 0.0f ? std::min(static_cast<double>(value), 1.0) : 0.0; }

template <class Word>
void store_unorm(const Texel& channels, std::byte* texel, std::size_t count) {
  constexpr double largest = static_cast<Word>(~Word{0});
  for (std::size_t k = 0; k < count; ++k) store(static_cast<Word>(std::nearbyint(unit(channels[k]) * largest)), texel, k);
}

constexpr double z24_largest = 0xFFFFFF;

/// x^(1/5) for x in (0, 1], by Newton's steps: the same everywhere, which a library's pow need not be.
double fifth_root(double x) {
  double y = 1.0;
  for (int step = 0; step < 60; ++step) {
    const double y2 = y * y;
    y = (4.0 * y + x / (y2 * y2)) / 5.0;
  }
  return y;
}

/// x^2.4.
double power_2_4(double x) { return x * x * fifth_root(x * x); }

std::array<float, 256> make_srgb_table() {
  std::array<float, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<float>(linear_of_srgb(static_cast<double>(i) / 255.0));
  }
  return table;
}

/// Linear values half-way (in the encoding) between neighbours: byte i + 1 begins at entry i.
std::array<float, 255> make_srgb_thresholds() {
  std::array<float, 255> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<float>(linear_of_srgb((static_cast<double>(i) + 0.5) / 255.0));
  }
  return table;
}

}  // namespace

Texel stored_channels(TexelFormat format, const std::byte* texel) {
  switch (format) {
    case TexelFormat::none: break;
    case TexelFormat::r8: return load_unorm<std::uint8_t>(texel, 1);
    case TexelFormat::rg8: return load_unorm<std::uint8_t>(texel, 2);
    case TexelFormat::rgba8: return load_unorm<std::uint8_t>(texel, 4);
    case TexelFormat::r16:
    case TexelFormat::z16: return load_unorm<std::uint16_t>(texel, 1);
    case TexelFormat::rg16: return load_unorm<std::uint16_t>(texel, 2);
    case TexelFormat::rgba16: return load_unorm<std::uint16_t>(texel, 4);
    case TexelFormat::rgba32f: return {load<float>(texel, 0), load<float>(texel, 1), load<float>(texel, 2), load<float>(texel, 3)};
    case TexelFormat::z24s8: return {static_cast<float>((load<std::uint32_t>(texel) & 0xFFFFFF) / z24_largest)};
    case TexelFormat::z32f: return {load<float>(texel)};
  }
  return {};
}

void store_channels(TexelFormat format, const Texel& channels, std::byte* texel) {
  switch (format) {
    case TexelFormat::none: break;
    case TexelFormat::r8: return store_unorm<std::uint8_t>(channels, texel, 1);
    case TexelFormat::rg8: return store_unorm<std::uint8_t>(channels, texel, 2);
    case TexelFormat::rgba8: return store_unorm<std::uint8_t>(channels, texel, 4);
    case TexelFormat::r16:
    case TexelFormat::z16: return store_unorm<std::uint16_t>(channels, texel, 1);
    case TexelFormat::rg16: return store_unorm<std::uint16_t>(channels, texel, 2);
    case TexelFormat::rgba16: return store_unorm<std::uint16_t>(channels, texel, 4);
    case TexelFormat::rgba32f:
      for (std::size_t k = 0; k < 4; ++k) store(channels[k], texel, k);
      return;
    case TexelFormat::z24s8: return store(static_cast<std::uint32_t>(std::nearbyint(unit(channels[0]) * z24_largest)), texel);
    case TexelFormat::z32f: return store(channels[0], texel);
  }
}

Texel expand_channels(const Image& image, const Texel& c) {
  const auto decoded = [&](float value) {
    return image.srgb ? decode_srgb(static_cast<std::uint8_t>(std::nearbyint(unit(value) * 255.0))) : value;
  };
  const bool wide = has_four_channels(image.format);
  switch (image.base_format) {
    case BaseFormat::alpha: return {0, 0, 0, wide ? c[3] : c[0]};
    case BaseFormat::luminance: {
      const float l = decoded(c[0]);
      return {l, l, l, 1};
    }
    case BaseFormat::luminance_alpha: {
      const float l = decoded(c[0]);
      return {l, l, l, wide ? c[3] : c[1]};
    }
    case BaseFormat::intensity:
    case BaseFormat::depth: return {c[0], c[0], c[0], c[0]};
    case BaseFormat::rgb: return {decoded(c[0]), decoded(c[1]), decoded(c[2]), 1};
    case BaseFormat::rgba: break;
  }
  return {decoded(c[0]), decoded(c[1]), decoded(c[2]), c[3]};
}

double linear_of_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : power_2_4((encoded + 0.055) / 1.055);
}

const std::array<float, 256>& srgb_table() {
  static const std::array<float, 256> table = make_srgb_table();
  return table;
}

float decode_srgb(std::uint8_t encoded) { return srgb_table()[encoded]; }

std::uint8_t encode_srgb(float linear) {
  static const std::array<float, 255> thresholds = make_srgb_thresholds();
  if (!(linear > 0.0f)) return 0;
  return static_cast<std::uint8_t>(std::upper_bound(thresholds.begin(), thresholds.end(), linear) - thresholds.begin());
}

}  // namespace gouraud::pipeline
