// What the program `stability` leaves: a plot a sweep and measure, the numbers as JSON, a page with all of it.
#pragma once

#include <string>
#include <vector>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {

struct SweepResult {
  const Sweep* sweep;
  std::vector<SweepSeries> series;
  std::vector<std::string> complaints;
};

/// Writes stability.json, stability.html and SWEEP_MEASURE.svg into an existing folder.
void write_report(const std::string& folder, const std::vector<SweepResult>& results);

/// A table for the terminal: a row a knob, a column a contestant.
std::string table_of(const SweepResult& result, std::size_t measure);

}  // namespace gouraud::stability
