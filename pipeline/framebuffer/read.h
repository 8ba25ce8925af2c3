// Reading the render target: rows of pixels out of the tiles, in the formats that ReadPixels and the OSMesa
// copy-out build on [GL1.5 §4.3.2]. All pending tiles must have been rasterized (Renderer::finish).
// Rectangles lie inside the target; rows go bottom-up, the first row is y.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Stored colour of one row, pixels [x, x + count), in the buffer's own format (bytes_per_pixel each).
void read_color_row(const Framebuffer& target, int x, int y, int count, void* out);

/// Stored colour of `rows` rows of `count` pixels, from (x, y) upwards, in the buffer's own format. Row i goes to
/// out + i * row_stride_bytes; a negative stride turns the picture upside down. Block by block: the way to read much.
void read_color_rows(const Framebuffer& target, int x, int y, int count, int rows, std::byte* out,
                     std::ptrdiff_t row_stride_bytes);

/// Stored depth of `rows` rows, as read_color_rows: 16-bit words, 32-bit words with the stencil in the top 8 bits, or
/// floats.
void read_depth_rows(const Framebuffer& target, int x, int y, int count, int rows, std::byte* out,
                     std::ptrdiff_t row_stride_bytes);

/// Depth of `rows` rows in [0, 1] as floats: value / (2^bits - 1), to nearest, or the float stored.
void read_depth_rows_float(const Framebuffer& target, int x, int y, int count, int rows, std::byte* out,
                           std::ptrdiff_t row_stride_bytes);

/// Colour of one row as float RGBA. Bytes give v * (1/255.0f), 16-bit words v * (1/65535.0f) (MESA-RULES 9).
void read_color_row_float(const Framebuffer& target, int x, int y, int count, float* out_rgba);

/// Colour of one row as bytes R, G, B, A. 16-bit and float buffers are converted: clamp to [0, 1], times 255, to
/// nearest.
void read_color_row_unorm8(const Framebuffer& target, int x, int y, int count, std::uint8_t* out_rgba);

/// Depth of one row as stored: 16-bit or 24-bit values as integers; not for float depth.
void read_depth_row(const Framebuffer& target, int x, int y, int count, std::uint32_t* out);

/// Depth of one row in [0, 1]: value / (2^bits - 1), or the float stored.
void read_depth_row_float(const Framebuffer& target, int x, int y, int count, float* out);

/// Stencil of one row; zeros if the target has none.
void read_stencil_row(const Framebuffer& target, int x, int y, int count, std::uint8_t* out);

}  // namespace gouraud::pipeline
