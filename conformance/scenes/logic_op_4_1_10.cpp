// Logical operations: all 16, alone, masked, and instead of blending. [GL1.5 §4.1.10]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// Flat tiles, so that no bit hangs on how a colour is interpolated.
void tiles(const GlTable& gl, Random& random, float x, float y, int count, float size) {
  for (int i = 0; i < count * count; ++i) {
    const auto byte = [&random] { return static_cast<GLubyte>(random.below(256)); };
    const GLubyte color[4] = {byte(), byte(), byte(), byte()};
    gl.Color4ubv(color);
    const float left = x + size * static_cast<float>(i % count), bottom = y + size * static_cast<float>(i / count);
    draw_rectangle(gl, left, bottom, left + size, bottom + size, 0);
  }
}

void operations(const GlTable& gl, bool masked) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(5);
  tiles(gl, random, 0, 0, 32, 8);
  gl.Enable(GL_COLOR_LOGIC_OP);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  for (int op = 0; op < 16; ++op) {
    gl.LogicOp(GL_CLEAR + static_cast<GLenum>(op));
    if (masked) gl.ColorMask((op & 1) != 0, (op & 2) == 0, (op & 4) != 0, (op & 8) == 0);
    tiles(gl, random, 6.5f + 64 * static_cast<float>(op % 4), 6.5f + 64 * static_cast<float>(op / 4), 10, 5.125f);
  }
}

// Drawn twice with XOR, a figure leaves no trace; once, it shows on every ground.
void rubber_band(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(9);
  tiles(gl, random, 0, 0, 16, 16);
  gl.Enable(GL_COLOR_LOGIC_OP);
  gl.LogicOp(GL_XOR);
  gl.Color4ub(255, 255, 255, 0);
  draw_rectangle(gl, 30.5f, 40.5f, 120.5f, 200.5f, 0);
  draw_rectangle(gl, 130.5f, 40.5f, 220.5f, 200.5f, 0);
  draw_rectangle(gl, 130.5f, 40.5f, 220.5f, 200.5f, 0);
}

}  // namespace

SceneList logic_op_scenes() {
  constexpr auto section = "§4.1.10";
  return {
      {.name = "logic_operations",
       .section = section,
       .shows = "16 squares of random tiles on random tiles, one for each operation; blending has no effect.",
       .draw = [](const GlTable& gl) { operations(gl, false); }},
      {.name = "logic_operations_masked",
       .section = section,
       .shows = "The same 16 squares, each through another colour mask.",
       .draw = [](const GlTable& gl) { operations(gl, true); }},
      {.name = "logic_rubber_band",
       .section = section,
       .shows = "Random tiles, inverted in one rectangle on the left; a second one on the right undid itself.",
       .draw = rubber_band},
  };
}

}  // namespace gouraud::conformance
