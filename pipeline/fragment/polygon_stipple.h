// Polygon stipple [GL1.5 §3.5.2].
#pragma once

#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The first pass of a plan with a stipple: takes away the fragments of filled polygons that the pattern masks.
FragmentPass polygon_stipple_pass();

}  // namespace gouraud::pipeline
