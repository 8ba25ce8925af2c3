#include "conformance/oracle/pixel_rectangles.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "conformance/oracle/shading.h"

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

/// Textures and the colour sum, with the coordinates and the secondary colour of the raster position.
void shade_fragment(const pipeline::DrawState& state, const pipeline::FragmentSource& source, Fragment& fragment) {
  VertexColors vertex;
  for (std::size_t c = 0; c < 3; ++c) vertex.secondary[front][c] = static_cast<double>(source.secondary_color[static_cast<int>(c)]);
  for (std::size_t i = 0; i < state.texturing.count; ++i) {
    Vector4& coordinate = vertex.texture_coordinates.emplace_back();
    const glm::vec4& given = source.texture_coordinates[state.texturing.unit[i].unit];
    for (std::size_t c = 0; c < 4; ++c) coordinate[c] = static_cast<double>(given[static_cast<int>(c)]);
  }
  FragmentSink sink;
  sink.texturing = state.texturing;
  sink.has_secondary = state.color_sum;
  if (sink.texturing.count > 0) {
    const std::array<VertexShare, 1> shares{VertexShare{&vertex, 1, 0, 0}};
    return set_color(shade(sink, fragment.color, shares), fragment);
  }
  for (std::size_t c = 0; c < 3 && sink.has_secondary; ++c) fragment.color[c] += vertex.secondary[front][c];
  fragment.color_lowest = fragment.color_highest = fragment.color;
}

/// All samples get the pixel's fragment.
void write(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source, Fragment fragment) {
  shade_fragment(state, source, fragment);
  fragment.fog_coordinate = static_cast<double>(source.fog_coordinate);
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
      write(samples, state, source, fragment);
    }
  }
}

void write_directly(Samples& samples, const pipeline::DirectRectangle& rectangle) {
  const pipeline::PixelRectangle& place = rectangle.place;
  const OraclePicture& size = samples.front();
  const auto columns = sources(place.x, place.zoom_x, place.first_column, rectangle.width_px, size.width_px);
  const auto rows = sources(place.y, place.zoom_y, place.first_row, rectangle.height_px, size.height_px);
  const pipeline::PixelRect& clip = rectangle.clip;
  for (int y = std::max(clip.y0, 0); y < std::min(clip.y1, size.height_px); ++y) {
    for (int x = std::max(clip.x0, 0); x < std::min(clip.x1, size.width_px); ++x) {
      const int column = columns[static_cast<std::size_t>(x)], row = rows[static_cast<std::size_t>(y)];
      if (column < 0 || row < 0) continue;
      const auto from = static_cast<std::size_t>(row) * static_cast<std::size_t>(rectangle.width_px) + static_cast<std::size_t>(column);
      const int mask = rectangle.stencil_write_mask;
      const auto write = [&](OraclePixel& pixel, double depth_units) {
        pixel.stencil = static_cast<std::uint8_t>((rectangle.stencils[from] & mask) | (pixel.stencil & ~mask));
        if (rectangle.depths == nullptr) return;
        pixel.depth_units = depth_units;
        pixel.depth_stored = pixel.depth_lowest = pixel.depth_highest = static_cast<std::uint32_t>(std::nearbyint(depth_units));
      };
      for (OraclePicture& picture : samples) {
        const double depth = rectangle.depths == nullptr ? 0 : std::clamp(rectangle.depths[from], 0.0, 1.0) * depth_units_of(picture.depth_bits);
        change_pixels(picture, {x, y, x + 1, y + 1}, [&](OraclePixel& pixel) { write(pixel, depth); });
      }
    }
  }
}

void draw_bitmap(Samples& samples, const pipeline::DrawState& state, const pipeline::FragmentSource& source,
                 const pipeline::Bitmap& bitmap) {
  for (int j = 0; j < bitmap.height_px; ++j) {
    for (int i = 0; i < bitmap.width_px; ++i) {
      if ((bitmap.rows[j * bitmap.row_bytes + i / 8] >> i % 8 & 1) == 0) continue;
      write(samples, state, source, fragment_of(source, bitmap.x + i, bitmap.y + j));
    }
  }
}

}  // namespace gouraud::oracle
