// necessity: what three pictures need, and what they would cost with everything enabled. See usage below.
//
// Runs itself under valgrind --tool=callgrind with GOURAUD_THREADS=1 and reads the instructions of two parts of each
// picture: the calls up to glFinish (vertices: immediate mode, transform, light, clip, setup) and glFinish (fragments:
// tiles, passes, the copy to the program's memory). The plans are those that GOURAUD_TRACE=plan prints.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <valgrind/callgrind.h>

#include "conformance/harness/drivers.h"
#include "conformance/harness/offscreen.h"
#include "conformance/speed/necessity_scenes.h"

namespace gouraud::speed {
namespace {

constexpr const char* usage = R"(necessity           prints Markdown: the plans of three pictures, and instructions a vertex and a fragment
necessity --library FILE   the libOSMesa that is ours
)";
constexpr std::array<const char*, 2> variants{"as it is", "everything enabled"};

struct Counts {
  double vertex_instructions = 0, fragment_instructions = 0;
  long vertices = 0, fragments = 0;
};

/// The child: draws one scene; under valgrind it leaves dumps named "vertices" and "fragments" for each pass, and prints
/// how many of both there were.
int draw(const std::string& library, const std::string& scene_name, bool everything) {
  const auto found = std::ranges::find(necessity_scenes(), scene_name, &NecessityScene::name);
  if (found == necessity_scenes().end()) throw std::runtime_error("no scene is called " + scene_name);
  const conformance::OsmesaFunctions osmesa = conformance::load_osmesa(library);
  conformance::OffscreenContext context(osmesa, necessity_width_px, necessity_height_px, 24);
  const GlTable& gl = context.gl();
  found->set(gl);
  if (everything) enable_everything(gl);

  long vertices = 0, fragments = 0;
  GLuint query = 0;
  gl.GenQueries(1, &query);
  // The first picture takes memory and counts samples; the second is measured.
  for (const bool is_measured : {false, true}) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    gl.Finish();
    for (const auto pass : found->passes) {
      take_vertex_count();
      if (!is_measured) gl.BeginQuery(GL_SAMPLES_PASSED, query);
      CALLGRIND_ZERO_STATS;
      pass(gl);
      if (is_measured) CALLGRIND_DUMP_STATS_AT("vertices");
      if (!is_measured) gl.EndQuery(GL_SAMPLES_PASSED);
      CALLGRIND_ZERO_STATS;
      gl.Finish();
      if (is_measured) CALLGRIND_DUMP_STATS_AT("fragments");
      if (is_measured) continue;
      vertices += take_vertex_count();
      GLuint passed = 0;
      gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &passed);
      fragments += passed;
    }
  }
  const GLenum error = gl.GetError();
  if (error != GL_NO_ERROR) throw std::runtime_error(scene_name + " raises a GL error");
  std::printf("%ld %ld\n", vertices, fragments);
  return 0;
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs this program as a child through the shell; its output and what it says on stderr go to files of the folder.
void run_child(const std::string& folder, const std::string& prefix, const std::string& library, std::string_view scene, bool everything) {
  const std::string self = std::filesystem::read_symlink("/proc/self/exe");
  const std::string command = "GOURAUD_THREADS=1 " + prefix + " '" + self + "' --draw '" + library + "' " + std::string(scene) +
                              (everything ? " everything" : " bare") + " > '" + folder + "/out' 2> '" + folder + "/err'";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command + "\n" + text_of(folder + "/err"));
}

Counts count(const std::string& library, std::string_view scene, bool everything) {
  const conformance::TemporaryFolder folder;
  run_child(folder.path(), "valgrind --quiet --tool=callgrind --callgrind-out-file='" + folder.path() + "/dump'", library, scene, everything);
  Counts counts;
  std::istringstream(text_of(folder.path() + "/out")) >> counts.vertices >> counts.fragments;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    const std::string text = text_of(entry.path());
    const std::size_t totals = text.find("\ntotals: ");
    if (totals == text.npos) continue;
    const double instructions = std::strtod(text.c_str() + totals + 9, nullptr);
    if (text.find("Client Request: vertices") != text.npos) counts.vertex_instructions += instructions;
    if (text.find("Client Request: fragments") != text.npos) counts.fragment_instructions += instructions;
  }
  if (counts.vertex_instructions == 0) throw std::runtime_error("valgrind left no dumps");
  return counts;
}

