// The numbers between two pictures of a scene, and between a picture and the oracle's. Judgement is elsewhere (judge.h).
// Pictures that are compared have the same size and depth format.
#pragma once

#include <cstddef>

#include "conformance/harness/picture.h"

namespace gouraud::conformance {

struct CoverageDifference {
  std::size_t drawn = 0;  ///< pixels covered in either picture
  std::size_t only_first = 0, only_second = 0;
  std::size_t total() const { return only_first + only_second; }
};

CoverageDifference compare_coverage(const Picture& first, const Picture& second);

/// Against the oracle; where the outcome of a depth test is ambiguous the pixel may be drawn or not.
CoverageDifference compare_coverage(const Picture& picture, const oracle::OraclePicture& exact);

/// Over the pixels that both pictures cover.
struct ColorDifference {
  std::size_t pixels = 0, identical = 0;
  std::size_t beyond_one = 0;  ///< pixels with a channel that differs by more than 1/255
  int max = 0;                 ///< largest difference of a channel, in 1/255
  double mean = 0.0;           ///< over all channels, in 1/255
  double different_percent() const;
};

ColorDifference compare_color(const Picture& first, const Picture& second);

/// Pixels that neither picture covers and whose colour or depth differs: the clears disagree.
std::size_t compare_background(const Picture& first, const Picture& second);

/// How far a picture is from the exact one, over the pixels that both draw.
struct ExactError {
  std::size_t pixels = 0;
  double color_max = 0.0;  ///< largest |byte - 255 ideal| of a channel; oracle::measure chooses the outcome
  /// Mean of the same over the channel values that are no whole number of 1/255 (those have no rounding error), and
  /// what the best rounding gives for the same values: 0.25 where colours vary, anything up to 0.5 where they do not.
  /// Only over pixels of which the oracle knows one outcome and no legal range.
  double color_mean = 0.0, color_mean_of_rounding = 0.0;
  double depth_max = 0.0, depth_mean = 0.0;  ///< |stored - ideal|, in units of the stored depth
};

ExactError compare_exact(const Picture& picture, const oracle::OraclePicture& exact);

/// oracle::measure of one pixel.
oracle::PixelError measure_pixel(const Picture& picture, const oracle::OraclePicture& exact, std::size_t index);

}  // namespace gouraud::conformance
