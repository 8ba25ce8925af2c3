// Copying a rectangle from one framebuffer to another: scaled, flipped, converted, resolved
// [ARB_framebuffer_object, "Framebuffer Blitting"]. All pending tiles must have been rasterized (Renderer::finish).
#pragma once

#include "pipeline/draw/draw_state.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Pixels whose place in the source lies outside the source framebuffer stay as they are. Depth formats are equal if
/// depth is copied; a plane that one of the two lacks is left out. Several samples to one: colours are averaged and
/// rounded once, depth and stencil are those of the first sample; one to several: each sample gets it.
void blit(const Framebuffer& source, const Framebuffer& destination, const Blit& blit);

}  // namespace gouraud::pipeline
