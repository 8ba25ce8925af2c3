// Blending and logical operation on targets of 16-bit integers and of floats: pixel by pixel, they are rare.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// As blend_pass, for rgba16 and rgba32f. It uses no instruction set in particular.
FragmentPass wide_blend_pass(const RasterState& state, ColorFormat format);

}  // namespace gouraud::pipeline
