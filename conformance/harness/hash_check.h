// The same bits everywhere: one hash a scene over instruction sets, thread counts and runs.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "conformance/harness/drivers.h"

namespace gouraud::conformance {

using Hashes = std::map<std::string, std::string>;  ///< scene name -> 16 hexadecimal digits

/// Hashes of our pictures under these settings; throws std::runtime_error if a scene is not drawn.
Hashes hash_scenes(const Paths& paths, const OurSettings& settings, const std::vector<std::string>& scene_names);

/// Lines `name hash`, as `conformance --hashes` prints them and accepted/hashes.txt holds them.
std::string to_text(const Hashes& hashes);
Hashes parse_hashes(const std::string& text);

/// Draws the scenes with every instruction set that this CPU has times 1, 2 and 16 threads, once more as at first, and
/// once with a C library held to what an old CPU has; prints a line for each and for each scene whose hash differs from
/// the first run's or from `reference_file` (if that exists). Returns true if none does.
bool check_hashes(const Paths& paths, const std::vector<std::string>& scene_names, const std::string& reference_file);

}  // namespace gouraud::conformance
