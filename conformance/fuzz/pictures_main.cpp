// fuzz_pictures LIBRARY SEED COUNT [FEATURES]
//
// Draws random pictures of the seeds from SEED on through a libOSMesa. Of each it writes on stdout a line
// "SEED FEATURES NAMES...", then picture_side_px^2 pixels of RGBA in bytes, depth in 32 bits, stencil in bytes; where the
// library brought its process down, the line alone, with "crashed" behind it. FEATURES, a mask in hexadecimal, is taken
// instead of those that the seed chooses.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include "conformance/fuzz/pictures.h"
#include "conformance/harness/offscreen.h"

namespace gouraud::conformance {
namespace {

constexpr rlim_t longest_s = 20;  // of processor time
constexpr std::size_t pixels = static_cast<std::size_t>(picture_side_px) * picture_side_px;

std::string title(std::uint32_t seed, std::uint64_t features) {
  char text[64];
  std::snprintf(text, sizeof text, "%u %llx", seed, static_cast<unsigned long long>(features));
  std::string line = text;
  for (std::size_t i = 0; i < all_features().size(); ++i) {
    if (features >> i & 1) line += std::string(" ") + all_features()[i].name;
  }
  return line;
}

void write_picture(const OsmesaFunctions& osmesa, std::uint32_t seed, std::uint64_t features) {
  OffscreenContext context(osmesa, picture_side_px, picture_side_px, 24);
  const GlTable& gl = context.gl();
  draw_picture(gl, seed, features);
  std::vector<GLuint> depth(pixels);
  std::vector<GLubyte> stencil(pixels);
  gl.ReadPixels(0, 0, picture_side_px, picture_side_px, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depth.data());
  gl.ReadPixels(0, 0, picture_side_px, picture_side_px, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencil.data());
  const Picture picture = context.read();
  std::printf("%s\n", title(seed, features).c_str());
  std::fwrite(picture.rgba.data(), 1, picture.rgba.size(), stdout);
  std::fwrite(depth.data(), sizeof depth[0], depth.size(), stdout);
  std::fwrite(stencil.data(), 1, stencil.size(), stdout);
  std::fflush(stdout);
}

/// In a process of its own: Mesa does not survive all that is asked of it.
void run(const OsmesaFunctions& osmesa, std::uint32_t seed, std::uint64_t features) {
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    const rlimit longest{longest_s, longest_s};
    ::setrlimit(RLIMIT_CPU, &longest);
    write_picture(osmesa, seed, features);
    std::_Exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (status != 0) {
    std::printf("%s crashed\n", title(seed, features).c_str());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  using namespace gouraud::conformance;
  try {
    if (argc != 4 && argc != 5) throw std::runtime_error("usage: fuzz_pictures LIBRARY SEED COUNT [FEATURES]");
    const OsmesaFunctions osmesa = load_osmesa(argv[1]);
    const auto first = static_cast<std::uint32_t>(std::strtoul(argv[2], nullptr, 10));
    const auto count = static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10));
    for (std::uint32_t seed = first; seed != first + count; ++seed) {
      run(osmesa, seed, argc == 5 ? std::strtoull(argv[4], nullptr, 16) : choose_features(seed));
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz_pictures: %s\n", error.what());
    return 2;
  }
}
