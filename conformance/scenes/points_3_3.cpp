// Points of size 1: one pixel each, the one that holds the centre. [GL1.5 §3.3]
// No centre lies within 1/256 pixel of a pixel's edge, where Mesa's rounding decides (MESA-RULES 5.4).
#include <cmath>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// 64 sub-pixel places, from 1/16 to 15/16, in cells of four pixels.
void points_sub_pixel(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  gl.Begin(GL_POINTS);
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) {
      const float x = static_cast<float>(column), y = static_cast<float>(row);
      gl.Color3f(x / 37, 0.6f, y / 37);
      gl.Vertex2f(4 * x + 1 + (1 + 2 * static_cast<float>(column % 8)) / 16,
                  4 * y + 1 + (1 + 2 * static_cast<float>(row % 8)) / 16);
    }
  }
  gl.End();
}

void points_at_centers(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 128 * 64; ++i) {
    const int x = 2 * (i % 64) + (i / 64) % 2, y = i / 64;
    gl.Color3f(static_cast<float>(x) / 140, static_cast<float>(y) / 140, 0.8f);
    gl.Vertex2f(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
  }
  gl.End();
}

void points_depth_tested(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  Random random(161);
  const Surface ring = torus(0.95f, 0.38f, 160, 80), ball = sphere(0.7f, 40, 80);
  for (const Surface* surface : {&ring, &ball}) {
    gl.Begin(GL_POINTS);
    for (const Surface::Point& point : surface->points) {
      gl.Color3f(point.u * 0.9f, surface == &ball ? 0.8f : 0.2f, point.v * 0.9f);
      gl.Vertex3fv(point.position.data());
    }
    gl.End();
  }
}

// Points are lit like vertices; they have no face, and take the front's material.
void points_lit(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.39f, 0.67f, 0.61f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.7f, 0.3f, 1});
  material(gl, GL_FRONT, GL_EMISSION, {0.12f, 0.09f, 0.2f, 1});
  material(gl, GL_BACK, GL_EMISSION, {0.8f, 0, 0, 1});
  gl.Enable(GL_CULL_FACE);
  gl.CullFace(GL_FRONT_AND_BACK);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  const Surface ring = torus(0.95f, 0.38f, 180, 90);
  gl.Begin(GL_POINTS);
  for (const Surface::Point& point : ring.points) {
    gl.Normal3fv(point.normal.data());
    gl.Vertex3fv(point.position.data());
  }
  gl.End();
}

}  // namespace

SceneList point_scenes() {
  constexpr auto section = "§3.3";
  return {
      {.name = "points_sub_pixel",
       .section = section,
       .shows = "A regular grid of points, whatever their sub-pixel place.",
       .judge = Judge::lines_and_points,
       .width_px = 128,
       .height_px = 128,
       .draw = points_sub_pixel},
      {.name = "points_at_centers",
       .section = section,
       .shows = "A chessboard of points at pixel centres.",
       .judge = Judge::lines_and_points,
       .width_px = 128,
       .height_px = 128,
       .draw = points_at_centers},
      {.name = "points_depth_tested",
       .section = section,
       .shows = "A ring and a ball of points, depth tested.",
       .judge = Judge::lines_and_points,
       .draw = points_depth_tested},
      {.name = "points_lit",
       .section = section,
       .shows = "A ring of lit points in gold: neither culling nor the red back material touches points.",
       .judge = Judge::lines_and_points,
       .draw = points_lit},
  };
}

}  // namespace gouraud::conformance
