// Takes a block with its varyings, gives its texels, or the bytes of its textured colours. The colour before the first unit is
// multiplied last: white texels give the bytes that the colour alone gives. Leaves out blocks where it has to come first.
//
// Texels and colours are channel pairs: R and B in one word, G and A in the other, each 16 bits that hold 0 to 1 as
// 0 to 32640 (128 * 255): what is filtered and multiplied keeps 7 fractional bits beyond the target's 8, and each step
// rounds to nearest. At most 0.04/255 from exact for one unit, 0.02/255 more for each further one.
//
// A row's texels x and x + 1 are one 64-bit load, if no lane's second texel lies at the row's other end.
#include "pipeline/texture/fixed_units.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/fixed_units.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/texture/channel_pairs-inl.h"
#include "pipeline/texture/levels-inl.h"
#include "pipeline/texture/row_texels-inl.h"
#include "pipeline/texture/texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// A block's channel pairs.
struct PairBlock {
  alignas(64) std::int32_t even[64], odd[64];
};
HWY_INLINE ChannelPairs load(const PairBlock& from, std::size_t lane) {
  return {hn::Load(IntTag(), from.even + lane), hn::Load(IntTag(), from.odd + lane)};
}
HWY_INLINE void store(const ChannelPairs& v, std::size_t lane, PairBlock& to) {
  hn::Store(v.even, IntTag(), to.even + lane);
  hn::Store(v.odd, IntTag(), to.odd + lane);
}

/// One axis of a level. Adding rounding_magic to an integral coordinate leaves it in the low bits, which `index_bits` keep.
struct FixedAxis {
  float size;
  std::int32_t last, index_bits;
  bool repeats;

  HWY_INLINE FixedAxis(const PreparedLevel& level, std::size_t k, WrapMode wrap)
      : size(static_cast<float>(level.size[k])), last(level.size[k] - 1),
        index_bits(wrap == WrapMode::repeat ? last : 0x3FFFFF), repeats(wrap == WrapMode::repeat) {}

  /// What of a coordinate counts: the same for all levels.
  HWY_INLINE FloatVector wrapped(FloatVector s) const { return repeats ? hn::Sub(s, hn::Floor(s)) : s; }
  HWY_INLINE IntVector index_of(FloatVector floor) const {
    return hn::And(bits_after_adding(rounding_magic, floor), hn::Set(IntTag(), index_bits));
  }
  /// Of a wrapped coordinate.
  HWY_INLINE IntVector nearest(FloatVector s) const {
    return index_of(hn::Floor(kept_between(hn::Mul(s, hn::Set(FloatTag(), size)), 0.0f, size - 0.5f)));
  }
  /// The two texels and the second one's share, in both halves of a word.
  HWY_INLINE void linear(FloatVector s, IntVector& first, IntVector& second, IntVector& weight) const {
    const FloatTag d;
    const IntTag di;
    FloatVector u = hn::Sub(hn::Mul(s, hn::Set(d, size)), hn::Set(d, 0.5f));
    if (!repeats) u = kept_between(u, 0.0f, size - 1.0f);
    const FloatVector floor = hn::Floor(u);
    weight = pair_weight(hn::Sub(u, floor));
    first = index_of(floor);
    const IntVector next = hn::Add(first, hn::Set(di, 1)), most = hn::Set(di, last);
    second = repeats ? hn::And(next, most) : hn::Min(next, most);
  }
};

HWY_INLINE TexelPair adjacent_texels(const std::byte* texels, IntVector offset) {
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_AVX3
  const IntTag d;
  const hn::Half<IntTag> half;
  const hn::Repartition<std::int64_t, IntTag> d64;
  const auto* base = reinterpret_cast<const std::int64_t*>(texels);
  const IntVector bytes = hn::ShiftLeft<2>(offset);
  const auto low = hn::BitCast(d, hn::GatherOffset(d64, base, hn::PromoteTo(d64, hn::LowerHalf(half, bytes))));
  const auto high = hn::BitCast(d, hn::GatherOffset(d64, base, hn::PromoteTo(d64, hn::UpperHalf(half, bytes))));
  return {hn::ConcatEven(d, high, low), hn::ConcatOdd(d, high, low)};
#else
  return {gather_word<4>(texels, offset), gather_word<4>(texels + 4, offset)};
#endif
}

/// A level as the kernel reads it. Coordinates are wrapped.
struct FixedLevel {
  const std::byte* texels;
  FixedAxis x, y;
  std::int32_t row, count;

