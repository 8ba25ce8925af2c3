// choice: luminance and intensity are drawn to as red, and read as red.
// choice: colours are stored with 8 or with 16 bits a channel, also where fewer were asked for; depths of 32 bits are
// floats, as in a context that is asked for so many; a stencil value always has 8 bits.
#include "api/snapshot/surface_formats.h"

namespace gouraud::api {
namespace {

using pipeline::ColorFormat;
using pipeline::DepthFormat;
using pipeline::Surface;

constexpr GLenum rgb565 = 0x8D62;  // of ARB_ES2_compatibility, which our headers lack
constexpr std::uint8_t rgba = 0b1111, rgb = 0b0111, red_green = 0b0011, red_alpha = 0b1001, red = 0b0001, alpha = 0b1000;

Surface color(ColorFormat format, std::uint8_t channels) {
  Surface surface;
  surface.color_format = format;
  surface.channels = channels;
  return surface;
}

Surface luminance(ColorFormat format, std::uint8_t channels) {
  Surface surface = color(format, channels);
  surface.red_is_luminance = true;
  return surface;
}

Surface depth(DepthFormat format, bool has_depth, bool has_stencil) {
  Surface surface;
  surface.depth_format = format;
  surface.has_depth = has_depth;
  surface.has_stencil = has_stencil;
  return surface;
}

}  // namespace

std::optional<Surface> surface_of_format(GLenum internal_format) {
  switch (internal_format) {
    case GL_RGBA:
    case GL_RGBA2:
    case GL_RGBA4:
    case GL_RGB5_A1:
    case GL_RGBA8:
    case GL_SRGB_ALPHA_EXT:
    case GL_SRGB8_ALPHA8_EXT:
      return color(ColorFormat::rgba8, rgba);
    case GL_RGB:
    case GL_R3_G3_B2:
    case GL_RGB2_EXT:
    case GL_RGB4:
    case GL_RGB5:
    case GL_RGB8:
    case rgb565:
    case GL_SRGB_EXT:
    case GL_SRGB8_EXT:
      return color(ColorFormat::rgba8, rgb);
    case GL_RGB10_A2:
    case GL_RGBA12:
    case GL_RGBA16:
      return color(ColorFormat::rgba16, rgba);
    case GL_RGB10:
    case GL_RGB12:
    case GL_RGB16:
      return color(ColorFormat::rgba16, rgb);
    case GL_RED:
    case GL_R8:
      return color(ColorFormat::rgba8, red);
    case GL_R16:
      return color(ColorFormat::rgba16, red);
    case GL_RG:
    case GL_RG8:
      return color(ColorFormat::rgba8, red_green);
    case GL_RG16:
      return color(ColorFormat::rgba16, red_green);
    case GL_ALPHA:
    case GL_ALPHA4:
    case GL_ALPHA8:
      return color(ColorFormat::rgba8, alpha);
    case GL_ALPHA12:
    case GL_ALPHA16:
      return color(ColorFormat::rgba16, alpha);
    case GL_LUMINANCE:
    case GL_LUMINANCE4:
    case GL_LUMINANCE8:
    case GL_INTENSITY:
    case GL_INTENSITY4:
    case GL_INTENSITY8:
      return luminance(ColorFormat::rgba8, red);
    case GL_LUMINANCE12:
    case GL_LUMINANCE16:
    case GL_INTENSITY12:
    case GL_INTENSITY16:
      return luminance(ColorFormat::rgba16, red);
    case GL_LUMINANCE_ALPHA:
    case GL_LUMINANCE4_ALPHA4:
    case GL_LUMINANCE6_ALPHA2:
    case GL_LUMINANCE8_ALPHA8:
      return luminance(ColorFormat::rgba8, red_alpha);
    case GL_LUMINANCE12_ALPHA4:
    case GL_LUMINANCE12_ALPHA12:
    case GL_LUMINANCE16_ALPHA16:
      return luminance(ColorFormat::rgba16, red_alpha);
    case GL_DEPTH_COMPONENT16:
      return depth(DepthFormat::z16, true, false);
    case GL_DEPTH_COMPONENT:
    case GL_DEPTH_COMPONENT24:
      return depth(DepthFormat::z24s8, true, false);
    case GL_DEPTH_COMPONENT32:
    case GL_DEPTH_COMPONENT32F:
      return depth(DepthFormat::z32f, true, false);
    case GL_DEPTH_STENCIL:
    case GL_DEPTH24_STENCIL8:
      return depth(DepthFormat::z24s8, true, true);
    case GL_DEPTH32F_STENCIL8:
      return depth(DepthFormat::z32f, true, true);
    case GL_STENCIL_INDEX:
    case GL_STENCIL_INDEX1:
    case GL_STENCIL_INDEX4:
    case GL_STENCIL_INDEX8:
    case GL_STENCIL_INDEX16:
      return depth(DepthFormat::none, false, true);
    default:
      return std::nullopt;
  }
}

ComponentBits component_bits(const Surface& surface) {
  ComponentBits bits;
  const GLint channel = bytes_per_pixel(surface.color_format) * 2;
  const auto has = [&](int k) { return (surface.channels >> k & 1) != 0 ? channel : 0; };
  bits.red = surface.red_is_luminance ? 0 : has(0);
  bits.green = has(1);
  bits.blue = has(2);
  bits.alpha = has(3);
  if (surface.has_depth) bits.depth = pipeline::depth_bits(surface.depth_format);
  if (surface.has_stencil) bits.stencil = 8;
  return bits;
}

}  // namespace gouraud::api
