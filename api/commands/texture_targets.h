// What the target of a texture command names [GL1.5 §3.8.1, §3.8.4, §3.8.11], with ARB_texture_rectangle.
#pragma once

#include <cstddef>
#include <optional>

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Of BindTexture, TexParameter, Enable: GL_TEXTURE_1D, _2D, _3D, _CUBE_MAP or _RECTANGLE_ARB.
constexpr std::optional<TextureTarget> texture_target(GLenum target) {
  switch (target) {
    case GL_TEXTURE_1D: return TextureTarget::one_d;
    case GL_TEXTURE_2D: return TextureTarget::two_d;
    case GL_TEXTURE_3D: return TextureTarget::three_d;
    case GL_TEXTURE_CUBE_MAP: return TextureTarget::cube_map;
    case GL_TEXTURE_RECTANGLE_ARB: return TextureTarget::rectangle;
    default: return std::nullopt;
  }
}

/// One image of the active unit's texture, or a proxy for one.
struct ImageTarget {
  TextureTarget target = TextureTarget::two_d;
  std::size_t face = 0;  ///< of a cube map: +x, -x, +y, -y, +z, -z
  bool proxy = false;
};

/// Of TexImage: a face of a cube map, not the whole; proxies.
constexpr std::optional<ImageTarget> image_target(GLenum target) {
  using enum TextureTarget;
  if (target - GL_TEXTURE_CUBE_MAP_POSITIVE_X < 6) return ImageTarget{cube_map, target - GL_TEXTURE_CUBE_MAP_POSITIVE_X};
  switch (target) {
    case GL_TEXTURE_1D: return ImageTarget{one_d};
    case GL_TEXTURE_2D: return ImageTarget{two_d};
    case GL_TEXTURE_3D: return ImageTarget{three_d};
    case GL_TEXTURE_RECTANGLE_ARB: return ImageTarget{rectangle};
    case GL_PROXY_TEXTURE_1D: return ImageTarget{one_d, 0, true};
    case GL_PROXY_TEXTURE_2D: return ImageTarget{two_d, 0, true};
    case GL_PROXY_TEXTURE_3D: return ImageTarget{three_d, 0, true};
    case GL_PROXY_TEXTURE_CUBE_MAP: return ImageTarget{cube_map, 0, true};
    case GL_PROXY_TEXTURE_RECTANGLE_ARB: return ImageTarget{rectangle, 0, true};
    default: return std::nullopt;
  }
}

inline TextureUnit& active_unit(Context& context) {
  return context.state.texture.units[static_cast<std::size_t>(context.state.texture.active_unit)];
}
inline const TextureUnit& active_unit(const Context& context) {
  return context.state.texture.units[static_cast<std::size_t>(context.state.texture.active_unit)];
}
/// What is bound to the target on the active unit; never null.
inline TextureObject& bound_texture(Context& context, TextureTarget target) {
  return *active_unit(context).binding[index_of(target)];
}

}  // namespace gouraud::api
