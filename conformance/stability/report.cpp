#include "conformance/stability/report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "conformance/probes/plot.h"

namespace gouraud::stability {
namespace {

using probes::Plot;
using probes::PlotSeries;

std::string number(double value) {
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.4g", value);
  return buffer.data();
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

/// JSON has no NaN.
std::string json_number(double value) { return std::isfinite(value) ? number(value) : "null"; }

Plot plot_of(const SweepResult& result, std::size_t measure) {
  const Sweep& sweep = *result.sweep;
  Plot plot{std::string(sweep.probe.name) + ": " + std::string(sweep.probe.shows), std::string(sweep.knob_label),
            std::string(sweep.measures[measure].label), sweep.log_x, sweep.log_y, sweep.least_y, {}};
  for (const SweepSeries& series : result.series) {
    PlotSeries line{series.contestant, PlotSeries::Style::lines, {}};
    for (const SweepSeries::Value& value : series.values) {
      if (std::isfinite(value.errors[measure]) && (!sweep.log_x || value.knob > 0)) line.points.emplace_back(value.knob, value.errors[measure]);
    }
    plot.series.push_back(std::move(line));
  }
  return plot;
}

std::string svg_name(const SweepResult& result, std::size_t measure) {
  return std::string(result.sweep->probe.name) + "_" + std::string(result.sweep->measures[measure].name) + ".svg";
}

std::string file_text(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream out(path);
  out << text;
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

std::string sentence_of(const Expectation& expected) {
  const std::string range = " from " + number(expected.from) + " to " + number(expected.to);
  if (expected.at_most) return std::string(expected.contestant) + ": " + std::string(expected.measure) + " at most " + number(*expected.at_most) + range;
  return std::string(expected.contestant) + ": " + std::string(expected.measure) + " at least " + number(*expected.at_least) + " somewhere" +
         range + ", because " + std::string(expected.because);
}

std::string json_of(const std::vector<SweepResult>& results) {
  std::ostringstream out;
  out << "[";
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Sweep& sweep = *results[i].sweep;
    out << (i == 0 ? "\n" : ",\n") << "{\"sweep\": \"" << sweep.probe.name << "\", \"measures\": [";
    for (std::size_t m = 0; m < sweep.measures.size(); ++m) out << (m == 0 ? "\"" : ", \"") << sweep.measures[m].name << "\"";
    out << "], \"series\": [";
    for (std::size_t s = 0; s < results[i].series.size(); ++s) {
      const SweepSeries& series = results[i].series[s];
      out << (s == 0 ? "\n  " : ",\n  ") << "{\"contestant\": \"" << series.contestant << "\", \"values\": [";
      for (std::size_t v = 0; v < series.values.size(); ++v) {
        out << (v == 0 ? "[" : ", [") << json_number(series.values[v].knob);
        for (const double error : series.values[v].errors) out << ", " << json_number(error);
        out << "]";
      }
      out << "], \"failures\": " << series.failures.size() << "}";
    }
    out << "]}";
  }
  out << "\n]\n";
  return out.str();
}

}  // namespace

std::string table_of(const SweepResult& result, std::size_t measure) {
  std::ostringstream out;
  const Sweep& sweep = *result.sweep;
  out << sweep.probe.name << ": " << sweep.measures[measure].label << "\n";
  const auto cell = [&](const std::string& text, std::size_t width) { out << std::string(width > text.size() ? width - text.size() : 1, ' ') << text; };
  cell(std::string(sweep.knob_label).substr(0, 22), 24);
  for (const SweepSeries& series : result.series) cell(series.contestant, std::max<std::size_t>(series.contestant.size() + 2, 12));
  out << "\n";
  for (const double knob : sweep.knobs) {
    cell(number(knob), 24);
    for (const SweepSeries& series : result.series) {
      const auto found = std::ranges::find(series.values, knob, &SweepSeries::Value::knob);
      cell(found == series.values.end() ? "-" : number(found->errors[measure]), std::max<std::size_t>(series.contestant.size() + 2, 12));
    }
    out << "\n";
  }
  for (const SweepSeries& series : result.series) {
    for (const std::string& failure : series.failures) out << "  " << series.contestant << " " << failure << "\n";
  }
  return out.str();
}

void write_report(const std::string& folder, const std::vector<SweepResult>& results) {
  std::ostringstream page;
  page << "<!doctype html><html lang=en><meta charset=utf-8><title>Gouraud: stability</title><style>body { font: 14px/1.4 system-ui, "
          "sans-serif; margin: 2em; color: #222; max-width: 1100px } .bad { color: #b00020 } pre { font-size: 12px; overflow-x: auto }"
          "</style><h1>Stability: one knob turned until things break</h1>\n";
  for (const SweepResult& result : results) {
    const Sweep& sweep = *result.sweep;
    page << "<h2>" << sweep.probe.name << "</h2><p>" << escaped(sweep.probe.shows) << "</p><ul>";
    for (const Expectation& expected : sweep.expectations) page << "<li>" << escaped(sentence_of(expected)) << "</li>";
    page << "</ul>\n";
    for (const std::string& complaint : result.complaints) page << "<p class=bad>" << escaped(complaint) << "</p>\n";
    for (std::size_t measure = 0; measure < sweep.measures.size(); ++measure) {
      const std::string path = folder + "/" + svg_name(result, measure);
      const Plot plot = plot_of(result, measure);
      const bool has_points = std::ranges::any_of(plot.series, [](const PlotSeries& series) { return !series.points.empty(); });
      if (has_points) {
        probes::write_plot(path, plot);
        const std::string svg = file_text(path);
        page << svg.substr(std::min(svg.find("<svg"), svg.size()));
      }
      page << "<details><summary>the numbers</summary><pre>" << escaped(table_of(result, measure)) << "</pre></details>\n";
    }
  }
  page << "</html>\n";
  write_file(folder + "/stability.html", page.str());
  write_file(folder + "/stability.json", json_of(results));
}

}  // namespace gouraud::stability
