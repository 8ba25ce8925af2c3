// Texels as they are stored, and as numbers. Takes rows of R, G, B, A or of depths, gives rows of texels of an image's
// format, and back [GL1.5 §3.8.1 Table 3.15, §6.1.4 Table 6.1]; and copies rows into and out of an image, whichever way
// it lies in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// Colours to texels of the image's format: each channel clamped to [0, 1] (NaN: 0) and rounded to nearest. `out` takes
/// count * bytes_per_texel bytes. Floats are `count` times R, G, B, A; so are bytes.
void store_colors(const Image& image, const float* rgba, std::size_t count, std::byte* out);
void store_colors(const Image& image, const std::uint8_t* rgba, std::size_t count, std::byte* out);
/// The same of depths; `stencils`, if not null, goes where the format has room for it, else 0 does.
void store_depths(const Image& image, const double* depths, const std::uint32_t* stencils, std::size_t count, std::byte* out);

/// Texels to colours: luminance to R, intensity to R; what is not there is 0, alpha 1 [GL1.5 Table 6.1].
void load_colors(const Image& image, const std::byte* texels, std::size_t count, float* rgba);
/// Of formats of 8 bits a channel, exactly.
void load_colors(const Image& image, const std::byte* texels, std::size_t count, std::uint8_t* rgba);
bool has_byte_channels(TexelFormat format);
/// `stencils` may be null.
void load_depths(const Image& image, const std::byte* texels, std::size_t count, double* depths, std::uint32_t* stencils);

/// Bytes of all texels.
std::size_t texel_bytes(const Image& image);
/// Gives the image texels of its format and size, untiled, zeroed unless all will be written. Throws std::bad_alloc.
void allocate_texels(Image& image, bool zeroed = true);
/// Gives an image its plane of stencil values, zero at first, if it is to have one and lacks it. Throws std::bad_alloc.
void make_stencil_plane(Image& image);
/// The first byte of a row of an untiled image.
std::byte* texel_row(const Image& image, int y, int z);
/// Stencil values [x, x + count) of a row of an image that has a plane of them; others are left alone, and give 0.
void read_stencils(const Image& image, int x, int y, int count, std::uint32_t* out);
void write_stencils(const Image& image, int x, int y, int count, const std::uint32_t* stencils);

/// Texels [x, x + count) of a row, as stored; the image may lie in tiles.
void read_texels(const Image& image, int x, int y, int z, int count, std::byte* out);
void write_texels(const Image& image, int x, int y, int z, int count, const std::byte* texels);

}  // namespace gouraud::pipeline
