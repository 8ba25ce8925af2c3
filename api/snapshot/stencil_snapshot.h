// The part of the snapshot that is the stencil test.
#pragma once

#include <cstdint>

#include "api/state/framebuffer.h"
#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

/// Canonical (pipeline::StencilState says how), for a buffer of the values 0 to `stencil_mask` and this depth test.
pipeline::StencilState stencil_state(const StencilGroup& group, std::uint32_t stencil_mask,
                                     const pipeline::DepthState& depth, bool back_faces_drawn);

}  // namespace gouraud::api
