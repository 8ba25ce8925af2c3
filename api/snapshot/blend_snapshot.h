// The part of the snapshot that decides how colours meet those of the target: alpha test, blending, logical operation.
#pragma once

#include "api/state/framebuffer.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::api {

/// Canonical: absent if it always passes.
pipeline::AlphaTestState alpha_test_state(const ColorBufferGroup& group);

/// Canonical blending of the channels in `color_write_mask`: absent if none of them would be blended, or if a logical
/// operation takes its place [GL1.5 §4.1.8, §4.1.10].
pipeline::BlendState blend_state(const ColorBufferGroup& group, std::uint8_t color_write_mask);

/// `copy` unless it is enabled and has an effect on this target. deviation: none on floating-point targets, which GL 1.5
/// does not know.
pipeline::LogicOp logic_op_state(const ColorBufferGroup& group, std::uint8_t color_write_mask, pipeline::ColorFormat format);

}  // namespace gouraud::api