  HWY_INLINE FixedLevel(const PreparedUnit& unit, std::int32_t index)
      : FixedLevel(unit.level(0, index), unit.state.sampler) {}
  HWY_INLINE FixedLevel(const PreparedLevel& level, const SamplerState& sampler)
      : texels(level.texels), x(level, 0, sampler.wrap[0]), y(level, 1, sampler.wrap[1]), row(level.stride[1]),
        count(level.stride[2]) {}

  HWY_INLINE IntVector nearest(FloatVector s, FloatVector t) const {
    return gather_word<4>(texels, hn::Add(x.nearest(s), hn::Mul(y.nearest(t), hn::Set(IntTag(), row))));
  }
  HWY_INLINE ChannelPairs linear(FloatVector s, FloatVector t) const {
    const IntTag d;
    IntVector x0, x1, y0, y1, weight_x, weight_y;
    x.linear(s, x0, x1, weight_x);
    y.linear(t, y0, y1, weight_y);
    y0 = hn::Mul(y0, hn::Set(d, row));
    y1 = hn::Mul(y1, hn::Set(d, row));
    TexelPair low, high;
    if (HWY_LIKELY(hn::AllFalse(d, hn::Eq(x0, hn::Set(d, x.last))))) {
      if (reads_along_rows && texels_along_rows(texels, count, x0, y0, y1, low, high)) return mixed(low, high, weight_x, weight_y);
      low = adjacent_texels(texels, hn::Add(x0, y0));
      high = adjacent_texels(texels, hn::Add(x0, y1));
    } else {
      low = {gather_word<4>(texels, hn::Add(x0, y0)), gather_word<4>(texels, hn::Add(x1, y0))};
      high = {gather_word<4>(texels, hn::Add(x0, y1)), gather_word<4>(texels, hn::Add(x1, y1))};
    }
    return mixed(low, high, weight_x, weight_y);
  }
  static HWY_INLINE ChannelPairs mixed(const TexelPair& low, const TexelPair& high, IntVector weight_x, IntVector weight_y) {
    return lerp(lerp(pairs_of(low.first), pairs_of(low.second), weight_x), lerp(pairs_of(high.first), pairs_of(high.second), weight_x),
                weight_y);
  }
  template <TexelFilter filter>
  HWY_INLINE ChannelPairs read(FloatVector s, FloatVector t) const {
    if constexpr (filter == TexelFilter::linear) return linear(s, t);
    else return pairs_of(nearest(s, t));
  }
};

/// Levels of a unit's texture into channel pairs (levels-inl.h).
struct PairReader {
  const PreparedUnit& unit;
  const float *s, *t;
  PairBlock& out;

  template <class Read>
  HWY_INLINE void for_lanes(std::uint64_t lanes, bool keeps_others, const Read& read) {
    const IntTag d;
    const FloatTag df;
    for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
      const std::uint64_t wanted = lane_bits(lanes, lane);
      if (wanted == 0) continue;
      ChannelPairs v = read(hn::Load(df, s + lane), hn::Load(df, t + lane), lane);
      if (keeps_others && !all_lanes(wanted)) {
        const auto mask = mask_of(d, wanted);
        const ChannelPairs old = load(out, lane);
        v = {hn::IfThenElse(mask, v.even, old.even), hn::IfThenElse(mask, v.odd, old.odd)};
      }
      store(v, lane, out);
    }
  }
  template <TexelFilter filter>
  HWY_INLINE void read_one(std::int32_t index, std::uint64_t lanes, bool keeps_others) {
    const FixedLevel level(unit, index);
    for_lanes(lanes, keeps_others, [&](FloatVector u, FloatVector v, std::size_t) HWY_ATTR {
      return level.read<filter>(level.x.wrapped(u), level.y.wrapped(v));
    });
  }
  HWY_NOINLINE void read(std::int32_t index, TexelFilter filter, std::uint64_t lanes, bool keeps_others) {
    if (filter == TexelFilter::linear) read_one<TexelFilter::linear>(index, lanes, keeps_others);
    else read_one<TexelFilter::nearest>(index, lanes, keeps_others);
  }
  template <TexelFilter filter>
  HWY_INLINE void read_both(std::int32_t index, const float* share, std::uint64_t lanes, bool keeps_others) {
    const FixedLevel level(unit, index), next(unit, index + 1);
    for_lanes(lanes, keeps_others, [&](FloatVector s_lanes, FloatVector t_lanes, std::size_t lane) HWY_ATTR {
      const FloatVector u = level.x.wrapped(s_lanes), v = level.y.wrapped(t_lanes);
      return lerp(level.read<filter>(u, v), next.read<filter>(u, v), pair_weight(hn::Load(FloatTag(), share + lane)));
    });
  }
  HWY_NOINLINE void read_two(std::int32_t index, const float* share, std::uint64_t lanes, bool keeps_others) {
    if (unit.state.sampler.minify == TexelFilter::linear) read_both<TexelFilter::linear>(index, share, lanes, keeps_others);
    else read_both<TexelFilter::nearest>(index, share, lanes, keeps_others);
  }
};

