// Texturing as the pipeline sees it: where texture coordinates come from (vertices), and what each unit does with a
// fragment. Canonical as all of DrawState: units that are off are absent, and so is what an enabled unit does not use.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include <glm/glm.hpp>

#include "pipeline/draw/limits.h"

namespace gouraud::pipeline {

struct Texture;  // pipeline/texture/image.h

/// [GL1.5 §2.11.4]. `given`: the vertex's own coordinate.
enum class TexgenMode : std::uint8_t { given, object_linear, eye_linear, sphere_map, normal_map, reflection_map };

/// The coordinates of one unit: s, t, r, q are generated or given, then multiplied by the matrix.
struct TextureCoordinateSource {
  std::array<TexgenMode, 4> mode{};
  std::array<glm::vec4, 4> plane{};  ///< of the linear modes (eye planes already times the inverse modelview); else 0
  bool transformed = false;          ///< false: the matrix is the identity
  glm::mat4 matrix{1.0f};
  bool operator==(const TextureCoordinateSource&) const = default;
};

/// By unit; units that `units` does not name hold initial values.
struct TextureCoordinatesState {
  std::uint8_t units = 0;  ///< bit k: unit k is textured (TexturingState has it)
  std::array<TextureCoordinateSource, max_texture_units> unit{};
  bool operator==(const TextureCoordinatesState& other) const {
    return units == other.units && (units == 0 || unit == other.unit);
  }
};

/// [GL1.5 §3.8.7]. `clamp` blends with the border at the edge when filtering linearly.
enum class WrapMode : std::uint8_t { repeat, clamp, clamp_to_edge, clamp_to_border, mirrored_repeat };
/// Filter within a level, and between levels [GL1.5 §3.8.8].
enum class TexelFilter : std::uint8_t { nearest, linear };
enum class MipFilter : std::uint8_t { none, nearest, linear };
enum class TextureTarget : std::uint8_t { one_d, two_d, three_d, cube_map, rectangle };
/// What a depth texture's result becomes [GL1.5 §3.8.5].
enum class DepthTextureMode : std::uint8_t { luminance, intensity, alpha, red };

/// How a texture is sampled.
struct SamplerState {
  std::array<WrapMode, 3> wrap{};  ///< s, t, r as far as the target has them
  std::array<bool, 3> mirrored_once{};  ///< their absolute values are wrapped [EXT_texture_mirror_clamp]
  TexelFilter minify = TexelFilter::nearest, magnify = TexelFilter::nearest;
  MipFilter mip = MipFilter::none;
  /// The level from which LOD 0 counts, and the last that may be used (q of §3.8.8); equal without mipmaps.
  std::uint8_t base_level = 0, last_level = 0;
  float lod_bias = 0.0f;           ///< of texture object and unit together
  float min_lod = 0.0f, max_lod = 0.0f;
  float max_anisotropy = 1.0f;     ///< most samples along a footprint's longer side: whole; 1 for cube maps
  glm::vec4 border_color{0.0f};    ///< if a wrap mode can reach it
  bool compares = false;           ///< TEXTURE_COMPARE_MODE is COMPARE_R_TO_TEXTURE, on a depth texture
  std::uint8_t compare_func = 0;   ///< a CompareFunc's number
  DepthTextureMode depth_mode = DepthTextureMode::luminance;
  bool seamless = false;           ///< cube maps filter across edges (ARB_seamless_cube_map)
  bool operator==(const SamplerState&) const = default;
};

/// [GL1.5 §3.8.13, Tables 3.22 to 3.26].
enum class EnvironmentMode : std::uint8_t { modulate, replace, decal, blend, add, combine };
enum class CombineFunction : std::uint8_t { replace, modulate, add, add_signed, interpolate, subtract, dot3_rgb, dot3_rgba };
enum class CombineSource : std::uint8_t { texture, constant, primary_color, previous, texture_unit };
enum class CombineOperand : std::uint8_t { color, one_minus_color, alpha, one_minus_alpha };
struct CombineArgument {
  CombineSource source = CombineSource::previous;
  std::uint8_t unit = 0;  ///< of texture_unit (crossbar)
  CombineOperand operand = CombineOperand::color;
  bool operator==(const CombineArgument&) const = default;
};
struct CombineTerms {
  CombineFunction function = CombineFunction::modulate;
  std::array<CombineArgument, 3> argument{};  ///< as many as the function takes; the others are initial
  float scale = 1.0f;                         ///< 1, 2 or 4
  bool operator==(const CombineTerms&) const = default;
};
struct TextureEnvironment {
  EnvironmentMode mode = EnvironmentMode::modulate;
  glm::vec4 color{0.0f};  ///< in [0, 1]; if the mode or a combiner uses it
  CombineTerms rgb{}, alpha{};  ///< of `combine`; of dot3_rgba all alpha terms but the scale are initial
  bool operator==(const TextureEnvironment&) const = default;
};

struct TextureUnitState {
  std::uint8_t unit = 0;  ///< its GL number, which finds its coordinates
  TextureTarget target = TextureTarget::two_d;
  const Texture* texture = nullptr;  ///< complete; whoever draws keeps it alive until the draw has been rasterized
  SamplerState sampler{};
  TextureEnvironment environment{};
  bool operator==(const TextureUnitState&) const = default;
};

/// The textured units in ascending order: enabled, complete, with a texture. Absent ones do nothing.
struct TexturingState {
  std::uint8_t count = 0;
  /// Point sprites [ARB_point_sprite]: bit k says that points get (0..1, 0..1) in place of unit k's coordinates.
  std::uint8_t sprite_units = 0;
  std::array<TextureUnitState, max_texture_units> unit{};
  bool operator==(const TexturingState& other) const {
    return count == other.count && sprite_units == other.sprite_units && (count == 0 || unit == other.unit);
  }
};
static_assert(std::is_trivially_copyable_v<TexturingState>);

}  // namespace gouraud::pipeline
