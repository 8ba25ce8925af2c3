// What is interpolated besides depth and colours: a primitive's VaryingRecord to FragmentBlock::varying [GL1.5 §3.5.1].
#pragma once

#include <cstdint>

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// Passes that light all lanes want all; others leave out pairs of rows that nothing covers. (Levels of detail come from planes,
/// not from neighbours.)
enum class LanesWanted : std::uint8_t { all, covered };

/// Fills the varyings of the binding's layout, in the lanes wanted at least.
FragmentPass varying_interpolation_pass(LanesWanted wanted = LanesWanted::all);

}  // namespace gouraud::pipeline
