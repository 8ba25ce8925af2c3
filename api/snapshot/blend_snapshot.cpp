#include "api/snapshot/blend_snapshot.h"

#include "api/snapshot/enums.h"

namespace gouraud::api {
namespace {

using pipeline::BlendEquation, pipeline::BlendFactor, pipeline::BlendTerms;

/// Terms without what makes no difference: min and max take no factors [GL1.5 §4.1.8], and a subtraction of nothing is
/// an addition of nothing.
BlendTerms canonical(BlendTerms terms) {
  if (terms.equation == BlendEquation::min || terms.equation == BlendEquation::max) return {terms.equation};
  if (terms.equation == BlendEquation::subtract && terms.destination == BlendFactor::zero) {
    terms.equation = BlendEquation::add;
  }
  return terms;
}

/// The factor as alpha sees it, where colour and alpha are the same [GL1.5 Table 4.1].
BlendFactor alpha_factor(BlendFactor factor) {
  using enum BlendFactor;
  switch (factor) {
    case source_color: return source_alpha;
    case one_minus_source_color: return one_minus_source_alpha;
    case destination_color: return destination_alpha;
    case one_minus_destination_color: return one_minus_destination_alpha;
    case constant_color: return constant_alpha;
    case one_minus_constant_color: return one_minus_constant_alpha;
    case source_alpha_saturate: return one;
    default: return factor;
  }
}

/// By its own enable, or as an equation of blending [EXT_blend_logic_op].
bool operates_logically(const ColorBufferGroup& group) {
  return group.logic_op_enabled || (group.blend.enabled && group.blend.equation_rgb == GL_LOGIC_OP);
}

bool takes(const BlendTerms& terms, BlendFactor first, BlendFactor second) {
  return terms.source == first || terms.source == second || terms.destination == first || terms.destination == second;
}

}  // namespace

pipeline::AlphaTestState alpha_test_state(const ColorBufferGroup& group) {
  const pipeline::CompareFunc func = compare_func(group.alpha_func);
  if (!group.alpha_test_enabled || func == pipeline::CompareFunc::always) return {};
  return {true, func, func == pipeline::CompareFunc::never ? 0.0f : group.alpha_reference};
}

pipeline::BlendState blend_state(const ColorBufferGroup& group, std::uint8_t color_write_mask) {
  const Blending& blend = group.blend;
  if (!blend.enabled || operates_logically(group)) return {};
  pipeline::BlendState result;
  if ((color_write_mask & 7) != 0) {
    result.rgb = canonical({blend_equation(blend.equation_rgb), blend_factor(blend.source_rgb),
                            blend_factor(blend.destination_rgb)});
  }
  if ((color_write_mask & 8) != 0) {
    result.alpha = canonical({blend_equation(blend.equation_alpha), alpha_factor(blend_factor(blend.source_alpha)),
                              alpha_factor(blend_factor(blend.destination_alpha))});
  }
  result.enabled = result.rgb != BlendTerms() || result.alpha != BlendTerms();

  // The constant, as far as a factor takes it.
  using enum BlendFactor;
  if (takes(result.rgb, constant_color, one_minus_constant_color)) {
    for (int i = 0; i < 3; ++i) result.constant[i] = blend.constant[i];
  }
  if (takes(result.rgb, constant_alpha, one_minus_constant_alpha) ||
      takes(result.alpha, constant_alpha, one_minus_constant_alpha)) {
    result.constant.w = blend.constant.w;
  }
  return result;
}

pipeline::LogicOp logic_op_state(const ColorBufferGroup& group, std::uint8_t color_write_mask, pipeline::ColorFormat format) {
  const bool acts = operates_logically(group) && color_write_mask != 0 && format != pipeline::ColorFormat::rgba32f;
  return acts ? logic_op(group.logic_op) : pipeline::LogicOp::copy;
}

}  // namespace gouraud::api
