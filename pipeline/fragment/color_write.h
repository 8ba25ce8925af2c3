// Colour: interpolated, converted to the buffer's format, and written under the colour mask [GL1.5 §3.5.1, §4.2.2].
//
// Interpolation and write are one pass where nothing stands between them: the colour of a block then never goes through
// memory. Where alpha test, blending or a logical operation need it, it is kept in the block.
#pragma once

#include <cstdint>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that shades a block from its ColorRecord and writes it, for the instruction set in use. `write_mask` has a
/// bit for each of R, G, B, A and is not 0; the format is not `none`.
FragmentPass color_write_pass(ColorFormat format, std::uint8_t write_mask);

/// The pass that shades a block into FragmentBlock::color, where another pass stands between interpolation and write.
FragmentPass color_interpolation_pass();

/// What setup multiplies colours by for this format: its largest stored value, or 1 for float.
float color_scale(ColorFormat format);

}  // namespace gouraud::pipeline
