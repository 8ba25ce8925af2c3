// The accumulation buffer, one tile at a time [GL1.5 §4.2.4].
//
// choice: four 32-bit floats a pixel, and every result clamped to [-1, 1], where the specification leaves results outside
// undefined. deviation: Mesa's 16-bit integers wrap there (MESA-RULES 14).
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Carries out the operation on the tile's pixels inside the scissor; the target has colour and accumulation buffers, of
/// one size. Colour converts back as fragments' does: clamped, to the nearest stored value.
void accumulate_tile(const Framebuffer& target, std::int32_t tile_index, const AccumState& state);

}  // namespace gouraud::pipeline
