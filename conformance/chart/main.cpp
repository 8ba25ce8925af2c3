// chart: speed against accuracy, of every method, llvmpipe and softpipe. See usage below.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "conformance/chart/chart_files.h"
#include "conformance/harness/options.h"

namespace gouraud::chart {
namespace {

constexpr const char* usage = R"(chart [OPTION...]      charts speed against accuracy, and writes chart.json, chart.html and SVGs
  --out DIR        where to (default: build/chart beside the program's build tree)
  --quick          fewer turns: under two minutes
  --tiny           one turn, few pictures: for a test of the program itself
  --only SCENE     only this scene (may be repeated)
  --method NAME    only this method or driver beside the default and llvmpipe (may be repeated)
  --library FILE   the libOSMesa that is ours
  --list           prints scenes and methods
)";

struct Options {
  ChartOptions chart;
  conformance::Paths paths = conformance::Paths::of_this_build();
  std::string out;
  bool list = false;
};

Options parse_options(std::span<char*> arguments) {
  Options options;
  options.out = std::filesystem::path(options.paths.programs).parent_path() / "chart";
  for (conformance::OptionWords words(arguments); words.next();) {
    const std::string_view option = words.option();
    if (option == "--out") {
      options.out = words.value();
    } else if (option == "--quick") {
      options.chart.rounds = 3;
      options.chart.area_grid = 11;
      options.chart.least_sample_s = 0.002;
    } else if (option == "--tiny") {
      options.chart.rounds = 1;
      options.chart.area_grid = 2;
      options.chart.least_sample_s = 0;
    } else if (option == "--only") {
      options.chart.only.push_back(words.value());
    } else if (option == "--method") {
      options.chart.contestants.push_back(words.value());
    } else if (option == "--library") {
      options.paths.our_library = words.value();
    } else if (option == "--list") {
      options.list = true;
    } else if (option == "--help") {
      std::fputs(usage, stdout);
      std::exit(0);
    } else {
      words.refuse(usage);
    }
  }
  return options;
}

void print_list(const std::vector<Contestant>& contestants) {
  for (const ChartScene& scene : chart_scenes()) {
    std::printf("%-18s %s\n", std::string(scene.probe.name).c_str(), std::string(scene.probe.shows).c_str());
  }
  for (const Contestant& contestant : contestants) std::printf("%s\n", contestant.name.c_str());
}

void write_file(const std::filesystem::path& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

/// One line that is written over; lines below each other where stderr is no terminal.
void show_progress(const std::string& text) {
  if (::isatty(STDERR_FILENO)) {
    std::fprintf(stderr, "\rchart: %s\033[K", text.c_str());
  } else if (text.find("turn") == text.npos && text.find("picture") == text.npos) {
    std::fprintf(stderr, "chart: %s\n", text.c_str());
  }
}

void print_table(const std::string& title, std::vector<Point> points) {
  std::ranges::sort(points, {}, &Point::time);
  const std::vector<bool> on_front = front(points);
  std::printf("\n%-44s %9s %12s\n", title.c_str(), "time", "error");
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::printf("  %-42s %9.3f %12.6f%s\n", points[i].name.c_str(), points[i].time, points[i].error, on_front[i] ? "  front" : "");
  }
}

int run(std::span<char*> arguments) {
  Options options = parse_options(arguments);
  const std::vector<Contestant> contestants = all_contestants(options.paths);
  if (options.list) {
    print_list(contestants);
    return 0;
  }
  options.chart.progress = show_progress;
  const std::vector<SceneChart> charts = measure_chart(contestants, options.chart);
  if (charts.empty()) throw std::runtime_error("no scene is called so; --list names them");
  show_progress("writing " + options.out);
  if (::isatty(STDERR_FILENO)) std::fputc('\n', stderr);

  std::filesystem::create_directories(options.out);
  write_file(options.out + "/chart.json", chart_json(charts));
  write_file(options.out + "/chart.html", chart_html(charts));
  write_chart_plots(options.out, charts);

  for (const SceneChart& chart : charts) print_table(std::string(chart.scene->probe.name), points_of(chart, Axis::color));
  print_table("over all scenes with an exact reference", overall_points(charts, Axis::color));
  std::printf("\n");
  for (const std::string& line : front_report(charts)) std::printf("%s\n", line.c_str());
  if (front_report(charts).empty()) std::printf("the default lies on the front of every scene and over all, by every error\n");
  std::printf("%s/chart.html\n", options.out.c_str());
  return 0;
}

}  // namespace
}  // namespace gouraud::chart

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return gouraud::chart::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "chart: %s\n", error.what());
    return 2;
  }
}
