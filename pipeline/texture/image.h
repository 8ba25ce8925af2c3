// Texture images: what the api stores, the sampler reads, and framebuffer objects draw into.
//
// Ownership: a Texture is published as std::shared_ptr<const Texture> and then never changes its shape. A change of
// shape (TexImage) makes a new Texture that shares the images that stay. A change of texels (TexSubImage) writes in place
// only if nobody else holds the texture after this context has finished its own pending work; else to a copy.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "pipeline/draw/limits.h"
#include "pipeline/draw/texture_state.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// How a texel lies in memory; channels in the order R, G, B, A. One-channel formats hold A, L, I (Image::base_format says
/// which), two-channel ones L and A. RGB images are stored as RGBA with alpha 1. So are A, L, LA and I once framebuffers
/// draw into them: L and I in R, A in A (wide_format()).
enum class TexelFormat : std::uint8_t { none, r8, rg8, rgba8, r16, rg16, rgba16, rgba32f, z16, z24s8, z32f };

/// Base internal formats [GL1.5 Table 3.15]: what the environment takes from a texel.
enum class BaseFormat : std::uint8_t { alpha, luminance, luminance_alpha, intensity, rgb, rgba, depth };

constexpr int bytes_per_texel(TexelFormat format) {
  switch (format) {
    case TexelFormat::none: return 0;
    case TexelFormat::r8: return 1;
    case TexelFormat::rg8:
    case TexelFormat::r16:
    case TexelFormat::z16: return 2;
    case TexelFormat::rgba8:
    case TexelFormat::rg16:
    case TexelFormat::z24s8:
    case TexelFormat::z32f: return 4;
    case TexelFormat::rgba16: return 8;
    case TexelFormat::rgba32f: return 16;
  }
  return 0;
}

/// Of as many channels as a pixel of a framebuffer has, and as many bits a channel.
constexpr TexelFormat wide_format(TexelFormat format) {
  switch (format) {
    case TexelFormat::r8:
    case TexelFormat::rg8: return TexelFormat::rgba8;
    case TexelFormat::r16:
    case TexelFormat::rg16: return TexelFormat::rgba16;
    default: return format;
  }
}
constexpr bool has_four_channels(TexelFormat format) {
  return format == TexelFormat::rgba8 || format == TexelFormat::rgba16 || format == TexelFormat::rgba32f;
}

/// One level of one face. Texel (x, y, z) counts from the lower left of the image, border included: the border of width
/// `border` surrounds it in the dimensions that the target has.
struct Image {
  TexelFormat format = TexelFormat::none;
  BaseFormat base_format = BaseFormat::rgba;
  std::uint8_t colors = 3;  ///< of rgb: fewer where only R, or R and G, are kept [ARB_texture_rg]; the others are 0
  bool srgb = false;  ///< R, G, B are sRGB-encoded: decoded before filtering
  std::int32_t width = 0, height = 0, depth = 0;  ///< in texels, borders included; 0: no image
  std::int32_t border = 0;
  /// Rows of width texels, tightly packed, row after row, slice after slice; at least 16 readable bytes lie behind.
  std::shared_ptr<std::byte[]> texels;
  /// In place of `texels`: the image is (or was) a framebuffer's attachment and lies in tiles, a plane a slice.
  std::shared_ptr<TiledBuffer> tiles;
  bool has_stencil = false;              ///< of depth: with stencil values, in the words of z24s8, else in `stencil`
  std::shared_ptr<TiledBuffer> stencil;  ///< a byte a texel; null until somebody needs it

  bool empty() const { return width == 0 || height == 0 || depth == 0; }
};

/// Whether it has more channels than its base format (wide_format()).
inline bool is_widened(const Image& image) {
  using enum BaseFormat;
  return has_four_channels(image.format) && image.base_format != rgb && image.base_format != rgba;
}

/// Whether texels of one fit the other, and mean the same there.
inline bool have_same_shape(const Image& a, const Image& b) {
  return a.format == b.format && a.base_format == b.base_format && a.colors == b.colors && a.srgb == b.srgb && a.width == b.width && a.height == b.height &&
         a.depth == b.depth && a.border == b.border && a.has_stencil == b.has_stencil;
}

struct Texture {
  TextureTarget target = TextureTarget::two_d;
  /// One face, or the six of a cube map (+x, -x, +y, -y, +z, -z), and its images by level: empty where there is none.
  std::vector<std::array<Image, max_texture_levels>> faces;
};

}  // namespace gouraud::pipeline
