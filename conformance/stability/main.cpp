// stability: every sweep, with the default, the methods concerned, llvmpipe and softpipe. See usage below.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/harness/options.h"
#include "conformance/stability/report.h"

namespace gouraud::stability {
namespace {

constexpr const char* usage = R"(stability [OPTION...]   turns one knob after the other until things break
  --out DIR        where the plots go (default: build/stability beside the program's build tree)
  --only SWEEP     only this sweep (may be repeated)
  --method NAME    only these contestants (may be repeated)
  --tables         prints all numbers
  --library FILE   the libOSMesa that is ours
  --list           prints the sweeps
)";

struct Options {
  conformance::Paths paths = conformance::Paths::of_this_build();
  std::string out;
  std::vector<std::string> only, contestants;
  bool tables = false, list = false;
};

Options parse_options(std::span<char*> arguments) {
  Options options;
  options.out = std::filesystem::path(options.paths.programs).parent_path() / "stability";
  for (conformance::OptionWords words(arguments); words.next();) {
    const std::string_view option = words.option();
    if (option == "--out") {
      options.out = words.value();
    } else if (option == "--only") {
      options.only.push_back(words.value());
    } else if (option == "--method") {
      options.contestants.push_back(words.value());
    } else if (option == "--library") {
      options.paths.our_library = words.value();
    } else if (option == "--tables") {
      options.tables = true;
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

bool is_wanted(const std::vector<std::string>& names, std::string_view name) {
  return names.empty() || std::ranges::find(names, name) != names.end();
}

int run(std::span<char*> arguments) {
  const Options options = parse_options(arguments);
  std::vector<probes::Contestant> contestants = probes::all_contestants(options.paths);
  std::erase_if(contestants, [&](const probes::Contestant& contestant) { return !is_wanted(options.contestants, contestant.name); });
  std::vector<SweepResult> results;
  for (const Sweep& sweep : all_sweeps()) {
    if (options.list) std::printf("%-24s %s\n", std::string(sweep.probe.name).c_str(), std::string(sweep.probe.shows).c_str());
    if (options.list || !is_wanted(options.only, sweep.probe.name)) continue;
    std::fprintf(stderr, "stability: %s\n", std::string(sweep.probe.name).c_str());
    SweepResult result{&sweep, run_sweep(sweep, contestants), {}};
    result.complaints = complaints(sweep, result.series);
    if (options.tables) {
      for (std::size_t measure = 0; measure < sweep.measures.size(); ++measure) std::printf("%s\n", table_of(result, measure).c_str());
    }
    results.push_back(std::move(result));
  }
  if (options.list) return 0;
  if (results.empty()) throw std::runtime_error("no sweep is called so; --list names them");
  std::filesystem::create_directories(options.out);
  write_report(options.out, results);
  bool all_hold = true;
  for (const SweepResult& result : results) {
    for (const std::string& complaint : result.complaints) {
      std::printf("%s\n", complaint.c_str());
      all_hold = false;
    }
  }
  std::printf("%s\n%s/stability.html\n", all_hold ? "all is as expected" : "not all is as expected", options.out.c_str());
  return all_hold ? 0 : 1;
}

}  // namespace
}  // namespace gouraud::stability

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return gouraud::stability::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stability: %s\n", error.what());
    return 2;
  }
}
