// What a probe's picture should be, and how far a contestant's is from it.
//
// Three kinds of reference, all by the oracle (conformance/oracle): the picture of the probe itself (point samples, the
// house's window positions); exact area coverage, for antialiasing: the mean of n x n pictures that are moved over the
// pixels by 1/n, with exact positions; and the picture of the probe at another knob, where a finer mesh says what a
// coarse one stands for.
#pragma once

#include <optional>
#include <vector>

#include "conformance/probes/probe.h"
#include "conformance/harness/picture.h"
#include "conformance/harness/png.h"

namespace gouraud::probes {

struct Reference {
  int width_px = 0, height_px = 0;
  std::vector<double> color;  ///< RGBA in [0, 1], four a pixel, rows bottom-up
  /// The whole story, where it is that of the probe itself: coverage, depth, legal alternatives.
  std::optional<oracle::OraclePicture> exact;
};

/// Drawn in this process, by the state machine of the static library under the oracle's eyes.
Reference exact_reference(const Probe& probe, double knob,
                          oracle::PositionModel positions = oracle::PositionModel::snapped);
/// The mean of grid x grid pictures.
Reference area_reference(const Probe& probe, double knob, int grid);

struct PictureError {
  bool has_coverage = false;      ///< coverage and depth are known only of exact references
  bool has_depth = false;         ///< and depth only where the scene writes it
  double coverage_percent = 0;    ///< pixels drawn by one of both, of those drawn by any
  double color_mean = 0;          ///< |byte - 255 ideal| over R, G and B of the pixels drawn, wrong ones included
  double color_max = 0;           ///< the same, the largest
  /// Mean over the pixels drawn of what the worst channel's error has beyond 1/2, which is rounding's. The chart's y.
  double color_beyond_rounding = 0;
  double depth_mean = 0, depth_max = 0;  ///< |stored - ideal| in units, over the pixels drawn by both
  double depth_beyond_rounding = 0;      ///< the mean of what goes beyond 1/2
  double dssim = 0;  ///< 1 - mean SSIM of luma; see structural_similarity()
};

PictureError measure(const conformance::Picture& picture, const Reference& reference);

/// The mean structural similarity of two pictures of luma, 0 to 255: Wang, Bovik, Sheikh and Simoncelli, "Image quality
/// assessment: from error visibility to structural similarity", IEEE Trans. Image Processing 13(4), 2004, eq 13 with
/// K1 = 0.01, K2 = 0.03, L = 255, over 8 x 8 windows of equal weight, every fourth pixel. 1: equal.
double structural_similarity(const std::vector<double>& a, const std::vector<double>& b, int width_px, int height_px);

/// Black where the colour is within rounding; grey by the logarithm of the error; magenta and cyan where only the
/// picture or only the reference drew.
conformance::RgbImage error_map(const conformance::Picture& picture, const Reference& reference);

conformance::RgbImage image_of(const conformance::Picture& picture);
conformance::RgbImage image_of(const Reference& reference);

}  // namespace gouraud::probes
