// The way back of unpack_rows.h: numbers to the rows of a ClientImage [GL1.5 §4.3.2, Table 4.6].
//
// choice: signed types hold round(c * (2^(n-1) - 1)), as Mesa's do and as later versions ask; Table 4.6's formula is at
// most 1 from it (MESA-RULES 9).
#pragma once

#include <cstdint>

#include "api/commands/unpack_rows.h"

namespace gouraud::api {

/// R, G, B, A; integers hold [0, 1], floats what is given. Luminance is R + G + B, at most 1 [GL1.5 §4.3.2].
void pack_color(const ClientImage& image, const PixelRun& run, const float* rgba);
/// The same of bytes: exactly v * 257 and v * 0x01010101 in the wider types, v * (1/255.0f) in floats.
void pack_color(const ClientImage& image, const PixelRun& run, const std::uint8_t* rgba);
/// Indices of either kind; integers keep their low bits, bits the lowest one.
void pack_indices(const ClientImage& image, const PixelRun& run, const std::uint32_t* indices);
/// choice: bytes are cut off, words are to nearest, as Mesa's. Floats are not clamped.
void pack_depth(const ClientImage& image, const PixelRun& run, const double* depths);
/// Depth as 32-bit fixed point, for unsigned_int: without a change.
void pack_fixed_depth(const ClientImage& image, const PixelRun& run, const std::uint32_t* depths);
void pack_depth_stencil(const ClientImage& image, const PixelRun& run, const double* depths, const std::uint32_t* stencils);

}  // namespace gouraud::api
