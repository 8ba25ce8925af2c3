#include "api/snapshot/texture_snapshot.h"

#include <algorithm>
#include <optional>
#include <span>

#include "api/snapshot/enums.h"
#include "pipeline/texture/completeness.h"

namespace gouraud::api {
namespace {

using pipeline::BaseFormat;
using pipeline::CombineFunction, pipeline::CombineOperand, pipeline::CombineSource;
using pipeline::EnvironmentMode;
using pipeline::MipFilter, pipeline::TexelFilter, pipeline::WrapMode;
using pipeline::SamplerState;

constexpr WrapMode wrap_mode(GLenum mode) {
  switch (mode) {
    case GL_CLAMP:
    case GL_MIRROR_CLAMP_EXT: return WrapMode::clamp;
    case GL_CLAMP_TO_EDGE:
    case GL_MIRROR_CLAMP_TO_EDGE_EXT: return WrapMode::clamp_to_edge;
    case GL_CLAMP_TO_BORDER:
    case GL_MIRROR_CLAMP_TO_BORDER_EXT: return WrapMode::clamp_to_border;
    case GL_MIRRORED_REPEAT: return WrapMode::mirrored_repeat;
    default: return WrapMode::repeat;
  }
}

constexpr bool is_mirrored_once(GLenum mode) {
  return mode == GL_MIRROR_CLAMP_EXT || mode == GL_MIRROR_CLAMP_TO_EDGE_EXT || mode == GL_MIRROR_CLAMP_TO_BORDER_EXT;
}

constexpr TexelFilter texel_filter(GLenum filter) {
  const bool linear = filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST || filter == GL_LINEAR_MIPMAP_LINEAR;
  return linear ? TexelFilter::linear : TexelFilter::nearest;
}

constexpr MipFilter mip_filter(GLenum filter) {
  switch (filter) {
    case GL_NEAREST_MIPMAP_NEAREST:
    case GL_LINEAR_MIPMAP_NEAREST:
      return MipFilter::nearest;
    case GL_NEAREST_MIPMAP_LINEAR:
    case GL_LINEAR_MIPMAP_LINEAR:
      return MipFilter::linear;
    default:
      return MipFilter::none;
  }
}

constexpr pipeline::DepthTextureMode depth_mode(GLenum mode) {
  using enum pipeline::DepthTextureMode;
  return mode == GL_INTENSITY ? intensity : mode == GL_ALPHA ? alpha : mode == GL_RED ? red : luminance;
}

/// True if sampling can take border texels: CLAMP does at the edge, when it filters linearly [GL1.5 §3.8.7].
bool reaches_border(const SamplerState& sampler, int dimensions) {
  const bool linear = sampler.minify == TexelFilter::linear || sampler.magnify == TexelFilter::linear;
  return std::any_of(sampler.wrap.begin(), sampler.wrap.begin() + dimensions, [&](WrapMode mode) {
    return mode == WrapMode::clamp_to_border || (mode == WrapMode::clamp && linear);
  });
}

/// The channels of the border colour that a texture of this kind has; others are 0 [GL1.5 §3.8.8].
glm::vec4 border_color(const glm::vec4& color, const pipeline::Image& image) {
  switch (image.base_format) {
    case BaseFormat::alpha: return {0.0f, 0.0f, 0.0f, color.w};
    case BaseFormat::luminance_alpha: return {color.x, 0.0f, 0.0f, color.w};
    case BaseFormat::luminance:
    case BaseFormat::intensity:
    case BaseFormat::depth: return {color.x, 0.0f, 0.0f, 0.0f};
    case BaseFormat::rgb: return {color.x, image.colors > 1 ? color.y : 0.0f, image.colors > 2 ? color.z : 0.0f, 0.0f};
    case BaseFormat::rgba: break;
  }
  return color;
}

/// Level of detail, as far as something depends on it: levels, or which of two filters applies.
void set_lod(SamplerState& sampler, const TextureParameters& p, float unit_bias) {
  if (sampler.mip == MipFilter::none && sampler.minify == sampler.magnify) return;
  const float bias = p.lod_bias + unit_bias;
  sampler.lod_bias = std::isnan(bias) ? 0.0f : std::clamp(bias, -max_texture_lod_bias, max_texture_lod_bias);
  sampler.min_lod = std::isnan(p.min_lod) ? -1000.0f : p.min_lod;
  sampler.max_lod = std::isnan(p.max_lod) ? 1000.0f : p.max_lod;
}

/// Of a complete texture whose usable levels are `levels`; `image` is its base level.
SamplerState sampler_state(const TextureObject& object, const pipeline::Image& image, pipeline::LevelRange levels,
                           float unit_bias, bool seamless) {
  const TextureParameters& p = object.parameters;
  SamplerState sampler;
  sampler.minify = texel_filter(p.min_filter);
  sampler.magnify = texel_filter(p.mag_filter);
  sampler.mip = mip_filter(p.min_filter);
  sampler.base_level = static_cast<std::uint8_t>(levels.base);
  sampler.last_level = static_cast<std::uint8_t>(levels.last);
  set_lod(sampler, p, unit_bias);
  // choice: plain nearest filters stay what they are, and so do cube maps; the limit is rounded down.
  if (object.target != TextureTarget::cube_map && (sampler.minify == TexelFilter::linear || sampler.mip != MipFilter::none)) {
    sampler.max_anisotropy = std::floor(p.max_anisotropy);
  }

  const bool linear = sampler.minify == TexelFilter::linear || sampler.magnify == TexelFilter::linear;
  sampler.seamless = seamless && object.target == TextureTarget::cube_map && linear;
  const int dimensions = pipeline::dimensions(object.target);
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions); ++i) {
    sampler.wrap[i] = wrap_mode(p.wrap[i]);
    sampler.mirrored_once[i] = is_mirrored_once(p.wrap[i]);
  }
  if (image.border == 0 && reaches_border(sampler, dimensions)) {
    sampler.border_color = border_color(p.border_color, image);
  }

