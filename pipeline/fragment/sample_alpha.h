// What alpha does to the samples of a fragment [GL1.5 §4.1.3].
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that leaves the fragments whose alpha covers the tile's sample, and then makes alpha 1, each if the binding
/// asks for it. choice: sample k of n is covered from alpha = (k + 1/2) / n on: so many samples as are nearest to alpha.
FragmentPass sample_alpha_pass(ColorFormat format);

}  // namespace gouraud::pipeline
