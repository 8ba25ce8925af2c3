// Plots as SVG or PNG files, drawn by gnuplot.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gouraud::probes {

struct PlotSeries {
  enum class Style { points, labelled_points, lines, steps };
  std::string title;  ///< empty: not in the key
  Style style = Style::lines;
  std::vector<std::pair<double, double>> points;
  std::vector<std::string> labels{};  ///< a label a point, of labelled_points
  std::string color{};                ///< "#rrggbb"; empty: gnuplot's next
};

struct Plot {
  std::string title, x_label, y_label;
  bool log_x = true, log_y = true;
  /// On a logarithmic y axis what is below this is drawn here: a zero has no place there.
  double least_y = 1e-5;
  std::vector<PlotSeries> series;
};

/// Runs gnuplot; throws std::runtime_error if it is missing or complains. A path that ends in .png gets a PNG, others an
/// SVG. Labels that would lie over each other are moved up.
void write_plot(const std::string& path, const Plot& plot);

}  // namespace gouraud::probes
