// Sampling a unit's texture for a block of fragments: cube map faces, level of detail, filters between levels
// [GL1.5 §3.8.6, §3.8.8, §3.8.9].
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// The way of a unit through its levels, for the instruction set in use.
SampleFunction sample_function(const PreparedUnit& unit);

}  // namespace gouraud::pipeline
