#include "conformance/stability/sweeps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gouraud::stability {
namespace {

using probes::Owner;

std::optional<Reference> reference_of(const Sweep& sweep, double knob) {
  constexpr int area_grid = 17;  // no sampling method shares its places
  const double drawn = sweep.reference_knob(knob);
  switch (sweep.reference) {
    case SweepReference::none: return std::nullopt;
    case SweepReference::house: return probes::exact_reference(sweep.probe, drawn);
    case SweepReference::exact: return probes::exact_reference(sweep.probe, drawn, oracle::PositionModel::exact);
    case SweepReference::area: break;
  }
  return probes::area_reference(sweep.probe, drawn, area_grid);
}

std::string number(double value) {
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return buffer.data();
}

struct Extremes {
  double largest = 0, knob_of_largest = 0;
  int values = 0;
};

Extremes extremes(const SweepSeries& series, std::size_t measure, double from, double to) {
  Extremes result;
  for (const SweepSeries::Value& value : series.values) {
    if (value.knob < from || value.knob > to) continue;
    ++result.values;
    if (result.values > 1 && !(value.errors[measure] > result.largest)) continue;
    result.largest = value.errors[measure];
    result.knob_of_largest = value.knob;
  }
  return result;
}

std::optional<std::string> complaint(const Sweep& sweep, const Expectation& expected, const SweepSeries& series) {
  const auto measure = static_cast<std::size_t>(
      std::ranges::find(sweep.measures, expected.measure, &SweepMeasure::name) - sweep.measures.begin());
  const std::string who = std::string(sweep.probe.name) + ", " + series.contestant + ": ";
  if (measure == sweep.measures.size()) return who + "there is no measure " + std::string(expected.measure);
  const Extremes found = extremes(series, measure, expected.from, expected.to);
  const std::string what = std::string(expected.measure) + " is " + number(found.largest) + " at " + number(found.knob_of_largest);
  if (found.values == 0) return who + "nothing was drawn from " + number(expected.from) + " to " + number(expected.to);
  if (expected.at_most && !(found.largest <= *expected.at_most)) return who + what + ", must be at most " + number(*expected.at_most);
  if (expected.at_least && !(found.largest >= *expected.at_least)) {
    return who + what + ", the largest; must be at least " + number(*expected.at_least) + " somewhere, because " + std::string(expected.because);
  }
  return std::nullopt;
}

}  // namespace

const std::vector<Sweep>& all_sweeps() {
  static const std::vector<Sweep> sweeps = [] {
    std::vector<Sweep> all;
    for (const auto list : {position_sweeps, edge_sweeps, depth_sweeps, color_sweeps, light_sweeps, number_sweeps}) {
      for (const Sweep& sweep : list()) all.push_back(sweep);
    }
    return all;
  }();
  return sweeps;
}

bool takes_part(const Contestant& contestant, const Sweep& sweep) {
  if (contestant.owner != Owner::ours_method) return true;
  const bool is_named = std::ranges::any_of(sweep.expectations, [&](const Expectation& e) { return e.contestant == contestant.name; });
  return is_named || std::ranges::find(sweep.steps, contestant.step) != sweep.steps.end();
}

std::vector<SweepSeries> run_sweep(const Sweep& sweep, const std::vector<Contestant>& contestants) {
  std::vector<std::optional<Reference>> references;
  for (std::size_t i = 0; i < sweep.knobs.size(); ++i) {
    const bool is_last_again = i > 0 && sweep.reference_knob(sweep.knobs[i]) == sweep.reference_knob(sweep.knobs[i - 1]);
    references.push_back(is_last_again ? references.back() : reference_of(sweep, sweep.knobs[i]));
  }

  std::vector<SweepSeries> all;
  for (const Contestant& contestant : contestants) {
    if (!takes_part(contestant, sweep)) continue;
    probes::ProbeDriver driver(contestant);
    SweepSeries series{contestant.name, {}, {}};
    std::optional<Answer> first;
    for (std::size_t i = 0; i < sweep.knobs.size(); ++i) {
      Answer answer = driver.picture(sweep.probe.name, sweep.knobs[i], references[i].has_value());
      if (!answer.picture) {
        series.failures.push_back("at " + number(sweep.knobs[i]) + ": " + answer.failure);
        continue;
      }
      if (!first) first = answer;
      const Observed observed{answer, references[i] ? &*references[i] : nullptr, *first, sweep.knobs[i]};
      SweepSeries::Value value{sweep.knobs[i], {}};
      for (const SweepMeasure& measure : sweep.measures) value.errors.push_back(measure.error(observed));
      series.values.push_back(value);
    }
    all.push_back(std::move(series));
  }
  return all;
}

std::vector<std::string> complaints(const Sweep& sweep, const std::vector<SweepSeries>& all) {
  std::vector<std::string> sentences;
  for (const SweepSeries& series : all) {
    if (series.contestant == "default") {
      for (const std::string& failure : series.failures) sentences.push_back(std::string(sweep.probe.name) + ", default: " + failure);
    }
    for (const Expectation& expected : sweep.expectations) {
      if (expected.contestant != series.contestant) continue;
      if (const auto sentence = complaint(sweep, expected, series)) sentences.push_back(*sentence);
    }
  }
  return sentences;
}

double coverage_percent(const Observed& observed) { return measure(*observed.answer.picture, *observed.reference).coverage_percent; }
double color_beyond_rounding(const Observed& observed) {
  return measure(*observed.answer.picture, *observed.reference).color_beyond_rounding;
}
double color_max(const Observed& observed) { return measure(*observed.answer.picture, *observed.reference).color_max; }
double depth_beyond_rounding(const Observed& observed) {
  return measure(*observed.answer.picture, *observed.reference).depth_beyond_rounding;
}
double depth_max(const Observed& observed) { return measure(*observed.answer.picture, *observed.reference).depth_max; }

double wrong_surface_percent(const Observed& observed) {
  constexpr double another = 8;
  const conformance::Picture& picture = *observed.answer.picture;
  int drawn = 0, wrong = 0;
  for (std::size_t i = 0; i < picture.pixel_count(); ++i) {
    const bool expected = observed.reference->exact && observed.reference->exact->fragments_written[i] > 0;
    if (!expected && (picture.covered.empty() || picture.covered[i] == 0)) continue;
    ++drawn;
    double worst = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      worst = std::max(worst, std::abs(picture.rgba[4 * i + channel] - 255 * observed.reference->color[4 * i + channel]));
    }
    wrong += worst > another ? 1 : 0;
  }
  return drawn == 0 ? 0.0 : 100.0 * wrong / drawn;
}

std::vector<double> powers(double base, int first, int last, int step) {
  std::vector<double> values;
  for (int exponent = first; exponent <= last; exponent += step) values.push_back(std::pow(base, exponent));
  return values;
}

}  // namespace gouraud::stability
