// The depth test [GL1.5 §4.1.6] and the depth write of fragments that pass it.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass for this test on a buffer of this format, for the instruction set in use. The test must be enabled, the
/// format not `none`. Whether depth is written the pass reads from the primitive's binding.
///
/// Fixed-point depth is compared as integers: round to nearest, ties to even, of z * (2^bits - 1) (MESA-RULES 4.3).
FragmentPass depth_test_pass(CompareFunc func, DepthFormat format);

/// Rejects what the depth test (FragmentPasses::inner_depth) will reject, and writes nothing: before fragments are shaded for
/// an alpha test, which comes before the depth test.
FragmentPass hidden_fragments_pass();

}  // namespace gouraud::pipeline
