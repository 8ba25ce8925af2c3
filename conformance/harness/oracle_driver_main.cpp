// conformance_oracle_driver SCENE...
//
// Draws scenes through the state machine of the static library `gouraud`, watched by the oracle, and writes the oracle's
// pictures to file descriptor 3. What the pipeline itself renders meanwhile is not looked at.

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "api/gouraud.h"
#include "conformance/harness/linked_osmesa.h"
#include "conformance/harness/offscreen.h"
#include "conformance/harness/render_scene.h"
#include "conformance/oracle/oracle.h"

namespace gouraud::conformance {
namespace {

Picture picture_of(const oracle::OraclePicture& exact) {
  Picture picture;
  picture.width_px = exact.width_px;
  picture.height_px = exact.height_px;
  picture.depth_bits = exact.depth_bits;
  for (std::size_t i = 0; i < exact.pixels.size(); ++i) {
    const oracle::OraclePixel& pixel = exact.pixels[i];
    picture.rgba.insert(picture.rgba.end(), pixel.color_unorm8.begin(), pixel.color_unorm8.end());
    if (exact.depth_bits > 0) picture.depth.push_back(pixel.depth_stored);
    picture.covered.push_back(exact.fragments_written[i] > 0 ? 1 : 0);
  }
  picture.exact = exact;
  return picture;
}

Picture watch_scene(const Scene& scene) {
  OffscreenContext context(linked_osmesa, scene.width_px, scene.height_px, scene.depth_bits);
  oracle::Oracle oracle;
  if (!set_draw_observer(&oracle)) throw std::runtime_error("set_draw_observer found no context");
  scene.draw(context.gl());
  context.gl().Finish();
  set_draw_observer(nullptr);
  return picture_of(oracle.picture());
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  try {
    return gouraud::conformance::serve_scenes({argv + 1, argv + argc}, gouraud::conformance::watch_scene);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "conformance_oracle_driver: %s\n", error.what());
    return 2;
  }
}