HWY_INLINE void sample(const FragmentBlock& block, const PreparedUnit& unit, const DividedCoordinates& at, PairBlock& out) {
  PairReader reader{unit, at.coordinate[0], at.coordinate[1], out};
  if (needs_no_lod(unit.state.sampler)) return reader.read(0, unit.state.sampler.minify, block.coverage, false);
  read_levels(unit, reader, coordinate_planes(block, layout_of(block, unit)), block.coverage, false);
}

/// The filtered texels of a unit, for what works in float.
void sample_in_float(const FragmentBlock& block, const PreparedUnit& unit, TexelBlock& out) {
  PairBlock texels;
  sample(block, unit, DividedCoordinates(block, layout_of(block, unit)), texels);
  const bool opaque = unit.base_format == BaseFormat::rgb;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(IntTag())) {
    if (lane_bits(block.coverage, lane) == 0) continue;
    TexelVector value = texels_of(load(texels, lane));
    if (opaque) value.channel[3] = hn::Set(FloatTag(), 1.0f);
    for (std::size_t k = 0; k < 4; ++k) hn::Store(value.channel[k], FloatTag(), out.channel[k].data() + lane);
  }
}

/// The colours before the first unit.
enum class Primary : std::uint8_t { white, constant, varying };
HWY_INLINE Primary primary_of(const FragmentBlock& block) {
  if (!block.primitive->binding->colors) return Primary::white;  // they count for nothing
  const ColorRecord& color = color_of(*block.primitive);
  if (color.variation != ColorVariation::constant) return Primary::varying;
  return color.base == std::array{1.0f, 1.0f, 1.0f, 1.0f} ? Primary::white : Primary::constant;
}

/// Whether it makes no difference that they are multiplied last.
HWY_INLINE bool all_modulate(const TextureUnits& units) {
  return std::all_of(units.unit.begin(), units.unit.begin() + units.count,
                     [](const PreparedUnit& unit) { return unit.state.environment.mode == EnvironmentMode::modulate; });
}

/// Alpha from one, the other channels from another.
HWY_INLINE ChannelPairs with_alpha(const ChannelPairs& rgb, IntVector alpha_odd) {
  const IntVector bits = hn::Set(IntTag(), static_cast<std::int32_t>(0xFFFF0000u));
  return {rgb.even, hn::Or(hn::AndNot(bits, rgb.odd), hn::And(bits, alpha_odd))};
}

/// The unit's function [GL1.5 Tables 3.22, 3.23]. An RGB texel's alpha is 1 whatever lies in memory.
HWY_INLINE ChannelPairs applied(const PreparedUnit& unit, ChannelPairs texel, const ChannelPairs& previous) {
  const bool opaque = unit.base_format == BaseFormat::rgb;
  if (unit.state.environment.mode != EnvironmentMode::modulate) return opaque ? with_alpha(texel, previous.odd) : texel;
  if (opaque) texel = with_alpha(texel, hn::Set(IntTag(), pair_one));
  return product(texel, factors_from(previous));
}

/// Whether the only unit gives texels as they are.
HWY_INLINE bool gives_texels(const TextureUnits& units) {
  const SamplerState& sampler = units.unit[0].state.sampler;
  return units.count == 1 && sampler.minify == TexelFilter::nearest && needs_no_lod(sampler);
}

void copy_texels(FragmentBlock& block, const PreparedUnit& unit) {
  const DividedCoordinates at(block, layout_of(block, unit));
  const FixedLevel level(unit, 0);
  const IntVector bits = hn::Set(IntTag(), word_map(unit.base_format).bits);
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(IntTag())) {
    const IntVector texel = level.nearest(level.x.wrapped(hn::Load(FloatTag(), at.coordinate[0] + lane)),
                                          level.y.wrapped(hn::Load(FloatTag(), at.coordinate[1] + lane)));
    hn::Store(hn::Or(texel, bits), IntTag(), block.words.word.data() + lane);
  }
}

using UnitTexels = std::array<PairBlock, max_texture_units>;

/// The units' texels of a vector, one applied to the other.
HWY_INLINE ChannelPairs combined(const TextureUnits& units, const UnitTexels& texels, std::size_t lane) {
  ChannelPairs color = load(texels[0], lane);
  if (units.unit[0].base_format == BaseFormat::rgb) color = with_alpha(color, hn::Set(IntTag(), pair_one));
  for (std::size_t i = 1; i < static_cast<std::size_t>(units.count); ++i) color = applied(units.unit[i], load(texels[i], lane), color);
  return color;
}

