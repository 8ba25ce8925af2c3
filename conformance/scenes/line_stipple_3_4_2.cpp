// Line stipple: a bit of the pattern for every `factor` fragments. [GL1.5 §3.4.2]
// The counter counts fragments; Mesa cuts the line by its length instead, which moves the bits of lines between generic
// points by one pixel. The specification decides, so the oracle judges; lines between centres are Mesa's as well.
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void patterns(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_LINE_STIPPLE);
  const GLushort bits[6] = {0xAAAA, 0x00FF, 0x1C47, 0x0101, 0xFFFF, 0x8000};
  for (int i = 0; i < 24; ++i) {
    gl.LineStipple(i / 6 == 3 ? 7 : i / 6 + 1, bits[i % 6]);
    gl.Begin(GL_LINES);
    gl.Color3f(0.9f, 0.04f * static_cast<float>(i), 0.3f);
    gl.Vertex2f(10.5f, 10.5f + 10 * static_cast<float>(i));
    gl.Vertex2f(245.5f, 10.5f + 10 * static_cast<float>(i));
    gl.End();
  }
}

// 0 counts as 1, 1000 as 256.
void factors(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 64);
  gl.Enable(GL_LINE_STIPPLE);
  const GLint values[6] = {0, -5, 1, 100, 256, 1000};
  for (int i = 0; i < 6; ++i) {
    gl.LineStipple(values[i], 0x5555);
    gl.Begin(GL_LINE_STRIP);
    gl.Color3f(0.9f, 0.7f, 0.15f * static_cast<float>(i));
    gl.Vertex2f(5.5f, 5.5f + 9 * static_cast<float>(i));
    gl.Vertex2f(250.5f, 5.5f + 9 * static_cast<float>(i));
    gl.Vertex2f(5.5f, 8.5f + 9 * static_cast<float>(i));
    gl.End();
  }
}

void continued(const GlTable& gl, GLenum mode, float width) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(3, 0x27CF);
  gl.LineWidth(width);
  Random random(321);
  for (int figure = 0; figure < 3; ++figure) {
    gl.Begin(mode);
    for (int i = 0; i < 8; ++i) {
      color_of(gl, random);
      const float x = random.range(9, 247);
      gl.Vertex2f(x, random.range(9, 247));
    }
    gl.End();
  }
}

void strips(const GlTable& gl) { continued(gl, GL_LINE_STRIP, 1); }
void loops(const GlTable& gl) { continued(gl, GL_LINE_LOOP, 1); }
void separate(const GlTable& gl) { continued(gl, GL_LINES, 1); }
void wide(const GlTable& gl) { continued(gl, GL_LINE_STRIP, 6); }

// More vertices than a batch holds: the counter goes on.
void long_strip(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(5, 0x0F0F);
  gl.Begin(GL_LINE_STRIP);
  gl.Color3f(0.3f, 0.9f, 0.6f);
  for (int i = 0; i < 3000; ++i) {
    const int row = i / 25, step = i % 25;
    const int x = row % 2 == 0 ? step : 24 - step;
    gl.Vertex2f(5.5f + 10 * static_cast<float>(x), 5.5f + 2 * static_cast<float>(row));
  }
  gl.End();
}

// The counter starts anew at each polygon, not at its edges.
void polygons(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 192, 128);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(4, 0x3333);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  const auto draw = [&](GLenum mode, float x, float y, int count) {
    const float places[6][2] = {{10.5f, 12.5f}, {47.5f, 8.5f}, {58.5f, 33.5f}, {40.5f, 55.5f}, {20.5f, 50.5f}, {6.5f, 30.5f}};
    gl.Begin(mode);
    for (int i = 0; i < count; ++i) gl.Vertex2f(x + places[i][0], y + places[i][1]);
    gl.End();
  };
  gl.Color3f(0.9f, 0.8f, 0.3f);
  draw(GL_POLYGON, 0, 0, 6);
  draw(GL_QUADS, 64, 0, 4);
  draw(GL_TRIANGLES, 128, 0, 6);
  draw(GL_TRIANGLE_STRIP, 0, 64, 5);
  draw(GL_TRIANGLE_FAN, 64, 64, 6);
  draw(GL_QUAD_STRIP, 128, 64, 6);
}

// The far end is clipped: the phase is that of the whole line.
void clipped_at_its_end(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(3, 0x5757);
  gl.Begin(GL_LINES);
  gl.Color3f(0.9f, 0.8f, 0.3f);
  for (int i = 0; i < 12; ++i) {
    gl.Vertex2f(20.5f, 5.5f + 10 * static_cast<float>(i));
    gl.Vertex2f(300.5f, 5.5f + 10 * static_cast<float>(i));
  }
  gl.End();
}

}  // namespace

SceneList line_stipple_scenes() {
  constexpr auto section = "§3.4.2";
  return {
      {.name = "lines_stipple_patterns", .section = section, .shows = "Dashed lines: six patterns, four factors.", .judge = Judge::lines_and_points, .draw = patterns},
      {.name = "lines_stipple_factors", .section = section, .shows = "Factors are kept between 1 and 256; strips go on counting.", .judge = Judge::oracle_only, .width_px = 256, .height_px = 64, .draw = factors},
      {.name = "lines_stipple_strips", .section = section, .shows = "Dashed strips: the pattern goes on round the corners.", .judge = Judge::oracle_only, .draw = strips},
      {.name = "lines_stipple_loops", .section = section, .shows = "Dashed loops.", .judge = Judge::oracle_only, .draw = loops},
      {.name = "lines_stipple_separate", .section = section, .shows = "Dashed lines, each from its start.", .judge = Judge::oracle_only, .draw = separate},
      {.name = "lines_stipple_wide", .section = section, .shows = "Wide dashed strips, cut parallel to the axes.", .judge = Judge::oracle_only, .draw = wide},
      {.name = "lines_stipple_long_strip", .section = section, .shows = "A long dashed strip to and fro.", .judge = Judge::oracle_only, .draw = long_strip},
      {.name = "lines_stipple_polygons", .section = section, .shows = "Dashed outlines of polygons of every mode.", .judge = Judge::oracle_only, .width_px = 192, .height_px = 128, .draw = polygons},
      {.name = "lines_stipple_clipped", .section = section, .shows = "Dashed lines that leave the picture.", .judge = Judge::lines_and_points, .width_px = 128, .height_px = 128, .draw = clipped_at_its_end},
  };
}

}  // namespace gouraud::conformance
