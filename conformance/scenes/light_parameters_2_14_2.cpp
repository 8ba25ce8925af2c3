// What glLight, glMaterial and glLightModel take: faces, integer forms, materials between vertices. [GL1.5 §2.14.2]
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void prepare(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.3f, 0.3f, 0.3f, 1});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.8f, 0.8f, 0.8f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.37f, 0.61f, 0.7f, 0});
}

// Initial lights and materials: light 0 white, material grey, no highlights.
void initial_values(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, 48, 24));
}

// Columns: specular and emission; rows: diffuse and ambient: 16 spheres in the way of the red book.
void material_grid(const GlTable& gl) {
  prepare(gl);
  const Matrix view = look(gl, {.distance = 12, .pitch_deg = 0, .yaw_deg = 0, .fov_y_deg = 45});
  const Surface ball = sphere(1, 20, 40);
  for (int i = 0; i < 16; ++i) {
    const int row = i / 4, column = i % 4;
    material(gl, GL_FRONT, GL_AMBIENT, row < 2 ? Four{0, 0, 0, 1} : Four{0.7f, 0.6f, 0.2f, 1});
    material(gl, GL_FRONT, GL_DIFFUSE, row % 2 == 0 ? Four{0.1f, 0.5f, 0.8f, 1} : Four{0.8f, 0.3f, 0.4f, 1});
    material(gl, GL_FRONT, GL_SPECULAR, column == 0 ? Four{0, 0, 0, 1} : Four{0.7f, 0.7f, 0.7f, 1});
    gl.Materialf(GL_FRONT, GL_SHININESS, column == 1 ? 5.0f : 90.0f);
    material(gl, GL_FRONT, GL_EMISSION, column == 3 ? Four{0.32f, 0.15f, 0.22f, 1} : Four{0, 0, 0, 1});
    load_model_view(gl, multiply(view, translation(2.4f * static_cast<float>(column) - 3.6f,
                                                   2.4f * static_cast<float>(row) - 3.6f, 0)));
    draw_surface(gl, ball);
  }
}

// glMaterial is legal between Begin and End: another one at every vertex, of every parameter.
void material_per_vertex(const GlTable& gl) {
  prepare(gl);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, 48, 24), [&](const Surface::Point& point) {
    const float u = point.u, v = point.v;
    material(gl, GL_FRONT, GL_DIFFUSE, {u, 0.8f - 0.6f * v, 0.3f + 0.5f * v, 1});
    if (v < 0.6f) material(gl, GL_FRONT, GL_EMISSION, {0, 0.3f * v, 0.25f * u, 1});
    material(gl, GL_FRONT, GL_SPECULAR, {0.8f * v, 0.8f * v, 0.4f, 1});
    gl.Materialf(GL_FRONT, GL_SHININESS, 4 + 90 * u);
  });
}

// One change in the middle of a long strip; what follows keeps it, over End as well.
void material_change_mid_strip(const GlTable& gl) {
  prepare(gl);
  look(gl, {.distance = 3.8f});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.6f, 0.2f, 1});
  material(gl, GL_FRONT, GL_AMBIENT, {0.5f, 0.5f, 0.5f, 1});
  int vertices = 0;
  draw_surface(gl, sphere(1.05f, 24, 48), [&](const Surface::Point&) {
    ++vertices;
    if (vertices == 1177) material(gl, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {0.2f, 0.7f, 0.4f, 1});
    if (vertices == 1655) material(gl, GL_FRONT, GL_DIFFUSE, {0.7f, 0.2f, 0.8f, 1});
  });
}

// Emission, ambient, diffuse, specular and shininess on the faces that they name, seen on both sides of pipes.
void material_faces(const GlTable& gl) {
  prepare(gl);
  gl.Enable(GL_NORMALIZE);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  material(gl, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {0.5f, 0.5f, 0.5f, 1});
  const Matrix view = look(gl, {.distance = 7.8f, .pitch_deg = 48, .yaw_deg = 9});
  const Surface pipe = half_pipe(0.8f, 1.5f, 8, 28);
  const auto draw_pair = [&](float x, float y) {
    const Matrix place = multiply(view, translation(x, 0, y));
    load_model_view(gl, multiply(place, translation(-0.5f, 0.3f, 0)));
    draw_surface(gl, pipe);
    load_model_view(
        gl, multiply(place, multiply(translation(0.7f, -0.2f, 0), multiply(rotation(180, 2), scaling(0.6f, 0.6f, 1)))));
    draw_surface(gl, pipe);
  };
  draw_pair(-1.2f, -1.2f);
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.3f, 0.2f, 1});
  draw_pair(1.2f, -1.2f);
  material(gl, GL_BACK, GL_AMBIENT_AND_DIFFUSE, {0.2f, 0.4f, 0.8f, 1});
  draw_pair(-1.2f, 1.2f);
  material(gl, GL_FRONT_AND_BACK, GL_EMISSION, {0.05f, 0.25f, 0.1f, 1});
  gl.Materialf(GL_BACK, GL_SHININESS, 15);
  material(gl, GL_BACK, GL_SPECULAR, {0.6f, 0.6f, 0.6f, 1});
  draw_pair(1.2f, 1.2f);
}

