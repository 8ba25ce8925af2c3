#include "conformance/chart/chart_files.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <sstream>

#include "conformance/chart/chart_page.h"
#include "conformance/probes/plot.h"
#include "conformance/harness/png.h"

namespace gouraud::chart {
namespace {

constexpr std::string_view default_name = "default";

std::string number(double value) {
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "%.6g", value);
  return buffer.data();
}

/// As a JSON string that may also stand inside a script element.
std::string json_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (c == '<') {
      result += "\\u003c";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      result += ' ';
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string_view owner_name(Owner owner) {
  switch (owner) {
    case Owner::ours_default: return "default";
    case Owner::ours_method: return "method";
    case Owner::llvmpipe: return "llvmpipe";
    case Owner::softpipe: break;
  }
  return "softpipe";
}

std::string_view reference_name(ReferenceKind kind) {
  switch (kind) {
    case ReferenceKind::area: return "area coverage";
    case ReferenceKind::finer_mesh: return "finer mesh";
    case ReferenceKind::exact: break;
  }
  return "exact";
}

/// Pictures by content: many contestants draw the same one.
class ImageTable {
 public:
  std::size_t add(const std::vector<std::uint8_t>& png) {
    const auto [found, is_new] = numbers_.try_emplace(png, numbers_.size());
    if (is_new) uris_.push_back("data:image/png;base64," + conformance::base64(png));
    return found->second;
  }
  const std::vector<std::string>& uris() const { return uris_; }

 private:
  std::map<std::vector<std::uint8_t>, std::size_t> numbers_;
  std::vector<std::string> uris_;
};

void write_entry(std::ostream& out, const Entry& entry, ImageTable* images) {
  const PictureError& error = entry.error;
  out << "{\"contestant\": " << json_text(entry.contestant->name) << ", \"owner\": \"" << owner_name(entry.contestant->owner)
      << "\", \"step\": " << json_text(entry.contestant->step);
  if (!entry.is_valid()) {
    out << ", \"failure\": " << json_text(entry.failure) << "}";
    return;
  }
  out << ", \"frame_ms\": " << number(1000 * entry.frame_s) << ", \"relative_time\": " << number(entry.relative)
      << ", \"color_mean\": " << number(error.color_mean) << ", \"color_max\": " << number(error.color_max);
  if (error.has_depth) {
    out << ", \"depth_mean\": " << number(error.depth_mean) << ", \"depth_max\": " << number(error.depth_max);
  }
  out << ", \"errors\": {";
  bool first = true;
  for (const Axis axis : all_axes) {
    const std::optional<double> value = error_of(error, axis);
    if (!value) continue;
    out << (first ? "" : ", ") << '"' << name_of(axis) << "\": " << number(*value);
    first = false;
  }
  out << "}";
  if (images != nullptr) out << ", \"picture\": " << images->add(entry.picture_png) << ", \"error_map\": " << images->add(entry.error_png);
  out << "}";
}

void write_overall(std::ostream& out, const std::vector<SceneChart>& charts) {
  out << "\"overall\": {";
  bool first_axis = true;
  for (const Axis axis : all_axes) {
    out << (first_axis ? "" : ", ") << '"' << name_of(axis) << "\": [";
    first_axis = false;
    bool first = true;
    for (const Point& point : overall_points(charts, axis)) {
      out << (first ? "" : ", ") << "{\"contestant\": " << json_text(point.name) << ", \"relative_time\": " << number(point.time)
          << ", \"error\": " << number(point.error) << "}";
      first = false;
    }
    out << "]";
  }
  out << "}";
}

std::string json_of(const std::vector<SceneChart>& charts, ImageTable* images) {
  std::ostringstream out;
  out << "{\"axes\": {";
  for (std::size_t i = 0; i < all_axes.size(); ++i) {
    out << (i == 0 ? "" : ", ") << '"' << name_of(all_axes[i]) << "\": " << json_text(label_of(all_axes[i]));
  }
  out << "},\n\"scenes\": [";
  for (std::size_t i = 0; i < charts.size(); ++i) {
    const SceneChart& chart = charts[i];
    out << (i == 0 ? "\n" : ",\n") << "{\"name\": " << json_text(chart.scene->probe.name) << ", \"shows\": "
        << json_text(chart.scene->probe.shows) << ", \"reference\": \"" << reference_name(chart.scene->reference) << "\", ";
    if (images != nullptr) out << "\"reference_picture\": " << images->add(chart.reference_png) << ", ";
    out << "\"entries\": [";
    for (std::size_t k = 0; k < chart.entries.size(); ++k) {
      out << (k == 0 ? "\n  " : ",\n  ");
      write_entry(out, chart.entries[k], images);
    }
    out << "]}";
  }
  out << "],\n";
  write_overall(out, charts);
  out << "}\n";
  return out.str();
}

/// The staircase of the front, from fast and wrong to slow and right.
PlotSeries front_series(const std::vector<Point>& points) {
  PlotSeries series{"Pareto front", PlotSeries::Style::steps, {}};
  const std::vector<bool> on_front = front(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (on_front[i]) series.points.emplace_back(points[i].time, points[i].error);
  }
  std::ranges::sort(series.points);
  return series;
}

Plot plot_of(const std::string& title, const std::vector<Point>& points, Axis axis) {
  Plot plot{title, "processor time, relative to llvmpipe", std::string(label_of(axis)), true, true, 1e-5, {}};
  plot.series.push_back(front_series(points));
  PlotSeries methods{"Gouraud's methods", PlotSeries::Style::labelled_points, {}, {}, "#1565c0"};
  PlotSeries ours{"Gouraud, the default", PlotSeries::Style::labelled_points, {}, {}, "#c62828"};
  PlotSeries mesa{"Mesa", PlotSeries::Style::labelled_points, {}, {}, "#2e7d32"};
  for (const Point& point : points) {
    const bool is_mesa = point.name == "llvmpipe" || point.name == "softpipe";
    PlotSeries& series = point.name == default_name ? ours : is_mesa ? mesa : methods;
    series.points.emplace_back(point.time, point.error);
    series.labels.push_back(point.name);
  }
  for (PlotSeries* series : {&methods, &mesa, &ours}) plot.series.push_back(*series);
  return plot;
}

void report_scene(std::vector<std::string>& lines, const std::string& scene, const std::vector<Point>& points, Axis axis) {
  const auto own = std::ranges::find(points, default_name, &Point::name);
  if (own == points.end()) return;
  for (const Point& other : points) {
    // All errors show in the colours; of the others only being better in both counts.
    if (axis == Axis::color ? !is_faster_and_as_accurate(other, *own) : !beats(other, *own)) continue;
    const char* const how = beats(other, *own) ? "beats" : "is faster than and as accurate as";
    lines.push_back(scene + ", " + std::string(name_of(axis)) + ": " + other.name + " " + how + " the default (time " +
                    number(other.time) + " against " + number(own->time) + ", error " + number(other.error) + " against " +
                    number(own->error) + ")");
  }
}

}  // namespace

std::string chart_json(const std::vector<SceneChart>& charts) { return json_of(charts, nullptr); }

void write_chart_plots(const std::string& folder, const std::vector<SceneChart>& charts) {
  const auto write = [&](const std::string& name, const std::string& title, const std::vector<Point>& points, Axis axis) {
    if (points.empty()) return;
    const std::string suffix = axis == Axis::color ? "" : "_" + std::string(name_of(axis));
    write_plot(folder + "/" + name + suffix + ".svg", plot_of(title, points, axis));
  };
  for (const Axis axis : all_axes) {
    write("overall", "All scenes with an exact reference", overall_points(charts, axis), axis);
    if (axis == Axis::color) {
      write_plot(folder + "/overall.png", plot_of("All scenes with an exact reference", overall_points(charts, axis), axis));
    }
    for (const SceneChart& chart : charts) {
      const std::string name(chart.scene->probe.name);
      write(name, name + ": " + std::string(chart.scene->probe.shows), points_of(chart, axis), axis);
    }
  }
}

std::string chart_html(const std::vector<SceneChart>& charts) {
  ImageTable images;
  const std::string data = json_of(charts, &images);
  std::ostringstream out;
  out << chart_page_head << "<script>\nconst chart = " << data << ";\nconst images = [";
  for (const std::string& uri : images.uris()) out << "\n\"" << uri << "\",";
  out << "];\n" << chart_page_script << "</script>\n</html>\n";
  return out.str();
}

std::vector<std::string> front_report(const std::vector<SceneChart>& charts) {
  std::vector<std::string> lines;
  for (const Axis axis : all_axes) {
    for (const SceneChart& chart : charts) report_scene(lines, std::string(chart.scene->probe.name), points_of(chart, axis), axis);
    report_scene(lines, "overall", overall_points(charts, axis), axis);
  }
  return lines;
}

}  // namespace gouraud::chart
