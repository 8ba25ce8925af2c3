// Wide lines: columns of fragments around a moved line of width 1. [GL1.5 §3.4.2]
// End points are generic, or pixel centres: elsewhere Mesa's emulation of diamonds decides ties its own way.
#include <cmath>
#include <numbers>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void star(const GlTable& gl, int rays, float inner, float outer) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Begin(GL_LINES);
  for (int i = 0; i < rays; ++i) {
    const double angle = 2 * std::numbers::pi * i / rays + 0.013;
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    gl.Color3f(0.8f, static_cast<float>(i % 5) * 0.2f, 0.2f);
    gl.Vertex2f(128.3f + inner * c, 127.6f + inner * s);
    gl.Color3f(0.2f, static_cast<float>(i % 7) * 0.13f, 0.8f);
    gl.Vertex2f(128.3f + outer * c, 127.6f + outer * s);
  }
  gl.End();
}

void width_2(const GlTable& gl) {
  gl.LineWidth(2);
  star(gl, 72, 23.3f, 121.7f);
}
void width_3(const GlTable& gl) {
  gl.LineWidth(3);
  star(gl, 60, 27.3f, 121.7f);
}
void width_8(const GlTable& gl) {
  gl.LineWidth(8);
  star(gl, 36, 57.3f, 111.7f);
}

// 0.3 counts as 1, 1.5 as 2, 2.4 as 2, 2.6 as 3, ...
void fractions(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  for (int i = 0; i < 20; ++i) {
    gl.LineWidth(0.3f + 0.43f * static_cast<float>(i));
    gl.Begin(GL_LINES);
    gl.Color3f(0.8f, 0.03f * static_cast<float>(i), 0.3f);
    gl.Vertex2f(12.5f, 8.5f + 12 * static_cast<float>(i));
    gl.Vertex2f(120.5f, 8.5f + 12 * static_cast<float>(i));
    gl.Vertex2f(136.5f + 6 * static_cast<float>(i), 10.5f);
    gl.Vertex2f(140.5f + 6 * static_cast<float>(i), 245.5f);
    gl.End();
  }
}

void strip_and_loop(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.LineWidth(5);
  Random random(311);
  for (const GLenum mode : {GL_LINE_STRIP, GL_LINE_LOOP}) {
    gl.Begin(mode);
    for (int i = 0; i < 9; ++i) {
      color_of(gl, random);
      const float x = random.range(15, 241);
      gl.Vertex2f(x, random.range(15, 241));
    }
    gl.End();
  }
}

void in_perspective(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.4f, .pitch_deg = 33});
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.LineWidth(4);
  draw_surface(gl, torus(0.95f, 0.38f, 24, 12), [&](const Surface::Point& point) { gl.Color3f(0.9f, point.u, point.v); });
}

void huge(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.LineWidth(1e30f);
  gl.Begin(GL_LINES);
  gl.Color3f(0.9f, 0.6f, 0.1f);
  gl.Vertex2f(70.3f, 130.6f);
  gl.Color3f(0.1f, 0.6f, 0.9f);
  gl.Vertex2f(220.7f, 160.2f);
  gl.End();
}

}  // namespace

SceneList line_width_scenes() {
  constexpr auto section = "§3.4.2";
  // Colours vary along the line [GL1.5 §3.4.1 eq 3.3]; Mesa's vary along the axis, which shows on wide lines.
  constexpr auto judge = Judge::oracle_only;
  return {
      {.name = "lines_width_2", .section = section, .shows = "A star of lines two pixels wide.", .judge = judge, .draw = width_2},
      {.name = "lines_width_3", .section = section, .shows = "A star of lines three pixels wide.", .judge = judge, .draw = width_3},
      {.name = "lines_width_8", .section = section, .shows = "A star of lines eight pixels wide, ends parallel to the axes.", .judge = judge, .draw = width_8},
      {.name = "lines_width_fractions", .section = section, .shows = "Lines whose widths are rounded to whole pixels.", .judge = Judge::lines_and_points, .draw = fractions},
      {.name = "lines_width_strip_and_loop", .section = section, .shows = "Wide strips and loops.", .judge = judge, .draw = strip_and_loop},
      {.name = "lines_width_in_perspective", .section = section, .shows = "A ring of wide lines that hide each other.", .judge = Judge::oracle_only, .draw = in_perspective},
      {.name = "lines_width_huge", .section = section, .shows = "A line 255 pixels wide.", .judge = judge, .draw = huge},
  };
}

}  // namespace gouraud::conformance
