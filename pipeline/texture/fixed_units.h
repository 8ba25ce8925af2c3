// Textures in 16-bit fixed point [GL1.5 §3.8.8, §3.8.13]: those that most programs use, one by one, and all units of a
// block in one kernel, straight to the bytes of an 8-bit target.
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// Samples a unit; null if it needs more than this can do: two dimensions of 8-bit R, G, B, A texels in rows, without
/// border, that repeat (sizes then are powers of two) or clamp to the edge.
SampleFunction fixed_sample_function(const PreparedUnit& unit);

/// The kernel for the instruction set in use; null if one of the units needs more: such textures, and functions that replace
/// or modulate.
FixedUnitsFunction fixed_units_function(const TextureUnits& units);

}  // namespace gouraud::pipeline
