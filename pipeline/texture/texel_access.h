// Single texels as four floats, for work that is not worth a kernel: mipmap generation, seams of cube maps, tests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

using Texel = std::array<float, 4>;  ///< R, G, B, A as the base format gives them: L is (L, L, L, 1), depth (d, d, d, d)

/// Address of texel (x, y, z), counted from the image's corner, border included.
inline std::byte* texel_address(const Image& image, int x, int y, int z) {
  if (image.tiles) return z == 0 ? image.tiles->pixel(x, y) : image.tiles->plane(z).pixel(x, y);
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  const std::size_t index = (static_cast<std::size_t>(z) * height + static_cast<std::size_t>(y)) * width + static_cast<std::size_t>(x);
  return image.texels.get() + index * static_cast<std::size_t>(bytes_per_texel(image.format));
}

/// The stored channels in [0, 1] (floats as they are), R, G, B, A or L, A or one; not decoded from sRGB.
Texel stored_channels(TexelFormat format, const std::byte* texel);
/// The converse, rounded to nearest; the stencil bits of z24s8 become 0.
void store_channels(TexelFormat format, const Texel& channels, std::byte* texel);

/// Stored channels to R, G, B, A by base format [GL1.5 Table 3.23], sRGB decoded.
Texel expand_channels(const Image& image, const Texel& channels);

/// The linear value of an sRGB-encoded one, both in [0, 1] [EXT_texture_sRGB].
double linear_of_srgb(double encoded);
/// The linear value of an sRGB-encoded byte [EXT_texture_sRGB], rounded to float.
float decode_srgb(std::uint8_t encoded);
/// The nearest encoded byte of a linear value; NaN gives 0.
std::uint8_t encode_srgb(float linear);
/// decode_srgb of all bytes.
const std::array<float, 256>& srgb_table();

}  // namespace gouraud::pipeline
