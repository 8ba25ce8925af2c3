#include "conformance/harness/drivers.h"

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <stdlib.h>

#include "conformance/harness/channel.h"

namespace gouraud::conformance {
namespace {

constexpr bool emulated = !std::string_view(CONFORMANCE_EMULATOR).empty();
constexpr int scene_time_limit_s = emulated ? 1800 : 120;  // an emulator on a busy machine is slow, not stuck

Command program_of_this_build(const Paths& paths, const std::string& name, const std::vector<std::string>& arguments) {
  const std::string program = paths.programs + "/" + name;
  Command command{paths.emulator.empty() ? program : paths.emulator, {}, {}, {}, false};
  if (!paths.emulator.empty()) command.arguments.push_back(program);
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  return command;
}

Driver mesa_driver(const Paths& paths, const std::string& name) {
  Driver driver{name, program_of_this_build(paths, "conformance_driver", {paths.mesa_library, name})};
  driver.command.dropped_environment = {"GALLIUM_", "GALLIVM_", "LP_", "MESA_", "LD_LIBRARY_PATH", "LD_PRELOAD"};
  driver.command.environment = {{"GALLIUM_DRIVER", name},
                                // Mesa's own leaks and races are not what our sanitizer builds look for.
                                {"ASAN_OPTIONS", "detect_leaks=0"},
                                {"TSAN_OPTIONS", "report_bugs=0"}};
  return driver;
}

/// Reads results into `renderings` until the process ends or fails. Returns the scene at fault, absent if all is well
/// or the process failed before its first scene; `failure` says how it ended.
std::optional<std::string> collect(ChildProcess& process, Renderings& renderings, std::string& failure) {
  Reader in(process.read_fd(), scene_time_limit_s);
  std::optional<std::string> scene;
  try {
    while (true) {
      scene.reset();
      scene = in.text();
      Rendering rendering;
      if (in.value<bool>()) {
        rendering.picture = in.picture();
      } else {
        rendering.failure = in.text();
      }
      renderings[*scene] = std::move(rendering);
    }
  } catch (const ChannelClosed&) {
    failure = process.wait();
  } catch (const ChannelTimeout& timeout) {
    process.kill();
    failure = timeout.what();
  }
  return scene;
}

}  // namespace

Paths Paths::of_this_build() {
  const std::filesystem::path programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  Paths paths;
  paths.programs = programs;
  paths.our_library = programs.parent_path() / "lib" / "libOSMesa.so.8";
  paths.emulator = CONFORMANCE_EMULATOR;
  return paths;
}

Driver our_driver(const Paths& paths, const OurSettings& settings) {
  Driver driver{"ours", program_of_this_build(paths, "conformance_driver", {})};
  driver.command.environment = settings.environment;
  if (settings.plain) driver.command.arguments.push_back("--plain");
  driver.command.arguments.push_back(paths.our_library);
  driver.command.arguments.push_back("Gouraud");
  if (!settings.simd.empty()) driver.command.environment.emplace_back("GOURAUD_SIMD", settings.simd);
  if (!settings.threads.empty()) driver.command.environment.emplace_back("GOURAUD_THREADS", settings.threads);
  return driver;
}

TemporaryFolder::TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "gouraud-conformance-XXXXXX") {
  if (::mkdtemp(path_.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder " + path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

Driver llvmpipe_driver(const Paths& paths, const TemporaryFolder& shader_cache) {
  Driver driver = mesa_driver(paths, "llvmpipe");
  driver.command.environment.emplace_back("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1");
  driver.command.environment.emplace_back("GALLIVM_PERF", "no_aos_sampling");
  driver.command.environment.emplace_back("LP_NUM_THREADS", "0");
  driver.command.environment.emplace_back("MESA_SHADER_CACHE_DIR", shader_cache.path());
  return driver;
}

Driver softpipe_driver(const Paths& paths) { return mesa_driver(paths, "softpipe"); }

Driver oracle_driver(const Paths& paths) {
  Driver driver{"oracle", program_of_this_build(paths, "conformance_oracle_driver", {})};
  driver.command.environment = {{"GOURAUD_THREADS", "1"}};
  return driver;
}

Renderings render_all(const Driver& driver, const std::vector<std::string>& scene_names) {
  Renderings renderings;
  std::vector<std::string> missing = scene_names;
  while (!missing.empty()) {
    Command command = driver.command;
    command.arguments.insert(command.arguments.end(), missing.begin(), missing.end());
    std::string failure;
    std::optional<std::string> culprit;
    const std::size_t before = renderings.size();
    try {
      ChildProcess process(command);
      culprit = collect(process, renderings, failure);
    } catch (const std::runtime_error& error) {
      failure = error.what();
    }

    if (culprit) renderings[*culprit] = {std::nullopt, "the driver's process ended: " + failure};
    const bool no_progress = renderings.size() == before;
    std::erase_if(missing, [&](const std::string& name) { return renderings.contains(name); });
    if (no_progress) {
      for (const std::string& name : missing) renderings[name] = {std::nullopt, "the driver does not run: " + failure};
      missing.clear();
    }
    // A process that ends badly after its last scene (a sanitizer's leak report, a crash in a destructor) is a failure.
    if (missing.empty() && !culprit && !no_progress && !failure.empty()) {
      renderings[scene_names.back()] = {std::nullopt, "after the last scene the driver's process ended: " + failure};
    }
  }
  return renderings;
}

}  // namespace gouraud::conformance
