// Writing rows into the target past all fragment operations, as pixel rectangles of stencil do [GL1.5 §4.3.1], and those
// of colours that nothing happens to. All pending tiles must have been rasterized. Rows lie inside the target.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Sets the bits of `mask` of pixels [x, x + count) of row y. Nothing happens without a stencil buffer.
void write_stencil_row(const Framebuffer& target, int x, int y, int count, const std::uint8_t* values, std::uint8_t mask);

/// Colours as the target stores them into the `rows` rows of `count` pixels from (x, y) upwards. Row i comes from
/// in + i * row_stride_bytes.
void write_color_rows(const Framebuffer& target, int x, int y, int count, int rows, const std::byte* in, std::ptrdiff_t row_stride_bytes);

/// Depths in [0, 1] become buffer units, to nearest; floats are kept. Nothing happens without a depth buffer.
void write_depth_row(const Framebuffer& target, int x, int y, int count, const double* depths);

/// A depth in [0, 1] in the units of a depth buffer, to nearest even; for z32 and z32f, whose units no float can count, the
/// depth itself.
float depth_in_units(double depth, DepthFormat format);

}  // namespace gouraud::pipeline
