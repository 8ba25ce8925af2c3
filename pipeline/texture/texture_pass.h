// The textured units of a draw as one fragment pass [GL1.5 §3.8.15].
#pragma once

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// Takes unscaled colours in the block, gives those that the binding's units make of them, times their output_scale.
FragmentPass texture_pass();

/// The same for targets of 8-bit channels: gives FragmentBlock::words.
FragmentPass texture_words_pass();

}  // namespace gouraud::pipeline
