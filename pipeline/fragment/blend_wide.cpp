// Takes a block with its colours, gives pixels [GL1.5 §4.1.8, §4.1.10]. The same rules as blend.cpp, a pixel at a time.
#include "pipeline/fragment/blend_wide.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {
namespace {

/// Arithmetic of a target's channels: what 1 is, products and sums kept in range.
struct Unorm16 {
  using Word = std::uint16_t;
  using Value = std::int64_t;
  static constexpr Value one = 0xFFFF;
  static Value quantized(float scaled) { return static_cast<Value>(std::nearbyint(std::clamp(scaled, 0.0f, 65535.0f))); }
  static Value constant(float unit) { return quantized(unit * 65535.0f); }
  static Value product(Value a, Value b) {
    const Value t = a * b + 0x8000;
    return (t + (t >> 16)) >> 16;
  }
};
struct Float {
  using Word = float;
  using Value = float;
  static constexpr Value one = 1.0f;
  static Value quantized(float scaled) { return std::clamp(scaled, 0.0f, 1.0f); }
  static Value constant(float unit) { return unit; }
  static Value product(Value a, Value b) { return a * b; }
};

template <class Format>
using Pixel = std::array<typename Format::Value, 4>;

template <class Format>
typename Format::Value factor_of(BlendFactor factor, std::size_t k, const Pixel<Format>& source,
                                 const Pixel<Format>& destination, const Pixel<Format>& constant) {
  using enum BlendFactor;
  switch (factor) {
    case zero: return 0;
    case one: return Format::one;
    case source_color: return source[k];
    case one_minus_source_color: return Format::one - source[k];
    case destination_color: return destination[k];
    case one_minus_destination_color: return Format::one - destination[k];
    case source_alpha: return source[3];
    case one_minus_source_alpha: return Format::one - source[3];
    case destination_alpha: return destination[3];
    case one_minus_destination_alpha: return Format::one - destination[3];
    case constant_color: return constant[k];
    case one_minus_constant_color: return Format::one - constant[k];
    case constant_alpha: return constant[3];
    case one_minus_constant_alpha: return Format::one - constant[3];
    case source_alpha_saturate: break;
  }
  return std::min(source[3], Format::one - destination[3]);
}

template <class Format>
typename Format::Value blended(const BlendTerms& terms, std::size_t k, const Pixel<Format>& source,
                               const Pixel<Format>& destination, const Pixel<Format>& constant) {
  const auto weighted = [&](BlendFactor factor, typename Format::Value value) {
    return Format::product(value, factor_of<Format>(factor, k, source, destination, constant));
  };
  using Value = typename Format::Value;
  switch (terms.equation) {
    case BlendEquation::min: return std::min(source[k], destination[k]);
    case BlendEquation::max: return std::max(source[k], destination[k]);
    case BlendEquation::add:
    case BlendEquation::subtract:
    case BlendEquation::reverse_subtract: break;
  }
  const Value s = weighted(terms.source, source[k]), d = weighted(terms.destination, destination[k]);
  const Value sum = terms.equation == BlendEquation::add ? s + d : terms.equation == BlendEquation::subtract ? s - d : d - s;
  return std::clamp(sum, Value{0}, Format::one);
}

/// Calls pixel(source, words) for each fragment, `words` being the target's four channels.
template <class Format, class PerPixel>
void for_fragments(const FragmentBlock& block, const TileTarget& target, const PerPixel& pixel) {
  auto* words = reinterpret_cast<typename Format::Word*>(target.color) + 4 * block.first_pixel;
  for (std::uint64_t left = block.coverage; left != 0; left &= left - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(left));
    Pixel<Format> source;
    for (std::size_t k = 0; k < 4; ++k) source[k] = Format::quantized(block.color[k][lane]);
    pixel(source, words + 4 * lane);
  }
}

template <class Format>
void blend(FragmentBlock& block, const TileTarget& target) {
  const RasterState& state = block.primitive->binding->state;
  Pixel<Format> constant;
  for (std::size_t k = 0; k < 4; ++k) constant[k] = Format::constant(state.blend.constant[static_cast<int>(k)]);
  for_fragments<Format>(block, target, [&](const Pixel<Format>& source, typename Format::Word* words) {
    const Pixel<Format> destination{words[0], words[1], words[2], words[3]};
    for (std::size_t k = 0; k < 4; ++k) {
      if ((state.color_write_mask >> k & 1) == 0) continue;
      const BlendTerms& terms = k == 3 ? state.blend.alpha : state.blend.rgb;
      words[k] = static_cast<typename Format::Word>(blended<Format>(terms, k, source, destination, constant));
    }
  });
}

std::uint32_t operate(LogicOp op, std::uint32_t s, std::uint32_t d) {
  using enum LogicOp;
  switch (op) {
    case clear: return 0;
    case and_: return s & d;
    case and_reverse: return s & ~d;
    case copy: return s;
    case and_inverted: return ~s & d;
    case noop: return d;
    case xor_: return s ^ d;
    case or_: return s | d;
    case nor: return ~(s | d);
    case equiv: return ~(s ^ d);
    case invert: return ~d;
    case or_reverse: return s | ~d;
    case copy_inverted: return ~s;
    case or_inverted: return ~s | d;
    case nand: return ~(s & d);
    case set: break;
  }
  return ~0u;
}

void logic_op_16(FragmentBlock& block, const TileTarget& target) {
  const RasterState& state = block.primitive->binding->state;
  for_fragments<Unorm16>(block, target, [&](const Pixel<Unorm16>& source, std::uint16_t* words) {
    for (std::size_t k = 0; k < 4; ++k) {
      if ((state.color_write_mask >> k & 1) == 0) continue;
      words[k] = static_cast<std::uint16_t>(operate(state.logic_op, static_cast<std::uint32_t>(source[k]), words[k]));
    }
  });
}

}  // namespace

// Terms that replace are blended exactly: product(s, 1) = s. So one pass serves with and without blending.
FragmentPass wide_blend_pass(const RasterState& state, ColorFormat format) {
  if (format == ColorFormat::rgba32f) return blend<Float>;
  return state.logic_op != LogicOp::copy ? logic_op_16 : blend<Unorm16>;
}

}  // namespace gouraud::pipeline
