// Takes a block with its colours, gives pixels. A block is blended in steps, each over its 64 pixels of four bytes:
// source, destination, both weighted by their factors, the equation. Factors are bytes too: 1 - f is ~f. The blendings that
// most programs ask for take one step.
// Leaves out index targets and dithering [GL1.5 §4.1.8, §4.1.10].
#include "pipeline/fragment/blend.h"

#include <cstddef>
#include <cstdint>

#include "pipeline/fragment/blend_wide.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/blend.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/byte_math-inl.h"
#include "pipeline/fragment/pixel_words-inl.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

constexpr std::int32_t alpha_byte = static_cast<std::int32_t>(0xFF000000u);

using Pixels = PixelWords;

/// out = function(lane) for each vector of the block.
template <class Function>
HWY_INLINE void for_block(Pixels& out, const Function& function) {
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(IntTag())) hn::Store(function(lane), IntTag(), out.word.data() + lane);
}
HWY_INLINE IntVector load(const Pixels& pixels, std::size_t lane) { return hn::Load(IntTag(), pixels.word.data() + lane); }

/// A vector of the block's colours as the target stores them.
template <bool packed>
HWY_INLINE IntVector source_pixel(const FragmentBlock& block, std::size_t lane) {
  if constexpr (packed) return load(block.words, lane);
  const auto channel = [&](std::size_t k) HWY_ATTR { return hn::Load(FloatTag(), block.color[k].data() + lane); };
  return pack_unorm8(channel(0), channel(1), channel(2), channel(3));
}

/// All of them; `memory` holds them if the block does not.
template <bool packed>
HWY_INLINE const Pixels& source_pixels(const FragmentBlock& block, Pixels& memory) {
  if constexpr (packed) return block.words;
  for_block(memory, [&](std::size_t lane) HWY_ATTR { return source_pixel<packed>(block, lane); });
  return memory;
}

/// out = value * factor [GL1.5 Table 4.1]. source_alpha_saturate is that of colours.
HWY_INLINE void weigh(BlendFactor factor, const Pixels& value, const Pixels& source, const Pixels& destination,
                      std::int32_t constant, Pixels& out) {
  const IntTag d;
  const IntVector c = hn::Set(d, constant);
  const auto fill = [&](auto factors) HWY_ATTR {
    for_block(out, [&](std::size_t lane) HWY_ATTR {
      return byte_product(load(value, lane), factors(load(source, lane), load(destination, lane)));
    });
  };
  using enum BlendFactor;
  switch (factor) {
    case zero: return for_block(out, [&](std::size_t) HWY_ATTR { return hn::Zero(d); });
    case one: return for_block(out, [&](std::size_t lane) HWY_ATTR { return load(value, lane); });
    case source_color: return fill([&](IntVector s, IntVector) HWY_ATTR { return s; });
    case one_minus_source_color: return fill([&](IntVector s, IntVector) HWY_ATTR { return hn::Not(s); });
    case destination_color: return fill([&](IntVector, IntVector t) HWY_ATTR { return t; });
    case one_minus_destination_color: return fill([&](IntVector, IntVector t) HWY_ATTR { return hn::Not(t); });
    case source_alpha: return fill([&](IntVector s, IntVector) HWY_ATTR { return alpha_of(s); });
    case one_minus_source_alpha: return fill([&](IntVector s, IntVector) HWY_ATTR { return hn::Not(alpha_of(s)); });
    case destination_alpha: return fill([&](IntVector, IntVector t) HWY_ATTR { return alpha_of(t); });
    case one_minus_destination_alpha: return fill([&](IntVector, IntVector t) HWY_ATTR { return hn::Not(alpha_of(t)); });
    case constant_color: return fill([&](IntVector, IntVector) HWY_ATTR { return c; });
    case one_minus_constant_color: return fill([&](IntVector, IntVector) HWY_ATTR { return hn::Not(c); });
    case constant_alpha: return fill([&](IntVector, IntVector) HWY_ATTR { return alpha_of(c); });
    case one_minus_constant_alpha: return fill([&](IntVector, IntVector) HWY_ATTR { return hn::Not(alpha_of(c)); });
    case source_alpha_saturate:
      return fill([&](IntVector s, IntVector t) HWY_ATTR {
        return byte_min(alpha_of(s), hn::Not(alpha_of(t)));
      });
  }
}

/// Takes the alpha bytes of `alpha` into `rgb`.
HWY_INLINE void take_alpha(const Pixels& alpha, Pixels& rgb) {
  const IntVector mask = hn::Set(IntTag(), alpha_byte);
  for_block(rgb, [&](std::size_t lane) HWY_ATTR {
    return hn::Or(hn::And(mask, load(alpha, lane)), hn::AndNot(mask, load(rgb, lane)));
  });
}

