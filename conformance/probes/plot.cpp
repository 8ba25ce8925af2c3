#include "conformance/probes/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace gouraud::probes {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

double placed_y(const Plot& plot, double y) { return plot.log_y ? std::max(y, plot.least_y) : y; }

struct Range {
  double lowest, highest;
};

Range y_range(const Plot& plot) {
  double highest = plot.least_y;
  for (const PlotSeries& series : plot.series) {
    for (const auto& [x, y] : series.points) highest = std::max(highest, placed_y(plot, y));
  }
  return {plot.least_y / 2, std::max(highest * 3, plot.least_y * 10)};
}

Range x_range(const Plot& plot) {
  Range range{1e300, 1e-300};
  for (const PlotSeries& series : plot.series) {
    for (const auto& [x, y] : series.points) range = {std::min(range.lowest, x), std::max(range.highest, x)};
  }
  // gnuplot's axis ends at powers of ten.
  return {std::pow(10, std::floor(std::log10(range.lowest))), std::pow(10, std::ceil(std::log10(range.highest)))};
}

/// Where labels stand: at their points, or as few lines above or below as keep them off the labels before. Logarithmic
/// axes.
class LabelPlaces {
 public:
  explicit LabelPlaces(const Plot& plot)
      : line_(decades(y_range(plot)) / lines), character_(decades(x_range(plot)) / characters) {}

  double place(double x, double y, std::size_t length) {
    const double begin = std::log10(x), end = begin + character_ * static_cast<double>(length + 2), height = std::log10(y);
    const auto is_taken = [&](double candidate) {
      return std::any_of(taken_.begin(), taken_.end(), [&](const Taken& taken) {
        return begin < taken.end && end > taken.begin && std::abs(taken.height - candidate) < 0.9 * line_;
      });
    };
    double candidate = height;
    for (int step = 1; is_taken(candidate); ++step) candidate = height + line_ * (step % 2 != 0 ? (step + 1) / 2 : -step / 2);
    taken_.push_back({begin, end, candidate});
    return std::pow(10, candidate);
  }

 private:
  static constexpr double lines = 40, characters = 150;  // that a plot has room for
  struct Taken {
    double begin, end, height;
  };
  static double decades(const Range& range) { return std::log10(range.highest / range.lowest); }

  double line_, character_;
  std::vector<Taken> taken_;
};

std::string blocks_of(const Plot& plot) {
  std::ostringstream out;
  out.precision(9);
  LabelPlaces places(plot);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& series = plot.series[i];
    out << "$series" << i << " << END\n";
    for (std::size_t k = 0; k < series.points.size(); ++k) {
      out << series.points[k].first << ' ' << placed_y(plot, series.points[k].second);
      if (!series.labels.empty()) {
        const auto [x, y] = series.points[k];
        out << ' ' << places.place(x, placed_y(plot, y), series.labels[k].size()) << ' ' << quoted(series.labels[k]);
      }
      out << '\n';
    }
    out << "END\n";
  }
  return out.str();
}

std::string drawn(const PlotSeries& series, std::size_t index) {
  const std::string data = "$series" + std::to_string(index);
  const std::string title = series.title.empty() ? " notitle" : " title " + quoted(series.title);
  const std::string type = std::to_string(index + 1) + (series.color.empty() ? "" : " linecolor rgb '" + series.color + "'");
  switch (series.style) {
    case PlotSeries::Style::lines: return data + " using 1:2 with linespoints linewidth 1.5 pointsize 0.5 linetype " + type + title;
    case PlotSeries::Style::steps: return data + " using 1:2 with steps linewidth 1.2 dashtype 2 linecolor rgb '#777777'" + title;
    case PlotSeries::Style::points: return data + " using 1:2 with points pointtype 7 pointsize 0.6 linetype " + type + title;
    case PlotSeries::Style::labelled_points: break;
  }
  return data + " using 1:2 with points pointtype 7 pointsize 0.7 linetype " + type + title + ", " + data +
         " using 1:3:4 with labels left offset 0.7,0 font ',9' notitle";
}

std::string script_of(const std::string& path, const Plot& plot) {
  std::ostringstream out;
  const bool is_png = path.ends_with(".png");
  out << "set terminal " << (is_png ? "pngcairo size 1000,640" : "svg size 1000,640 dynamic") << " noenhanced font 'sans,12' background rgb 'white'\n"
      << "set output " << quoted(path) << "\nset title " << quoted(plot.title) << "\nset xlabel " << quoted(plot.x_label)
      << "\nset ylabel " << quoted(plot.y_label) << "\nset grid linecolor rgb '#dddddd'\nset key outside center bottom horizontal\n";
  const Range range = y_range(plot);
  if (plot.log_y) out << "set yrange [" << range.lowest << ':' << range.highest << "]\n";
  if (plot.log_x) out << "set logscale x\n";
  if (plot.log_y) out << "set logscale y\nset format y '%.0e'\n";
  out << blocks_of(plot) << "plot ";
  bool first = true;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    if (plot.series[i].points.empty()) continue;
    out << (first ? "" : ", \\\n  ") << drawn(plot.series[i], i);
    first = false;
  }
  if (first) throw std::runtime_error("nothing to plot for " + path);
  out << "\n";
  return out.str();
}

}  // namespace

void write_plot(const std::string& path, const Plot& plot) {
  const std::string script = script_of(path, plot);
  std::FILE* const gnuplot = ::popen("gnuplot 2>&1", "w");
  if (gnuplot == nullptr) throw std::runtime_error("gnuplot cannot be started");
  const bool written = std::fwrite(script.data(), 1, script.size(), gnuplot) == script.size();
  if (::pclose(gnuplot) != 0 || !written) throw std::runtime_error("gnuplot failed to draw " + path + " (package gnuplot-nox)");
}

}  // namespace gouraud::probes
