// Stored depths as floats in [0, 1]: value / (2^bits - 1), to nearest. Nothing needs to be aligned.
#pragma once

#include <cstddef>

namespace gouraud::pipeline {

/// Of 16-bit words.
void depths_of_z16(const std::byte* in, std::size_t count, std::byte* out);
/// Of the low 24 bits of 32-bit words.
void depths_of_z24s8(const std::byte* in, std::size_t count, std::byte* out);
/// Of 32-bit words.
void depths_of_z32(const std::byte* in, std::size_t count, std::byte* out);

}  // namespace gouraud::pipeline
