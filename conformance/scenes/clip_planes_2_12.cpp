// The user's clip planes, in eye space. [GL1.5 §2.12]
// Mesa tests them in clip space, by planes times the inverse projection in float (MESA-RULES 2.4): along a cut single
// pixels may differ.
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void plane(const GlTable& gl, int number, double a, double b, double c, double d) {
  const GLdouble equation[4] = {a, b, c, d};
  gl.ClipPlane(GL_CLIP_PLANE0 + static_cast<GLenum>(number), equation);
  gl.Enable(GL_CLIP_PLANE0 + static_cast<GLenum>(number));
}

void two_sided_lamp(const GlTable& gl) {
  black_lighting(gl, 1);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  light(gl, GL_LIGHT0, GL_POSITION, {0.37f, 0.71f, 0.63f, 0});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.2f, 0.2f, 0.2f, 1});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 1});
  material(gl, GL_BACK, GL_DIFFUSE, {0.2f, 0.5f, 0.8f, 1});
  material(gl, GL_FRONT_AND_BACK, GL_AMBIENT, {0.57f, 0.57f, 0.57f, 1});
  material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0.6f, 0.6f, 0.6f, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 15);
}

void opened_sphere(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  two_sided_lamp(gl);
  look(gl, {.distance = 3.7f, .pitch_deg = 31});
  plane(gl, 0, 0.31, -0.83, 0.17, 0.29);
  draw_surface(gl, sphere(1, 24, 36));
}

// A wedge of two planes, given at two model-view matrices.
void wedge_of_a_torus(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  two_sided_lamp(gl);
  const Matrix view = look(gl, {.distance = 4.4f, .pitch_deg = 48});
  plane(gl, 2, 1, 0, 0, 0.13);
  load_model_view(gl, multiply(view, rotation(70, 1)));
  plane(gl, 5, 1, 0, 0, 0.07);
  load_model_view(gl, view);
  draw_surface(gl, torus(1, 0.45f, 60, 24));
}

void eight_planes(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  two_sided_lamp(gl);
  look(gl, {.distance = 3.9f, .pitch_deg = 22});
  constexpr double directions[8][3] = {{0.9, 0.1, 0.2}, {-0.8, 0.2, 0.3}, {0.1, 0.9, -0.2}, {0.2, -0.9, 0.1},
                                       {0.3, 0.1, 0.9}, {-0.2, 0.3, -0.8}, {0.6, 0.6, 0.5}, {-0.6, -0.5, 0.6}};
  for (int i = 0; i < 8; ++i) plane(gl, i, directions[i][0], directions[i][1], directions[i][2], 0.71);
  draw_surface(gl, sphere(1, 30, 44));
}

void random_triangles(const GlTable& gl, Random& random, int count) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3 * count; ++i) {
    color_of(gl, random);
    const float x = random.range(-2, 2), y = random.range(-2, 2);
    gl.Vertex3f(x, y, random.range(-2, 2));
  }
  gl.End();
}

void random_cut_triangles(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 3.4f, .pitch_deg = 12, .near = 1.7f, .far = 5});
  plane(gl, 0, 0.4, 0.7, -0.2, 0.3);
  plane(gl, 3, -0.6, 0.2, 0.5, 0.4);
  Random random(212);
  random_triangles(gl, random, 50);
}

void flat_cut(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(GL_FLAT);
  look(gl, {.distance = 3.4f});
  plane(gl, 1, -0.3, 0.9, 0.1, 0.2);
  Random random(213);
  random_triangles(gl, random, 40);
}

void flipped_by_the_sign(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4});
  gl.Color3f(0.8f, 0.4f, 0.2f);
  plane(gl, 0, 0.5, 0.6, -0.4, 0.1);
  draw_box(gl, 1.6f, 1.2f, 1.4f);
  gl.Color3f(0.2f, 0.5f, 0.8f);
  plane(gl, 0, -0.5, -0.6, 0.4, -0.1);
  draw_box(gl, 1.6f, 1.2f, 1.4f);
}