/// The equation over all channels; source and destination are weighted already.
HWY_INLINE void combine(BlendEquation equation, const Pixels& source, const Pixels& destination, Pixels& out) {
  const auto fill = [&](auto value) HWY_ATTR {
    for_block(out, [&](std::size_t lane) HWY_ATTR { return value(load(source, lane), load(destination, lane)); });
  };
  using V = IntVector;
  switch (equation) {
    case BlendEquation::add: return fill([](V s, V t) HWY_ATTR { return byte_sum(s, t); });
    case BlendEquation::subtract: return fill([](V s, V t) HWY_ATTR { return byte_difference(s, t); });
    case BlendEquation::reverse_subtract: return fill([](V s, V t) HWY_ATTR { return byte_difference(t, s); });
    case BlendEquation::min: return fill([](V s, V t) HWY_ATTR { return byte_min(s, t); });
    case BlendEquation::max: return fill([](V s, V t) HWY_ATTR { return byte_max(s, t); });
  }
}

HWY_INLINE bool takes_factors(BlendEquation equation) {
  return equation != BlendEquation::min && equation != BlendEquation::max;
}

/// 4 x 8 bits of the constant colour.
HWY_INLINE std::int32_t packed_constant(const glm::vec4& color) {
  const FloatTag d;
  alignas(64) std::int32_t out[16];
  const auto channel = [&](int k) HWY_ATTR { return hn::Set(d, color[k] * 255.0f); };
  hn::Store(pack_unorm8(channel(0), channel(1), channel(2), channel(3)), IntTag(), out);
  return out[0];
}

/// One group of channels (or all) by its terms: out = equation(source * factor, destination * factor).
HWY_INLINE void blend_group(const BlendTerms& terms, const Pixels& source, const Pixels& destination,
                            std::int32_t constant, Pixels& out) {
  if (!takes_factors(terms.equation)) return combine(terms.equation, source, destination, out);
  Pixels weighted_source, weighted_destination;
  weigh(terms.source, source, source, destination, constant, weighted_source);
  weigh(terms.destination, destination, source, destination, constant, weighted_destination);
  combine(terms.equation, weighted_source, weighted_destination, out);
}

template <bool all_channels>
HWY_INLINE void write_block(const FragmentBlock& block, const Unorm8Writer<all_channels>& writer, const Pixels& pixels) {
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(IntTag())) {
    const std::uint64_t covered = lane_bits(block.coverage, lane);
    if (covered != 0) writer.put(load(pixels, lane), covered, lane);
  }
}

/// Whether the terms of R, G and B give the right alpha too.
HWY_INLINE bool one_for_all(const BlendState& blend) {
  const auto same = [](BlendFactor rgb, BlendFactor alpha) {
    using enum BlendFactor;
    return rgb == alpha || (rgb == source_color && alpha == source_alpha) ||
           (rgb == one_minus_source_color && alpha == one_minus_source_alpha) ||
           (rgb == destination_color && alpha == destination_alpha) ||
           (rgb == one_minus_destination_color && alpha == one_minus_destination_alpha) ||
           (rgb == constant_color && alpha == constant_alpha) ||
           (rgb == one_minus_constant_color && alpha == one_minus_constant_alpha);
  };
  return blend.rgb.equation == blend.alpha.equation && same(blend.rgb.source, blend.alpha.source) &&
         same(blend.rgb.destination, blend.alpha.destination);
}

template <bool all_channels, bool packed>
void blend_8(FragmentBlock& block, const TileTarget& target) {
  const RasterState& state = block.primitive->binding->state;
  const Unorm8Writer<all_channels> writer(target, block.first_pixel, state.color_write_mask);
  Pixels memory, destination, result;
  const Pixels& source = source_pixels<packed>(block, memory);
  for_block(destination, [&](std::size_t lane) HWY_ATTR { return writer.stored(lane); });
  const std::int32_t constant = packed_constant(state.blend.constant);
  blend_group(state.blend.rgb, source, destination, constant, result);
  if (!one_for_all(state.blend)) {
    Pixels alpha;
    blend_group(state.blend.alpha, source, destination, constant, alpha);
    take_alpha(alpha, result);
  }
  write_block(block, writer, result);
}

/// In one step: writes function(source, destination) of the covered lanes.
template <bool all_channels, bool packed, class Function>
HWY_INLINE void write_function(FragmentBlock& block, const TileTarget& target, const Function& function) {
  const Unorm8Writer<all_channels> writer(target, block.first_pixel, block.primitive->binding->state.color_write_mask);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(IntTag())) {
    const std::uint64_t covered = lane_bits(block.coverage, lane);
    if (covered != 0) writer.put(function(source_pixel<packed>(block, lane), writer.stored(lane)), covered, lane);
  }
}

template <bool all_channels, bool packed>
void replace_8(FragmentBlock& block, const TileTarget& target) {
  write_function<all_channels, packed>(block, target, [](IntVector s, IntVector) HWY_ATTR { return s; });
}

