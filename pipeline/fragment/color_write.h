// Colour: interpolated, converted to the buffer's format, and written under the colour mask [GL1.5 §3.5.1, §4.2.2].
//
// Interpolation and write are one pass where nothing stands between them: the colour of a block then never goes through
// memory. Where alpha test, blending or a logical operation need it, it is kept in the block.
#pragma once

#include <cstdint>

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that shades a block from its ColorRecord and writes it, for the instruction set in use. `write_mask` has a
/// bit for each of R, G, B, A and is not 0; the format is not `none`.
FragmentPass color_write_pass(ColorFormat format, std::uint8_t write_mask);

/// The same with fog between shading and write, for 8-bit targets all of whose channels are written: the block has its fog
/// coordinate. (Three passes that hand the colours on through memory cost half as much again.)
FragmentPass fogged_color_write_pass(FogMode mode);

/// The pass that shades a block into FragmentBlock::color, where another pass stands between interpolation and write.
FragmentPass color_interpolation_pass();

/// What setup multiplies colours by for this format: its largest stored value, or 1 for float.
float color_scale(ColorFormat format);

}  // namespace gouraud::pipeline
