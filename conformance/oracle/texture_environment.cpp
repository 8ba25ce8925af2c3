// Texture functions as their tables have them [GL1.5 Tables 3.22 to 3.26], for one fragment.
#include <algorithm>

#include "conformance/oracle/textures.h"
#include "pipeline/texture/image.h"

namespace gouraud::oracle {
namespace {

using pipeline::BaseFormat;
using pipeline::CombineArgument;
using pipeline::CombineFunction;
using pipeline::CombineOperand;
using pipeline::CombineSource;
using pipeline::CombineTerms;
using pipeline::EnvironmentMode;

Color replace(BaseFormat format, const Color& f, const Color& s) {
  switch (format) {
    case BaseFormat::alpha: return {f[0], f[1], f[2], s[3]};
    case BaseFormat::luminance:
    case BaseFormat::rgb: return {s[0], s[1], s[2], f[3]};
    default: return s;
  }
}

Color modulate(BaseFormat format, const Color& f, const Color& s) {
  switch (format) {
    case BaseFormat::alpha: return {f[0], f[1], f[2], f[3] * s[3]};
    case BaseFormat::luminance:
    case BaseFormat::rgb: return {f[0] * s[0], f[1] * s[1], f[2] * s[2], f[3]};
    default: return {f[0] * s[0], f[1] * s[1], f[2] * s[2], f[3] * s[3]};
  }
}

Color decal(BaseFormat format, const Color& f, const Color& s) {
  if (format == BaseFormat::rgb) return {s[0], s[1], s[2], f[3]};
  if (format != BaseFormat::rgba) return f;
  Color out = f;
  for (std::size_t k = 0; k < 3; ++k) out[k] = f[k] * (1 - s[3]) + s[k] * s[3];
  return out;
}

Color blend(BaseFormat format, const Color& f, const Color& s, const Color& c) {
  Color out = f;
  for (std::size_t k = 0; format != BaseFormat::alpha && k < 3; ++k) out[k] = f[k] * (1 - s[k]) + c[k] * s[k];
  switch (format) {
    case BaseFormat::luminance:
    case BaseFormat::rgb: break;
    case BaseFormat::intensity: out[3] = f[3] * (1 - s[3]) + c[3] * s[3]; break;
    default: out[3] = f[3] * s[3];
  }
  return out;
}

Color add(BaseFormat format, const Color& f, const Color& s) {
  Color out = f;
  for (std::size_t k = 0; format != BaseFormat::alpha && k < 3; ++k) out[k] = std::min(f[k] + s[k], 1.0);
  switch (format) {
    case BaseFormat::luminance:
    case BaseFormat::rgb: break;
    case BaseFormat::intensity: out[3] = std::min(f[3] + s[3], 1.0); break;
    default: out[3] = f[3] * s[3];
  }
  return out;
}

/// [GL1.5 Tables 3.24 to 3.26].
class Combiner {
 public:
  Combiner(const pipeline::TexturingState& state, std::size_t unit, const Color& primary, const Color& previous, std::span<const Color> texels)
      : state_(state), unit_(unit), primary_(primary), previous_(previous), texels_(texels) {}

  Color result() const {
    const pipeline::TextureEnvironment& environment = state_.unit[unit_].environment;
    Color out;
    for (std::size_t k = 0; k < 3; ++k) out[k] = scaled(environment.rgb, k, environment.rgb.scale);
    // [GL1.5 Table 3.24]: the scalar goes to all four; RGB and alpha results are scaled each by its own.
    const bool dot3_to_alpha = environment.rgb.function == CombineFunction::dot3_rgba;
    out[3] = scaled(dot3_to_alpha ? environment.rgb : environment.alpha, 3, environment.alpha.scale);
    return out;
  }

 private:
  double scaled(const CombineTerms& terms, std::size_t channel, float scale) const {
    return std::clamp(value(terms, channel) * static_cast<double>(scale), 0.0, 1.0);
  }

  double value(const CombineTerms& terms, std::size_t channel) const {
    const auto arg = [&](std::size_t i, std::size_t k) { return argument(terms.argument[i], k); };
    const std::size_t k = channel;
    switch (terms.function) {
      case CombineFunction::replace: return arg(0, k);
      case CombineFunction::modulate: return arg(0, k) * arg(1, k);
      case CombineFunction::add: return arg(0, k) + arg(1, k);
      case CombineFunction::add_signed: return arg(0, k) + arg(1, k) - 0.5;
      case CombineFunction::interpolate: return arg(0, k) * arg(2, k) + arg(1, k) * (1 - arg(2, k));
      case CombineFunction::subtract: return arg(0, k) - arg(1, k);
      case CombineFunction::dot3_rgb:
      case CombineFunction::dot3_rgba: break;
    }
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += (arg(0, i) - 0.5) * (arg(1, i) - 0.5);
    return 4 * sum;
  }

  double argument(const CombineArgument& a, std::size_t channel) const {
    const Color source = source_of(a);
    switch (a.operand) {
      case CombineOperand::color: return source[channel];
      case CombineOperand::one_minus_color: return 1 - source[channel];
      case CombineOperand::alpha: return source[3];
      case CombineOperand::one_minus_alpha: break;
    }
    return 1 - source[3];
  }

  Color source_of(const CombineArgument& a) const {
    const glm::vec4& c = state_.unit[unit_].environment.color;
    switch (a.source) {
      case CombineSource::texture: return texels_[unit_];
      case CombineSource::constant: return {c.x, c.y, c.z, c.w};
      case CombineSource::primary_color: return primary_;
      case CombineSource::previous: return previous_;
      case CombineSource::texture_unit: break;
    }
    for (std::size_t i = 0; i < state_.count; ++i) {
      if (state_.unit[i].unit == a.unit) return texels_[i];
    }
    return {};
  }

  const pipeline::TexturingState& state_;
  std::size_t unit_;
  const Color &primary_, &previous_;
  std::span<const Color> texels_;
};

}  // namespace

Color apply_environment(const pipeline::TexturingState& state, std::size_t unit, const Color& primary, const Color& previous,
                        std::span<const Color> texels) {
  const pipeline::TextureEnvironment& environment = state.unit[unit].environment;
  const BaseFormat format = seen_format(state.unit[unit]);
  const Color& texel = texels[unit];
  const glm::vec4& c = environment.color;
  switch (environment.mode) {
    case EnvironmentMode::replace: return replace(format, previous, texel);
    case EnvironmentMode::modulate: return modulate(format, previous, texel);
    case EnvironmentMode::decal: return decal(format, previous, texel);
    case EnvironmentMode::blend: return blend(format, previous, texel, {c.x, c.y, c.z, c.w});
    case EnvironmentMode::add: return add(format, previous, texel);
    case EnvironmentMode::combine: break;
  }
  return Combiner(state, unit, primary, previous, texels).result();
}

}  // namespace gouraud::oracle