/// The bytes of texels times the block's colours, in float.
HWY_INLINE IntVector multiplied(const FragmentBlock& block, const ChannelPairs& texels, float scale, std::size_t lane) {
  const FloatTag d;
  const TexelVector value = texels_of(texels);
  const auto channel = [&](std::size_t k) HWY_ATTR {
    return hn::Mul(hn::Mul(hn::Load(d, block.color[k].data() + lane), value.channel[k]), hn::Set(d, scale));
  };
  return pack_unorm8(channel(0), channel(1), channel(2), channel(3));
}

/// word_of(lane) for the vectors between the first covered one and the last.
template <class WordOf>
HWY_INLINE void store_words(FragmentBlock& block, const WordOf& word_of) {
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(IntTag())) {
    hn::Store(word_of(lane), IntTag(), block.words.word.data() + lane);
  }
}

HWY_INLINE void store_products(FragmentBlock& block, const TextureUnits& units, const UnitTexels& texels, Primary primary) {
  const auto texel = [&](std::size_t lane) HWY_ATTR { return combined(units, texels, lane); };
  if (primary == Primary::white) return store_words(block, [&](std::size_t lane) HWY_ATTR { return bytes_of(texel(lane)); });
  if (primary == Primary::varying) {
    return store_words(block, [&](std::size_t lane) HWY_ATTR { return multiplied(block, texel(lane), units.output_scale, lane); });
  }
  const auto& color = color_of(*block.primitive).base;
  const FactorPairs factors = factors_of(color[0], color[1], color[2], color[3]);
  store_words(block, [&](std::size_t lane) HWY_ATTR { return bytes_of(product(texel(lane), factors)); });
}

bool apply_units(FragmentBlock& block, const TextureUnits& units) {
  const PreparedUnit& first = units.unit[0];
  const bool replaces = first.state.environment.mode == EnvironmentMode::replace && first.base_format == BaseFormat::rgba;
  Primary primary = replaces ? Primary::white : primary_of(block);
  if (primary != Primary::white && !all_modulate(units)) return false;
  if (gives_texels(units)) {
    if (primary == Primary::white) {
      copy_texels(block, first);
      return true;
    }
    // Bytes times a constant are often half way between two bytes: they go where floats take them, as with llvmpipe.
    primary = Primary::varying;
  }
  UnitTexels texels;
  const auto count = static_cast<std::size_t>(units.count);
  for (std::size_t i = 0; i < count; ++i) {
    const DividedCoordinates at(block, layout_of(block, units.unit[i]));
    sample(block, units.unit[i], at, texels[i]);
  }
  store_products(block, units, texels, primary);
  return true;
}

FixedUnitsFunction select_fixed_units() { return apply_units; }
SampleFunction select_sample() { return sample_in_float; }

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
namespace {

bool suits(const PreparedLevel& level, const SamplerState& sampler) {
  const auto suits_axis = [&](std::size_t k) {
    const bool power_of_two = (level.size[k] & (level.size[k] - 1)) == 0;
    return level.border[k] == 0 && !sampler.mirrored_once[k] && (sampler.wrap[k] == WrapMode::clamp_to_edge || (sampler.wrap[k] == WrapMode::repeat && power_of_two));
  };
  return !level.tiled && suits_axis(0) && suits_axis(1);
}

bool suits(const PreparedUnit& unit) {
  if (unit.state.target != TextureTarget::two_d || unit.format != TexelFormat::rgba8 || unit.srgb) return false;
  if (unit.state.sampler.max_anisotropy > 1) return false;
  if (unit.base_format != BaseFormat::rgba && unit.base_format != BaseFormat::rgb) return false;
  return std::all_of(unit.levels.begin(), unit.levels.end(), [&](const PreparedLevel& level) { return suits(level, unit.state.sampler); });
}

bool replaces_or_modulates(const PreparedUnit& unit) {
  const EnvironmentMode mode = unit.state.environment.mode;
  return mode == EnvironmentMode::replace || mode == EnvironmentMode::modulate ||
         (mode == EnvironmentMode::decal && unit.base_format == BaseFormat::rgb);
}

}  // namespace

SampleFunction fixed_sample_function(const PreparedUnit& unit) { return suits(unit) ? GOURAUD_SIMD_PICK(select_sample)() : nullptr; }

FixedUnitsFunction fixed_units_function(const TextureUnits& units) {
  const auto end = units.unit.begin() + units.count;
  if (!std::all_of(units.unit.begin(), end, [](const PreparedUnit& unit) { return suits(unit) && replaces_or_modulates(unit); })) return nullptr;
  return GOURAUD_SIMD_PICK(select_fixed_units)();
}

}  // namespace gouraud::pipeline
#endif
