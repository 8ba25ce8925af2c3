// What is interpolated besides depth and colours: a primitive's VaryingRecord to FragmentBlock::varying [GL1.5 §3.5.1].
#pragma once

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// Fills the varyings of the binding's layout, in all lanes of the block.
FragmentPass varying_interpolation_pass();

}  // namespace gouraud::pipeline
