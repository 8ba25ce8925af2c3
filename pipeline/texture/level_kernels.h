// Reading one level of a texture: texels and weights of each lane to filtered colours [GL1.5 §3.8.8 eq 3.19 to 3.22].
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// The kernel for a unit's format, dimensions and comparison, for the instruction set in use.
LevelKernel level_kernel(const PreparedUnit& unit, TexelFilter filter);

}  // namespace gouraud::pipeline
