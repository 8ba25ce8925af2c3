// Rows of a ClientImage as numbers: unpacking, conversion to floating-point, to RGB, to RGBA [GL1.5 §3.6.4]; and, with
// a Context, after pixel transfer [GL1.5 §3.6.5]. The image lies in readable memory; no row is of another kind than the
// function's.
#pragma once

#include <cstdint>
#include <optional>

#include "api/commands/client_pixels.h"
#include "pipeline/framebuffer/byte_orders.h"

namespace gouraud::api {

/// Pixels [first, first + count) of a row.
struct PixelRun {
  GLsizei y = 0, z = 0;
  GLsizei first = 0, count = 0;
};
inline PixelRun whole_row(const ClientImage& image, GLsizei y, GLsizei z = 0) { return {y, z, 0, image.size.width}; }

/// PixelKind::color as R, G, B, A: four floats a pixel, not clamped.
void unpack_color(const ClientImage& image, const PixelRun& run, float* rgba);
/// Indices of either kind, and the stencil of depth_stencil; negative ones modulo 2^32.
/// choice: a float becomes the nearest integer, one that is out of range or NaN becomes 0.
void unpack_indices(const ClientImage& image, const PixelRun& run, std::uint32_t* indices);
/// Depth, also that of depth_stencil, not clamped; doubles, so that 32 bits keep their order.
void unpack_depth(const ClientImage& image, const PixelRun& run, double* depths);

/// Colours (RGBA also of colour indices, by their maps) after pixel transfer, not clamped.
void transferred_color(const Context& context, const ClientImage& image, const PixelRun& run, float* rgba);
/// Stencil indices after pixel transfer.
void transferred_stencil(const Context& context, const ClientImage& image, const PixelRun& run, std::uint32_t* indices);
/// Depths after pixel transfer, not clamped.
void transferred_depth(const Context& context, const ClientImage& image, const PixelRun& run, double* depths);

/// The short road: how to get bytes R, G, B, A out of a pixel's bytes, if pixels are unsigned bytes (or words packed of
/// them) and no pixel transfer changes them.
std::optional<pipeline::ByteOrder> byte_order(const Context& context, const ClientImage& image);
/// Four bytes a pixel: R, G, B, A.
void unpack_bytes(const ClientImage& image, const pipeline::ByteOrder& order, const PixelRun& run, std::byte* rgba);

/// One byte a pixel, 0 or 1, of an image of bits.
void unpack_bits(const ClientImage& image, const PixelRun& run, std::uint8_t* bits);

}  // namespace gouraud::api
