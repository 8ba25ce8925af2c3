#include "conformance/probes/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "api/gouraud.h"
#include "conformance/harness/compare.h"
#include "conformance/harness/linked_osmesa.h"
#include "conformance/harness/offscreen.h"

namespace gouraud::probes {
namespace {

using conformance::OffscreenContext;
using conformance::linked_osmesa;
using conformance::Picture;
using conformance::RgbImage;
using oracle::OraclePicture;

constexpr double rounding = 0.5;
constexpr std::array luma_of_rgb{0.2126, 0.7152, 0.0722};  // ITU-R BT.709

OraclePicture watch(const Probe& probe, double knob, oracle::PositionModel positions) {
  OffscreenContext context(linked_osmesa, probe.width_px, probe.height_px, probe.depth_bits);
  oracle::Oracle oracle({.positions = positions});
  if (!set_draw_observer(&oracle)) throw std::runtime_error("set_draw_observer found no context");
  probe.setup(context.gl(), knob).frame(context.gl());
  context.gl().Finish();
  set_draw_observer(nullptr);
  return oracle.picture();
}

Reference empty_reference(const Probe& probe) {
  return {probe.width_px, probe.height_px,
          std::vector<double>(static_cast<std::size_t>(probe.width_px) * static_cast<std::size_t>(probe.height_px) * 4), {}};
}

void add_colors(Reference& reference, const OraclePicture& picture, double weight) {
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    for (std::size_t channel = 0; channel < 4; ++channel) {
      reference.color[4 * i + channel] += weight * picture.pixels[i].color[channel];
    }
  }
}

/// Of one pixel: the mean of R, G and B, and the worst channel.
struct ColorError {
  double mean = 0, worst = 0;
};

ColorError color_error(const Picture& picture, const Reference& reference, std::size_t pixel) {
  ColorError error;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double distance = std::abs(picture.rgba[4 * pixel + channel] - 255 * reference.color[4 * pixel + channel]);
    error.mean += distance / 3;
    error.worst = std::max(error.worst, distance);
  }
  // Where several outcomes or a range of values are legal, the nearest counts.
  if (reference.exact && (reference.exact->flags[pixel] & ~oracle::pixel_covered) != 0) {
    error.worst = std::min(error.worst, conformance::measure_pixel(picture, *reference.exact, pixel).color);
    error.mean = std::min(error.mean, error.worst);
  }
  return error;
}

bool is_drawn(const Picture& picture, const Reference& reference, std::size_t pixel) {
  if (!picture.covered.empty() && picture.covered[pixel] != 0) return true;
  return reference.exact && reference.exact->fragments_written[pixel] > 0;
}

std::vector<double> luma_of(const std::vector<double>& rgba) {
  std::vector<double> luma;
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    luma.push_back(luma_of_rgb[0] * rgba[i] + luma_of_rgb[1] * rgba[i + 1] + luma_of_rgb[2] * rgba[i + 2]);
  }
  return luma;
}

double dissimilarity(const Picture& picture, const Reference& reference) {
  std::vector<double> ideal(reference.color.size());
  std::ranges::transform(reference.color, ideal.begin(), [](double value) { return 255 * value; });
  const std::vector<double> given(picture.rgba.begin(), picture.rgba.end());
  return 1 - structural_similarity(luma_of(given), luma_of(ideal), picture.width_px, picture.height_px);
}

void measure_depth(PictureError& error, const Picture& picture, const OraclePicture& exact) {
  std::size_t count = 0;
  const std::uint32_t farthest = exact.depth_bits > 0 ? static_cast<std::uint32_t>((std::uint64_t{1} << exact.depth_bits) - 1) : 0;
  for (std::size_t i = 0; i < picture.depth.size(); ++i) {
    error.has_depth = error.has_depth || exact.pixels[i].depth_stored != farthest;
    if (picture.covered[i] == 0 || exact.fragments_written[i] == 0) continue;
    const double depth = conformance::measure_pixel(picture, exact, i).depth;
    error.depth_mean += depth;
    error.depth_max = std::max(error.depth_max, depth);
    error.depth_beyond_rounding += std::max(depth - rounding, 0.0);
    ++count;
  }
  if (count == 0) return;
  error.depth_mean /= static_cast<double>(count);
  error.depth_beyond_rounding /= static_cast<double>(count);
}

struct WindowSums {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

double similarity(const WindowSums& sums, double count) {
  constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);
  const double mean_a = sums.a / count, mean_b = sums.b / count;
  // Unbiased, as the paper's eq 15 and 16.
  const double variance_a = (sums.aa - count * mean_a * mean_a) / (count - 1);
  const double variance_b = (sums.bb - count * mean_b * mean_b) / (count - 1);
  const double covariance = (sums.ab - count * mean_a * mean_b) / (count - 1);
  return (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
         ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
}

}  // namespace

