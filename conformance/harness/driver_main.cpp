// conformance_driver [--plain] LIBRARY RENDERER SCENE...
//
// Draws scenes through a libOSMesa and writes the pictures to file descriptor 3. RENDERER is a word that GL_RENDERER
// must contain: a missing GALLIUM_DRIVER or a wrong library must not pass for another driver. --plain leaves coverage out.

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "conformance/harness/offscreen.h"
#include "conformance/harness/render_scene.h"

namespace gouraud::conformance {
namespace {

void check_renderer(const OsmesaFunctions& osmesa, const std::string& expected) {
  OffscreenContext context(osmesa, 8, 8, 24);
  const GLubyte* const text = context.gl().GetString(GL_RENDERER);
  const std::string renderer = text == nullptr ? "(null)" : reinterpret_cast<const char*>(text);
  if (renderer.find(expected) == std::string::npos) {
    throw std::runtime_error("GL_RENDERER is \"" + renderer + "\", not \"" + expected + "\"");
  }
}

int run(std::vector<std::string> arguments) {
  CoverageWanted coverage = CoverageWanted::yes;
  if (!arguments.empty() && arguments.front() == "--plain") {
    coverage = CoverageWanted::no;
    arguments.erase(arguments.begin());
  }
  if (arguments.size() < 2) throw std::runtime_error("usage: conformance_driver [--plain] LIBRARY RENDERER SCENE...");
  const OsmesaFunctions osmesa = load_osmesa(arguments[0]);
  check_renderer(osmesa, arguments[1]);
  return serve_scenes({arguments.begin() + 2, arguments.end()},
                      [&](const Scene& scene) { return render_scene(osmesa, scene, coverage); });
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  try {
    return gouraud::conformance::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "conformance_driver: %s\n", error.what());
    return 2;
  }
}
