#include <algorithm>
#include <stdexcept>
#include <string>

#include "conformance/probes/probe.h"
#include "conformance/stability/sweeps.h"

namespace gouraud::probes {
namespace {

double shift_x_px = 0, shift_y_px = 0;

}  // namespace

const std::vector<Probe>& all_probes() {
  static const std::vector<Probe> probes = [] {
    std::vector<Probe> all = chart_probes();
    for (const stability::Sweep& sweep : stability::all_sweeps()) all.push_back(sweep.probe);
    return all;
  }();
  return probes;
}

const Probe& probe_of_name(std::string_view name) {
  const auto found = std::ranges::find(all_probes(), name, &Probe::name);
  if (found == all_probes().end()) throw std::runtime_error("no probe is called " + std::string(name));
  return *found;
}

void shift_pixels(double x_px, double y_px) {
  shift_x_px = x_px;
  shift_y_px = y_px;
}

void project(const GlTable& gl, const conformance::Matrix& matrix, int width_px, int height_px) {
  conformance::Matrix moved = matrix;
  // x' = x + shift w: rows 0 and 1 gain a multiple of row 3.
  for (std::size_t column = 0; column < 4; ++column) {
    const double w = matrix[4 * column + 3];
    moved[4 * column] = static_cast<float>(matrix[4 * column] + 2 * shift_x_px / width_px * w);
    moved[4 * column + 1] = static_cast<float>(matrix[4 * column + 1] + 2 * shift_y_px / height_px * w);
  }
  conformance::load_projection(gl, moved);
}

void project_pixels(const GlTable& gl, int width_px, int height_px) {
  conformance::Matrix matrix = conformance::scaling(static_cast<float>(2.0 / width_px), static_cast<float>(2.0 / height_px), 1);
  matrix[12] = matrix[13] = -1;
  project(gl, matrix, width_px, height_px);
}

}  // namespace gouraud::probes
