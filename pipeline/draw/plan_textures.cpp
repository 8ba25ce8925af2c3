#include "pipeline/draw/plan_textures.h"

#include <array>
#include <string_view>

#include "pipeline/texture/environment.h"
#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {
namespace {

/// What a stage needs of the colour before it.
struct Needs {
  bool rgb = false, alpha = false;
  bool fragment = false;  ///< the fragment's own colour, whatever the units before make of it
};

int arguments_of(CombineFunction function) {
  if (function == CombineFunction::replace) return 1;
  return function == CombineFunction::interpolate ? 3 : 2;
}

void add_needs(const CombineTerms& terms, bool of_alpha, Needs& needs) {
  for (int i = 0; i < arguments_of(terms.function); ++i) {
    const CombineArgument& argument = terms.argument[static_cast<std::size_t>(i)];
    const bool alpha = of_alpha || argument.operand == CombineOperand::alpha || argument.operand == CombineOperand::one_minus_alpha;
    if (argument.source == CombineSource::primary_color) needs.fragment = true;
    if (argument.source == CombineSource::previous) (alpha ? needs.alpha : needs.rgb) = true;
  }
}

Needs needs_before(const TextureUnitState& unit, const Needs& after) {
  Needs needs;
  needs.fragment = after.fragment;
  if (unit.environment.mode == EnvironmentMode::combine) {
    const bool dot3_to_alpha = unit.environment.rgb.function == CombineFunction::dot3_rgba;
    if (after.rgb || (after.alpha && dot3_to_alpha)) add_needs(unit.environment.rgb, false, needs);
    if (after.alpha && !dot3_to_alpha) add_needs(unit.environment.alpha, true, needs);
    return needs;
  }
  const TextureFunctions functions = texture_functions(unit.environment.mode, texture_base_format(unit));
  needs.rgb = after.rgb && functions.rgb != TextureFunction::replace;
  needs.alpha = after.alpha && functions.alpha != TextureFunction::replace;
  return needs;
}

constexpr std::array<std::string_view, 5> target_names{"1D", "2D", "3D", "cube map", "rectangle"};
constexpr std::array<std::string_view, 6> mode_names{"modulate", "replace", "decal", "blend", "add", "combine"};
constexpr std::array<std::string_view, 8> function_names{"replace", "modulate", "add", "add signed", "interpolate", "subtract",
                                                         "dot3", "dot3 to alpha"};
constexpr std::array<std::string_view, 8> compare_names{"never", "less", "equal", "lequal", "greater", "notequal", "gequal", "always"};

std::string_view name_of(TexelFilter filter) { return filter == TexelFilter::linear ? "linear" : "nearest"; }

std::string describe_filter(const SamplerState& sampler) {
  std::string text(name_of(sampler.magnify));
  if (sampler.mip != MipFilter::none || sampler.minify != sampler.magnify) text.append(" or ").append(name_of(sampler.minify));
  if (sampler.mip == MipFilter::nearest) text += " in the nearest level";
  if (sampler.mip == MipFilter::linear) text += " in two levels";
  if (sampler.max_anisotropy > 1) text.append(", up to ").append(std::to_string(static_cast<int>(sampler.max_anisotropy))).append(" along the footprint");
  if (sampler.compares) text.append(", compared by ").append(compare_names[sampler.compare_func]);
  return text;
}

std::string describe_environment(const TextureEnvironment& environment) {
  std::string text(mode_names[static_cast<std::size_t>(environment.mode)]);
  if (environment.mode != EnvironmentMode::combine) return text;
  const auto name = [](const CombineTerms& terms) { return function_names[static_cast<std::size_t>(terms.function)]; };
  return text.append(" (").append(name(environment.rgb)).append(", ").append(name(environment.alpha)).append(")");
}

}  // namespace

bool textures_read_color(const TexturingState& state) {
  Needs needs{true, true, false};
  for (std::size_t i = state.count; i-- > 0;) needs = needs_before(state.unit[i], needs);
  return needs.rgb || needs.alpha || needs.fragment;
}

std::string describe_unit(const TextureUnitState& unit) {
  std::string text = "unit " + std::to_string(unit.unit) + ", ";
  text.append(target_names[static_cast<std::size_t>(unit.target)]).append(", ").append(describe_filter(unit.sampler));
  return text.append(", ").append(describe_environment(unit.environment));
}

}  // namespace gouraud::pipeline
