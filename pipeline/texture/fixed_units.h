// The textured units of a block in one kernel, in 16-bit fixed point, straight to the bytes of an 8-bit target
// [GL1.5 §3.8.8, §3.8.13]: for the textures and functions that most programs use.
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// The kernel for the instruction set in use; null if one of the units needs more than it can do: two dimensions of 8-bit
/// R, G, B, A texels in rows, without border, that repeat (sizes then are powers of two) or clamp to the edge; functions
/// that replace or modulate.
FixedUnitsFunction fixed_units_function(const TextureUnits& units);

}  // namespace gouraud::pipeline
