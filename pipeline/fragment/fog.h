// Fog [GL1.5 §3.10]: colours of a block are blended with the fog's colour.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// For blocks with colours, scaled as the format's, and the varying fog coordinate. The mode is not `none`.
FragmentPass fog_pass(FogMode mode, ColorFormat format);

}  // namespace gouraud::pipeline
