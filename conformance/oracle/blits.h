// Takes the pictures of two framebuffers, gives the second with a copy of the first's pixels: scaled, mirrored, resolved
// [ARB_framebuffer_object, "Framebuffer Blitting"].
//
// A pixel's centre has its place in the source by the rectangles' proportions, as an exact fraction. The nearest pixel
// holds that place; where it lies between two pixels either is legal. Between centres colours are interpolated, from
// none outside the source rectangle. Of several samples colours are averaged as they are stored.
// choice: depth and stencil of several samples are those of the first; pixels whose place lies outside the source stay
// as they are.
#pragma once

#include <cstdint>

#include "conformance/oracle/targets.h"

namespace gouraud::oracle {

/// `channels`: those that the destination has, bit 0 red to bit 3 alpha.
void blit_samples(const Samples& source, Samples& destination, const pipeline::Blit& blit, std::uint8_t channels);

}  // namespace gouraud::oracle
