#include "conformance/oracle/pixel_rectangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gouraud::oracle {
namespace {

using pipeline::PixelImage;
using pipeline::PixelImageFormat;

/// The image's column (or row) of each pixel of an axis; -1: none. Column n lies between origin + zoom * (first + n) and
/// origin + zoom * (first + n + 1).
std::vector<int> sources(double origin, double zoom, int first, int count, int pixels) {
  std::vector<int> result(static_cast<std::size_t>(pixels), -1);
  for (int n = 0; n < count; ++n) {
    const double a = origin + zoom * (first + n), b = origin + zoom * (first + n + 1);
    for (int pixel = 0; pixel < pixels; ++pixel) {
      const double center = pixel + 0.5;
      if (std::min(a, b) <= center && center < std::max(a, b)) result[static_cast<std::size_t>(pixel)] = n;
    }
  }
  return result;
}

Fragment fragment_of(const pipeline::FragmentSource& source, int x, int y) {
  Fragment fragment;
  fragment.x = x;
  fragment.y = y;
  for (int c = 0; c < 4; ++c) fragment.color[static_cast<std::size_t>(c)] = static_cast<double>(source.color[c]);
  fragment.depth = static_cast<double>(source.depth);
  return fragment;
}

void take_pixel(const PixelImage& image, int column, int row, Fragment& fragment) {
  const auto at = static_cast<std::size_t>(column);
  switch (image.format) {
    case PixelImageFormat::rgba8:
      for (std::size_t c = 0; c < 4; ++c) fragment.color[c] = std::to_integer<int>(image.row(row)[at * 4 + c]) / 255.0;
      break;
    case PixelImageFormat::rgba32f:
      for (std::size_t c = 0; c < 4; ++c) {
        fragment.color[c] = static_cast<double>(reinterpret_cast<const float*>(image.row(row))[at * 4 + c]);
      }
      break;
    case PixelImageFormat::depth:
      fragment.depth = std::clamp(reinterpret_cast<const double*>(image.row(row))[at], 0.0, 1.0);
      break;
  }
}

/// All samples get the pixel's fragment.
void write(Samples& samples, const pipeline::DrawState& state, Fragment fragment) {
  fragment.color_lowest = fragment.color_highest = fragment.color;
  fragment.depth_lowest = fragment.depth_highest = fragment.depth;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if ((state.multisample.sample_mask >> k & 1) != 0) write_fragment(samples[k], state.raster, fragment, k);
  }
}

}  // namespace

void draw_rectangle(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                    const pipeline::PixelRectangle& rectangle) {
  const PixelImage& image = *rectangle.image;
  const OraclePicture& picture = samples.front();
  const auto columns = sources(rectangle.x, rectangle.zoom_x, rectangle.first_column, image.width_px, picture.width_px);
  const auto rows = sources(rectangle.y, rectangle.zoom_y, rectangle.first_row, image.height_px, picture.height_px);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) {
      const int column = columns[static_cast<std::size_t>(x)], row = rows[static_cast<std::size_t>(y)];
      if (column < 0 || row < 0) continue;
      Fragment fragment = fragment_of(source, x, y);
      take_pixel(image, column, row, fragment);
      write(samples, state, fragment);
    }
  }
}

void draw_bitmap(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                 const pipeline::Bitmap& bitmap) {
  for (int j = 0; j < bitmap.height_px; ++j) {
    for (int i = 0; i < bitmap.width_px; ++i) {
      if ((bitmap.rows[j * bitmap.row_bytes + i / 8] >> i % 8 & 1) == 0) continue;
      write(samples, state, fragment_of(source, bitmap.x + i, bitmap.y + j));
    }
  }
}

}  // namespace gouraud::oracle
