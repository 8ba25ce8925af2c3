#include "pipeline/framebuffer/tile_bands.h"

#include "pipeline/simd/dispatch.h"

#ifndef GOURAUD_PIPELINE_FRAMEBUFFER_TILE_ROWS
#define GOURAUD_PIPELINE_FRAMEBUFFER_TILE_ROWS
namespace gouraud::pipeline {
/// Rows that cross a whole tile, the first of which is at `pixels`; out of it, into it.
struct TileRows {
  void (*copy)(const std::byte* pixels, int rows, std::byte* out, std::ptrdiff_t stride);
  void (*paste)(std::byte* pixels, int rows, const std::byte* in, std::ptrdiff_t stride);
};
}  // namespace gouraud::pipeline
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/framebuffer/tile_bands.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A run of eight pixels, of a size that the compiler knows.
template <std::size_t bytes>
HWY_INLINE void copy_run(const std::byte* in, std::byte* out) {
#if HWY_TARGET == HWY_SCALAR
  std::memcpy(out, in, bytes);
#else
  const hn::CappedTag<std::uint8_t, bytes> d;
  const auto* const from = reinterpret_cast<const std::uint8_t*>(in);
  auto* const to = reinterpret_cast<std::uint8_t*>(out);
  for (std::size_t i = 0; i < bytes; i += hn::Lanes(d)) hn::StoreU(hn::LoadU(d, from + i), d, to + i);
#endif
}

template <std::size_t bytes_per_pixel, class Pixels, class Rows, class Copy>
HWY_INLINE void for_runs(Pixels* pixels, int count, Rows* rows, std::ptrdiff_t stride, const Copy& copy) {
  constexpr std::size_t run = block_size * bytes_per_pixel, block = pixels_per_block * bytes_per_pixel;
  for (int row = 0; row < count; ++row, pixels += run, rows += stride) {
    for (std::size_t i = 0; i < blocks_per_tile_row; ++i) copy(pixels + i * block, rows + i * run);
  }
}

template <std::size_t bytes_per_pixel>
void copy_rows(const std::byte* pixels, int rows, std::byte* out, std::ptrdiff_t stride) {
  for_runs<bytes_per_pixel>(pixels, rows, out, stride, copy_run<block_size * bytes_per_pixel>);
}
template <std::size_t bytes_per_pixel>
void paste_rows(std::byte* pixels, int rows, const std::byte* in, std::ptrdiff_t stride) {
  for_runs<bytes_per_pixel>(pixels, rows, in, stride,
                            [](std::byte* to, const std::byte* from) HWY_ATTR { copy_run<block_size * bytes_per_pixel>(from, to); });
}

TileRows select(int bytes_per_pixel) {
  switch (bytes_per_pixel) {
    case 1: return {copy_rows<1>, paste_rows<1>};
    case 2: return {copy_rows<2>, paste_rows<2>};
    case 4: return {copy_rows<4>, paste_rows<4>};
    case 8: return {copy_rows<8>, paste_rows<8>};
    default: return {copy_rows<16>, paste_rows<16>};
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

void copy_band(const TiledBuffer& buffer, int x, int y, int count, int rows, std::byte* out, std::ptrdiff_t stride) {
  if (buffer.empty()) return;
  const int bytes = buffer.bytes_per_pixel();
  const auto part = [=](const std::byte* pixels, std::size_t length, std::byte* to) {
    std::memcpy(to, pixels, length * static_cast<std::size_t>(bytes));
  };
  for_each_tile(buffer, x, y, count, rows, out, stride, bytes, GOURAUD_SIMD_PICK(select)(bytes).copy, part);
}

void paste_band(const TiledBuffer& buffer, int x, int y, int count, int rows, const std::byte* in, std::ptrdiff_t stride) {
  if (buffer.empty()) return;
  const int bytes = buffer.bytes_per_pixel();
  const auto part = [=](std::byte* pixels, std::size_t length, const std::byte* from) {
    std::memcpy(pixels, from, length * static_cast<std::size_t>(bytes));
  };
  for_each_tile(buffer, x, y, count, rows, in, stride, bytes, GOURAUD_SIMD_PICK(select)(bytes).paste, part);
}

}  // namespace gouraud::pipeline
#endif
