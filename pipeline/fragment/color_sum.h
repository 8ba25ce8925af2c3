// The colour sum behind textures [GL1.5 §3.9]. Without textures it is made at the vertices.
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// For blocks with colours, scaled as the format's, and the varying secondary colour.
FragmentPass color_sum_pass(ColorFormat format);

}  // namespace gouraud::pipeline
