// The vertices' own secondary colour, added without lighting. [GL1.5 §2.7, §3.9]
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void triangles(const GlTable& gl, Random& random, int count) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3 * count; ++i) {
    color_of(gl, random);
    const float r = random.range(-0.2f, 0.9f), g = random.range(-0.2f, 0.9f);
    gl.SecondaryColor3f(r, g, random.range(-0.2f, 0.9f));
    const float x = random.range(-1.2f, 1.2f), y = random.range(-1.2f, 1.2f);
    gl.Vertex3f(x, y, random.range(-1.2f, 1.2f));
  }
  gl.End();
}

void sum(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_COLOR_SUM);
  look(gl, {.distance = 4});
  Random random(391);
  triangles(gl, random, 30);
}

void flat(const GlTable& gl) {
  gl.ShadeModel(GL_FLAT);
  sum(gl);
}

// Without COLOR_SUM, and with lighting, the vertices' secondary colour counts for nothing.
void off_and_lit(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4});
  Random random(392);
  triangles(gl, random, 12);
  gl.Enable(GL_COLOR_SUM);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_POSITION, {0.43f, 0.67f, 0.59f, 0});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.6f, 0.6f, 0.3f, 1});
  draw_surface(gl, sphere(0.6f, 14, 20));
}

void arrays(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_COLOR_SUM);
  Random random(393);
  std::vector<GLfloat> positions;
  std::vector<GLubyte> colors, secondary;
  for (int i = 0; i < 3 * 700; ++i) {
    const float x = 8 * static_cast<float>(i / 3 % 28) + 12.3f, y = 9 * static_cast<float>(i / 84) + 12.7f;
    positions.push_back(x + random.range(-8, 8));
    positions.push_back(y + random.range(-8, 8));
    for (int k = 0; k < 4; ++k) colors.push_back(static_cast<GLubyte>(random.below(256)));
    for (int k = 0; k < 3; ++k) secondary.push_back(static_cast<GLubyte>(random.below(256)));
  }
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.EnableClientState(GL_SECONDARY_COLOR_ARRAY);
  gl.VertexPointer(2, GL_FLOAT, 0, positions.data());
  gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
  gl.SecondaryColorPointer(3, GL_UNSIGNED_BYTE, 0, secondary.data());
  gl.DrawArrays(GL_TRIANGLES, 0, 3 * 700);
}

// The sum is clamped before the fog.
void in_fog(const GlTable& gl) {
  const GLfloat color[4] = {0.1f, 0.3f, 0.2f, 0};
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_START, 2);
  gl.Fogf(GL_FOG_END, 6);
  gl.Fogfv(GL_FOG_COLOR, color);
  sum(gl);
}

}  // namespace

SceneList secondary_color_scenes() {
  constexpr auto section = "§3.9";
  return {
      {.name = "secondary_color_sum", .section = section, .shows = "Bright triangles: sums of two colours.", .draw = sum},
      {.name = "secondary_color_flat", .section = section, .shows = "The same, flat.", .draw = flat},
      {.name = "secondary_color_off",
       .section = section,
       .shows = "Triangles of their primary colours, and a lit sphere.",
       .draw = off_and_lit},
      {.name = "secondary_color_arrays", .section = section, .shows = "700 small triangles from arrays.", .draw = arrays},
      // Mesa does not clamp the sum (MESA-RULES 13).
      {.name = "secondary_color_in_fog",
       .section = section,
       .shows = "Bright triangles in a dark fog: sums beyond 1 are clamped first.",
       .judge = Judge::oracle_only,
       .draw = in_fog},
  };
}

}  // namespace gouraud::conformance
