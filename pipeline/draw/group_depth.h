// The depth test of a group of triangles, all of their blocks at once.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// For this depth test on a buffer of this format, for the instruction set in use; null where there is none: floating-point
/// depths and 32 bits, and sets without vectors. The early passes of the plan must be this test, or the one that rejects
/// hidden fragments by it, and no other.
GroupDepthTest group_depth_test(CompareFunc func, DepthFormat format);

}  // namespace gouraud::pipeline