/// The stages of all plans of a picture, in order, without what follows their colon and their citations.
std::vector<std::string> stages_of(const std::string& library, std::string_view scene, bool everything) {
  const conformance::TemporaryFolder folder;
  run_child(folder.path(), "GOURAUD_TRACE=plan", library, scene, everything);
  std::vector<std::string> stages;
  std::istringstream lines(text_of(folder.path() + "/err"));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ")) continue;
    const std::size_t end = std::min({line.find(':'), line.find("  ", 2), line.size()});
    const std::string stage = line.substr(2, end - 2);
    // Samples are counted by the child itself.
    if (stage != "count samples" && std::ranges::find(stages, stage) == stages.end()) stages.push_back(stage);
  }
  if (stages.empty()) throw std::runtime_error("GOURAUD_TRACE=plan printed no plan");
  return stages;
}

void print_stages(const std::string& library) {
  std::vector<std::string> all;
  std::map<std::string_view, std::array<std::vector<std::string>, 2>> kept;
  for (const NecessityScene& scene : necessity_scenes()) {
    for (const bool everything : {true, false}) {
      auto& stages = kept[scene.name][everything ? 1 : 0];
      stages = stages_of(library, scene.name, everything);
      for (const std::string& stage : stages) {
        if (std::ranges::find(all, stage) == all.end()) all.push_back(stage);
      }
    }
  }
  std::printf("| stage of the plan |");
  for (const NecessityScene& scene : necessity_scenes()) std::printf(" %s |", std::string(scene.name).c_str());
  std::printf(" everything |\n|---|");
  for (std::size_t i = 0; i <= necessity_scenes().size(); ++i) std::printf(":-:|");
  std::printf("\n");
  const auto mark = [](const std::vector<std::string>& stages, const std::string& stage) {
    return std::ranges::find(stages, stage) != stages.end() ? " x |" : "   |";
  };
  for (const std::string& stage : all) {
    std::printf("| %s |", stage.c_str());
    bool in_everything = false;
    for (const NecessityScene& scene : necessity_scenes()) {
      std::printf("%s", mark(kept[scene.name][0], stage));
      in_everything = in_everything || std::ranges::find(kept[scene.name][1], stage) != kept[scene.name][1].end();
    }
    std::printf("%s\n", in_everything ? " x |" : "   |");
  }
}

void print_counts(const std::string& library) {
  std::printf("\n| scene | | vertices | fragments | instructions a vertex | instructions a fragment |\n|---|---|--:|--:|--:|--:|\n");
  for (const NecessityScene& scene : necessity_scenes()) {
    for (const bool everything : {false, true}) {
      const Counts counts = count(library, scene.name, everything);
      std::printf("| %s | %s | %ld | %ld | %.0f | %.1f |\n", everything ? "" : std::string(scene.shows).c_str(), variants[everything ? 1 : 0],
                  counts.vertices, counts.fragments, counts.vertex_instructions / static_cast<double>(counts.vertices),
                  counts.fragment_instructions / static_cast<double>(counts.fragments));
    }
  }
}

int run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 4 && arguments[0] == "--draw") return draw(arguments[1], arguments[2], arguments[3] == "everything");
  std::string library = conformance::Paths::of_this_build().our_library;
  if (arguments.size() == 2 && arguments[0] == "--library") {
    library = arguments[1];
  } else if (!arguments.empty()) {
    throw std::runtime_error(std::string("usage:\n") + usage);
  }
  print_stages(library);
  print_counts(library);
  return 0;
}

}  // namespace
}  // namespace gouraud::speed

int main(int argc, char** argv) {
  try {
    return gouraud::speed::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "necessity: %s\n", error.what());
    return 2;
  }
}
