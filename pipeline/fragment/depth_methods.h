// Depth tests of other values than the default's: the methods "depth=z16", "depth=w" and "depth=w16".
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/method_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/fragment_block.h"

namespace gouraud::pipeline {

/// The pass that stands in for depth_test_pass; the method is not `z`, painter or ray.
FragmentPass depth_method_pass(CompareFunc func, DepthFormat format);

/// How window depths of this projection and viewport tell the distance.
MethodState::Distance distance_of_depth(const TransformState& transform, const ViewportState& viewport);

}  // namespace gouraud::pipeline
