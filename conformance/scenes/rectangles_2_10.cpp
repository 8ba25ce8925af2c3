// Rect: a polygon of four vertices, as if it stood between Begin and End. [GL1.5 §2.10]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void all_forms(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  const GLdouble d0[2] = {3.5, 4.5}, d1[2] = {30.25, 33.75};
  const GLint i0[2] = {40, 5}, i1[2] = {60, 30};
  const GLshort s0[2] = {70, 5}, s1[2] = {90, 30};
  const GLfloat f0[2] = {100.3f, 5.6f}, f1[2] = {120.7f, 30.2f};
  gl.Color3f(0.9f, 0.4f, 0.2f);
  gl.Rectdv(d0, d1);
  gl.Rectiv(i0, i1);
  gl.Color3f(0.2f, 0.9f, 0.4f);
  gl.Rectsv(s0, s1);
  gl.Rectfv(f0, f1);
  gl.Color3f(0.4f, 0.2f, 0.9f);
  gl.Rectd(5.5, 50.5, 30.5, 80.5);
  gl.Recti(40, 50, 60, 80);
  gl.Rects(70, 50, 90, 80);
  gl.Rectf(100.5f, 50.5f, 120.5f, 80.5f);
  gl.Color3f(0.8f, 0.8f, 0.8f);
  gl.Rectf(60, 120, 10, 90);  // turned twice: still counterclockwise
  gl.Rectf(60, 60, 60, 90);   // nothing
}

// Rectangles that are given clockwise are back faces.
void culled(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 64);
  gl.Enable(GL_CULL_FACE);
  gl.Color3f(0.9f, 0.8f, 0.2f);
  gl.Rectf(5, 5, 35, 55);
  gl.Rectf(75, 5, 45, 55);
  gl.Rectf(85, 55, 115, 5);
}

void outlined_and_lit(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 64);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.2f, 0.93f, 0});
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.7f, 0.3f, 1});
  gl.Normal3f(0, 0, 1);
  gl.Rectf(5.3f, 6.7f, 50.2f, 55.4f);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Rectf(65.3f, 6.7f, 110.2f, 55.4f);
}

void in_a_list(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 64, 64);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Color3f(0.2f, 0.8f, 0.9f);
  gl.Rectf(8.2f, 9.1f, 40.7f, 30.3f);
  gl.Recti(20, 25, 60, 60);
  gl.EndList();
  gl.CallList(list);
  gl.DeleteLists(list, 1);
}

}  // namespace

SceneList rectangle_scenes() {
  constexpr auto section = "§2.10";
  return {
      {.name = "rectangles_all_forms", .section = section, .shows = "Nine rectangles, by every form of the command.", .width_px = 128, .height_px = 128, .draw = all_forms},
      {.name = "rectangles_culled", .section = section, .shows = "One rectangle of three faces the viewer.", .width_px = 128, .height_px = 64, .draw = culled},
      {.name = "rectangles_lit", .section = section, .shows = "A lit rectangle and a lit outline.", .judge = Judge::lines_and_points, .width_px = 128, .height_px = 64, .draw = outlined_and_lit},
      {.name = "rectangles_in_a_list", .section = section, .shows = "Two rectangles from a list.", .width_px = 64, .height_px = 64, .draw = in_a_list},
  };
}

}  // namespace gouraud::conformance
