#include "api/commands/texel_formats.h"

namespace gouraud::api {
namespace {

constexpr GLenum compressed_red = 0x8225, compressed_rg = 0x8226;  // of ARB_texture_rg; gl.xml lacks them there

using pipeline::BaseFormat;
using pipeline::S3tcFormat;
using pipeline::TexelFormat;

std::optional<StoredFormat> plain(TexelFormat texels, BaseFormat base) { return StoredFormat{texels, base}; }

std::optional<StoredFormat> srgb(TexelFormat texels, BaseFormat base) {
  return StoredFormat{.texels = texels, .base = base, .srgb = true};
}

/// [ARB_texture_rg]: R, or R and G; the environment sees R, G, B.
std::optional<StoredFormat> few_colors(TexelFormat texels, std::uint8_t colors, bool is_generic = false) {
  return StoredFormat{.texels = texels, .base = BaseFormat::rgb, .colors = colors, .generic_compressed = is_generic};
}

std::optional<StoredFormat> generic(TexelFormat texels, BaseFormat base, bool is_srgb = false) {
  return StoredFormat{.texels = texels, .base = base, .srgb = is_srgb, .generic_compressed = true};
}

std::optional<StoredFormat> s3tc(S3tcFormat blocks, bool is_srgb) {
  const BaseFormat base = blocks == S3tcFormat::dxt1_rgb ? BaseFormat::rgb : BaseFormat::rgba;
  return StoredFormat{.texels = TexelFormat::rgba8, .base = base, .srgb = is_srgb, .blocks = blocks};
}

std::optional<StoredFormat> depth_stencil(TexelFormat texels) {
  return StoredFormat{.texels = texels, .base = BaseFormat::depth, .stencil = true};
}

std::optional<StoredFormat> find_color_format(GLenum internal_format) {
  using enum TexelFormat;
  using enum BaseFormat;
  switch (internal_format) {
    case GL_ALPHA:
    case GL_ALPHA4:
    case GL_ALPHA8: return plain(r8, alpha);
    case GL_ALPHA12:
    case GL_ALPHA16: return plain(r16, alpha);
    case 1:
    case GL_LUMINANCE:
    case GL_LUMINANCE4:
    case GL_LUMINANCE8: return plain(r8, luminance);
    case GL_LUMINANCE12:
    case GL_LUMINANCE16: return plain(r16, luminance);
    case 2:
    case GL_LUMINANCE_ALPHA:
    case GL_LUMINANCE4_ALPHA4:
    case GL_LUMINANCE6_ALPHA2:
    case GL_LUMINANCE8_ALPHA8: return plain(rg8, luminance_alpha);
    case GL_LUMINANCE12_ALPHA4:
    case GL_LUMINANCE12_ALPHA12:
    case GL_LUMINANCE16_ALPHA16: return plain(rg16, luminance_alpha);
    case GL_INTENSITY:
    case GL_INTENSITY4:
    case GL_INTENSITY8: return plain(r8, intensity);
    case GL_INTENSITY12:
    case GL_INTENSITY16: return plain(r16, intensity);
    case 3:
    case GL_RGB:
    case GL_R3_G3_B2:
    case GL_RGB2_EXT:
    case GL_RGB4:
    case GL_RGB5:
    case GL_RGB8: return plain(rgba8, rgb);
    case GL_RGB10:
    case GL_RGB12:
    case GL_RGB16: return plain(rgba16, rgb);
    case 4:
    case GL_RGBA:
    case GL_RGBA2:
    case GL_RGBA4:
    case GL_RGB5_A1:
    case GL_RGBA8: return plain(rgba8, rgba);
    case GL_RGB10_A2:
    case GL_RGBA12:
    case GL_RGBA16: return plain(rgba16, rgba);
    case GL_RED:
    case GL_R8: return few_colors(rgba8, 1);
    case GL_R16: return few_colors(rgba16, 1);
    case GL_RG:
    case GL_RG8: return few_colors(rgba8, 2);
    case GL_RG16: return few_colors(rgba16, 2);
    default: return std::nullopt;
  }
}

std::optional<StoredFormat> find_special_format(GLenum internal_format) {
  using enum TexelFormat;
  using enum BaseFormat;
  switch (internal_format) {
    case GL_DEPTH_COMPONENT16: return plain(z16, depth);
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_COMPONENT24:
    case GL_DEPTH_COMPONENT32: return plain(z24s8, depth);
    case GL_DEPTH_COMPONENT32F: return plain(z32f, depth);
    case GL_DEPTH_STENCIL_EXT:
    case GL_DEPTH24_STENCIL8_EXT: return depth_stencil(z24s8);
    case GL_DEPTH32F_STENCIL8: return depth_stencil(z32f);

    case GL_SRGB_EXT:
    case GL_SRGB8_EXT: return srgb(rgba8, rgb);
    case GL_SRGB_ALPHA_EXT:
    case GL_SRGB8_ALPHA8_EXT: return srgb(rgba8, rgba);
    case GL_SLUMINANCE_EXT:
    case GL_SLUMINANCE8_EXT: return srgb(r8, luminance);
    case GL_SLUMINANCE_ALPHA_EXT:
    case GL_SLUMINANCE8_ALPHA8_EXT: return srgb(rg8, luminance_alpha);

    case GL_COMPRESSED_ALPHA: return generic(r8, alpha);
    case GL_COMPRESSED_LUMINANCE: return generic(r8, luminance);
    case GL_COMPRESSED_LUMINANCE_ALPHA: return generic(rg8, luminance_alpha);
    case GL_COMPRESSED_INTENSITY: return generic(r8, intensity);
    case compressed_red: return few_colors(rgba8, 1, true);
    case compressed_rg: return few_colors(rgba8, 2, true);
    case GL_COMPRESSED_RGB: return generic(rgba8, rgb);
    case GL_COMPRESSED_RGBA: return generic(rgba8, rgba);
    case GL_COMPRESSED_SRGB_EXT: return generic(rgba8, rgb, true);
    case GL_COMPRESSED_SRGB_ALPHA_EXT: return generic(rgba8, rgba, true);
    case GL_COMPRESSED_SLUMINANCE_EXT: return generic(r8, luminance, true);
    case GL_COMPRESSED_SLUMINANCE_ALPHA_EXT: return generic(rg8, luminance_alpha, true);

    case GL_COMPRESSED_RGB_S3TC_DXT1_EXT: return s3tc(S3tcFormat::dxt1_rgb, false);
    case GL_COMPRESSED_RGBA_S3TC_DXT1_EXT: return s3tc(S3tcFormat::dxt1_rgba, false);
    case GL_COMPRESSED_RGBA_S3TC_DXT3_EXT: return s3tc(S3tcFormat::dxt3, false);
    case GL_COMPRESSED_RGBA_S3TC_DXT5_EXT: return s3tc(S3tcFormat::dxt5, false);
    case GL_COMPRESSED_SRGB_S3TC_DXT1_EXT: return s3tc(S3tcFormat::dxt1_rgb, true);
    case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT: return s3tc(S3tcFormat::dxt1_rgba, true);
    case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT: return s3tc(S3tcFormat::dxt3, true);
    case GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT: return s3tc(S3tcFormat::dxt5, true);
    default: return std::nullopt;
  }
}

int channel_bits(TexelFormat format) {
  switch (format) {
    case TexelFormat::r16:
    case TexelFormat::rg16:
    case TexelFormat::rgba16: return 16;
    case TexelFormat::rgba32f: return 32;
    default: return 8;
  }
}

int depth_bits(TexelFormat format) {
  return format == TexelFormat::z16 ? 16 : format == TexelFormat::z24s8 ? 24 : 32;
}

}  // namespace

std::optional<StoredFormat> find_stored_format(GLint internal_format) {
  const auto name = static_cast<GLenum>(internal_format);
  const auto color = find_color_format(name);
  return color ? color : find_special_format(name);
}

GLenum stored_name(GLenum internal_format) {
  switch (internal_format) {
    case GL_COMPRESSED_ALPHA: return GL_ALPHA;
    case GL_COMPRESSED_LUMINANCE: return GL_LUMINANCE;
    case GL_COMPRESSED_LUMINANCE_ALPHA: return GL_LUMINANCE_ALPHA;
    case GL_COMPRESSED_INTENSITY: return GL_INTENSITY;
    case compressed_red: return GL_RED;
    case compressed_rg: return GL_RG;
    case GL_COMPRESSED_RGB: return GL_RGB;
    case GL_COMPRESSED_RGBA: return GL_RGBA;
    case GL_COMPRESSED_SRGB_EXT: return GL_SRGB_EXT;
    case GL_COMPRESSED_SRGB_ALPHA_EXT: return GL_SRGB_ALPHA_EXT;
    case GL_COMPRESSED_SLUMINANCE_EXT: return GL_SLUMINANCE_EXT;
    case GL_COMPRESSED_SLUMINANCE_ALPHA_EXT: return GL_SLUMINANCE_ALPHA_EXT;
    default: return internal_format;
  }
}

std::span<const GLenum, compressed_format_count> compressed_formats() {
  static constexpr GLenum formats[compressed_format_count] = {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT3_EXT,
                                       GL_COMPRESSED_RGBA_S3TC_DXT5_EXT};
  return formats;
}

ComponentBits component_bits(const StoredFormat& format) {
  ComponentBits bits;
  const int size = channel_bits(format.texels);
  switch (format.base) {
    case BaseFormat::rgba:
      bits.alpha = format.blocks == S3tcFormat::dxt1_rgba ? 1 : format.blocks == S3tcFormat::dxt3 ? 4 : size;
      [[fallthrough]];
    case BaseFormat::rgb:
      bits.red = size;
      bits.green = format.colors > 1 ? size : 0;
      bits.blue = format.colors > 2 ? size : 0;
      break;
    case BaseFormat::luminance_alpha:
      bits.alpha = size;
      [[fallthrough]];
    case BaseFormat::luminance:
      bits.luminance = size;
      break;
    case BaseFormat::alpha:
      bits.alpha = size;
      break;
    case BaseFormat::intensity:
      bits.intensity = size;
      break;
    case BaseFormat::depth:
      bits.depth = depth_bits(format.texels);
      bits.stencil = format.stencil ? 8 : 0;
      break;
  }
  return bits;
}

}  // namespace gouraud::api