void cut_lines(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 3.3f, .pitch_deg = 17});
  plane(gl, 0, 0.2, 0.8, 0.3, 0.4);
  plane(gl, 1, 0.7, -0.3, -0.1, 0.8);
  Random random(214);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 300; ++i) {
    color_of(gl, random);
    const float x = random.range(-1.6f, 1.6f), y = random.range(-1.6f, 1.6f);
    gl.Vertex3f(x, y, random.range(-1.2f, 1.2f));
  }
  gl.End();
}

void cut_points(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 3.3f, .pitch_deg = 17});
  plane(gl, 4, 0.2, 0.8, 0.3, 0.1);
  Random random(215);
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 9000; ++i) {
    color_of(gl, random);
    const float x = random.range(-1.2f, 1.2f), y = random.range(-1.2f, 1.2f);
    gl.Vertex3f(x, y, random.range(-1, 1));
  }
  gl.End();
}

// The edges that the plane makes are drawn.
void outlined_cut(const GlTable& gl) {
  clear_background(gl);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  look(gl, {.distance = 3.9f, .pitch_deg = 26});
  gl.Color3f(0.9f, 0.8f, 0.3f);
  plane(gl, 0, 0.31, -0.83, 0.17, 0.29);
  draw_box(gl, 1.6f, 1.4f, 1.5f);
}

// Cut by a plane that is disabled again, and by none: a plane is what it was when it was given.
void given_under_a_matrix(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  const Matrix view = look(gl, {.distance = 5});
  load_model_view(gl, multiply(view, multiply(translation(0.3f, 0.1f, -0.2f), scaling(1.3f, 0.6f, 2))));
  plane(gl, 7, 0.4, 0.9, -0.3, 0.2);
  load_model_view(gl, multiply(view, rotation(40, 2)));
  gl.Color3f(0.3f, 0.8f, 0.5f);
  draw_box(gl, 2.1f, 1.3f, 1.7f);
  gl.Disable(GL_CLIP_PLANE0 + 7);
  load_model_view(gl, multiply(view, translation(1.2f, -1.3f, 0.2f)));
  gl.Color3f(0.8f, 0.3f, 0.5f);
  draw_box(gl, 0.7f, 0.6f, 0.5f);
}

}  // namespace

SceneList clip_plane_scenes() {
  constexpr auto section = "§2.12";
  return {
      {.name = "clip_plane_sphere",
       .section = section,
       .shows = "An orange sphere cut open by a slanted plane; its inside is blue.",
       .draw = opened_sphere},
      {.name = "clip_plane_wedge",
       .section = section,
       .shows = "A part of a ring between two planes.",
       .draw = wedge_of_a_torus},
      {.name = "clip_plane_eight", .section = section, .shows = "A sphere cut by all eight planes.", .draw = eight_planes},
      {.name = "clip_plane_triangles",
       .section = section,
       .shows = "Random triangles cut by two planes and by the view volume.",
       .draw = random_cut_triangles},
      {.name = "clip_plane_flat",
       .section = section,
       .shows = "Flat triangles, cut: they keep the provoking vertex's colour even where it was cut off.",
       .draw = flat_cut},
      {.name = "clip_plane_halves",
       .section = section,
       .shows = "Two halves of one box, orange and blue, that meet without a gap.",
       .draw = flipped_by_the_sign},
      {.name = "clip_plane_lines",
       .section = section,
       .shows = "Lines cut by two planes.",
       .judge = Judge::lines_and_points,
       .draw = cut_lines},
      {.name = "clip_plane_points",
       .section = section,
       .shows = "A cloud of points, a part of it cut away.",
       .judge = Judge::lines_and_points,
       .draw = cut_points},
      {.name = "clip_plane_outline",
       .section = section,
       .shows = "The edges of a box cut by a plane, those along the cut as well.",
       .judge = Judge::lines_and_points,
       .draw = outlined_cut},
      {.name = "clip_plane_under_a_matrix",
       .section = section,
       .shows = "A green box cut by a plane that was given under another matrix; a small red one that is whole.",
       .draw = given_under_a_matrix},
  };
}

}  // namespace gouraud::conformance
