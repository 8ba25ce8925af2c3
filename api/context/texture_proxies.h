// Proxy textures: what would be stored, without texels [GL1.5 §3.8.11].
#pragma once

#include <array>

#include <GL/gl.h>

#include "api/state/texture.h"

namespace gouraud::api {

/// All zero if the image that was asked for last would not fit.
struct ProxyImage {
  pipeline::Image image;
  GLenum internal_format = 1;
};

/// By target and level.
using TextureProxies = std::array<std::array<ProxyImage, pipeline::max_texture_levels>, texture_target_count>;

}  // namespace gouraud::api
