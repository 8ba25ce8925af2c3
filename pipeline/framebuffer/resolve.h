// Many samples to one pixel.
#pragma once

#include <cstddef>
#include <span>

#include "pipeline/draw/limits.h"

namespace gouraud::pipeline {

/// The averages of four samples' bytes, rounded once, to nearest even: byte i of `out` is that of bytes i of the samples.
/// `out` may be one of them. `size` is a multiple of 4: pixels of four bytes.
using ByteAverager = void (*)(const std::byte* const (&samples)[max_samples], std::byte* out, std::size_t size);
/// For the instruction set in use.
ByteAverager byte_averager();

}  // namespace gouraud::pipeline
