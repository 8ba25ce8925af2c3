#include "pipeline/texture/s3tc.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace gouraud::pipeline {
namespace {

using Rgb = std::array<int, 3>;

std::uint64_t little_endian(const std::byte* bytes, int count) {
  std::uint64_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | std::to_integer<std::uint64_t>(bytes[i]);
  return value;
}
void put_little_endian(std::uint64_t value, int count, std::byte* bytes) {
  for (int i = 0; i < count; ++i, value >>= 8) bytes[i] = static_cast<std::byte>(value & 0xFF);
}

/// The channels of a 5:6:5 colour, and the most that each can be.
constexpr Rgb most_565{31, 63, 31};
Rgb from_565(unsigned color) {
  return {static_cast<int>(color >> 11 & 31), static_cast<int>(color >> 5 & 63), static_cast<int>(color & 31)};
}
unsigned to_565(const Rgb& c) {
  const auto scaled = [](int value, int most) { return static_cast<unsigned>((value * most + 127) / 255); };
  return scaled(c[0], 31) << 11 | scaled(c[1], 63) << 5 | scaled(c[2], 31);
}

/// (wa a + wb b) / (wa + wb) in bytes, to nearest: a and b are 5:6:5, nothing is rounded before.
Rgb mixed(const Rgb& a, int wa, const Rgb& b, int wb) {
  Rgb result;
  for (std::size_t c = 0; c < 3; ++c) {
    const int whole = (wa + wb) * most_565[c];
    result[c] = (2 * 255 * (wa * a[c] + wb * b[c]) + whole) / (2 * whole);
  }
  return result;
}

/// The four colours that a block's codes choose among; true if the fourth is transparent black.
bool make_palette(unsigned color0, unsigned color1, bool always_four, std::array<Rgb, 4>& palette) {
  const Rgb a = from_565(color0), b = from_565(color1);
  const bool four = always_four || color0 > color1;
  palette = {mixed(a, 1, b, 0), mixed(a, 0, b, 1), four ? mixed(a, 2, b, 1) : mixed(a, 1, b, 1), four ? mixed(a, 1, b, 2) : Rgb{}};
  return !four;
}

/// The eight alphas of DXT5.
std::array<int, 8> alpha_palette(int alpha0, int alpha1) {
  std::array<int, 8> palette{alpha0, alpha1};
  const int steps = alpha0 > alpha1 ? 7 : 5;
  for (int i = 1; i < steps; ++i) {
    palette[static_cast<std::size_t>(i) + 1] = ((steps - i) * alpha0 + i * alpha1 + steps / 2) / steps;
  }
  if (steps == 5) {
    palette[6] = 0;
    palette[7] = 255;
  }
  return palette;
}

void decode_colors(S3tcFormat format, const std::byte* block, TexelBlock& texels) {
  const bool dxt1 = format == S3tcFormat::dxt1_rgb || format == S3tcFormat::dxt1_rgba;
  std::array<Rgb, 4> palette{};
  const bool transparent = make_palette(static_cast<unsigned>(little_endian(block, 2)),
                                        static_cast<unsigned>(little_endian(block + 2, 2)), !dxt1, palette);
  const std::uint64_t codes = little_endian(block + 4, 4);
  for (std::size_t i = 0; i < 16; ++i) {
    const std::size_t code = codes >> (2 * i) & 3;
    for (std::size_t c = 0; c < 3; ++c) texels[4 * i + c] = static_cast<std::uint8_t>(palette[code][c]);
    texels[4 * i + 3] = transparent && code == 3 && format == S3tcFormat::dxt1_rgba ? 0 : 255;
  }
}

Rgb color_of(const TexelBlock& texels, std::size_t i) {
  return {texels[4 * i], texels[4 * i + 1], texels[4 * i + 2]};
}

int distance(const Rgb& a, const Rgb& b) {
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

/// The ends of the colours of the texels in `used` (bits): the extremes along the axis of their bounding box, its
/// diagonal chosen by the sign of each channel's covariance with the widest one.
void find_ends(const TexelBlock& texels, unsigned used, Rgb& low, Rgb& high) {
  Rgb least{255, 255, 255}, most{0, 0, 0}, sum{};
  int count = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    if ((used >> i & 1) == 0) continue;
    const Rgb color = color_of(texels, i);
    for (std::size_t c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], color[c]);
      most[c] = std::max(most[c], color[c]);
      sum[c] += color[c];
    }
    ++count;
  }
  if (count == 0) {
    low = high = {};
    return;
  }
  std::size_t widest = 0;
  for (std::size_t c = 1; c < 3; ++c) {
    if (most[c] - least[c] > most[widest] - least[widest]) widest = c;
  }
  Rgb axis;
  for (std::size_t c = 0; c < 3; ++c) {
    int covariance = 0;
    for (std::size_t i = 0; i < 16; ++i) {
      if ((used >> i & 1) == 0) continue;
      const Rgb color = color_of(texels, i);
      covariance += (count * color[c] - sum[c]) / 16 * ((count * color[widest] - sum[widest]) / 16);
    }
    axis[c] = covariance < 0 ? least[c] - most[c] : most[c] - least[c];
  }
  int first = 0, last = 0;
  bool none = true;
  for (std::size_t i = 0; i < 16; ++i) {
    if ((used >> i & 1) == 0) continue;
    const Rgb color = color_of(texels, i);
    const int along = color[0] * axis[0] + color[1] * axis[1] + color[2] * axis[2];
    if (none || along < first) first = along, low = color;
    if (none || along > last) last = along, high = color;
    none = false;
  }
}

