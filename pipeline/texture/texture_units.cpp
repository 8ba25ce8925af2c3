#include "pipeline/texture/texture_units.h"

#include <algorithm>

#include "pipeline/texture/environment.h"
#include "pipeline/texture/fixed_units.h"
#include "pipeline/texture/level_kernels.h"
#include "pipeline/texture/sampling.h"
#include "pipeline/texture/shadow_samples.h"
#include "pipeline/texture/texel_access.h"

namespace gouraud::pipeline {
namespace {

constexpr std::int32_t dimensions_of(TextureTarget target) {
  return target == TextureTarget::one_d ? 1 : target == TextureTarget::three_d ? 3 : 2;
}

PreparedLevel prepare_level(const Image& image, std::int32_t dimensions) {
  PreparedLevel level;
  level.image = &image;
  level.tiled = image.tiles != nullptr;
  const std::array<std::int32_t, 3> size{image.width, image.height, image.depth};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimensions); ++k) {
    level.border[k] = image.border;
    level.size[k] = size[k] - 2 * image.border;
  }
  if (level.tiled) {
    level.texels = image.tiles->storage();
    level.stride = {1, image.tiles->tiles_per_row(), image.tiles->pixels_per_plane()};
  } else {
    level.texels = image.texels.get();
    level.stride = {1, image.width, image.width * image.height};
  }
  return level;
}

/// [GL1.5 §3.8.8]: as Table 3.15 has it for the base format; the first component for depths.
std::array<float, 4> border_texel(const glm::vec4& c, BaseFormat format, bool depth, bool compares) {
  if (compares) return {c.x, c.x, c.x, c.x};
  switch (format) {
    case BaseFormat::alpha: return {0, 0, 0, depth ? c.x : c.w};
    case BaseFormat::luminance: return {c.x, c.x, c.x, 1};
    case BaseFormat::luminance_alpha: return {c.x, c.x, c.x, c.w};
    case BaseFormat::intensity:
    case BaseFormat::depth: return {c.x, c.x, c.x, c.x};
    case BaseFormat::rgb: return {c.x, c.y, c.z, 1};
    case BaseFormat::rgba: break;
  }
  return {c.x, c.y, c.z, c.w};
}

void prepare_unit(const TextureUnitState& state, PreparedUnit& out) {
  const Texture& texture = *state.texture;
  const auto base = static_cast<std::size_t>(state.sampler.base_level);
  const Image& first = texture.faces[0][base];
  out.state = state;
  out.dimensions = dimensions_of(state.target);
  out.level_count = state.sampler.last_level - state.sampler.base_level + 1;
  out.levels.clear();
  out.levels.reserve(texture.faces.size() * static_cast<std::size_t>(out.level_count));
  for (const auto& face : texture.faces) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(out.level_count); ++i) {
      out.levels.push_back(prepare_level(face[base + i], out.dimensions));
    }
  }
  out.format = first.format;
  out.srgb = first.srgb;
  out.widened = is_widened(first);
  out.base_format = texture_base_format(state);
  out.border = border_texel(state.sampler.border_color, out.base_format, first.base_format == BaseFormat::depth, state.sampler.compares);
  out.kernel = {level_kernel(out, TexelFilter::nearest), level_kernel(out, TexelFilter::linear)};
  const SampleFunction fixed = fixed_sample_function(out);
  const ShadowFunctions shadow = shadow_functions(out);
  out.sample = fixed != nullptr ? fixed : shadow.sample != nullptr ? shadow.sample : sample_function(out);
  out.fetch = shadow.fetch;
  out.environment = environment_function(state.environment, out.base_format);
}

bool reads_primary(const TextureEnvironment& environment) {
  if (environment.mode != EnvironmentMode::combine) return false;
  const auto reads = [](const CombineTerms& terms) {
    return std::any_of(terms.argument.begin(), terms.argument.end(),
                       [](const CombineArgument& argument) { return argument.source == CombineSource::primary_color; });
  };
  return reads(environment.rgb) || reads(environment.alpha);
}

}  // namespace

BaseFormat texture_base_format(const TextureUnitState& unit) {
  const BaseFormat format = unit.texture->faces[0][unit.sampler.base_level].base_format;
  if (format != BaseFormat::depth) return format;
  switch (unit.sampler.depth_mode) {
    case DepthTextureMode::luminance: return BaseFormat::luminance;
    case DepthTextureMode::alpha: return BaseFormat::alpha;
    case DepthTextureMode::red: return BaseFormat::rgb;
    case DepthTextureMode::intensity: break;
  }
  return BaseFormat::intensity;
}

void prepare_texture_units(const TexturingState& state, float output_scale, TextureUnits& out) {
  out.count = state.count;
  out.output_scale = output_scale;
  out.keeps_primary = out.fetches = false;
  for (std::size_t i = 0; i < state.count; ++i) {
    prepare_unit(state.unit[i], out.unit[i]);
    out.fetches |= state.count > 1 && out.unit[i].fetch != nullptr;
    out.keeps_primary |= reads_primary(state.unit[i].environment);
  }
  out.fixed = fixed_units_function(out);
  out.pack = packing_function();
}

}  // namespace gouraud::pipeline
