#include "conformance/chart/measure_chart.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "conformance/harness/png.h"

namespace gouraud::chart {
namespace {

constexpr double slow_frame_s = 0.3;  // such a frame is timed three times at most

Reference reference_of(const ChartScene& scene, const ChartOptions& options) {
  switch (scene.reference) {
    case ReferenceKind::area: return area_reference(scene.probe, 0, options.area_grid);
    case ReferenceKind::finer_mesh: {
      Reference reference = exact_reference(scene.probe, 1, oracle::PositionModel::exact);
      reference.exact.reset();  // another mesh: of its pixels only the colours compare
      return reference;
    }
    case ReferenceKind::exact: break;
  }
  return exact_reference(scene.probe, 0);
}

using Drivers = std::map<const Contestant*, std::unique_ptr<ProbeDriver>>;

Entry draw(ProbeDriver& driver, const Contestant& contestant, const ChartScene& scene, const Reference& reference) {
  Entry entry;
  entry.contestant = &contestant;
  const Answer answer = driver.picture(scene.probe.name, 0, true);
  if (!answer.picture) {
    entry.failure = answer.failure;
    return entry;
  }
  entry.error = measure(*answer.picture, reference);
  entry.picture_png = encode_png(image_of(*answer.picture));
  entry.error_png = encode_png(error_map(*answer.picture, reference));
  return entry;
}

/// Frames in turns; a sample is as many frames as take the least time.
struct Timing {
  Entry* entry;
  ProbeDriver* driver;
  int frames = 1, rounds = 1;
  std::vector<double> samples{};
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

void time_in_turns(SceneChart& chart, Drivers& drivers, const ChartOptions& options) {
  std::vector<Timing> timings;
  for (Entry& entry : chart.entries) {
    if (!entry.is_valid()) continue;
    Timing timing{&entry, drivers[entry.contestant].get()};
    if (!timing.driver->begin(chart.scene->probe.name, 0)) {
      entry.failure = timing.driver->failure();
      continue;
    }
    const double first_s = timing.driver->frames(1);
    timing.frames = std::max(1, static_cast<int>(std::ceil(options.least_sample_s / std::max(first_s, 1e-6))));
    timing.rounds = first_s > slow_frame_s ? std::min(3, options.rounds) : options.rounds;
    timings.push_back(timing);
  }
  for (int round = 0; round < options.rounds; ++round) {
    // In another order each time: who comes after a slow one finds its caches cold.
    if (round > 0) std::rotate(timings.begin(), timings.begin() + static_cast<std::ptrdiff_t>(timings.size() / 2 - (timings.size() > 4 ? 1 : 0)), timings.end());
    options.progress(std::string(chart.scene->probe.name) + ": times, turn " + std::to_string(round + 1) + " of " +
                     std::to_string(options.rounds));
    for (Timing& timing : timings) {
      if (round < timing.rounds) timing.samples.push_back(timing.driver->frames(timing.frames));
    }
  }
  for (Timing& timing : timings) timing.entry->frame_s = median(timing.samples);
}

void relate_to_llvmpipe(SceneChart& chart) {
  const auto llvmpipe = std::ranges::find_if(
      chart.entries, [](const Entry& entry) { return entry.contestant->owner == Owner::llvmpipe && entry.is_valid(); });
  if (llvmpipe == chart.entries.end()) throw std::runtime_error("llvmpipe did not draw " + std::string(chart.scene->probe.name));
  for (Entry& entry : chart.entries) entry.relative = entry.frame_s / llvmpipe->frame_s;
}

bool takes_part(const Contestant& contestant, const ChartScene& scene, const ChartOptions& options) {
  if (contestant.antialiases && scene.reference != ReferenceKind::area) return false;
  const bool is_method = contestant.owner == Owner::ours_method;
  if (is_method && std::ranges::find(scene.steps, contestant.step) == scene.steps.end()) return false;
  const bool always = contestant.owner == Owner::llvmpipe || contestant.owner == Owner::ours_default;
  return always || options.contestants.empty() || std::ranges::find(options.contestants, contestant.name) != options.contestants.end();
}

}  // namespace

std::string_view name_of(Axis axis) {
  switch (axis) {
    case Axis::color: return "color";
    case Axis::coverage: return "coverage";
    case Axis::depth: return "depth";
    case Axis::perceptual: break;
  }
  return "perceptual";
}

std::string_view label_of(Axis axis) {
  switch (axis) {
    case Axis::color: return "mean colour error beyond rounding, 1/255";
    case Axis::coverage: return "wrong coverage, % of the pixels drawn";
    case Axis::depth: return "mean depth error beyond rounding, units";
    case Axis::perceptual: break;
  }
  return "perceptual difference, 1 - SSIM";
}

std::optional<double> error_of(const PictureError& error, Axis axis) {
  switch (axis) {
    case Axis::color: return error.color_beyond_rounding;
    case Axis::coverage: return error.has_coverage ? std::optional(error.coverage_percent) : std::nullopt;
    case Axis::depth: return error.has_depth ? std::optional(error.depth_beyond_rounding) : std::nullopt;
    case Axis::perceptual: break;
  }
  return error.dssim;
}

std::vector<Point> points_of(const SceneChart& chart, Axis axis) {
  std::vector<Point> points;
  for (const Entry& entry : chart.entries) {
    const std::optional<double> error = error_of(entry.error, axis);
    if (entry.is_valid() && error) points.push_back({entry.contestant->name, entry.relative, *error});
  }
  return points;
}

std::vector<Point> overall_points(const std::vector<SceneChart>& charts, Axis axis) {
  struct Sum {
    double log_time = 0, error = 0;
  };
  std::map<std::string, Sum> sums;
  for (const SceneChart& chart : charts) {
    if (chart.scene->reference != ReferenceKind::exact) continue;
    for (const Point& point : points_of(chart, axis)) sums[point.name];
  }
  int scenes = 0;
  for (const SceneChart& chart : charts) {
    const std::vector<Point> known = points_of(chart, axis);
    if (chart.scene->reference != ReferenceKind::exact || known.empty()) continue;
    ++scenes;
    const auto own = std::ranges::find_if(chart.entries, [](const Entry& entry) { return entry.contestant->owner == Owner::ours_default; });
    for (auto& [name, sum] : sums) {
      // A method that the scene does not show draws it as the default does.
      auto point = std::ranges::find(known, name, &Point::name);
      if (point == known.end()) point = std::ranges::find(known, own->contestant->name, &Point::name);
      sum.log_time += std::log(point->time);
      sum.error += point->error;
    }
  }
  std::vector<Point> points;
  for (const auto& [name, sum] : sums) points.push_back({name, std::exp(sum.log_time / scenes), sum.error / scenes});
  return points;
}

std::vector<SceneChart> measure_chart(const std::vector<Contestant>& contestants, const ChartOptions& options) {
  Drivers drivers;
  for (const Contestant& contestant : contestants) drivers[&contestant] = std::make_unique<ProbeDriver>(contestant);
  std::vector<SceneChart> charts;
  for (const ChartScene& scene : chart_scenes()) {
    const std::string name(scene.probe.name);
    if (!options.only.empty() && std::ranges::find(options.only, name) == options.only.end()) continue;
    options.progress(name + ": the reference");
    const Reference reference = reference_of(scene, options);
    SceneChart chart{&scene, encode_png(image_of(reference)), {}};
    for (const Contestant& contestant : contestants) {
      if (!takes_part(contestant, scene, options)) continue;
      options.progress(name + ": the picture by " + contestant.name);
      chart.entries.push_back(draw(*drivers[&contestant], contestant, scene, reference));
    }
    time_in_turns(chart, drivers, options);
    relate_to_llvmpipe(chart);
    charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace gouraud::chart
