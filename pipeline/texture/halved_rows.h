// Two rows of 8-bit texels to one of half the width.
#pragma once

#include <cstddef>

namespace gouraud::pipeline {

/// Each texel of `out` is the mean of two neighbours of `lower` and the two above them in `upper`, rounded to nearest,
/// halves up. `channels` (1, 2 or 4) bytes a texel, `width` texels of `out`; nothing else is read or written.
void halve_rows_unorm8(const std::byte* lower, const std::byte* upper, int channels, int width, std::byte* out);

}  // namespace gouraud::pipeline
