#include "conformance/oracle/blending.h"

#include <algorithm>
#include <cmath>

namespace gouraud::oracle {
namespace {

using pipeline::BlendEquation, pipeline::BlendFactor, pipeline::LogicOp;

/// Values of one pixel, R, G, B, A, as integers of 8 bits.
using Bytes = std::array<int, 4>;

double clamped(double value) {
  return value > 0 ? std::min(value, 1.0) : 0.0;
}

int byte_of(double value) {
  return static_cast<int>(std::nearbyint(clamped(value) * 255.0));
}

int product(int a, int b) {
  return static_cast<int>(std::nearbyint(a * b / 255.0));
}

/// Channel i of a factor [GL1.5 Table 4.1].
int factor_of(BlendFactor factor, std::size_t i, const Bytes& s, const Bytes& d, const Bytes& c) {
  switch (factor) {
    case BlendFactor::zero:
      return 0;
    case BlendFactor::one:
      return 255;
    case BlendFactor::source_color:
      return s[i];
    case BlendFactor::one_minus_source_color:
      return 255 - s[i];
    case BlendFactor::destination_color:
      return d[i];
    case BlendFactor::one_minus_destination_color:
      return 255 - d[i];
    case BlendFactor::source_alpha:
      return s[3];
    case BlendFactor::one_minus_source_alpha:
      return 255 - s[3];
    case BlendFactor::destination_alpha:
      return d[3];
    case BlendFactor::one_minus_destination_alpha:
      return 255 - d[3];
    case BlendFactor::constant_color:
      return c[i];
    case BlendFactor::one_minus_constant_color:
      return 255 - c[i];
    case BlendFactor::constant_alpha:
      return c[3];
    case BlendFactor::one_minus_constant_alpha:
      return 255 - c[3];
    case BlendFactor::source_alpha_saturate:
      break;
  }
  return i == 3 ? 255 : std::min(s[3], 255 - d[3]);
}

int blended(const pipeline::BlendTerms& terms, std::size_t i, const Bytes& s, const Bytes& d, const Bytes& c) {
  const int weighted_s = product(s[i], factor_of(terms.source, i, s, d, c));
  const int weighted_d = product(d[i], factor_of(terms.destination, i, s, d, c));
  switch (terms.equation) {
    case BlendEquation::add:
      return std::min(weighted_s + weighted_d, 255);
    case BlendEquation::subtract:
      return std::max(weighted_s - weighted_d, 0);
    case BlendEquation::reverse_subtract:
      return std::max(weighted_d - weighted_s, 0);
    case BlendEquation::min:
      return std::min(s[i], d[i]);
    case BlendEquation::max:
      break;
  }
  return std::max(s[i], d[i]);
}

/// [GL1.5 Table 4.2].
int operated(LogicOp op, int s, int d) {
  constexpr int all = 255;
  switch (op) {
    case LogicOp::clear:
      return 0;
    case LogicOp::and_:
      return s & d;
    case LogicOp::and_reverse:
      return s & (all - d);
    case LogicOp::copy:
      return s;
    case LogicOp::and_inverted:
      return (all - s) & d;
    case LogicOp::noop:
      return d;
    case LogicOp::xor_:
      return s ^ d;
    case LogicOp::or_:
      return s | d;
    case LogicOp::nor:
      return all - (s | d);
    case LogicOp::equiv:
      return all - (s ^ d);
    case LogicOp::invert:
      return all - d;
    case LogicOp::or_reverse:
      return s | (all - d);
    case LogicOp::copy_inverted:
      return all - s;
    case LogicOp::or_inverted:
      return (all - s) | d;
    case LogicOp::nand:
      return all - (s & d);
    case LogicOp::set:
      break;
  }
  return all;
}

Bytes result_of(const pipeline::RasterState& state, const Bytes& s, const Bytes& d) {
  Bytes constant{}, out{};
  for (std::size_t i = 0; i < 4; ++i) constant[i] = byte_of(state.blend.constant[static_cast<int>(i)]);
  for (std::size_t i = 0; i < 4; ++i) {
    const pipeline::BlendTerms& terms = i == 3 ? state.blend.alpha : state.blend.rgb;
    out[i] = state.logic_op != LogicOp::copy ? operated(state.logic_op, s[i], d[i]) : blended(terms, i, s, d, constant);
  }
  return out;
}

bool passes(pipeline::CompareFunc func, int alpha, int reference) {
  switch (func) {
    case pipeline::CompareFunc::never:
      return false;
    case pipeline::CompareFunc::less:
      return alpha < reference;
    case pipeline::CompareFunc::equal:
      return alpha == reference;
    case pipeline::CompareFunc::lequal:
      return alpha <= reference;
    case pipeline::CompareFunc::greater:
      return alpha > reference;
    case pipeline::CompareFunc::notequal:
      return alpha != reference;
    case pipeline::CompareFunc::gequal:
      return alpha >= reference;
    case pipeline::CompareFunc::always:
      break;
  }
  return true;
}

}  // namespace

void write_color(OraclePixel& pixel, const pipeline::RasterState& state, const Fragment& fragment) {
  const bool replaces = !state.blend.enabled && state.logic_op == LogicOp::copy;
  const bool exact = !fragment.extrapolated && pixel.color_lowest == pixel.color_highest;
  Bytes source, destination;
  for (std::size_t i = 0; i < 4; ++i) {
    source[i] = byte_of(fragment.color[i]);
    destination[i] = pixel.color_unorm8[i];
  }
  const Bytes result = replaces ? source : result_of(state, source, destination);
  for (std::size_t i = 0; i < 4; ++i) {
    if ((state.color_write_mask >> i & 1) == 0) continue;
    pixel.color_unorm8[i] = static_cast<std::uint8_t>(result[i]);
    if (replaces) {
      pixel.color[i] = clamped(fragment.color[i]);
      pixel.color_lowest[i] = static_cast<float>(clamped(fragment.color_lowest[i]));
      pixel.color_highest[i] = static_cast<float>(clamped(fragment.color_highest[i]));
    } else {
      // Where a legal source or destination is not known exactly, nor is what they make.
      pixel.color[i] = result[i] / 255.0;
      pixel.color_lowest[i] = exact ? static_cast<float>(pixel.color[i]) : 0.0f;
      pixel.color_highest[i] = exact ? static_cast<float>(pixel.color[i]) : 1.0f;
    }
  }
}

AlphaVerdict test_alpha(const pipeline::AlphaTestState& state, const Fragment& fragment) {
  if (!state.enabled) return {};
  constexpr double slack = 1.0 / (255 * 1024);
  const int reference = byte_of(static_cast<double>(state.reference));
  const int lowest = byte_of(std::min(fragment.color_lowest[3], fragment.color[3]) - slack);
  const int highest = byte_of(std::max(fragment.color_highest[3], fragment.color[3]) + slack);
  AlphaVerdict verdict{passes(state.func, byte_of(fragment.color[3]), reference), false};
  for (int alpha = lowest; alpha <= highest; ++alpha) {
    verdict.ambiguous |= passes(state.func, alpha, reference) != verdict.passes;
  }
  return verdict;
}

}  // namespace gouraud::oracle