// Integer colours are mapped like signed ones of Table 2.9, integer positions and factors are taken as they are.
void integer_forms(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 2);
  constexpr GLint one = 2147483647;
  const std::array<GLint, 4> diffuse = {one / 5 * 4, one / 4 * 3, one / 2, one},
                             specular = {one / 3, one / 3, one / 3, one};
  const std::array<GLint, 4> position = {2, 3, 4, 0}, lamp = {-1, 1, -2, 1}, model = {one / 9, one / 11, one / 7, one};
  const std::array<GLint, 3> direction = {1, -1, -2};
  gl.Lightiv(GL_LIGHT0, GL_DIFFUSE, diffuse.data());
  gl.Lightiv(GL_LIGHT0, GL_SPECULAR, specular.data());
  gl.Lightiv(GL_LIGHT0, GL_POSITION, position.data());
  gl.Lightiv(GL_LIGHT1, GL_DIFFUSE, specular.data());
  gl.Lightiv(GL_LIGHT1, GL_POSITION, lamp.data());
  gl.Lightiv(GL_LIGHT1, GL_SPOT_DIRECTION, direction.data());
  gl.Lighti(GL_LIGHT1, GL_SPOT_CUTOFF, 51);
  gl.Lighti(GL_LIGHT1, GL_SPOT_EXPONENT, 2);
  gl.Lighti(GL_LIGHT1, GL_LINEAR_ATTENUATION, 1);
  gl.LightModeliv(GL_LIGHT_MODEL_AMBIENT, model.data());
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  const std::array<GLint, 4> paint = {one / 4, one / 5 * 3, one / 5 * 4, one}, sheen = {one / 2, one / 2, one / 4, one};
  gl.Materialiv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, paint.data());
  gl.Materialiv(GL_FRONT, GL_SPECULAR, sheen.data());
  gl.Materiali(GL_FRONT, GL_SHININESS, 14);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, 48, 24));
}

// The alpha of a lit vertex is the diffuse material's alone.
void lit_alpha(const GlTable& gl) {
  prepare(gl);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 0.3f});
  material(gl, GL_FRONT, GL_AMBIENT, {0.4f, 0.4f, 0.4f, 0.9f});
  material(gl, GL_FRONT, GL_EMISSION, {0.1f, 0.1f, 0.2f, 0.7f});
  look(gl, {.distance = 3.8f});
  draw_surface(gl, sphere(1.05f, 20, 40), [&](const Surface::Point& point) {
    material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.6f, 0.3f, 0.2f + 0.7f * point.v});
  });
}

}  // namespace

SceneList light_parameter_scenes() {
  constexpr auto section = "§2.14.2";
  return {
      {.name = "light_initial_values",
       .section = section,
       .shows = "A grey ring lit from the eye: the initial light and material.",
       .draw = initial_values},
      {.name = "material_grid",
       .section = section,
       .shows = "16 balls: no highlight, broad, small, glowing; blue and red, without and with ambient.",
       .draw = material_grid},
      {.name = "material_per_vertex",
       .section = section,
       .shows = "A ring whose colour, glow and shine change from vertex to vertex.",
       .draw = material_per_vertex},
      {.name = "material_change_mid_strip",
       .section = section,
       .shows = "A ball of gold below, green in the middle, violet above: two changes within strips.",
       .draw = material_change_mid_strip},
      {.name = "material_faces",
       .section = section,
       .shows = "Four pairs of pipes, each pair inside and outside: grey; red inside; blue outside; all glowing green, "
                "shiny outside.",
       .draw = material_faces},
      {.name = "light_integer_forms",
       .section = section,
       .shows = "A blue ring under a light from above and a spot at the left, all set with integers.",
       .draw = integer_forms},
      {.name = "lit_alpha",
       .section = section,
       .shows = "A gold ball; its alpha (not its colour) rises from bottom to top.",
       .draw = lit_alpha},
  };
}

}  // namespace gouraud::conformance
