#include "conformance/harness/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace gouraud::conformance {
namespace {

constexpr double whole_number_slack = 1e-4;  // colours come in as floats: 255 * 0.2f is not quite 51

bool same_color(const Picture& first, const Picture& second, std::size_t index) {
  return std::memcmp(&first.rgba[4 * index], &second.rgba[4 * index], 4) == 0;
}

void count_coverage(CoverageDifference& difference, bool first, bool second) {
  difference.drawn += first || second ? 1 : 0;
  difference.only_first += first && !second ? 1 : 0;
  difference.only_second += second && !first ? 1 : 0;
}

/// True if the pixel has exactly one legal colour.
bool has_one_color(const oracle::OraclePicture& exact, std::size_t index) {
  constexpr int several = oracle::pixel_depth_ambiguous | oracle::pixel_extrapolated | oracle::pixel_alternatives_lost;
  return (exact.flags[index] & several) == 0;
}

struct RoundingSums {
  double distance = 0.0, best_distance = 0.0;
  std::size_t values = 0;

  void add(double ideal, std::uint8_t byte) {
    const double best = std::abs(std::nearbyint(ideal) - ideal);
    const double given = std::abs(byte - ideal);
    if (best < whole_number_slack && given < 0.5) return;
    distance += given;
    best_distance += best;
    ++values;
  }
};

}  // namespace

CoverageDifference compare_coverage(const Picture& first, const Picture& second) {
  CoverageDifference difference;
  for (std::size_t i = 0; i < first.covered.size(); ++i) {
    count_coverage(difference, first.covered[i] != 0, second.covered[i] != 0);
  }
  return difference;
}

CoverageDifference compare_coverage(const Picture& picture, const oracle::OraclePicture& exact) {
  CoverageDifference difference;
  for (std::size_t i = 0; i < picture.covered.size(); ++i) {
    const bool covered = picture.covered[i] != 0;
    count_coverage(difference, covered, exact.alternatives.contains(i) ? covered : exact.fragments_written[i] > 0);
  }
  return difference;
}

double ColorDifference::different_percent() const {
  return pixels == 0 ? 0.0 : 100.0 * static_cast<double>(pixels - identical) / static_cast<double>(pixels);
}

ColorDifference compare_color(const Picture& first, const Picture& second) {
  ColorDifference difference;
  std::size_t sum = 0;
  for (std::size_t i = 0; i < first.covered.size(); ++i) {
    if (first.covered[i] == 0 || second.covered[i] == 0) continue;
    ++difference.pixels;
    int largest = 0;
    for (std::size_t channel = 4 * i; channel < 4 * i + 4; ++channel) {
      const int distance = std::abs(first.rgba[channel] - second.rgba[channel]);
      largest = std::max(largest, distance);
      sum += static_cast<std::size_t>(distance);
    }
    difference.identical += largest == 0 ? 1 : 0;
    difference.beyond_one += largest > 1 ? 1 : 0;
    difference.max = std::max(difference.max, largest);
  }
  if (difference.pixels > 0) difference.mean = static_cast<double>(sum) / static_cast<double>(4 * difference.pixels);
  return difference;
}

std::size_t compare_background(const Picture& first, const Picture& second) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < first.covered.size(); ++i) {
    if (first.covered[i] != 0 || second.covered[i] != 0) continue;
    const bool same_depth = first.depth.empty() || second.depth.empty() || first.depth[i] == second.depth[i];
    differing += same_depth && same_color(first, second, i) ? 0 : 1;
  }
  return differing;
}

oracle::PixelError measure_pixel(const Picture& picture, const oracle::OraclePicture& exact, std::size_t index) {
  const int x = static_cast<int>(index % static_cast<std::size_t>(exact.width_px));
  const int y = static_cast<int>(index / static_cast<std::size_t>(exact.width_px));
  const std::uint8_t* const rgba = &picture.rgba[4 * index];
  const bool has_depth = !picture.depth.empty();
  return oracle::measure(exact, x, y, {rgba[0], rgba[1], rgba[2], rgba[3]}, has_depth ? picture.depth[index] : 0,
                         has_depth);
}

ExactError compare_exact(const Picture& picture, const oracle::OraclePicture& exact) {
  ExactError error;
  RoundingSums sums;
  for (std::size_t i = 0; i < picture.covered.size(); ++i) {
    const bool both = picture.covered[i] != 0 && exact.fragments_written[i] > 0;
    if (!both && !exact.alternatives.contains(i)) continue;
    ++error.pixels;
    const oracle::PixelError pixel = measure_pixel(picture, exact, i);
    error.color_max = std::max(error.color_max, pixel.color);
    error.depth_max = std::max(error.depth_max, pixel.depth);
    error.depth_mean += pixel.depth;
    if (!has_one_color(exact, i)) continue;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      sums.add(255.0 * exact.pixels[i].color[channel], picture.rgba[4 * i + channel]);
    }
  }
  if (error.pixels > 0) error.depth_mean /= static_cast<double>(error.pixels);
  if (sums.values > 0) {
    error.color_mean = sums.distance / static_cast<double>(sums.values);
    error.color_mean_of_rounding = sums.best_distance / static_cast<double>(sums.values);
  }
  return error;
}

}  // namespace gouraud::conformance
