// Sweeps: each turns one knob of a scene until something breaks, and says up to where the default holds and which
// method fails where.
//
// A sweep is a row of data: a probe that draws at a knob, the knobs, what is measured, and what is expected. One file a
// family; to add one, write its drawing and add a row.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/probes/contestants.h"
#include "conformance/probes/probe.h"
#include "conformance/probes/reference.h"

namespace gouraud::stability {

using probes::Answer;
using probes::Contestant;
using probes::Drawing;
using probes::Probe;
using probes::Reference;

/// What a measure sees of one contestant at one knob.
struct Observed {
  const Answer& answer;
  const Reference* reference;  ///< null if the sweep wants none
  const Answer& first;         ///< the same contestant's at the first knob
  double knob;
};

struct SweepMeasure {
  std::string_view name;   ///< "holes"
  std::string_view label;  ///< with its unit, for the plot
  double (*error)(const Observed& observed);
};

/// What must be true of a contestant over a range of knobs. Of a method that the library does not know: nothing.
struct Expectation {
  std::string_view contestant;  ///< "default", "colors=affine", "llvmpipe"
  std::string_view measure;
  double from, to;                   ///< knobs, both included
  std::optional<double> at_most{};   ///< at every one of these knobs
  std::optional<double> at_least{};  ///< at one of these knobs: it fails where theory says so
  std::string_view because{};
};

enum class SweepReference : std::uint8_t {
  none,
  house,  ///< the oracle with the house's window positions (float chain, 1/256 pixel): what an implementation must give
  exact,  ///< the oracle with exact positions: the true picture
  area,   ///< exact area coverage
};

struct Sweep {
  Probe probe;
  std::string_view knob_label;
  std::vector<double> knobs;
  std::vector<SweepMeasure> measures;
  std::vector<Expectation> expectations;
  SweepReference reference = SweepReference::none;
  std::vector<std::string_view> steps{};  ///< methods of these steps take part, with default, llvmpipe and softpipe
  /// The knob at which the reference is drawn.
  double (*reference_knob)(double knob) = [](double knob) { return knob; };
  bool log_x = false, log_y = true;
  double least_y = 1e-5;
};

const std::vector<Sweep>& all_sweeps();

// By file.
std::vector<Sweep> position_sweeps();
std::vector<Sweep> edge_sweeps();
std::vector<Sweep> depth_sweeps();
std::vector<Sweep> color_sweeps();
std::vector<Sweep> light_sweeps();
std::vector<Sweep> number_sweeps();

/// One contestant's way through a sweep; knobs at which it did not draw are left out, with the reason kept.
struct SweepSeries {
  std::string contestant;
  struct Value {
    double knob;
    std::vector<double> errors;  ///< one a measure
  };
  std::vector<Value> values;
  std::vector<std::string> failures;
};

/// Whether a contestant takes part in a sweep.
bool takes_part(const Contestant& contestant, const Sweep& sweep);

/// Draws all knobs with each contestant.
std::vector<SweepSeries> run_sweep(const Sweep& sweep, const std::vector<Contestant>& contestants);

/// What is not as expected, a sentence each.
std::vector<std::string> complaints(const Sweep& sweep, const std::vector<SweepSeries>& series);

// Measures that many sweeps share.
double coverage_percent(const Observed& observed);
double color_beyond_rounding(const Observed& observed);
double color_max(const Observed& observed);
double depth_beyond_rounding(const Observed& observed);
double depth_max(const Observed& observed);
/// % of the pixels drawn whose colour is more than 8/255 from the reference's: another surface is seen.
double wrong_surface_percent(const Observed& observed);

/// 10^first .. 10^last or 2^first .. 2^last by steps.
std::vector<double> powers(double base, int first, int last, int step = 1);

}  // namespace gouraud::stability
