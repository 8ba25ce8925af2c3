// off_is_free LIBRARY
//
// Draws two fixed scenes through a libOSMesa with each feature's parameters set and the feature off. Run it under
// valgrind --tool=callgrind with GOURAUD_THREADS=1 (off_is_free.py does): it writes a dump for each picture, called
// SCENE, FEATURE and "set" or "unset", which holds the instructions of drawing alone.
#include <array>
#include <cstdio>
#include <exception>
#include <string>

#include <valgrind/callgrind.h>

#include "conformance/harness/offscreen.h"
#include "conformance/scenes/shapes.h"
#include "conformance/stability/off_features.h"

namespace gouraud::conformance {
namespace {

constexpr int side_px = 128;

/// Lit, depth-tested spheres, through glBegin.
void draw_lit(const GlTable& gl) {
  static const Surface ball = sphere(0.8f, 12, 24);
  clear_background(gl);
  gl.PushMatrix();
  for (int i = 0; i < 3; ++i) {
    gl.Color4f(0.2f * static_cast<float>(i), 0.5f, 0.8f, 1.0f);
    draw_surface(gl, ball);
    gl.Translatef(0.3f, 0.2f, -0.4f);
  }
  gl.PopMatrix();
  gl.Finish();
}

void set_lit(const GlTable& gl) {
  look(gl, {});
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
}

/// Gouraud triangles, lines and points without lighting and depth.
void draw_plain(const GlTable& gl) {
  clear_background(gl);
  Random random(7);
  for (const GLenum mode : {GL_TRIANGLES, GL_QUADS, GL_LINES, GL_POINTS}) {
    gl.Begin(mode);
    for (int i = 0; i < 240; ++i) {
      color_of(gl, random);
      const float x = random.range(-1, 1), y = random.range(-1, 1), z = random.range(-1, 1);
      gl.Vertex3f(x, y, z);
    }
    gl.End();
  }
  gl.Finish();
}

void set_plain(const GlTable& gl) { look(gl, {}); }

struct OffScene {
  const char* name;
  void (*set)(const GlTable& gl);
  void (*draw)(const GlTable& gl);
};

void measure(const OffScene& scene, const GlTable& gl, std::string_view feature, const char* when) {
  const std::string name = std::string(scene.name) + " " + std::string(feature) + " " + when;
  CALLGRIND_ZERO_STATS;
  scene.draw(gl);
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

/// In a context of its own. The first picture of a context is not counted: memory is taken then.
void run(const OsmesaFunctions& osmesa, const OffScene& scene, const OffFeature& feature) {
  OffscreenContext context(osmesa, side_px, side_px, 24);
  const GlTable& gl = context.gl();
  scene.set(gl);
  scene.draw(gl);
  measure(scene, gl, feature.name, "unset");
  feature.set(gl);
  measure(scene, gl, feature.name, "set");
}

}  // namespace
}  // namespace gouraud::conformance

int main(int argc, char** argv) {
  using namespace gouraud::conformance;
  constexpr std::array<OffScene, 2> scenes{{{"lit", set_lit, draw_lit}, {"plain", set_plain, draw_plain}}};
  try {
    if (argc != 2) throw std::runtime_error("usage: off_is_free LIBRARY");
    const OsmesaFunctions osmesa = load_osmesa(argv[1]);
    for (const OffScene& scene : scenes) {
      for (const OffFeature& feature : off_features()) {
        if (scene.draw == draw_lit && feature.plain_scene_only) continue;
        run(osmesa, scene, feature);
      }
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "off_is_free: %s\n", error.what());
    return 2;
  }
}
