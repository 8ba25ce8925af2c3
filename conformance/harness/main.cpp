// conformance: every scene through ours, llvmpipe, softpipe and the oracle, compared and judged. See usage below.

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <functional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <fnmatch.h>

#include "conformance/harness/accepted.h"
#include "conformance/harness/drivers.h"
#include "conformance/harness/hash_check.h"
#include "conformance/harness/options.h"
#include "conformance/harness/report.h"

namespace gouraud::conformance {
namespace {

constexpr const char* usage = R"(conformance [OPTION...]   draws every scene and judges the pictures
  --scene GLOB     only scenes whose name matches (may be repeated)
  --list           prints name, section and what each scene shows
  --report DIR     writes DIR/report.html: pictures, error maps, numbers
  --verbose        prints every measure of every scene
  --driver NAME    judges llvmpipe or softpipe in place of ours
  --no-oracle      leaves the oracle out
  --library FILE   the libOSMesa that is ours
  --accepted DIR   the accepted exceptions (default: the source tree's)
  --hashes         prints one hash a scene: of colour and depth, as ours draws it
  --check-hashes   the hashes must be the same for all instruction sets, thread counts and runs
  --update-hashes  writes the hashes to accepted/hashes.txt, which --check-hashes then compares with as well
)";

/// Scenes that are in memory at a time; a scene's pictures are about 6 MB.
constexpr std::size_t batch_size = 24;

struct Options {
  std::vector<std::string> globs;
  std::string report_folder, accepted_folder = CONFORMANCE_ACCEPTED_DIR, candidate = "ours";
  bool list = false, verbose = false, with_oracle = true;
  bool print_hashes = false, check_hashes = false, update_hashes = false;
  Paths paths = Paths::of_this_build();
};

Options parse_options(std::span<char*> arguments) {
  Options options;
  for (conformance::OptionWords words(arguments); words.next();) {
    const std::string_view option = words.option();
    if (option == "--scene") {
      options.globs.push_back(words.value());
    } else if (option == "--report") {
      options.report_folder = words.value();
    } else if (option == "--driver") {
      options.candidate = words.value();
    } else if (option == "--library") {
      options.paths.our_library = words.value();
    } else if (option == "--accepted") {
      options.accepted_folder = words.value();
    } else if (option == "--list") {
      options.list = true;
    } else if (option == "--verbose") {
      options.verbose = true;
    } else if (option == "--no-oracle") {
      options.with_oracle = false;
    } else if (option == "--hashes") {
      options.print_hashes = true;
    } else if (option == "--check-hashes") {
      options.check_hashes = true;
    } else if (option == "--update-hashes") {
      options.update_hashes = true;
    } else if (option == "--help") {
      std::fputs(usage, stdout);
      std::exit(0);
    } else {
      words.refuse(usage);
    }
  }
  return options;
}

bool matches(const Scene& scene, const std::vector<std::string>& globs) {
  const std::string name(scene.name);
  return globs.empty() ||
         std::ranges::any_of(globs, [&](const std::string& glob) { return ::fnmatch(glob.c_str(), name.c_str(), 0) == 0; });
}

std::vector<const Scene*> chosen_scenes(const Options& options) {
  std::vector<const Scene*> scenes;
  std::set<std::string_view> names;
  for (const Scene& scene : all_scenes()) {
    if (!names.insert(scene.name).second) {
      throw std::runtime_error("two scenes are called " + std::string(scene.name));
    }
    if (matches(scene, options.globs)) scenes.push_back(&scene);
  }
  if (scenes.empty()) throw std::runtime_error("no scene matches");
  return scenes;
}

std::vector<std::string> names_of(std::span<const Scene* const> scenes) {
  std::vector<std::string> names;
  for (const Scene* scene : scenes) names.emplace_back(scene->name);
  return names;
}

Driver candidate_driver(const Options& options, const TemporaryFolder& shader_cache) {
  if (options.candidate == "ours") return our_driver(options.paths);
  if (options.candidate == "llvmpipe") return llvmpipe_driver(options.paths, shader_cache);
  if (options.candidate == "softpipe") return softpipe_driver(options.paths);
  throw std::runtime_error("no driver is called " + options.candidate);
}

/// The batch through every driver, all at once.
std::vector<SceneRenderings> render_batch(const Options& options, const TemporaryFolder& shader_cache,
                                          std::span<const Scene* const> scenes) {
  const std::vector<std::string> names = names_of(scenes);
  Renderings ours, llvmpipe, softpipe, oracle;
  {
    std::vector<std::jthread> threads;
    const auto start = [&](const Driver& driver, Renderings& into) {
      threads.emplace_back([&names, driver, &into] { into = render_all(driver, names); });
    };
    start(candidate_driver(options, shader_cache), ours);
    start(llvmpipe_driver(options.paths, shader_cache), llvmpipe);
    start(softpipe_driver(options.paths), softpipe);
    if (options.with_oracle) start(oracle_driver(options.paths), oracle);
  }
  std::vector<SceneRenderings> result;
  for (const std::string& name : names) {
    SceneRenderings& renderings = result.emplace_back();
    renderings.ours = std::move(ours[name]);
    renderings.llvmpipe = std::move(llvmpipe[name]);
    renderings.softpipe = std::move(softpipe[name]);
    if (options.with_oracle) renderings.oracle = std::move(oracle[name]);
  }
  return result;
}

void print_result(const SceneResult& result, bool verbose) {
  std::printf("%s\n", summary_line(result).c_str());
  for (const std::string& complaint : result.verdict.complaints) std::printf("       %s\n", complaint.c_str());
  if (verbose) {
    for (const Measure& measure : result.verdict.measures) {
      std::printf("       %-22s %-12.6g %s\n", std::string(measure.key).c_str(), measure.value,
                  std::string(measure.says).c_str());
    }
  }
  std::fflush(stdout);
}

int judge_scenes(const Options& options, std::span<const Scene* const> scenes) {
  const auto accepted = read_accepted(options.accepted_folder);
  for (const auto& [name, exceptions] : accepted) {
    if (std::ranges::find(all_scenes(), name, &Scene::name) == all_scenes().end()) {
      throw std::runtime_error("accepted/" + name + ".md: no scene is called so");
    }
  }

  const TemporaryFolder shader_cache;
  Report report(options.candidate);
  int passed = 0, failed = 0;
  std::printf("%s", summary_header().c_str());
  for (std::size_t first = 0; first < scenes.size(); first += batch_size) {
    const auto batch = scenes.subspan(first, std::min(batch_size, scenes.size() - first));
    std::vector<SceneRenderings> renderings = render_batch(options, shader_cache, batch);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const auto exceptions = accepted.find(batch[i]->name);
      const bool listed = exceptions != accepted.end();
      SceneResult result{batch[i], std::move(renderings[i]), {}, listed ? exceptions->second.reason : ""};
      result.verdict = judge(*batch[i], result.renderings, listed ? &exceptions->second : nullptr);
      ++(result.verdict.passed() ? passed : failed);
      print_result(result, options.verbose);
      if (!options.report_folder.empty()) report.add(result);
    }
  }
  if (!options.report_folder.empty()) report.write(options.report_folder);
  std::printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}

int run(std::span<char*> arguments) {
  const Options options = parse_options(arguments);
  const std::vector<const Scene*> scenes = chosen_scenes(options);
  const std::string hash_file = options.accepted_folder + "/hashes.txt";
  if (options.list) {
    for (const Scene* scene : scenes) {
      std::printf("%-34s %-9s %s\n", std::string(scene->name).c_str(), std::string(scene->section).c_str(),
                  std::string(scene->shows).c_str());
    }
    return 0;
  }
  if (options.print_hashes) {
    std::printf("%s", to_text(hash_scenes(options.paths, {"", "", true}, names_of(scenes))).c_str());
    return 0;
  }
  if (options.update_hashes) {
    if (!options.globs.empty()) throw std::runtime_error("--update-hashes writes all scenes; leave --scene out");
    std::ofstream file(hash_file);
    file << to_text(hash_scenes(options.paths, {"", "", true}, names_of(scenes)));
    if (!file.flush()) throw std::runtime_error("cannot write " + hash_file);
    return 0;
  }
  if (options.check_hashes) return check_hashes(options.paths, names_of(scenes), hash_file) ? 0 : 1;
  return judge_scenes(options, scenes);
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return gouraud::conformance::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "conformance: %s\n", error.what());
    return 2;
  }
}
