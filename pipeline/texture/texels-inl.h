// Texels as they lie in memory to lanes of numbers [GL1.5 §3.8.1 Table 3.15]; for kernels: included inside a kernel file,
// once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_TEXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_TEXELS_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_TEXELS_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_TEXELS_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/texture/channel_pairs-inl.h"
#include "pipeline/texture/texel_access.h"
#include "pipeline/texture/texture_units.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Four bytes from `bytes_per_step` * offset; a few may lie behind the texel (Image::texels has spare ones).
template <int bytes_per_step>
HWY_INLINE IntVector gather_word(const std::byte* texels, IntVector offset) {
  const IntTag d;
  const auto* base = reinterpret_cast<const std::int32_t*>(texels);
  if constexpr (bytes_per_step == 4) return hn::GatherIndex(d, base, offset);
  else if constexpr (bytes_per_step == 2) return hn::GatherOffset(d, base, hn::ShiftLeft<1>(offset));
  else return hn::GatherOffset(d, base, offset);
}

/// How the bytes of a texel become a word of R, G, B, A: times, then or.
struct WordMap {
  std::int32_t multiply = 1, bits = 0;
};
HWY_INLINE WordMap word_map(BaseFormat format) {
  constexpr auto opaque = static_cast<std::int32_t>(0xFF000000u);
  switch (format) {
    case BaseFormat::alpha: return {0x01000000, 0};
    case BaseFormat::luminance: return {0x00010101, opaque};
    case BaseFormat::intensity:
    case BaseFormat::depth: return {0x01010101, 0};
    case BaseFormat::rgb: return {1, opaque};
    case BaseFormat::luminance_alpha:
    case BaseFormat::rgba: break;
  }
  return {1, 0};
}

/// Texels at offset and offset + 1.
struct TexelPair {
  IntVector first, second;
};

/// 8-bit formats: texels to words of R, G, B, A; where `loads_two`, the one behind comes in the same load.
struct WordsR8 {
  static constexpr bool loads_two = true;
  static HWY_INLINE IntVector load(const std::byte* texels, IntVector offset, const WordMap& map) {
    return word(gather_word<1>(texels, offset), map);
  }
  static HWY_INLINE TexelPair load_two(const std::byte* texels, IntVector offset, const WordMap& map) {
    const IntVector both = gather_word<1>(texels, offset);
    return {word(both, map), word(hn::ShiftRight<8>(both), map)};
  }

 private:
  static HWY_INLINE IntVector word(IntVector bytes, const WordMap& map) {
    const IntTag d;
    const IntVector byte = hn::And(bytes, hn::Set(d, 0xFF));
    return hn::Or(hn::Mul(byte, hn::Set(d, map.multiply)), hn::Set(d, map.bits));
  }
};
struct WordsRG8 {
  static constexpr bool loads_two = true;
  static HWY_INLINE IntVector load(const std::byte* texels, IntVector offset, const WordMap&) {
    return word(gather_word<2>(texels, offset));
  }
  static HWY_INLINE TexelPair load_two(const std::byte* texels, IntVector offset, const WordMap&) {
    const IntVector both = gather_word<2>(texels, offset);
    return {word(both), word(hn::ShiftRight<16>(both))};
  }

 private:
  static HWY_INLINE IntVector word(IntVector bytes) {
    const IntTag d;
    const IntVector luminance = hn::And(bytes, hn::Set(d, 0xFF));
    const IntVector alpha = hn::ShiftLeft<16>(hn::And(bytes, hn::Set(d, 0xFF00)));
    return hn::Or(hn::Or(luminance, hn::ShiftLeft<8>(luminance)), hn::Or(hn::ShiftLeft<16>(luminance), alpha));
  }
};
/// A, L, LA and I in four channels. The map is that of one channel.
struct WordsWide8 {
  static constexpr bool loads_two = false;
  static HWY_INLINE IntVector load(const std::byte* texels, IntVector offset, const WordMap& map) {
    const IntTag d;
    const IntVector word = gather_word<4>(texels, offset), red = hn::And(word, hn::Set(d, 0xFF));
    const IntVector alpha = hn::And(word, hn::Set(d, static_cast<std::int32_t>(0xFF000000u)));
    if (map.multiply == 0x01000000) return alpha;
    if (map.multiply != 1) return hn::Or(hn::Mul(red, hn::Set(d, map.multiply)), hn::Set(d, map.bits));
    return hn::Or(hn::Mul(red, hn::Set(d, 0x00010101)), alpha);
  }
};
struct WordsRGBA8 {
  static constexpr bool loads_two = false;
  static HWY_INLINE IntVector load(const std::byte* texels, IntVector offset, const WordMap& map) {
    return hn::Or(gather_word<4>(texels, offset), hn::Set(IntTag(), map.bits));
  }
};

struct TexelVector {
  FloatVector channel[4];
};

template <int shift>
HWY_INLINE IntVector byte_of(IntVector word) {
  const hn::RebindToUnsigned<IntTag> du;
  return hn::And(hn::BitCast(IntTag(), hn::ShiftRight<shift>(hn::BitCast(du, word))), hn::Set(IntTag(), 0xFF));
}

HWY_INLINE FloatVector scaled(IntVector v, float scale) {
  const FloatTag d;
  return hn::Mul(hn::ConvertTo(d, v), hn::Set(d, scale));
}

