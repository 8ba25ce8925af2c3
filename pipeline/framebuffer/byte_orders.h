// Pixels of bytes from one channel order into another: what uploads, DrawPixels, ReadPixels and the copy-out have in
// common.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gouraud::pipeline {

/// A pixel's bytes, of which there are up to four: each comes from this byte of the other pixel, or is constant.
struct ByteOrder {
  static constexpr std::int8_t zero = -1, full = -2;
  std::array<std::int8_t, 4> source{zero, zero, zero, zero};
  bool operator==(const ByteOrder&) const = default;
};
inline constexpr ByteOrder same_order{{0, 1, 2, 3}};
inline constexpr ByteOrder red_and_blue_swapped{{2, 1, 0, 3}};

/// How four pixels of `bytes_in` bytes become four of `bytes_out` (1 to 4 each), of which the order names the first ones.
struct ByteArrangement {
  ByteOrder order;
  int bytes_in, bytes_out;
  std::array<std::uint8_t, 16> place{}, bits{};  ///< of each byte: where it comes from (0x80: nowhere), and what is or-ed
  ByteArrangement(const ByteOrder& byte_order, int in, int out);
};

/// Nothing needs to be aligned; the two may not overlap.
void arrange_bytes(const ByteArrangement& arrangement, const std::byte* in, std::size_t pixels, std::byte* out);

/// Rows that cross a whole tile of four-byte pixels; `pixels` is the first of them. As copy_tile_rows (tile_bands.h).
void arrange_tile_rows(const ByteArrangement& arrangement, const std::byte* pixels, int rows, std::byte* out, std::ptrdiff_t stride);

}  // namespace gouraud::pipeline
