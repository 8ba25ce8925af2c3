// Two rows of sRGB-encoded texels to one of half the width.
#pragma once

#include <cstddef>

namespace gouraud::pipeline {

/// As halve_rows_unorm8, but that R, G, B or L (the first of 4, 2 or 1 channels) are sRGB-encoded: their mean is that of the
/// linear values, and the byte is the nearest one in the encoding: byte i + 1 begins at the linear value of (i + 1/2) / 255.
void halve_rows_srgb8(const std::byte* lower, const std::byte* upper, int channels, int width, std::byte* out);

}  // namespace gouraud::pipeline
