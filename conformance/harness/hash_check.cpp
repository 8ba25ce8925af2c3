#include "conformance/harness/hash_check.h"

#include <cinttypes>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace gouraud::conformance {
namespace {

struct Configuration {
  std::string name;
  OurSettings settings;
};

/// Values of GOURAUD_SIMD that this CPU has (pipeline/simd/dispatch.h); what it has not would silently be its best.
std::vector<std::string> instruction_sets() {
  std::vector<std::string> result{"baseline"};
#if defined(__x86_64__) || defined(__i386__)
  if (__builtin_cpu_supports("sse4.2")) result.push_back("sse4");
#endif
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) result.push_back("avx2");
  if (__builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl")) result.push_back("avx512");
#endif
  return result;
}

std::vector<Configuration> configurations() {
  std::vector<Configuration> result;
  for (const std::string& simd : instruction_sets()) {
    for (const char* threads : {"1", "2", "16"}) {
      result.push_back({simd + ", " + threads + (threads[1] == 0 && threads[0] == '1' ? " thread" : " threads"),
                        {simd, threads, true}});
    }
  }
  result.push_back({result.front().name + ", again", result.front().settings});
#if defined(__x86_64__)
  // glibc chooses sin, cos and the rest by the CPU; pictures must not hang on the last bit of those.
  OurSettings old_cpu{"", "1", true, {{"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F"}}};
  result.push_back({"best, 1 thread, C library without FMA", old_cpu});
#endif
  return result;
}

/// Prints what differs; returns true if nothing does.
bool same_hashes(const Hashes& expected, const Hashes& found, const std::string& against) {
  bool same = true;
  for (const auto& [scene, hash] : found) {
    const auto other = expected.find(scene);
    if (other == expected.end()) {
      std::printf("       %s has no hash in %s\n", scene.c_str(), against.c_str());
    } else if (other->second != hash) {
      std::printf("       %s: %s, but %s in %s\n", scene.c_str(), hash.c_str(), other->second.c_str(), against.c_str());
    } else {
      continue;
    }
    same = false;
  }
  return same;
}

}  // namespace

Hashes hash_scenes(const Paths& paths, const OurSettings& settings, const std::vector<std::string>& scene_names) {
  Hashes hashes;
  for (const auto& [name, rendering] : render_all(our_driver(paths, settings), scene_names)) {
    if (!rendering.picture) throw std::runtime_error(name + ": " + rendering.failure);
    char text[17];
    std::snprintf(text, sizeof(text), "%016" PRIx64, hash(*rendering.picture));
    hashes[name] = text;
  }
  return hashes;
}

std::string to_text(const Hashes& hashes) {
  std::string text;
  for (const auto& [scene, hash] : hashes) text += scene + " " + hash + "\n";
  return text;
}

Hashes parse_hashes(const std::string& text) {
  Hashes hashes;
  std::istringstream words(text);
  for (std::string scene, hash; words >> scene >> hash;) hashes[scene] = hash;
  return hashes;
}

bool check_hashes(const Paths& paths, const std::vector<std::string>& scene_names, const std::string& reference_file) {
  bool all_same = true;
  std::string reference_name = reference_file;
  Hashes reference;
  if (std::ifstream file(reference_file); file) {
    std::ostringstream text;
    text << file.rdbuf();
    reference = parse_hashes(text.str());
  }
  for (const auto& [name, settings] : configurations()) {
    const Hashes hashes = hash_scenes(paths, settings, scene_names);
    if (reference.empty()) {
      reference = hashes;
      reference_name = "the first run (" + name + ")";
    }
    const bool same = same_hashes(reference, hashes, reference_name);
    all_same = all_same && same;
    std::printf("%s %s: %zu scenes\n", same ? "same  " : "DIFFER", name.c_str(), hashes.size());
    std::fflush(stdout);
  }
  return all_same;
}

}  // namespace gouraud::conformance
