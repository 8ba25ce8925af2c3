// A pixel rectangle's colours for a block, for kernels: included inside a kernel file, once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_IMAGE_COLORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_IMAGE_COLORS_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_IMAGE_COLORS_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_IMAGE_COLORS_INL_H_
#endif

#include <cstring>

#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/pixel_image.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls visit(lane, the image's pixel) for every covered lane.
template <class Visit>
HWY_INLINE void for_image_pixels(const PlacedImage& image, const FragmentBlock& block, const Visit& visit) {
  const std::size_t bytes = image.format == PixelImageFormat::depth ? sizeof(float) : bytes_per_pixel(image.format);
  for (std::int32_t row = 0; row < 8; ++row) {
    const std::uint64_t covered = block.coverage >> (8 * row) & 0xFFu;
    if (covered == 0) continue;
    const std::byte* const pixels = image.row_at(block.y + row);
    for (std::int32_t column = 0; column < 8; ++column) {
      if ((covered >> column & 1u) == 0) continue;
      visit(row * 8 + column, pixels + image.column_at(block.x + column) * bytes);
    }
  }
}

/// Whether eight pixels of the image, side by side, are those of a row of the block.
HWY_INLINE bool has_whole_rows(const PlacedImage& image, const FragmentBlock& block) {
  return block.coverage == ~std::uint64_t{0} && image.column == nullptr;
}

/// The 64 pixels of a block with whole rows, four bytes each.
HWY_INLINE void copy_image_rows(const PlacedImage& image, const FragmentBlock& block, std::int32_t* out) {
  for (std::int32_t row = 0; row < 8; ++row, out += 8) {
    const std::byte* const from = image.row_at(block.y + row) + image.column_at(block.x) * 4;
#if HWY_TARGET == HWY_SCALAR
    std::memcpy(out, from, 32);
#else
    const hn::CappedTag<std::uint8_t, 32> d;
    auto* const to = reinterpret_cast<std::uint8_t*>(out);
    for (std::size_t i = 0; i < 32; i += hn::Lanes(d)) hn::Store(hn::LoadU(d, reinterpret_cast<const std::uint8_t*>(from) + i), d, to + i);
#endif
  }
}

/// Pixels of bytes, R in the low ones; lanes that are not covered hold anything.
HWY_INLINE void load_image_words(const PlacedImage& image, const FragmentBlock& block, std::int32_t (&word)[64]) {
  if (!has_whole_rows(image, block)) {
    for_image_pixels(image, block, [&](std::int32_t lane, const std::byte* pixel) { std::memcpy(word + lane, pixel, 4); });
    return;
  }
  copy_image_rows(image, block, word);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
