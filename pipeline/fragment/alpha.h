// The alpha test [GL1.5 §4.1.4].
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that compares the colours in the block with the reference of the primitive's binding, for the instruction
/// set in use. choice: on 8-bit targets both are first rounded to 8 bits (MESA-RULES 8); elsewhere they are compared
/// as floats.
FragmentPass alpha_test_pass(ColorFormat format);

}  // namespace gouraud::pipeline
