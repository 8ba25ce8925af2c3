// Reading the render target as a program wants it: rows of pixels with their channels in a given order and size.
// All pending tiles must have been rasterized (Renderer::finish).
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/framebuffer/byte_orders.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Channels in the order of memory, without gaps; words and floats in the machine's byte order. rgb565 is a 16-bit word
/// with red in the top bits.
enum class PackedLayout : std::uint8_t {
  rgba8,
  bgra8,
  argb8,
  rgb8,
  bgr8,
  rgb565,  // of a ColorFormat::rgba8 target
  rgba16,
  rgb16,
  bgr16,  // of rgba16
  rgba32f,
  rgb32f,
  bgr32f,  // of rgba32f
};

/// What a target must store so that `layout` can be packed from it without a change of precision.
ColorFormat stored_format(PackedLayout layout);

int bytes_per_pixel(PackedLayout layout);

/// Packs `rows` rows of `count` pixels, from (x, y) upwards; row i goes to out + i * row_stride_bytes, which may be
/// negative and need not be aligned. The target's colour format is stored_format(layout).
void pack_color_rows(const Framebuffer& target, PackedLayout layout, int x, int y, int count, int rows, std::byte* out,
                     std::ptrdiff_t row_stride_bytes);

/// The same of a ColorFormat::rgba8 target, with any of its bytes in any order.
void pack_bytes(const Framebuffer& target, const ByteOrder& order, int bytes_per_pixel, int x, int y, int count, int rows, std::byte* out,
                std::ptrdiff_t row_stride_bytes);

}  // namespace gouraud::pipeline
