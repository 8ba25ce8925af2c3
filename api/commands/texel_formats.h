// How an image of a given internal format is stored [GL1.5 §3.8.1, Tables 3.15 to 3.18], with EXT_texture_sRGB,
// ARB_texture_rg, EXT_texture_compression_s3tc, EXT_packed_depth_stencil and ARB_depth_buffer_float.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <GL/gl.h>

#include "pipeline/texture/image.h"
#include "pipeline/texture/s3tc.h"

namespace gouraud::api {

struct StoredFormat {
  pipeline::TexelFormat texels = pipeline::TexelFormat::none;
  pipeline::BaseFormat base = pipeline::BaseFormat::rgba;
  std::uint8_t colors = 3;  ///< of rgb: as pipeline::Image has it
  bool srgb = false;
  bool stencil = false;  ///< DEPTH_STENCIL: the base internal format holds both
  std::optional<pipeline::S3tcFormat> blocks{};  ///< what an image is kept as besides its decoded texels
  bool generic_compressed = false;  ///< GL_COMPRESSED_RGB and its like: CompressedTexImage refuses them

  bool depth() const { return base == pipeline::BaseFormat::depth; }
};

/// The stored format; none for what is no internal format.
/// choice: channels of up to 8 bits take 8, those of more take 16; depth of up to 16 bits takes 16, of more 24; generic
/// compressed formats are stored uncompressed; one or two colours take the room of three, which sampling knows.
std::optional<StoredFormat> find_stored_format(GLint internal_format);

/// What the internal format of an image is called once it is stored: the base internal format in place of a generic
/// compressed one, since nothing is compressed then [GL1.5 §3.8.1].
GLenum stored_name(GLenum internal_format);

/// What GL_COMPRESSED_TEXTURE_FORMATS lists: those without a restriction that a general program would not expect
/// [GL1.5 §6.1.3]: not DXT1 with alpha (EXT_texture_compression_s3tc).
inline constexpr int compressed_format_count = 3;
std::span<const GLenum, compressed_format_count> compressed_formats();

/// Bits of each component as stored: what GetTexLevelParameter tells.
struct ComponentBits {
  int red = 0, green = 0, blue = 0, alpha = 0, luminance = 0, intensity = 0, depth = 0, stencil = 0;
};
ComponentBits component_bits(const StoredFormat& format);

}  // namespace gouraud::api
