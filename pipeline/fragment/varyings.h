// What is interpolated besides depth and colours: a primitive's VaryingRecord to FragmentBlock::varying [GL1.5 §3.5.1].
#pragma once

#include <cstdint>

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// Passes that look at neighbours (levels of detail) want all lanes; others leave out rows that nothing covers.
enum class LanesWanted : std::uint8_t { all, covered };

/// Fills the varyings of the binding's layout, in the lanes wanted at least.
FragmentPass varying_interpolation_pass(LanesWanted wanted = LanesWanted::all);

}  // namespace gouraud::pipeline
