// The stencil test and the updates of the stencil buffer [GL1.5 §4.1.5], with EXT_stencil_wrap and
// EXT_stencil_two_side.
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that runs the stencil test of the primitive's binding, then the binding's depth test (FragmentPasses::
/// inner_depth, if there is one), and updates the stencil buffer by the outcome of both. For the instruction set in
/// use. Stencil values lie in the words of a z24s8 depth buffer, else in TileTarget::stencil.
FragmentPass stencil_pass(DepthFormat format);

}  // namespace gouraud::pipeline
