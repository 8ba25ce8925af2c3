// Takes offsets and weights along the axes (wrap-inl.h), gives R, G, B, A of each lane. 8-bit texels in two dimensions are
// filtered in 16-bit fixed point with 7 fractional bits, two channels a word: at most 0.02/255 from exact, of which the
// weights' 15 bits are 0.012 each. All else in float. Comparison [GL1.5 §3.8.14] comes before filtering: a linear filter gives
// the weighted share of the texels that pass, as Mesa does.
#include "pipeline/texture/level_kernels.h"

#include <algorithm>

#include "pipeline/draw/draw_state.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/level_kernels.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/texture/channel_pairs-inl.h"
#include "pipeline/texture/texels-inl.h"
#include "pipeline/texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE void store_texels(const LevelRead& read, std::uint64_t wanted, std::size_t lane, const TexelVector& value, TexelBlock& out) {
  const FloatTag d;
  for (std::size_t k = 0; k < 4; ++k) {
    float* to = out.channel[k].data() + lane;
    if (!read.keeps_others || all_lanes(wanted)) hn::Store(value.channel[k], d, to);
    else hn::Store(hn::IfThenElse(mask_of(d, wanted), value.channel[k], hn::Load(d, to)), d, to);
  }
}

HWY_INLINE IntVector corner_offset(const LevelRead& read, std::size_t corner, std::size_t dimensions, std::size_t lane) {
  const IntTag d;
  IntVector offset = hn::Zero(d);
  for (std::size_t k = 0; k < dimensions; ++k) {
    const AxisTexels& axis = (*read.axis)[k];
    offset = hn::Add(offset, hn::Load(d, ((corner >> k & 1) != 0 ? axis.second : axis.first).data() + lane));
  }
  return offset;
}

/// What one texel adds to the filter.
template <class Format>
struct Colors {
  static constexpr std::size_t channels = 4;
  static HWY_INLINE void load(const LevelRead& read, IntVector offset, std::size_t, FloatVector* out) {
    const FloatTag d;
    const TexelVector texel = Format::load(*read.unit, read.texels, hn::Max(offset, hn::Zero(IntTag())));
    for (std::size_t k = 0; k < 4; ++k) out[k] = texel.channel[k];
    if (!read.reaches_border) return;
    const auto outside = hn::RebindMask(d, hn::Lt(offset, hn::Zero(IntTag())));
    for (std::size_t k = 0; k < 4; ++k) out[k] = hn::IfThenElse(outside, hn::Set(d, read.unit->border[k]), out[k]);
  }
  static HWY_INLINE TexelVector result(const LevelRead&, const FloatVector* v) { return {{v[0], v[1], v[2], v[3]}}; }
};

/// The comparison's result in place of the depth [GL1.5 Table 3.27].
template <class Format>
struct Comparison {
  static constexpr std::size_t channels = 1;
  static HWY_INLINE void load(const LevelRead& read, IntVector offset, std::size_t lane, FloatVector* out) {
    const FloatTag d;
    FloatVector depth = Format::value(read.texels, hn::Max(offset, hn::Zero(IntTag())));
    if (read.reaches_border) {
      depth = hn::IfThenElse(hn::RebindMask(d, hn::Lt(offset, hn::Zero(IntTag()))), hn::Set(d, read.unit->border[0]), depth);
    }
    const FloatVector r = hn::Load(d, read.compared + lane);
    const std::uint8_t func = read.unit->state.sampler.compare_func;
    // The number's bits say which outcomes pass: 1 less, 2 equal, 4 greater.
    static_assert(static_cast<int>(CompareFunc::lequal) == 3 && static_cast<int>(CompareFunc::greater) == 4 &&
                  static_cast<int>(CompareFunc::notequal) == 5 && static_cast<int>(CompareFunc::always) == 7);
    const auto one_if = [&](int bit) HWY_ATTR { return hn::Set(d, (func & bit) != 0 ? 1.0f : 0.0f); };
    out[0] = hn::IfThenElse(hn::Lt(r, depth), one_if(1), hn::IfThenElse(hn::Eq(r, depth), one_if(2), one_if(4)));
  }
  static HWY_INLINE TexelVector result(const LevelRead& read, const FloatVector* v) { return spread(v[0], read.unit->base_format); }
};

/// Any number of dimensions, in float: the texels of the corners, then one axis after the other.
template <class Source, bool linear>
void read_in_float(const LevelRead& read, TexelBlock& out) {
  const FloatTag d;
  const auto dimensions = static_cast<std::size_t>(read.unit->dimensions);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(read.lanes, lane);
    if (wanted == 0) continue;
    FloatVector texel[linear ? 8 : 1][Source::channels];
    const std::size_t corners = linear ? std::size_t{1} << dimensions : 1;
    for (std::size_t corner = 0; corner < corners; ++corner) {
      Source::load(read, corner_offset(read, corner, dimensions, lane), lane, texel[corner]);
    }
    if constexpr (linear) {
      for (std::size_t k = 0, count = corners / 2; k < dimensions; ++k, count /= 2) {
        const FloatVector weight = hn::Load(d, (*read.axis)[k].weight.data() + lane);
        for (std::size_t i = 0; i < count; ++i) {
          for (std::size_t c = 0; c < Source::channels; ++c) {
            const FloatVector a = texel[2 * i][c], b = texel[2 * i + 1][c];
            texel[i][c] = hn::Add(a, hn::Mul(hn::Sub(b, a), weight));
          }
        }
      }
    }
    store_texels(read, wanted, lane, Source::result(read, texel[0]), out);
  }
}

