#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "conformance/harness/compare.h"
#include "conformance/harness/report.h"

namespace gouraud::conformance {
namespace {

constexpr int amplification = 64;
constexpr double rounding = 0.5, grey_of_one = 128.0;

/// Calls shade(pixel, out) where both or neither picture is covered, and marks the other pixels.
template <class Shade>
RgbImage map_pixels(const Picture& ours, const Picture& other, Shade shade) {
  RgbImage image{ours.width_px, ours.height_px, std::vector<std::uint8_t>(ours.pixel_count() * 3)};
  for (std::size_t i = 0; i < ours.pixel_count(); ++i) {
    std::uint8_t* const out = &image.rgb[3 * i];
    if (ours.covered[i] == other.covered[i]) {
      shade(i, out);
    } else {
      out[0] = ours.covered[i] != 0 ? 255 : 0;
      out[1] = ours.covered[i] != 0 ? 0 : 255;
      out[2] = 255;
    }
  }
  return image;
}

}  // namespace

RgbImage difference_map(const Picture& ours, const Picture& other) {
  return map_pixels(ours, other, [&](std::size_t pixel, std::uint8_t* out) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int difference = std::abs(ours.rgba[4 * pixel + channel] - other.rgba[4 * pixel + channel]);
      out[channel] = static_cast<std::uint8_t>(std::min(difference * amplification, 255));
    }
  });
}

RgbImage error_map(const Picture& picture, const Picture& oracle) {
  return map_pixels(picture, oracle, [&](std::size_t pixel, std::uint8_t* out) {
    const double error = measure_pixel(picture, *oracle.exact, pixel).color;
    const double beyond_rounding = std::max(error - rounding, 0.0) / (1.0 - rounding);
    const auto grey = static_cast<std::uint8_t>(std::min(beyond_rounding * grey_of_one, 255.0));
    std::fill(out, out + 3, grey);
  });
}

}  // namespace gouraud::conformance