void encode_colors(S3tcFormat format, const TexelBlock& texels, std::byte* block) {
  unsigned opaque = 0xFFFF;
  if (format == S3tcFormat::dxt1_rgba) {
    for (std::size_t i = 0; i < 16; ++i) {
      if (texels[4 * i + 3] < 128) opaque &= ~(1u << i);
    }
  }
  Rgb low{}, high{};
  find_ends(texels, opaque, low, high);
  unsigned color0 = to_565(high), color1 = to_565(low);
  const bool three = opaque != 0xFFFF;  // colours, and transparent black
  if (three ? color0 > color1 : color0 < color1) std::swap(color0, color1);

  std::array<Rgb, 4> palette{};
  const bool always_four = format == S3tcFormat::dxt3 || format == S3tcFormat::dxt5;
  const std::size_t choices = make_palette(color0, color1, always_four, palette) ? 3 : 4;
  std::uint64_t codes = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    std::size_t best = 3;
    if ((opaque >> i & 1) != 0) {
      const Rgb color = color_of(texels, i);
      best = 0;
      for (std::size_t code = 1; code < choices; ++code) {
        if (distance(palette[code], color) < distance(palette[best], color)) best = code;
      }
    }
    codes |= static_cast<std::uint64_t>(best) << (2 * i);
  }
  put_little_endian(color0, 2, block);
  put_little_endian(color1, 2, block + 2);
  put_little_endian(codes, 4, block + 4);
}

/// DXT3: four bits a texel.
void decode_explicit_alpha(const std::byte* block, TexelBlock& texels) {
  const std::uint64_t alphas = little_endian(block, 8);
  for (std::size_t i = 0; i < 16; ++i) texels[4 * i + 3] = static_cast<std::uint8_t>((alphas >> (4 * i) & 15) * 17);
}
void encode_explicit_alpha(const TexelBlock& texels, std::byte* block) {
  std::uint64_t alphas = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    alphas |= static_cast<std::uint64_t>((texels[4 * i + 3] * 15 + 127) / 255) << (4 * i);
  }
  put_little_endian(alphas, 8, block);
}

/// DXT5: two ends and three bits a texel.
void decode_interpolated_alpha(const std::byte* block, TexelBlock& texels) {
  const auto palette = alpha_palette(std::to_integer<int>(block[0]), std::to_integer<int>(block[1]));
  const std::uint64_t codes = little_endian(block + 2, 6);
  for (std::size_t i = 0; i < 16; ++i) texels[4 * i + 3] = static_cast<std::uint8_t>(palette[codes >> (3 * i) & 7]);
}
void encode_interpolated_alpha(const TexelBlock& texels, std::byte* block) {
  int low = 255, high = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    low = std::min<int>(low, texels[4 * i + 3]);
    high = std::max<int>(high, texels[4 * i + 3]);
  }
  const auto palette = alpha_palette(high, low);
  std::uint64_t codes = 0;
  for (std::size_t i = 0; i < 16; ++i) {
    const int alpha = texels[4 * i + 3];
    const auto nearest = std::min_element(palette.begin(), palette.end(), [alpha](int a, int b) {
      return std::abs(a - alpha) < std::abs(b - alpha);
    });
    codes |= static_cast<std::uint64_t>(nearest - palette.begin()) << (3 * i);
  }
  put_little_endian(static_cast<std::uint64_t>(high | low << 8), 2, block);
  put_little_endian(codes, 6, block + 2);
}

}  // namespace

TexelBlock decode_block(S3tcFormat format, const std::byte* block) {
  TexelBlock texels;
  decode_colors(format, block + bytes_per_block(format) - 8, texels);
  if (format == S3tcFormat::dxt3) decode_explicit_alpha(block, texels);
  if (format == S3tcFormat::dxt5) decode_interpolated_alpha(block, texels);
  return texels;
}

void encode_block(S3tcFormat format, const TexelBlock& texels, std::byte* block) {
  encode_colors(format, texels, block + bytes_per_block(format) - 8);
  if (format == S3tcFormat::dxt3) encode_explicit_alpha(texels, block);
  if (format == S3tcFormat::dxt5) encode_interpolated_alpha(texels, block);
}

}  // namespace gouraud::pipeline