/// The border colour as channel pairs: rounded to 1/32640.
struct BorderPairs {
  std::int32_t even, odd;
  explicit HWY_INLINE BorderPairs(const std::array<float, 4>& border) {
    const auto fixed = [&](std::size_t k) { return static_cast<std::int32_t>(std::clamp(border[k], 0.0f, 1.0f) * 32640.0f + 0.5f); };
    even = fixed(0) | fixed(2) << 16;
    odd = fixed(1) | fixed(3) << 16;
  }
  HWY_INLINE ChannelPairs where(hn::Mask<IntTag> outside, const ChannelPairs& inside) const {
    const IntTag d;
    return {hn::IfThenElse(outside, hn::Set(d, even), inside.even), hn::IfThenElse(outside, hn::Set(d, odd), inside.odd)};
  }
};

/// A row's two texels of each lane. Where the second ones lie behind the first ones, one load may give both.
template <class Words>
HWY_INLINE TexelPair two_texels(const std::byte* texels, IntVector first, IntVector second, bool behind, const WordMap& map) {
  if constexpr (Words::loads_two) {
    if (behind) return Words::load_two(texels, first, map);
  }
  return {Words::load(texels, first, map), Words::load(texels, second, map)};
}

template <class Words>
void read_bilinear(const LevelRead& read, TexelBlock& out) {
  const IntTag d;
  const AxisTexels &x = (*read.axis)[0], &y = (*read.axis)[1];
  const WordMap map = word_map(read.unit->base_format);
  const BorderPairs border(read.unit->border);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t wanted = lane_bits(read.lanes, lane);
    if (wanted == 0) continue;
    const IntVector x0 = hn::Load(d, x.first.data() + lane), x1 = hn::Load(d, x.second.data() + lane);
    const IntVector y0 = hn::Load(d, y.first.data() + lane), y1 = hn::Load(d, y.second.data() + lane);
    const IntVector weight_x = pair_weight(hn::Load(FloatTag(), x.weight.data() + lane));
    const IntVector weight_y = pair_weight(hn::Load(FloatTag(), y.weight.data() + lane));
    const IntVector signs = hn::Or(hn::Or(x0, x1), hn::Or(y0, y1));
    if (read.reaches_border && !hn::AllFalse(d, hn::Lt(signs, hn::Zero(d)))) {
      const auto texel = [&](IntVector offset) HWY_ATTR {
        const ChannelPairs inside = pairs_of(Words::load(read.texels, hn::Max(offset, hn::Zero(d)), map));
        return border.where(hn::Lt(offset, hn::Zero(d)), inside);
      };
      const ChannelPairs lower = lerp(texel(hn::Add(x0, y0)), texel(hn::Add(x1, y0)), weight_x);
      const ChannelPairs upper = lerp(texel(hn::Add(x0, y1)), texel(hn::Add(x1, y1)), weight_x);
      store_texels(read, wanted, lane, texels_of(lerp(lower, upper, weight_y)), out);
      continue;
    }
    const bool behind = Words::loads_two && hn::AllTrue(d, hn::Eq(x1, hn::Add(x0, hn::Set(d, 1))));
    const TexelPair low = two_texels<Words>(read.texels, hn::Add(x0, y0), hn::Add(x1, y0), behind, map);
    const TexelPair high = two_texels<Words>(read.texels, hn::Add(x0, y1), hn::Add(x1, y1), behind, map);
    const ChannelPairs lower = lerp(pairs_of(low.first), pairs_of(low.second), weight_x);
    const ChannelPairs upper = lerp(pairs_of(high.first), pairs_of(high.second), weight_x);
    store_texels(read, wanted, lane, texels_of(lerp(lower, upper, weight_y)), out);
  }
}

template <class Words>
LevelKernel select_unorm8(const PreparedUnit& unit, bool linear) {
  if (unit.srgb) return linear ? read_in_float<Colors<Srgb8<Words>>, true> : read_in_float<Colors<Srgb8<Words>>, false>;
  if (!linear) return read_in_float<Colors<Unorm8<Words>>, false>;
  return unit.dimensions == 2 ? read_bilinear<Words> : read_in_float<Colors<Unorm8<Words>>, true>;
}

template <class Source>
LevelKernel select_float(bool linear) {
  return linear ? read_in_float<Source, true> : read_in_float<Source, false>;
}

LevelKernel select(const PreparedUnit& unit, bool linear) {
  const bool compares = unit.state.sampler.compares;
  switch (unit.format) {
    case TexelFormat::r8: return select_unorm8<WordsR8>(unit, linear);
    case TexelFormat::rg8: return select_unorm8<WordsRG8>(unit, linear);
    case TexelFormat::rgba8:
      if (unit.widened) return select_unorm8<WordsWide8>(unit, linear);
      break;
    case TexelFormat::none: break;
    case TexelFormat::r16:
    case TexelFormat::z16: return compares ? select_float<Comparison<R16>>(linear) : select_float<Colors<R16>>(linear);
    case TexelFormat::rg16: return select_float<Colors<RG16>>(linear);
    case TexelFormat::rgba16: return select_float<Colors<RGBA16>>(linear);
    case TexelFormat::rgba32f: return select_float<Colors<RGBA32F>>(linear);
    case TexelFormat::z24s8: return compares ? select_float<Comparison<Z24S8>>(linear) : select_float<Colors<Z24S8>>(linear);
    case TexelFormat::z32f: return compares ? select_float<Comparison<Z32F>>(linear) : select_float<Colors<Z32F>>(linear);
  }
  return select_unorm8<WordsRGBA8>(unit, linear);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
LevelKernel level_kernel(const PreparedUnit& unit, TexelFilter filter) {
  return GOURAUD_SIMD_PICK(select)(unit, filter == TexelFilter::linear);
}
}  // namespace gouraud::pipeline
#endif
