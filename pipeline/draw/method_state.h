// What the passes of methods need of a draw beside its RasterState: interned with its binding, null for the default ones.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/methods.h"

namespace gouraud::pipeline {

struct MethodState {
  Methods methods{};

  /// depth=w: from window depth z to the distance, w = numerator / (z scale + offset), which lies in [w_near, w_far]. A
  /// numerator of 0: all distances are equal (an orthographic projection), and depth is z.
  struct Distance {
    double numerator = 0, scale = 1, offset = 0, w_near = 0, w_far = 1;
  } distance{};

  /// shading=phong: the lights, with the material of the primitive.
  LightingState lighting{};
  float color_scale = 1;
};

}  // namespace gouraud::pipeline
