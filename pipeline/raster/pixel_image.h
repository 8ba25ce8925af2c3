// What pixel rectangles are made of: images that wait in memory until their fragments are made, and where each of their
// pixels goes in the window [GL1.5 §3.6.4].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <glm/glm.hpp>

#include "pipeline/draw/byte_count.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/limits.h"

namespace gouraud::pipeline {

/// R, G, B, A as bytes or as floats in [0, 1] (any, for a float target); depth in [0, 1] as doubles.
enum class PixelImageFormat : std::uint8_t { rgba8, rgba32f, depth };

constexpr std::size_t bytes_per_pixel(PixelImageFormat format) {
  return format == PixelImageFormat::rgba8 ? 4 : format == PixelImageFormat::rgba32f ? 16 : 8;
}

/// From so many pixels on it pays to draw an image at once, and not to keep it until the tiles are drawn.
inline constexpr std::int64_t many_pixels = 1 << 16;

struct PixelImage {
  /// Pixels are not initialized; throws std::bad_alloc.
  PixelImage(PixelImageFormat image_format, std::int32_t width, std::int32_t height)
      : format(image_format),
        width_px(width),
        height_px(height),
        row_bytes(static_cast<std::ptrdiff_t>(width) * static_cast<std::ptrdiff_t>(bytes_per_pixel(image_format))),
        own(std::make_unique_for_overwrite<std::byte[]>(byte_count({row_bytes, height}))),
        first_row(own.get()) {}
  /// Pixels of somebody else, valid as long as the call lasts that they are given to; need not be aligned.
  PixelImage(PixelImageFormat image_format, std::int32_t width, std::int32_t height, const std::byte* pixels, std::ptrdiff_t stride)
      : format(image_format), width_px(width), height_px(height), row_bytes(stride), first_row(pixels) {}

  const std::byte* row(std::int32_t y) const { return first_row + y * row_bytes; }
  std::byte* own_row(std::int32_t y) { return own.get() + y * row_bytes; }
  bool borrowed() const { return own == nullptr; }

  PixelImageFormat format;
  std::int32_t width_px, height_px;
  std::ptrdiff_t row_bytes;  ///< from one row to the next
  std::unique_ptr<std::byte[]> own;
  const std::byte* first_row;
};

/// A part of a pixel rectangle, in window space: column n of the whole lies between x + zoom_x * n and
/// x + zoom_x * (n + 1), rows likewise. The image holds the columns and rows from the first ones on.
struct PixelRectangle {
  double x = 0, y = 0;
  double zoom_x = 1, zoom_y = 1;
  std::int32_t first_column = 0, first_row = 0;
  std::shared_ptr<const PixelImage> image;
};

/// Stencil, and depth if `depths` is not null, of a pixel rectangle, written past all tests but the scissor
/// [GL1.5 §4.3.1]. Both are row_px values a row, laid out as a PixelImage's.
struct DirectRectangle {
  PixelRectangle place;  ///< without an image
  std::int32_t width_px = 0, height_px = 0;
  PixelRect clip{};
  std::shared_ptr<const std::uint8_t[]> stencils;
  std::shared_ptr<const double[]> depths;
  std::uint8_t stencil_write_mask = 0xFF;
};

/// Bits to be drawn: pixel (x + i, y + j) gets a fragment if bit i % 8 of byte i / 8 of row j is set.
struct Bitmap {
  std::int32_t x = 0, y = 0, width_px = 0, height_px = 0;
  const std::uint8_t* rows = nullptr;
  std::int32_t row_bytes = 0;
};

/// What all fragments of a bitmap or pixel rectangle get from the current raster position [GL1.5 §2.13].
struct FragmentSource {
  float depth = 0.0f;  ///< in [0, 1]
  float fog_coordinate = 0.0f;
  glm::vec4 color{1.0f}, secondary_color{0.0f};
  std::array<glm::vec4, max_texture_units> texture_coordinates{};
  bool operator==(const FragmentSource&) const = default;
};

/// A rectangle's image as fragment passes see it, in the bins: pixel (x0 + i, y0 + j) of the window has the image's
/// pixel (column[i], row[j]), or (i, j) where there are no tables.
struct PlacedImage {
  PixelImageFormat format = PixelImageFormat::rgba8;
  const std::byte* pixels = nullptr;  ///< depth: one float a pixel, in buffer units
  std::ptrdiff_t row_bytes = 0;
  std::int32_t x0 = 0, y0 = 0;
  const std::int32_t* column = nullptr;
  const std::int32_t* row = nullptr;

  const std::byte* row_at(std::int32_t y) const {
    const std::int32_t j = y - y0;
    return pixels + (row != nullptr ? row[j] : j) * row_bytes;
  }
  std::size_t column_at(std::int32_t x) const {
    const std::int32_t i = x - x0;
    return static_cast<std::size_t>(column != nullptr ? column[i] : i);
  }
};

}  // namespace gouraud::pipeline
