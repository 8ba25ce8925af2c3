// Clearing one tile [GL1.5 §4.2.3]. choice: clears wait in the tile bins like primitives, so that a tile's whole frame
// happens while it is in the cache; a whole tile's clear waits on, in the plane, until the tile is drawn to or read.
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Sets the chosen buffers of the tile, inside the scissor and under the masks. Colour converts as fragments do;
/// depth is round(clear_depth * (2^bits - 1)) in double. A clear that leaves a stencil value other than zero needs
/// use_stencil() of the plane that holds it before.
void clear_tile(const Framebuffer& target, std::int32_t tile_index, const ClearState& state);

}  // namespace gouraud::pipeline
