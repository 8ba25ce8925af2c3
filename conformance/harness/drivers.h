// The drivers of the suite, each in a process of its own, and many scenes through one of them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "conformance/harness/child_process.h"
#include "conformance/harness/judge.h"

namespace gouraud::conformance {

/// How to start a driver program, scene names to be appended, and what to call it.
struct Driver {
  std::string name;
  Command command;
};

/// Where the programs and our library lie.
struct Paths {
  std::string programs;                    ///< folder of conformance_driver and conformance_oracle_driver
  std::string our_library;                 ///< libOSMesa.so.8 of this build
  std::string mesa_library = "libOSMesa.so.8";  ///< found by the system's loader, LD_LIBRARY_PATH left out
  std::string emulator;                    ///< runs the build's programs where they are for another CPU; mostly empty
  /// Beside the running program, in the build tree.
  static Paths of_this_build();
};

/// Ours; the environment variables GOURAUD_SIMD and GOURAUD_THREADS if not empty; without coverage if `plain`.
struct OurSettings {
  std::string simd, threads;
  bool plain = false;
  std::vector<std::pair<std::string, std::string>> environment{};
};
Driver our_driver(const Paths& paths, const OurSettings& settings = {});

/// A new folder among the system's temporary ones, removed at the end with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// Mesa's, with the settings that make its pixels the same on every host (MESA-RULES 1). llvmpipe keeps the shaders
/// that it compiles in `shader_cache`, an empty folder: most of its time goes there, and scenes have many in common.
Driver llvmpipe_driver(const Paths& paths, const TemporaryFolder& shader_cache);
Driver softpipe_driver(const Paths& paths);
Driver oracle_driver(const Paths& paths);

using Renderings = std::map<std::string, Rendering, std::less<>>;

/// Draws the scenes through one process of the driver. A scene that brings the process down, or takes longer than two
/// minutes (half an hour under an emulator), fails; the scenes after it go to a new process. A driver that cannot start
/// fails them all.
Renderings render_all(const Driver& driver, const std::vector<std::string>& scene_names);

}  // namespace gouraud::conformance
