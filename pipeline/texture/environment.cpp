// Takes texels and the colours of the previous unit, gives colours. In float; only sums can leave [0, 1] and are clamped.
#include "pipeline/texture/environment.h"

#include <algorithm>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/texture/environment.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

template <TextureFunction function>
HWY_INLINE FloatVector applied(FloatVector previous, FloatVector texel, FloatVector texel_alpha, FloatVector constant) {
  const FloatTag d;
  using enum TextureFunction;
  if constexpr (function == replace) return texel;
  if constexpr (function == modulate) return hn::Mul(previous, texel);
  if constexpr (function == mix_by_alpha) return hn::Add(previous, hn::Mul(hn::Sub(texel, previous), texel_alpha));
  if constexpr (function == blend) return hn::Add(previous, hn::Mul(hn::Sub(constant, previous), texel));
  if constexpr (function == add) return hn::Min(hn::Add(previous, texel), hn::Set(d, 1.0f));
  return previous;
}

template <TextureFunction rgb, TextureFunction alpha>
void apply(FragmentBlock& block, const EnvironmentInput& input) {
  const FloatTag d;
  const FloatVector scale = hn::Set(d, input.scale);
  const glm::vec4& constant = input.unit->state.environment.color;
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(d)) {
    const FloatVector texel_alpha = hn::Load(d, input.texels->channel[3].data() + lane);
    for (std::size_t k = 0; k < 4; ++k) {
      float* const color = block.color[k].data() + lane;
      const FloatVector texel = k == 3 ? texel_alpha : hn::Load(d, input.texels->channel[k].data() + lane);
      const FloatVector c = hn::Set(d, constant[static_cast<int>(k)]), previous = hn::Load(d, color);
      const FloatVector value = k == 3 ? applied<alpha>(previous, texel, texel_alpha, c) : applied<rgb>(previous, texel, texel_alpha, c);
      hn::Store(hn::Mul(value, scale), d, color);
    }
  }
}

/// The pairs that Tables 3.22 and 3.23 have.
EnvironmentFunction select(TextureFunctions functions) {
  using enum TextureFunction;
  constexpr auto pair = [](TextureFunction rgb, TextureFunction alpha) { return static_cast<int>(rgb) * 8 + static_cast<int>(alpha); };
  switch (pair(functions.rgb, functions.alpha)) {
    case pair(keep, replace): return apply<keep, replace>;
    case pair(keep, modulate): return apply<keep, modulate>;
    case pair(replace, keep): return apply<replace, keep>;
    case pair(replace, replace): return apply<replace, replace>;
    case pair(modulate, keep): return apply<modulate, keep>;
    case pair(modulate, modulate): return apply<modulate, modulate>;
    case pair(mix_by_alpha, keep): return apply<mix_by_alpha, keep>;
    case pair(blend, keep): return apply<blend, keep>;
    case pair(blend, modulate): return apply<blend, modulate>;
    case pair(blend, blend): return apply<blend, blend>;
    case pair(add, keep): return apply<add, keep>;
    case pair(add, modulate): return apply<add, modulate>;
    case pair(add, add): return apply<add, add>;
    default: break;
  }
  return apply<keep, keep>;
}

/// One argument of the combiner as R, G, B, A of a vector of lanes [GL1.5 Tables 3.25, 3.26].
struct ArgumentReader {
  const FragmentBlock& block;
  const EnvironmentInput& input;

  HWY_INLINE FloatVector source(const CombineArgument& argument, std::size_t k, std::size_t lane) const {
    const FloatTag d;
    const auto from = [&](const TexelBlock& texels) HWY_ATTR { return hn::Load(d, texels.channel[k].data() + lane); };
    switch (argument.source) {
      case CombineSource::texture: return from(*input.texels);
      case CombineSource::constant: return hn::Set(d, input.unit->state.environment.color[static_cast<int>(k)]);
      case CombineSource::primary_color: return from(*input.primary);
      case CombineSource::texture_unit: return from(input.all_texels[argument.unit]);
      case CombineSource::previous: break;
    }
    return hn::Load(d, block.color[k].data() + lane);
  }
  HWY_INLINE FloatVector operator()(const CombineArgument& argument, std::size_t k, std::size_t lane) const {
    const FloatTag d;
    const CombineOperand operand = argument.operand;
    const bool of_alpha = operand == CombineOperand::alpha || operand == CombineOperand::one_minus_alpha;
    const bool inverted = operand == CombineOperand::one_minus_color || operand == CombineOperand::one_minus_alpha;
    const FloatVector value = source(argument, of_alpha ? 3 : k, lane);
    return inverted ? hn::Sub(hn::Set(d, 1.0f), value) : value;
  }
};

