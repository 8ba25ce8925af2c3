// Coverage of smooth points, lines and polygons [GL1.5 §3.11].
#pragma once

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that multiplies the alphas in a block by the shares of the pixels that a smooth primitive covers; other
/// primitives of the draw it leaves alone. For the instruction set in use.
FragmentPass coverage_pass();

}  // namespace gouraud::pipeline
