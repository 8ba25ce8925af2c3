// Colours and varyings interpolated another way: the methods "colors=affine8", "affine16" and "barycentric". (affine is the
// geometry's: affine.h.)
#pragma once

#include "pipeline/draw/methods.h"
#include "pipeline/fragment/varyings.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The passes that stand in for color_interpolation_pass and varying_interpolation_pass: those themselves for methods that need no
/// others.
FragmentPass color_interpolation_pass(InterpolationMethod method);
FragmentPass varying_interpolation_pass(InterpolationMethod method, LanesWanted wanted);

}  // namespace gouraud::pipeline
