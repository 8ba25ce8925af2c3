// speed: ours and llvmpipe against the clock, in one run. See usage below.
//
// Each runs in processes of its own, one on one core (GOURAUD_THREADS=1, LP_NUM_THREADS=0) and one on all cores, as it
// ships; frames are drawn in turns, so that what slows the machine slows all. Medians are reported, nothing is asserted.

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "conformance/harness/channel.h"
#include "conformance/harness/child_process.h"
#include "conformance/harness/drivers.h"
#include "conformance/harness/options.h"
#include "conformance/speed/measure.h"
#include "conformance/speed/workloads.h"

namespace gouraud::speed {
namespace {

using conformance::ChildProcess;
using conformance::Command;
using conformance::Paths;
using conformance::Reader;
using conformance::Writer;

constexpr const char* usage = R"(speed [OPTION...]    times ours and llvmpipe, in turns, and prints medians
  --only NAME      only this workload (may be repeated)
  --repeat N       timed frames of each (default 9)
  --quick          three frames of each
  --json FILE      writes the figures as JSON as well
  --library FILE   the libOSMesa that is ours
  --list           prints the workloads
)";

constexpr int warm_up_frames = 2;
constexpr int answer_limit_s = 120;
constexpr std::string_view fresh_process = "first_frame_process";
constexpr std::string_view first_load = "first_frame";
constexpr std::string_view fresh_context = "fresh_context";

struct Options {
  std::vector<std::string> only;
  int repeat = 9;
  std::string json_file;
  bool list = false;
  Paths paths = Paths::of_this_build();
  bool wants(std::string_view name) const { return only.empty() || std::ranges::find(only, name) != only.end(); }
};

Options parse_options(std::span<char*> arguments) {
  Options options;
  for (conformance::OptionWords words(arguments); words.next();) {
    const std::string_view option = words.option();
    if (option == "--only") {
      options.only.push_back(words.value());
    } else if (option == "--repeat") {
      options.repeat = std::max(1, std::stoi(words.value()));
    } else if (option == "--quick") {
      options.repeat = 3;
    } else if (option == "--json") {
      options.json_file = words.value();
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

enum Contestant { ours_one_core, llvmpipe_one_core, ours_all_cores, llvmpipe_all_cores, contestant_count };
constexpr std::array<std::string_view, contestant_count> contestant_names{"ours, one core", "llvmpipe, one core",
                                                                          "ours, all cores", "llvmpipe, all cores"};

Command command_of(const Paths& paths, Contestant contestant) {
  const bool ours = contestant == ours_one_core || contestant == ours_all_cores;
  const bool one_core = contestant == ours_one_core || contestant == llvmpipe_one_core;
  Command command{paths.programs + "/speed_driver", {}, {}, {}, false};
  // As they ship: no settings from outside but the number of threads.
  command.dropped_environment = {"GALLIUM_", "GALLIVM_", "LP_", "MESA_", "GOURAUD_", "LD_LIBRARY_PATH", "LD_PRELOAD"};
  if (ours) {
    command.arguments = {paths.our_library, "Gouraud"};
    if (one_core) command.environment = {{"GOURAUD_THREADS", "1"}};
  } else {
    command.arguments = {paths.mesa_library, "llvmpipe"};
    command.environment = {{"GALLIUM_DRIVER", "llvmpipe"}};
    if (one_core) command.environment.emplace_back("LP_NUM_THREADS", "0");
  }
  return command;
}

class SpeedDriver {
 public:
  explicit SpeedDriver(const Command& command)
      : process_(command), in_(process_.read_fd(), answer_limit_s), out_(process_.write_fd()) {}

  void begin(std::string_view workload) {
    out_.value(Request::begin);
    out_.text(workload);
    in_.value<bool>();
  }
  Sample run(Request request) {
    out_.value(request);
    return in_.value<Sample>();
  }

 private:
  ChildProcess process_;
  Reader in_;
  Writer out_;
};

/// Medians by contestant.
struct Row {
  std::string name, what;
  std::array<Sample, contestant_count> medians;
};

/// Lets all contestants do `take` in turns: first to warm up, then timed.
template <class Take>
Row in_turns(std::string_view name, std::string_view what, int repeat, Take take) {
  std::array<std::vector<Sample>, contestant_count> samples;
  for (int turn = -warm_up_frames; turn < repeat; ++turn) {
    for (std::size_t contestant = 0; contestant < contestant_count; ++contestant) {
      const Sample sample = take(static_cast<Contestant>(contestant));
      if (turn >= 0) samples[contestant].push_back(sample);
    }
  }
  Row row{std::string(name), std::string(what), {}};
  std::ranges::transform(samples, row.medians.begin(), median);
  return row;
}

/// A fresh process up to its first frame: since it was started, and since it began to load the library.
struct FirstFrame {
  Sample since_start, since_main;
};

FirstFrame time_first_frame(Command command) {
  command.arguments.insert(command.arguments.begin(), "--first-frame");
  const Sample spawned = now();
  ChildProcess process(command);
  Reader in(process.read_fd(), answer_limit_s);
  const auto start = in.value<Sample>();
  const auto end = in.value<Sample>();
  process.wait();
  // The child's processor clock began at zero with the child.
  return {{end.cpu_s, end.wall_s - spawned.wall_s}, end - start};
}

void print_row(const Row& row, Contestant ours, Contestant llvmpipe) {
  constexpr double ms = 1000.0;
  const Sample& a = row.medians[ours];
  const Sample& b = row.medians[llvmpipe];
  std::printf("%-34s %9.2f %9.2f %6.2fx   %9.2f %9.2f %6.2fx\n", row.what.c_str(), ms * a.cpu_s, ms * b.cpu_s,
              b.cpu_s / a.cpu_s, ms * a.wall_s, ms * b.wall_s, b.wall_s / a.wall_s);
}

void print_tables(const std::vector<Row>& rows) {
  const unsigned cores = std::thread::hardware_concurrency();
  for (const bool one_core : {true, false}) {
    const std::string title = one_core ? "one core" : "all cores (" + std::to_string(cores) + ")";
    std::printf("\n%-34s %27s   %27s\n", title.c_str(), "processor time, ms", "time on the wall, ms");
    std::printf("%-34s %9s %9s %7s   %9s %9s %7s\n", "", "ours", "llvmpipe", "", "ours", "llvmpipe", "");
    for (const Row& row : rows) {
      print_row(row, one_core ? ours_one_core : ours_all_cores, one_core ? llvmpipe_one_core : llvmpipe_all_cores);
    }
  }
}

void write_json(const std::string& path, const std::vector<Row>& rows, int repeat) {
  std::ofstream out(path);
  out << "{\"cores\": " << std::thread::hardware_concurrency() << ", \"repeat\": " << repeat << ", \"medians_s\": [";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n") << "  {\"workload\": \"" << rows[i].name << "\"";
    for (std::size_t contestant = 0; contestant < contestant_count; ++contestant) {
      const Sample& sample = rows[i].medians[contestant];
      out << ", \"" << contestant_names[contestant] << "\": {\"cpu\": " << sample.cpu_s << ", \"wall\": " << sample.wall_s
          << "}";
    }
    out << "}";
  }
  out << "\n]}\n";
  if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

std::vector<Row> measure(const Options& options) {
  std::vector<Row> rows;
  const auto announce = [](std::string_view name) {
    std::fprintf(stderr, "speed: %s\n", std::string(name).c_str());
  };

  std::vector<std::unique_ptr<SpeedDriver>> drivers;
  for (std::size_t contestant = 0; contestant < contestant_count; ++contestant) {
    drivers.push_back(std::make_unique<SpeedDriver>(command_of(options.paths, static_cast<Contestant>(contestant))));
  }
  for (const Workload& workload : all_workloads()) {
    if (!options.wants(workload.name)) continue;
    announce(workload.name);
    for (const auto& driver : drivers) driver->begin(workload.name);
    rows.push_back(in_turns(workload.name, workload.what, options.repeat,
                            [&](Contestant contestant) { return drivers[contestant]->run(Request::frame); }));
  }
  if (options.wants(fresh_context)) {
    announce(fresh_context);
    rows.push_back(in_turns(fresh_context, "new context to first frame", options.repeat,
                            [&](Contestant contestant) { return drivers[contestant]->run(Request::context); }));
  }
  if (options.wants(first_load)) {
    announce(first_load);
    rows.push_back(in_turns(first_load, "dlopen to first frame", options.repeat, [&](Contestant contestant) {
      return time_first_frame(command_of(options.paths, contestant)).since_main;
    }));
  }
  if (options.wants(fresh_process)) {
    announce(fresh_process);
    rows.push_back(in_turns(fresh_process, "process start to first frame", options.repeat, [&](Contestant contestant) {
      return time_first_frame(command_of(options.paths, contestant)).since_start;
    }));
  }
  return rows;
}

int run(std::span<char*> arguments) {
  const Options options = parse_options(arguments);
  if (options.list) {
    for (const Workload& workload : all_workloads()) {
      std::printf("%-22s %s\n", std::string(workload.name).c_str(), std::string(workload.what).c_str());
    }
    for (const std::string_view name : {fresh_context, first_load, fresh_process}) {
      std::printf("%s\n", std::string(name).c_str());
    }
    return 0;
  }
  const std::vector<Row> rows = measure(options);
  if (rows.empty()) throw std::runtime_error("no workload is called so; --list names them");
  print_tables(rows);
  if (!options.json_file.empty()) write_json(options.json_file, rows, options.repeat);
  return 0;
}

}  // namespace
}  // namespace gouraud::speed

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return gouraud::speed::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed: %s\n", error.what());
    return 2;
  }
}
