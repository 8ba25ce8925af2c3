// Small pictures made by hand, for the tests of this folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "conformance/harness/picture.h"

namespace gouraud::conformance {

using Rgba = std::array<std::uint8_t, 4>;

inline void set_color(Picture& picture, std::size_t pixel, const Rgba& color) {
  for (std::size_t channel = 0; channel < 4; ++channel) picture.rgba[4 * pixel + channel] = color[channel];
}

/// One row of pixels, 24 bits of depth. All covered, depth 1000.
inline Picture covered_row(const std::vector<Rgba>& colors) {
  Picture picture;
  picture.width_px = static_cast<int>(colors.size());
  picture.height_px = 1;
  picture.depth_bits = 24;
  picture.rgba.resize(4 * colors.size());
  picture.depth.assign(colors.size(), 1000);
  picture.covered.assign(colors.size(), 1);
  for (std::size_t i = 0; i < colors.size(); ++i) set_color(picture, i, colors[i]);
  return picture;
}

/// The oracle's row whose ideal colours are these, in 1/255, and whose depth is 1000 units.
inline Picture exact_row(const std::vector<std::array<double, 4>>& ideal_colors) {
  Picture picture = covered_row(std::vector<Rgba>(ideal_colors.size()));
  oracle::OraclePicture exact;
  exact.width_px = picture.width_px;
  exact.height_px = 1;
  exact.depth_bits = 24;
  exact.pixels.resize(ideal_colors.size());
  exact.flags.assign(ideal_colors.size(), oracle::pixel_covered);
  exact.fragments_written.assign(ideal_colors.size(), 1);
  for (std::size_t i = 0; i < ideal_colors.size(); ++i) {
    oracle::OraclePixel& pixel = exact.pixels[i];
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const double value = ideal_colors[i][channel] / 255.0;
      pixel.color[channel] = value;
      pixel.color_lowest[channel] = pixel.color_highest[channel] = static_cast<float>(value);
      pixel.color_unorm8[channel] = static_cast<std::uint8_t>(ideal_colors[i][channel] + 0.5);
    }
    pixel.depth_units = 1000.0;
    pixel.depth_stored = pixel.depth_lowest = pixel.depth_highest = 1000;
    set_color(picture, i, pixel.color_unorm8);
  }
  picture.exact = exact;
  return picture;
}

}  // namespace gouraud::conformance
