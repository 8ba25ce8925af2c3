// The road of small triangles: coverage and depth test of a whole group at once.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// For this depth test on a buffer of this format, for the instruction set in use; null where the road is closed: floating-
/// point depths, and sets without vectors. The early passes of the plan must be this test, or the one that rejects hidden
/// fragments by it, and no other, and no polygon offset may apply.
SmallTriangleTests small_triangle_tests(CompareFunc func, DepthFormat format);

}  // namespace gouraud::pipeline
