// Depth and stencil of the target as numbers, and which of them it has: for ReadPixels, CopyPixels and DrawPixels.
#pragma once

#include <cstdint>

#include "api/commands/pixel_layout.h"
#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::api {

/// What the target lacks for pixels of this kind, null if nothing. Color indices are colors, once they are drawn.
const char* missing_buffer(const pipeline::Framebuffer& target, PixelKind kind);

/// In [0, 1], exactly what is stored divided by the largest value.
void read_depths(const pipeline::Framebuffer& target, int x, int y, int count, double* depths);

void read_stencils(const pipeline::Framebuffer& target, int x, int y, int count, std::uint32_t* stencils);

}  // namespace gouraud::api
