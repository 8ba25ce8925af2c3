// Pictures as PNG files in memory, for the report.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gouraud::conformance {

/// Bytes R G B, rows bottom-up as GL's; the report shows colours as they are, without alpha.
struct RgbImage {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;
};

/// The bytes of a PNG file; throws std::runtime_error if libpng fails.
std::vector<std::uint8_t> encode_png(const RgbImage& image);

std::string base64(const std::vector<std::uint8_t>& bytes);

}  // namespace gouraud::conformance