  if (image.base_format == BaseFormat::depth) {
    sampler.depth_mode = depth_mode(p.depth_mode);
    sampler.compares = p.compare_mode == GL_COMPARE_R_TO_TEXTURE;
    if (sampler.compares) sampler.compare_func = static_cast<std::uint8_t>(compare_func(p.compare_func));
  }
  return sampler;
}

constexpr EnvironmentMode environment_mode(GLenum mode) {
  using enum EnvironmentMode;
  switch (mode) {
    case GL_REPLACE: return replace;
    case GL_DECAL: return decal;
    case GL_BLEND: return blend;
    case GL_ADD: return add;
    case GL_COMBINE: return combine;
    default: return modulate;
  }
}

constexpr CombineFunction combine_function(GLenum function) {
  using enum CombineFunction;
  switch (function) {
    case GL_REPLACE: return replace;
    case GL_ADD: return add;
    case GL_ADD_SIGNED: return add_signed;
    case GL_INTERPOLATE: return interpolate;
    case GL_SUBTRACT: return subtract;
    case GL_DOT3_RGB:
    case GL_DOT3_RGB_EXT: return dot3_rgb;
    case GL_DOT3_RGBA:
    case GL_DOT3_RGBA_EXT: return dot3_rgba;
    default: return modulate;
  }
}

constexpr std::size_t argument_count(CombineFunction function) {
  return function == CombineFunction::replace ? 1 : function == CombineFunction::interpolate ? 3 : 2;
}

constexpr CombineOperand combine_operand(GLenum operand) {
  using enum CombineOperand;
  switch (operand) {
    case GL_ONE_MINUS_SRC_COLOR: return one_minus_color;
    case GL_SRC_ALPHA: return alpha;
    case GL_ONE_MINUS_SRC_ALPHA: return one_minus_alpha;
    default: return color;
  }
}

/// TEXTUREn of the unit itself is TEXTURE.
pipeline::CombineArgument combine_argument(GLenum source, GLenum operand, int own_unit) {
  using enum CombineSource;
  pipeline::CombineArgument result{previous, 0, combine_operand(operand)};
  switch (source) {
    case GL_TEXTURE: result.source = texture; break;
    case GL_CONSTANT: result.source = constant; break;
    case GL_PRIMARY_COLOR: result.source = primary_color; break;
    case GL_PREVIOUS: break;
    default: {
      const auto unit = static_cast<std::uint8_t>(source - GL_TEXTURE0);
      result.source = unit == own_unit ? texture : texture_unit;
      if (unit != own_unit) result.unit = unit;
      break;
    }
  }
  return result;
}

pipeline::CombineTerms combine_terms(const CombineParameters& p, int own_unit) {
  pipeline::CombineTerms terms;
  terms.function = combine_function(p.function);
  // [EXT_texture_env_dot3]: its own names of the functions take no scale.
  terms.scale = p.function == GL_DOT3_RGB_EXT || p.function == GL_DOT3_RGBA_EXT ? 1.0f : p.scale;
  for (std::size_t i = 0; i < argument_count(terms.function); ++i) {
    terms.argument[i] = combine_argument(p.source[i], p.operand[i], own_unit);
  }
  return terms;
}

bool takes_constant(const pipeline::CombineTerms& terms, bool its_color) {
  return std::any_of(terms.argument.begin(), terms.argument.end(), [&](const pipeline::CombineArgument& argument) {
    const bool color = argument.operand == CombineOperand::color || argument.operand == CombineOperand::one_minus_color;
    return argument.source == CombineSource::constant && color == its_color;
  });
}

