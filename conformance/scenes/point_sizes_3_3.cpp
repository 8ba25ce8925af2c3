// Sizes of points: rounded squares, attenuation, sprites. [GL1.5 §3.3]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// A grid of points at places that no rounding decides; sizes grow along the rows. Batches of one size each.
void draw_grid(const GlTable& gl, float first_size, float step) {
  Random random(301);
  for (int i = 0; i < 49; ++i) {
    gl.PointSize(first_size + step * static_cast<float>(i));
    gl.Begin(GL_POINTS);
    color_of(gl, random);
    const float dx = static_cast<float>(i * 5 % 16), dy = static_cast<float>(i * 11 % 16);
    gl.Vertex2f(18 + 36 * static_cast<float>(i % 7) + (2 * dx + 1) / 32, 18 + 36 * static_cast<float>(i / 7) + (2 * dy + 1) / 32);
    gl.End();
  }
}

void whole_sizes(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  draw_grid(gl, 1, 0.5f);
}

void fractions(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  draw_grid(gl, 0.06f, 0.13f);
}

// Larger than the largest size: 255 is drawn. Its centre is inside, its corners are not.
void huge_sizes(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 320, 320);
  const float sizes[3] = {1e30f, 300, 40};
  const float places[3][2] = {{190.3f, 180.7f}, {4.2f, 6.6f}, {318.4f, 3.3f}};
  for (int i = 0; i < 3; ++i) {
    gl.PointSize(sizes[i]);
    gl.Begin(GL_POINTS);
    gl.Color3f(0.9f - 0.3f * static_cast<float>(i), 0.2f, 0.3f * static_cast<float>(i));
    gl.Vertex2fv(places[i]);
    gl.End();
  }
}

void depth_tested_squares(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  gl.PointSize(7);
  gl.Begin(GL_POINTS);
  for (const Surface::Point& point : torus(0.95f, 0.38f, 60, 30).points) {
    gl.Color3f(point.u * 0.9f, 0.3f, point.v * 0.9f);
    gl.Vertex3fv(point.position.data());
  }
  gl.End();
}

void attenuated(const GlTable& gl, const Four& terms, float smallest, float largest) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 24});
  gl.PointSize(24);
  gl.PointParameterfv(GL_POINT_DISTANCE_ATTENUATION, terms.data());
  gl.PointParameterf(GL_POINT_SIZE_MIN, smallest);
  gl.PointParameterf(GL_POINT_SIZE_MAX, largest);
  gl.Begin(GL_POINTS);
  for (const Surface::Point& point : floor_grid(4.6f, 14).points) {
    gl.Color3f(point.u * 0.9f, 0.4f, point.v * 0.9f);
    gl.Vertex3fv(point.position.data());
  }
  gl.End();
}

void attenuated_constant(const GlTable& gl) { attenuated(gl, {5.3f, 0, 0, 0}, 0, 255); }
void attenuated_linear(const GlTable& gl) { attenuated(gl, {0, 1.37f, 0, 0}, 0, 255); }
void attenuated_quadratic(const GlTable& gl) { attenuated(gl, {0, 0, 0.53f, 0}, 0, 255); }
void attenuated_clamped(const GlTable& gl) { attenuated(gl, {0.2f, 0.1f, 0.53f, 0}, 6.2f, 10.7f); }

void sprites(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_POINT_SPRITE_ARB);
  draw_grid(gl, 1.2f, 0.61f);
}

// Size, width, smoothing and stipple belong to attribute groups.
void restored(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  gl.PointSize(9);
  gl.PushAttrib(GL_POINT_BIT | GL_LINE_BIT);
  gl.PointSize(3);
  gl.LineWidth(7);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(2, 0x5555);
  gl.PopAttrib();
  gl.Begin(GL_POINTS);
  gl.Color3f(0.9f, 0.7f, 0.1f);
  gl.Vertex2f(40.2f, 60.3f);
  gl.End();
  gl.Begin(GL_LINES);
  gl.Vertex2f(60.5f, 20.5f);
  gl.Vertex2f(110.5f, 100.5f);
  gl.End();
}

}  // namespace

SceneList point_size_scenes() {
  constexpr auto section = "§3.3";
  constexpr auto judge = Judge::lines_and_points;
  return {
      {.name = "points_size_halves", .section = section, .shows = "Squares from 1 to 25 pixels, half a pixel a step.", .judge = judge, .draw = whole_sizes},
      {.name = "points_size_fractions", .section = section, .shows = "Squares from 1 to 6 pixels, sizes of any fraction.", .judge = judge, .draw = fractions},
      {.name = "points_size_huge", .section = section, .shows = "Three squares, the largest 255 pixels wide, across the borders.", .judge = judge, .width_px = 320, .height_px = 320, .draw = huge_sizes},
      {.name = "points_size_depth_tested", .section = section, .shows = "A ring of squares that hide each other.", .judge = judge, .draw = depth_tested_squares},
      // deviation: the distance is that from the eye [GL1.5 §3.3]; Mesa's is |z_eye|.
      {.name = "points_attenuation_constant", .section = section, .shows = "A floor of points of one size, half of what was asked for.", .judge = judge, .draw = attenuated_constant},
      {.name = "points_attenuation_linear", .section = section, .shows = "A floor of points, smaller with the root of the distance.", .judge = Judge::oracle_only, .draw = attenuated_linear},
      {.name = "points_attenuation_quadratic", .section = section, .shows = "A floor of points, smaller with the distance.", .judge = Judge::oracle_only, .draw = attenuated_quadratic},
      {.name = "points_attenuation_clamped", .section = section, .shows = "The same between a smallest and a largest size.", .judge = Judge::oracle_only, .draw = attenuated_clamped},
      {.name = "points_sprites", .section = section, .shows = "Squares of exactly their size, rounded to no whole number.", .judge = judge, .draw = sprites},
      {.name = "points_and_lines_restored", .section = section, .shows = "A point of size 9 and a plain line: PopAttrib has brought both back.", .judge = judge, .width_px = 128, .height_px = 128, .draw = restored},
  };
}

}  // namespace gouraud::conformance