HWY_INLINE FloatVector dot3(const CombineTerms& terms, const ArgumentReader& read, std::size_t lane) {
  const FloatTag d;
  const FloatVector half = hn::Set(d, 0.5f);
  FloatVector sum = hn::Zero(d);
  for (std::size_t k = 0; k < 3; ++k) {
    const FloatVector a = hn::Sub(read(terms.argument[0], k, lane), half), b = hn::Sub(read(terms.argument[1], k, lane), half);
    sum = hn::Add(sum, hn::Mul(a, b));
  }
  return hn::Mul(sum, hn::Set(d, 4.0f));
}

/// [GL1.5 Table 3.24], not scaled.
HWY_INLINE FloatVector combined(const CombineTerms& terms, const ArgumentReader& read, std::size_t k, std::size_t lane) {
  const FloatTag d;
  const FloatVector a = read(terms.argument[0], k, lane);
  using enum CombineFunction;
  if (terms.function == replace) return a;
  const FloatVector b = read(terms.argument[1], k, lane);
  switch (terms.function) {
    case modulate: return hn::Mul(a, b);
    case add: return hn::Add(a, b);
    case add_signed: return hn::Sub(hn::Add(a, b), hn::Set(d, 0.5f));
    case interpolate: return hn::Add(b, hn::Mul(hn::Sub(a, b), read(terms.argument[2], k, lane)));
    case subtract: return hn::Sub(a, b);
    case replace:
    case dot3_rgb:
    case dot3_rgba: break;
  }
  return dot3(terms, read, lane);
}

void combine(FragmentBlock& block, const EnvironmentInput& input) {
  const FloatTag d;
  const TextureEnvironment& environment = input.unit->state.environment;
  const ArgumentReader read{block, input};
  const bool dot3_to_alpha = environment.rgb.function == CombineFunction::dot3_rgba;
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(d)) {
    FloatVector result[4];
    for (std::size_t k = 0; k < 4; ++k) {
      const CombineTerms& terms = k < 3 || dot3_to_alpha ? environment.rgb : environment.alpha;
      const float scale = k < 3 ? environment.rgb.scale : environment.alpha.scale;
      const FloatVector value = hn::Mul(combined(terms, read, k, lane), hn::Set(d, scale));
      result[k] = hn::Mul(clamp_lanes(value, hn::Zero(d), hn::Set(d, 1.0f)), hn::Set(d, input.scale));
    }
    for (std::size_t k = 0; k < 4; ++k) hn::Store(result[k], d, block.color[k].data() + lane);
  }
}

EnvironmentFunction select_combiner() { return combine; }

void pack_colors(FragmentBlock& block) {
  const PairRange pairs = covered_pairs(block.coverage);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(IntTag())) {
    const auto channel = [&](std::size_t k) HWY_ATTR { return hn::Load(FloatTag(), block.color[k].data() + lane); };
    hn::Store(pack_unorm8(channel(0), channel(1), channel(2), channel(3)), IntTag(), block.words.word.data() + lane);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

TextureFunctions texture_functions(EnvironmentMode mode, BaseFormat format) {
  using enum TextureFunction;
  const bool has_color = format != BaseFormat::alpha;
  const bool has_alpha = format != BaseFormat::luminance && format != BaseFormat::rgb;
  const bool intensity = format == BaseFormat::intensity;
  const TextureFunction modulated_alpha = has_alpha ? modulate : keep;
  switch (mode) {
    case EnvironmentMode::replace: return {has_color ? replace : keep, has_alpha ? replace : keep};
    case EnvironmentMode::decal:
      return {format == BaseFormat::rgb ? replace : format == BaseFormat::rgba ? mix_by_alpha : keep, keep};
    case EnvironmentMode::blend: return {has_color ? blend : keep, intensity ? blend : modulated_alpha};
    case EnvironmentMode::add: return {has_color ? add : keep, intensity ? add : modulated_alpha};
    case EnvironmentMode::modulate:
    case EnvironmentMode::combine: break;
  }
  return {has_color ? modulate : keep, modulated_alpha};
}

void (*packing_function())(FragmentBlock& block) { return GOURAUD_SIMD_PICK(pack_colors); }

EnvironmentFunction environment_function(const TextureEnvironment& environment, BaseFormat format) {
  if (environment.mode == EnvironmentMode::combine) return GOURAUD_SIMD_PICK(select_combiner)();
  return GOURAUD_SIMD_PICK(select)(texture_functions(environment.mode, format));
}

}  // namespace gouraud::pipeline
#endif