HWY_INLINE TexelVector unpack_unorm8(IntVector word) {
  constexpr float unit = 1.0f / 255.0f;
  return {{scaled(byte_of<0>(word), unit), scaled(byte_of<8>(word), unit), scaled(byte_of<16>(word), unit), scaled(byte_of<24>(word), unit)}};
}

HWY_INLINE TexelVector texels_of(const ChannelPairs& v) {
  const hn::RebindToUnsigned<IntTag> du;
  const auto low = [](IntVector pair) HWY_ATTR { return scaled(hn::And(pair, hn::Set(IntTag(), 0xFFFF)), pair_scale); };
  const auto high = [&](IntVector pair) HWY_ATTR {
    return scaled(hn::BitCast(IntTag(), hn::ShiftRight<16>(hn::BitCast(du, pair))), pair_scale);
  };
  return {{low(v.even), low(v.odd), high(v.even), high(v.odd)}};
}

/// Formats for the kernels that filter in float. Each gives R, G, B, A by base format.
template <class Words>
struct Unorm8 {
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    return unpack_unorm8(Words::load(texels, offset, word_map(unit.base_format)));
  }
};

template <class Words>
struct Srgb8 {
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    const FloatTag d;
    const IntVector word = Words::load(texels, offset, word_map(unit.base_format));
    const float* table = srgb_table().data();
    return {{hn::GatherIndex(d, table, byte_of<0>(word)), hn::GatherIndex(d, table, byte_of<8>(word)),
             hn::GatherIndex(d, table, byte_of<16>(word)), scaled(byte_of<24>(word), 1.0f / 255.0f)}};
  }
};

/// One stored channel to R, G, B, A. Of R, G, B it is R.
HWY_INLINE TexelVector spread(FloatVector v, BaseFormat format) {
  const FloatTag d;
  switch (format) {
    case BaseFormat::alpha: return {{hn::Zero(d), hn::Zero(d), hn::Zero(d), v}};
    case BaseFormat::luminance: return {{v, v, v, hn::Set(d, 1.0f)}};
    case BaseFormat::rgb: return {{v, hn::Zero(d), hn::Zero(d), hn::Set(d, 1.0f)}};
    default: break;
  }
  return {{v, v, v, v}};
}

/// Four stored channels to R, G, B, A.
HWY_INLINE TexelVector wide_texel(BaseFormat format, const TexelVector& v) {
  const FloatTag d;
  const FloatVector red = v.channel[0], alpha = v.channel[3], one = hn::Set(d, 1.0f), zero = hn::Zero(d);
  switch (format) {
    case BaseFormat::alpha: return {{zero, zero, zero, alpha}};
    case BaseFormat::luminance: return {{red, red, red, one}};
    case BaseFormat::luminance_alpha: return {{red, red, red, alpha}};
    case BaseFormat::intensity:
    case BaseFormat::depth: return {{red, red, red, red}};
    case BaseFormat::rgb: return {{red, v.channel[1], v.channel[2], one}};
    case BaseFormat::rgba: break;
  }
  return v;
}

HWY_INLINE FloatVector low_half(IntVector word) {
  return scaled(hn::And(word, hn::Set(IntTag(), 0xFFFF)), 1.0f / 65535.0f);
}
HWY_INLINE FloatVector high_half(IntVector word) {
  const hn::RebindToUnsigned<IntTag> du;
  return scaled(hn::BitCast(IntTag(), hn::ShiftRight<16>(hn::BitCast(du, word))), 1.0f / 65535.0f);
}

struct R16 {
  static HWY_INLINE FloatVector value(const std::byte* texels, IntVector offset) { return low_half(gather_word<2>(texels, offset)); }
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    return spread(value(texels, offset), unit.base_format);
  }
};
struct RG16 {
  static HWY_INLINE TexelVector load(const PreparedUnit&, const std::byte* texels, IntVector offset) {
    const IntVector word = gather_word<4>(texels, offset);
    const FloatVector luminance = low_half(word);
    return {{luminance, luminance, luminance, high_half(word)}};
  }
};
struct RGBA16 {
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    const IntVector twice = hn::ShiftLeft<1>(offset);
    const IntVector rg = gather_word<4>(texels, twice), ba = gather_word<4>(texels + 4, twice);
    return wide_texel(unit.base_format, {{low_half(rg), high_half(rg), low_half(ba), high_half(ba)}});
  }
};
struct RGBA32F {
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    const FloatTag d;
    const IntVector four_times = hn::ShiftLeft<2>(offset);
    const auto channel = [&](std::size_t k) HWY_ATTR {
      return hn::BitCast(d, gather_word<4>(texels + 4 * k, four_times));
    };
    return wide_texel(unit.base_format, {{channel(0), channel(1), channel(2), channel(3)}});
  }
};
struct Z24S8 {
  static HWY_INLINE FloatVector value(const std::byte* texels, IntVector offset) {
    return scaled(hn::And(gather_word<4>(texels, offset), hn::Set(IntTag(), 0xFFFFFF)), 1.0f / 16777215.0f);
  }
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    return spread(value(texels, offset), unit.base_format);
  }
};
struct Z32F {
  static HWY_INLINE FloatVector value(const std::byte* texels, IntVector offset) {
    return hn::BitCast(FloatTag(), gather_word<4>(texels, offset));
  }
  static HWY_INLINE TexelVector load(const PreparedUnit& unit, const std::byte* texels, IntVector offset) {
    return spread(value(texels, offset), unit.base_format);
  }
};

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
