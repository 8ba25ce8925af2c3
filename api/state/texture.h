// Texture objects, and what a texture unit does with them [GL1.5 §3.8.4, §3.8.11 to §3.8.13, Tables 6.15 to 6.18].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>
#include <glm/glm.hpp>

#include "api/state/limits.h"
#include "pipeline/texture/image.h"

namespace gouraud::api {

inline constexpr std::size_t texture_target_count = 5;
using pipeline::TextureTarget;
constexpr std::size_t index_of(TextureTarget target) { return static_cast<std::size_t>(target); }

/// The parameters of a texture object [GL1.5 Table 3.19], as given; border colour and priority are clamped to [0, 1].
struct TextureParameters {
  std::array<GLenum, 3> wrap{GL_REPEAT, GL_REPEAT, GL_REPEAT};  ///< s, t, r
  GLenum min_filter = GL_NEAREST_MIPMAP_LINEAR, mag_filter = GL_LINEAR;
  glm::vec4 border_color{0.0f};
  float priority = 1.0f;
  float min_lod = -1000.0f, max_lod = 1000.0f;
  GLint base_level = 0, max_level = 1000;
  float lod_bias = 0.0f;
  float max_anisotropy = 1.0f;
  bool generate_mipmap = false;
  GLenum depth_mode = GL_LUMINANCE;
  GLenum compare_mode = GL_NONE, compare_func = GL_LEQUAL;
  bool operator==(const TextureParameters&) const = default;
};

/// What a program may ask about an image beside its texels.
struct ImageDescription {
  GLenum internal_format = 1;  ///< as specified
  /// The image as S3TC blocks, if that is its internal format.
  std::shared_ptr<const std::vector<std::byte>> blocks;
};
using LevelDescriptions = std::array<ImageDescription, pipeline::max_texture_levels>;

/// A texture object. Contexts that share it see each other's changes when they bind it.
struct TextureObject {
  explicit TextureObject(TextureTarget its_target) : target(its_target) {
    const std::size_t faces = target == TextureTarget::cube_map ? 6 : 1;
    texture->target = target;
    texture->faces.resize(faces);
    descriptions.resize(faces);
    if (target != TextureTarget::rectangle) return;
    parameters.wrap.fill(GL_CLAMP_TO_EDGE);
    parameters.min_filter = GL_LINEAR;
  }

  GLuint name = 0;
  TextureTarget target;
  TextureParameters parameters;
  /// Never null. Who holds it beside the object may read it: see pipeline/texture/image.h on changing it.
  std::shared_ptr<pipeline::Texture> texture = std::make_shared<pipeline::Texture>();
  std::vector<LevelDescriptions> descriptions;  ///< by face
};

/// A binding keeps the object alive, also after its name was deleted elsewhere. Null only in a State without a Context;
/// the name 0 is the Context's default texture.
using TextureBinding = std::shared_ptr<TextureObject>;

inline GLuint name_of(const TextureBinding& binding) {
  return binding != nullptr ? binding->name : 0;
}

/// One half of the COMBINE environment [GL1.5 Table 3.24]: of R, G, B, or of alpha.
struct CombineParameters {
  GLenum function = GL_MODULATE;
  std::array<GLenum, 3> source{GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT};
  std::array<GLenum, 3> operand{};
  float scale = 1.0f;
  bool operator==(const CombineParameters&) const = default;
};

/// [GL1.5 §3.8.13].
struct TextureEnvironmentParameters {
  GLenum mode = GL_MODULATE;
  glm::vec4 color{0.0f};  ///< in [0, 1]
  CombineParameters rgb{.operand = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA}};
  CombineParameters alpha{.operand = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA}};
  float lod_bias = 0.0f;
  bool operator==(const TextureEnvironmentParameters&) const = default;
};

struct TextureUnit {
  std::array<bool, texture_target_count> enabled{};
  std::array<TextureBinding, texture_target_count> binding{};
  TextureEnvironmentParameters environment;
  /// The name 0 is the same binding in every context, though each has default textures of its own.
  bool operator==(const TextureUnit& other) const {
    const auto same = [](const TextureBinding& a, const TextureBinding& b) {
      return a == b || (name_of(a) == 0 && name_of(b) == 0);
    };
    return enabled == other.enabled && environment == other.environment &&
           std::equal(binding.begin(), binding.end(), other.binding.begin(), same);
  }
};

/// The target that texturing uses: cube map over 3D over rectangle over 2D over 1D [GL1.5 §3.8.15],
/// ARB_texture_rectangle. False if none is enabled.
inline bool enabled_target(const TextureUnit& unit, TextureTarget& target) {
  using enum TextureTarget;
  for (const TextureTarget candidate : {cube_map, three_d, rectangle, two_d, one_d}) {
    target = candidate;
    if (unit.enabled[index_of(candidate)]) return true;
  }
  return false;
}

}  // namespace gouraud::api
