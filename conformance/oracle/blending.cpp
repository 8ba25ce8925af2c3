#include "conformance/oracle/blending.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// The bytes that a channel may be stored as: either of two if it lies all but in their middle.
struct Range {
  int lowest = 0, highest = 0;
};
using Ranges = std::array<Range, 4>;

Range range_of(double lowest, double highest) {
  return {byte_of(lowest - color_slack_bytes / 255), byte_of(highest + color_slack_bytes / 255)};
}

bool are_known(const Ranges& ranges) {
  return std::ranges::all_of(ranges, [](const Range& range) { return range.lowest == range.highest; });
}

/// The numbers in a range where results can be extreme: its ends, and the middle, where x (1 - x) is largest.
std::vector<int> extremes_of(const Range& range) {
  std::vector<int> out{range.lowest};
  for (const int middle : {127, 128}) {
    if (middle > range.lowest && middle < range.highest) out.push_back(middle);
  }
  if (range.highest != range.lowest) out.push_back(range.highest);
  return out;
}

/// What channel i can be: blended from all extremes of its source and destination and of their alphas.
Range results_of(const pipeline::RasterState& state, std::size_t i, const Ranges& source, const Ranges& destination) {
  Range out{255, 0};
  for (const int s : extremes_of(source[i])) {
    for (const int s_alpha : i == 3 ? std::vector{s} : extremes_of(source[3])) {
      for (const int d : extremes_of(destination[i])) {
        for (const int d_alpha : i == 3 ? std::vector{d} : extremes_of(destination[3])) {
          const int result = result_of(state, {s, s, s, s_alpha}, {d, d, d, d_alpha})[i];
          out = {std::min(out.lowest, result), std::max(out.highest, result)};
        }
      }
    }
  }
  return out;
}

/// Blending is linear in each of its numbers, or of the form x (1 - x), but for the rounding of its two products. Logical
/// operations are neither: of unknown numbers they may give all.
Ranges results_of(const pipeline::RasterState& state, const Ranges& source, const Ranges& destination) {
  if (state.logic_op != LogicOp::copy) return {Range{0, 255}, {0, 255}, {0, 255}, {0, 255}};
  const auto is_wide = [](const Range& range) { return range.highest - range.lowest > 1; };
  const bool wide = std::ranges::any_of(source, is_wide) || std::ranges::any_of(destination, is_wide);
  Ranges out;
  for (std::size_t i = 0; i < 4; ++i) {
    out[i] = results_of(state, i, source, destination);
    if (wide) out[i] = {std::max(out[i].lowest - 1, 0), std::min(out[i].highest + 1, 255)};
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

bool write_color(OraclePixel& pixel, const pipeline::RasterState& state, const Fragment& fragment) {
  const bool replaces = !state.blend.enabled && state.logic_op == LogicOp::copy;
  Bytes source, destination;
  Ranges source_range, destination_range;
  for (std::size_t i = 0; i < 4; ++i) {
    source[i] = byte_of(fragment.color[i]);
    destination[i] = pixel.color_unorm8[i];
    source_range[i] = fragment.extrapolated ? range_of(fragment.color_lowest[i], fragment.color_highest[i]) : range_of(fragment.color[i], fragment.color[i]);
    const bool known = pixel.color_lowest[i] == pixel.color_highest[i];
    destination_range[i] = known ? range_of(pixel.color[i], pixel.color[i])
                                 : range_of(static_cast<double>(pixel.color_lowest[i]), static_cast<double>(pixel.color_highest[i]));
  }
  const Bytes result = replaces ? source : result_of(state, source, destination);
  const bool exact = replaces || (are_known(source_range) && are_known(destination_range));
  const Ranges range = exact ? Ranges{} : results_of(state, source_range, destination_range);
  for (std::size_t i = 0; i < 4; ++i) {
    if ((state.color_write_mask >> i & 1) == 0) continue;
    pixel.color_unorm8[i] = static_cast<std::uint8_t>(result[i]);
    if (replaces) {
      pixel.color[i] = clamped(fragment.color[i]);
      pixel.color_lowest[i] = static_cast<float>(clamped(fragment.color_lowest[i]));
      pixel.color_highest[i] = static_cast<float>(clamped(fragment.color_highest[i]));
    } else {
      pixel.color[i] = result[i] / 255.0;
      pixel.color_lowest[i] = static_cast<float>((exact ? result[i] : std::min(range[i].lowest, result[i])) / 255.0);
      pixel.color_highest[i] = static_cast<float>((exact ? result[i] : std::max(range[i].highest, result[i])) / 255.0);
    }
  }
  return exact;
}

AlphaVerdict test_alpha(const pipeline::AlphaTestState& state, const Fragment& fragment) {
  if (!state.enabled) return {};
  constexpr double slack = color_slack_bytes / 255;
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
