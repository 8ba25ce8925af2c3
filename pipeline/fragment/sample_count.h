// Counting the fragments that pass the depth test, for occlusion queries [GL1.5 §4.1.7].
#pragma once

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// Adds the block's fragments to the counter of the primitive's binding.
FragmentPass sample_count_pass();

}  // namespace gouraud::pipeline
