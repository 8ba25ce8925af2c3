// Takes the figures of the chart: pictures and their errors, then times, all contestants in turns.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "conformance/probes/contestants.h"
#include "conformance/chart/pareto.h"
#include "conformance/probes/reference.h"
#include "conformance/chart/scenes.h"

namespace gouraud::chart {

/// One contestant in one scene.
struct Entry {
  const Contestant* contestant = nullptr;
  std::string failure;  ///< why there is nothing else
  double frame_s = 0;   ///< median of processor time
  double relative = 0;  ///< to llvmpipe's
  PictureError error;
  std::vector<std::uint8_t> picture_png, error_png;
  bool is_valid() const { return failure.empty(); }
};

struct SceneChart {
  const ChartScene* scene = nullptr;
  std::vector<std::uint8_t> reference_png;
  std::vector<Entry> entries;
};

struct ChartOptions {
  int rounds = 7;      ///< turns of timing
  int area_grid = 23;  ///< pictures a side whose mean is area coverage: prime, so that no method samples where it does
  double least_sample_s = 0.004;
  std::vector<std::string> only;  ///< scenes; all if empty
  std::vector<std::string> contestants;  ///< beside llvmpipe and the default; all if empty
  std::function<void(const std::string&)> progress = [](const std::string&) {};
};

/// The errors that the chart can show on its y axis.
enum class Axis : std::uint8_t { color, coverage, depth, perceptual };
inline constexpr std::array all_axes{Axis::color, Axis::coverage, Axis::depth, Axis::perceptual};
std::string_view name_of(Axis axis);   ///< "color"
std::string_view label_of(Axis axis);  ///< for the plot, with its unit
/// Absent where the reference does not know it: coverage and depth by area, or where nothing has a depth.
std::optional<double> error_of(const PictureError& error, Axis axis);

/// The points of a scene, of the contestants that drew.
std::vector<Point> points_of(const SceneChart& chart, Axis axis);
/// Over all scenes with an exact reference: the geometric mean of the relative times and the mean of the errors. A method
/// counts as the default where a scene does not show its step.
std::vector<Point> overall_points(const std::vector<SceneChart>& charts, Axis axis);

std::vector<SceneChart> measure_chart(const std::vector<Contestant>& contestants, const ChartOptions& options);

}  // namespace gouraud::chart