/// The blendings that most programs ask for, in one step: s and t times their factors, added.
struct ByAlpha {  // SRC_ALPHA, ONE_MINUS_SRC_ALPHA
  static HWY_INLINE IntVector blended(IntVector s, IntVector t) {
    const IntVector alpha = alpha_of(s);
    return byte_sum(byte_product(s, alpha), byte_product(t, hn::Not(alpha)));
  }
};
struct Premultiplied {  // ONE, ONE_MINUS_SRC_ALPHA
  static HWY_INLINE IntVector blended(IntVector s, IntVector t) { return byte_sum(s, byte_product(t, hn::Not(alpha_of(s)))); }
};
struct Added {  // ONE, ONE
  static HWY_INLINE IntVector blended(IntVector s, IntVector t) { return byte_sum(s, t); }
};
struct AddedByAlpha {  // SRC_ALPHA, ONE
  static HWY_INLINE IntVector blended(IntVector s, IntVector t) { return byte_sum(byte_product(s, alpha_of(s)), t); }
};
struct Multiplied {  // DST_COLOR, ZERO and ZERO, SRC_COLOR
  static HWY_INLINE IntVector blended(IntVector s, IntVector t) { return byte_product(s, t); }
};

template <bool all_channels, bool packed, class Blending>
void blend_at_once_8(FragmentBlock& block, const TileTarget& target) {
  write_function<all_channels, packed>(block, target, Blending::blended);
}

/// Null if there is no such function.
template <bool all_channels, bool packed>
FragmentPass select_blending_at_once(const BlendState& blend) {
  using enum BlendFactor;
  if (!one_for_all(blend) || blend.rgb.equation != BlendEquation::add) return nullptr;
  const auto are = [&](BlendFactor source, BlendFactor destination) {
    return blend.rgb.source == source && blend.rgb.destination == destination;
  };
  if (are(source_alpha, one_minus_source_alpha)) return blend_at_once_8<all_channels, packed, ByAlpha>;
  if (are(one, one_minus_source_alpha)) return blend_at_once_8<all_channels, packed, Premultiplied>;
  if (are(one, one)) return blend_at_once_8<all_channels, packed, Added>;
  if (are(source_alpha, one)) return blend_at_once_8<all_channels, packed, AddedByAlpha>;
  if (are(destination_color, zero) || are(zero, source_color)) return blend_at_once_8<all_channels, packed, Multiplied>;
  return nullptr;
}

template <bool all_channels, bool packed>
FragmentPass select_blending_8(const BlendState& blend) {
  const FragmentPass at_once = select_blending_at_once<all_channels, packed>(blend);
  return at_once != nullptr ? at_once : blend_8<all_channels, packed>;
}

/// s op t, bit by bit [GL1.5 Table 4.2].
HWY_INLINE IntVector operate(LogicOp op, IntVector s, IntVector t) {
  using enum LogicOp;
  switch (op) {
    case clear: return hn::Zero(IntTag());
    case and_: return hn::And(s, t);
    case and_reverse: return hn::AndNot(t, s);
    case copy: return s;
    case and_inverted: return hn::AndNot(s, t);
    case noop: return t;
    case xor_: return hn::Xor(s, t);
    case or_: return hn::Or(s, t);
    case nor: return hn::Not(hn::Or(s, t));
    case equiv: return hn::Not(hn::Xor(s, t));
    case invert: return hn::Not(t);
    case or_reverse: return hn::Or(s, hn::Not(t));
    case copy_inverted: return hn::Not(s);
    case or_inverted: return hn::Or(hn::Not(s), t);
    case nand: return hn::Not(hn::And(s, t));
    case set: break;
  }
  return hn::Set(IntTag(), -1);
}

template <bool packed>
void logic_op_8(FragmentBlock& block, const TileTarget& target) {
  const RasterState& state = block.primitive->binding->state;
  const Unorm8Writer<false> writer(target, block.first_pixel, state.color_write_mask);
  Pixels memory, pixels;
  const Pixels& source = source_pixels<packed>(block, memory);
  for_block(pixels, [&](std::size_t lane) HWY_ATTR {
    return operate(state.logic_op, load(source, lane), writer.stored(lane));
  });
  write_block(block, writer, pixels);
}

template <bool packed>
FragmentPass select_8(const RasterState& state) {
  if (state.logic_op != LogicOp::copy) return logic_op_8<packed>;
  const bool all_channels = state.color_write_mask == 0xF;
  if (state.blend.enabled) return all_channels ? select_blending_8<true, packed>(state.blend) : select_blending_8<false, packed>(state.blend);
  return all_channels ? replace_8<true, packed> : replace_8<false, packed>;
}

FragmentPass select(const RasterState& state, ColorFormat format, bool packed) {
  if (format != ColorFormat::rgba8) return wide_blend_pass(state, format);
  return packed ? select_8<true>(state) : select_8<false>(state);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass blend_pass(const RasterState& state, ColorFormat format, bool packed) {
  return GOURAUD_SIMD_PICK(select)(state, format, packed);
}
}  // namespace gouraud::pipeline
#endif
