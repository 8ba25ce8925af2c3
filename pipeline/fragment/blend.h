// Blending [GL1.5 §4.1.8], logical operation [GL1.5 §4.1.10], and the write of colours that a block holds [GL1.5 §4.2.2].
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that brings the colours in a block to a target of this format, which is not `none`, blended or combined as
/// `state` says; `packed`: an 8-bit target's colours lie in the block's words; state and colour mask it reads from the primitive's binding. For the instruction set in use.
///
/// choice: an 8-bit target is blended in 8-bit integers (MESA-RULES 8): colours are quantised first, products are
/// round(a * b / 255), sums saturate. 16-bit targets likewise with 65535, floating-point ones in float, clamped to [0, 1].
FragmentPass blend_pass(const RasterState& state, ColorFormat format, bool packed = false);

}  // namespace gouraud::pipeline
