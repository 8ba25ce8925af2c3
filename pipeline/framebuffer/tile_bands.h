// Tiles to rows and back: a band is up to eight rows of pixels that lie in one row of blocks, so that a walk along it reads memory
// in order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::pipeline {

/// Calls visit(y, rows, out) for the bands of `rows` rows from y upwards; row i belongs at out + i * stride. Byte is
/// std::byte, or const for the way back.
template <class Byte, class Visit>
void for_each_band(int y, int rows, Byte* out, std::ptrdiff_t stride, const Visit& visit) {
  while (rows > 0) {
    const int band = std::min(rows, block_size - y % block_size);
    visit(y, band, out);
    out += band * stride;
    y += band;
    rows -= band;
  }
}

/// Pixels [x, x + count) of a band's rows, the lowest of which is y: calls whole(pixels, rows, out, stride) for rows that
/// cross a whole tile, `pixels` being the first of them, and part(pixels, count, out) for what else there is.
template <class Byte, class Whole, class Part>
void for_each_tile(const TiledBuffer& buffer, int x, int y, int count, int rows, Byte* out, std::ptrdiff_t stride, int bytes_out,
                   const Whole& whole, const Part& part) {
  for (int length; count > 0; x += length, count -= length, out += length * bytes_out) {
    std::byte* const pixels = buffer.pixel(x, y);
    length = std::min(count, tile_size - x % tile_size);
    if (length == tile_size) {
      whole(pixels, rows, out, stride);
      continue;
    }
    length = std::min(length, block_size - x % block_size);
    for (std::ptrdiff_t row = 0; row < rows; ++row) {
      part(pixels + row * block_size * buffer.bytes_per_pixel(), static_cast<std::size_t>(length), out + row * stride);
    }
  }
}

/// The same, as stored.
void copy_band(const TiledBuffer& buffer, int x, int y, int count, int rows, std::byte* out, std::ptrdiff_t stride);

/// The way back: into the buffer.
void paste_band(const TiledBuffer& buffer, int x, int y, int count, int rows, const std::byte* in, std::ptrdiff_t stride);

/// copy_band by way of memory in the first-level cache: calls convert(pixels, count, out) for pieces of rows.
template <int bytes_per_pixel, class Convert>
void convert_band(const TiledBuffer& buffer, int x, int y, int count, int rows, std::byte* out, std::ptrdiff_t stride, int bytes_out,
                  const Convert& convert) {
  constexpr int piece = 4 * tile_size;
  alignas(64) std::byte linear[block_size][piece * bytes_per_pixel];
  for (int length; count > 0; x += length, count -= length, out += length * bytes_out) {
    length = std::min(count, piece - x % tile_size);
    copy_band(buffer, x, y, length, rows, linear[0], sizeof linear[0]);
    for (int row = 0; row < rows; ++row) convert(linear[row], static_cast<std::size_t>(length), out + row * stride);
  }
}

}  // namespace gouraud::pipeline
