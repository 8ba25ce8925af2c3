#include "pipeline/framebuffer/write.h"

#include <cmath>
#include <cstring>

#include "pipeline/framebuffer/tile_bands.h"

namespace gouraud::pipeline {
namespace {

template <class Word>
Word load(const std::byte* at) {
  Word word;
  std::memcpy(&word, at, sizeof word);
  return word;
}
template <class Word>
void store(std::byte* at, Word word) {
  std::memcpy(at, &word, sizeof word);
}

}  // namespace

float depth_in_units(double depth, DepthFormat format) {
  const double clamped = depth > 0 ? (depth < 1 ? depth : 1.0) : 0.0;  // NaN gives 0
  switch (format) {
    case DepthFormat::none: return 0.0f;
    case DepthFormat::z16: return static_cast<float>(std::nearbyint(clamped * 65535.0));
    case DepthFormat::z24s8: return static_cast<float>(std::nearbyint(clamped * 16777215.0));
    case DepthFormat::z32:
    case DepthFormat::z32f: return static_cast<float>(clamped);
  }
  return 0.0f;
}

void write_color_rows(const Framebuffer& target, int x, int y, int count, int rows, const std::byte* in, std::ptrdiff_t row_stride_bytes) {
  for_each_band(y, rows, in, row_stride_bytes, [&](int band_y, int band_rows, const std::byte* band) {
    paste_band(target.color, x, band_y, count, band_rows, band, row_stride_bytes);
  });
}

void write_stencil_row(const Framebuffer& target, int x, int y, int count, const std::uint8_t* values, std::uint8_t mask) {
  if (target.stencil_bits == 0) return;
  const bool in_depth = target.depth_format == DepthFormat::z24s8;
  if (in_depth) target.depth.use_stencil();
  for (int i = 0; i < count; ++i) {
    if (in_depth) {
      std::byte* const at = target.depth.pixel(x + i, y);
      const auto word = load<std::uint32_t>(at), bits = std::uint32_t{mask} << 24;
      store(at, (word & ~bits) | (std::uint32_t{values[i]} << 24 & bits));
    } else {
      std::byte* const at = target.stencil.pixel(x + i, y);
      store(at, static_cast<std::uint8_t>((load<std::uint8_t>(at) & ~mask) | (values[i] & mask)));
    }
  }
}

void write_depth_row(const Framebuffer& target, int x, int y, int count, const double* depths) {
  for (int i = 0; i < count; ++i) {
    const float units = depth_in_units(depths[i], target.depth_format);
    switch (target.depth_format) {
      case DepthFormat::none: return;
      case DepthFormat::z16: store(target.depth.pixel(x + i, y), static_cast<std::uint16_t>(units)); break;
      case DepthFormat::z24s8: {
        std::byte* const at = target.depth.pixel(x + i, y);
        store(at, (load<std::uint32_t>(at) & 0xFF000000u) | static_cast<std::uint32_t>(units));
        break;
      }
      case DepthFormat::z32:
        store(target.depth.pixel(x + i, y), static_cast<std::uint32_t>(std::nearbyint(static_cast<double>(units) * 0xFFFFFFFF)));
        break;
      case DepthFormat::z32f: store(target.depth.pixel(x + i, y), units); break;
    }
  }
}

}  // namespace gouraud::pipeline