Reference exact_reference(const Probe& probe, double knob, oracle::PositionModel positions) {
  Reference reference = empty_reference(probe);
  reference.exact = watch(probe, knob, positions);
  add_colors(reference, *reference.exact, 1);
  return reference;
}

Reference area_reference(const Probe& probe, double knob, int grid) {
  Reference reference = empty_reference(probe);
  for (int y = 0; y < grid; ++y) {
    for (int x = 0; x < grid; ++x) {
      shift_pixels((x + 0.5) / grid - 0.5, (y + 0.5) / grid - 0.5);
      add_colors(reference, watch(probe, knob, oracle::PositionModel::exact), 1.0 / (grid * grid));
    }
  }
  shift_pixels(0, 0);
  return reference;
}

PictureError measure(const Picture& picture, const Reference& reference) {
  PictureError error;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    if (reference.exact && !is_drawn(picture, reference, i)) continue;
    const ColorError color = color_error(picture, reference, i);
    error.color_mean += color.mean;
    error.color_max = std::max(error.color_max, color.worst);
    error.color_beyond_rounding += std::max(color.worst - rounding, 0.0);
    ++drawn;
  }
  if (drawn > 0) {
    error.color_mean /= static_cast<double>(drawn);
    error.color_beyond_rounding /= static_cast<double>(drawn);
  }
  if (reference.exact) {
    const auto coverage = conformance::compare_coverage(picture, *reference.exact);
    error.has_coverage = true;
    if (coverage.drawn > 0) {
      error.coverage_percent = 100.0 * static_cast<double>(coverage.total()) / static_cast<double>(coverage.drawn);
    }
    measure_depth(error, picture, *reference.exact);
  }
  error.dssim = std::max(dissimilarity(picture, reference), 0.0);
  return error;
}

double structural_similarity(const std::vector<double>& a, const std::vector<double>& b, int width_px, int height_px) {
  constexpr int window = 8, step = 4;
  const int window_x = std::min(window, width_px), window_y = std::min(window, height_px);
  double sum = 0;
  int windows = 0;
  for (int top = 0; top + window_y <= height_px; top += step) {
    for (int left = 0; left + window_x <= width_px; left += step, ++windows) {
      WindowSums sums;
      for (int y = top; y < top + window_y; ++y) {
        for (int x = left; x < left + window_x; ++x) {
          const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) + static_cast<std::size_t>(x);
          sums.a += a[i];
          sums.b += b[i];
          sums.aa += a[i] * a[i];
          sums.bb += b[i] * b[i];
          sums.ab += a[i] * b[i];
        }
      }
      sum += similarity(sums, window_x * window_y);
    }
  }
  return sum / windows;
}

RgbImage error_map(const Picture& picture, const Reference& reference) {
  constexpr double shade_a_decade = 85;  // 1/255 beyond rounding: dark grey; 100/255: white
  RgbImage image{picture.width_px, picture.height_px, std::vector<std::uint8_t>(picture.pixel_count() * 3)};
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    std::uint8_t* const out = &image.rgb[3 * i];
    const bool drawn = !picture.covered.empty() && picture.covered[i] != 0;
    if (reference.exact && drawn != (reference.exact->fragments_written[i] > 0) &&
        !reference.exact->alternatives.contains(i)) {
      out[0] = drawn ? 255 : 0;
      out[1] = drawn ? 0 : 255;
      out[2] = 255;
      continue;
    }
    const double beyond = color_error(picture, reference, i).worst - rounding;
    const double shade = beyond <= 0.02 ? 0 : 85 + shade_a_decade * std::log10(beyond);
    std::fill(out, out + 3, static_cast<std::uint8_t>(std::clamp(shade, beyond <= 0.02 ? 0.0 : 24.0, 255.0)));
  }
  return image;
}

RgbImage image_of(const Picture& picture) {
  RgbImage image{picture.width_px, picture.height_px, {}};
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    if (i % 4 != 3) image.rgb.push_back(picture.rgba[i]);
  }
  return image;
}

RgbImage image_of(const Reference& reference) {
  RgbImage image{reference.width_px, reference.height_px, {}};
  for (std::size_t i = 0; i < reference.color.size(); ++i) {
    if (i % 4 != 3) image.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(reference.color[i], 0.0, 1.0))));
  }
  return image;
}

}  // namespace gouraud::probes