/// [GL1.5 §3.8.13]: the constant is read by BLEND, its alpha of intensity alone (Table 3.23), and by combiners.
pipeline::TextureEnvironment environment(const TextureEnvironmentParameters& p, BaseFormat format, int unit) {
  pipeline::TextureEnvironment result;
  result.mode = environment_mode(p.mode);
  bool takes_color = result.mode == EnvironmentMode::blend && format != BaseFormat::alpha;
  bool takes_alpha = result.mode == EnvironmentMode::blend && format == BaseFormat::intensity;
  if (result.mode == EnvironmentMode::combine) {
    result.rgb = combine_terms(p.rgb, unit);
    // The scalar of DOT3_RGBA stands in for the alpha function's result, and is scaled as that would be.
    if (result.rgb.function != CombineFunction::dot3_rgba) result.alpha = combine_terms(p.alpha, unit);
    else result.alpha.scale = p.rgb.function == GL_DOT3_RGBA_EXT ? 1.0f : p.alpha.scale;
    takes_color = takes_constant(result.rgb, true);
    takes_alpha = takes_constant(result.rgb, false) || takes_constant(result.alpha, false);
  }
  if (takes_color) result.color = {p.color.x, p.color.y, p.color.z, 0.0f};
  if (takes_alpha) result.color.w = p.color.w;
  return result;
}

/// What the environment takes the texture for: depth by its mode [GL1.5 §3.8.14].
BaseFormat effective_format(const pipeline::Image& image, const SamplerState& sampler) {
  if (image.base_format != BaseFormat::depth) return image.base_format;
  using enum pipeline::DepthTextureMode;
  return sampler.depth_mode == intensity ? BaseFormat::intensity
         : sampler.depth_mode == alpha   ? BaseFormat::alpha
         : sampler.depth_mode == red     ? BaseFormat::rgb
                                         : BaseFormat::luminance;
}

std::optional<pipeline::TextureUnitState> unit_state(const TextureGroup& group, int number) {
  const TextureUnit& unit = group.units[static_cast<std::size_t>(number)];
  TextureTarget target;
  if (!enabled_target(unit, target)) return std::nullopt;
  const TextureBinding& object = unit.binding[index_of(target)];
  if (object == nullptr) return std::nullopt;
  const TextureParameters& p = object->parameters;
  const auto levels =
      pipeline::usable_levels(*object->texture, p.base_level, p.max_level, mip_filter(p.min_filter) != MipFilter::none);
  if (!levels) return std::nullopt;

  const pipeline::Image& image = object->texture->faces[0][static_cast<std::size_t>(levels->base)];
  pipeline::TextureUnitState result;
  result.unit = static_cast<std::uint8_t>(number);
  result.target = target;
  result.texture = object->texture.get();
  result.sampler = sampler_state(*object, image, *levels, unit.environment.lod_bias, group.seamless_enabled);
  result.environment = environment(unit.environment, effective_format(image, result.sampler), number);
  return result;
}

/// [GL1.5 §3.8.15]: what an argument that names a unit without a texture gives is undefined.
/// choice: such a unit does nothing, as ARB_texture_env_crossbar has it.
void drop_dangling_units(pipeline::TexturingState& texturing) {
  const auto end = [&] { return texturing.unit.begin() + texturing.count; };
  const auto exists = [&](std::uint8_t unit) {
    return std::any_of(texturing.unit.begin(), end(), [&](const auto& other) { return other.unit == unit; });
  };
  const auto dangles = [&](const pipeline::CombineTerms& terms) {
    return std::any_of(terms.argument.begin(), terms.argument.end(), [&](const pipeline::CombineArgument& argument) {
      return argument.source == CombineSource::texture_unit && !exists(argument.unit);
    });
  };
  const auto is_dangling = [&](const pipeline::TextureUnitState& unit) {
    return dangles(unit.environment.rgb) || dangles(unit.environment.alpha);
  };
  // Each round drops the first; another may have referred to it.
  for (auto found = std::find_if(texturing.unit.begin(), end(), is_dangling); found != end();
       found = std::find_if(texturing.unit.begin(), end(), is_dangling)) {
    std::move(found + 1, end(), found);
    texturing.unit[--texturing.count] = {};
  }
}

}  // namespace

pipeline::TexturingState texturing_state(const State& state) {
  pipeline::TexturingState result;
  for (int number = 0; number < max_texture_units; ++number) {
    if (const auto unit = unit_state(state.texture, number)) result.unit[result.count++] = *unit;
  }
  drop_dangling_units(result);
  if (!state.point.sprite_enabled) return result;
  for (const pipeline::TextureUnitState& unit : std::span(result.unit).first(result.count)) {
    result.sprite_units = static_cast<std::uint8_t>(result.sprite_units | (state.point.coord_replace & 1u << unit.unit));
  }
  return result;
}

}  // namespace gouraud::api
