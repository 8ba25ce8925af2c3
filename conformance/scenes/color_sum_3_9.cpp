// Separate specular colour, added after rasterization. [GL1.5 §2.14.1, §3.9]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void draw_plastic(const GlTable& gl, GLenum color_control, GLenum shade_model, int slices) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(shade_model);
  black_lighting(gl, 2);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, static_cast<GLint>(color_control));
  for (const GLenum i : {GL_LIGHT0, GL_LIGHT1}) {
    const float strength = i == GL_LIGHT0 ? 0.83f : 0.41f;
    light(gl, i, GL_DIFFUSE, {strength, strength, strength, 1});
    light(gl, i, GL_SPECULAR, {strength, strength, strength, 1});
  }
  light(gl, GL_LIGHT0, GL_POSITION, {0.43f, 0.67f, 0.59f, 0});
  light(gl, GL_LIGHT1, GL_POSITION, {-1.7f, 0.6f, -2.1f, 1});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.75f, 0.25f, 0.3f, 0.8f});
  material(gl, GL_FRONT, GL_SPECULAR, {0.7f, 0.7f, 0.5f, 0.3f});
  gl.Materialf(GL_FRONT, GL_SHININESS, 7);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, slices, slices / 2));
}

void separate(const GlTable& gl) {
  draw_plastic(gl, GL_SEPARATE_SPECULAR_COLOR, GL_SMOOTH, 48);
}
void single(const GlTable& gl) {
  draw_plastic(gl, GL_SINGLE_COLOR, GL_SMOOTH, 48);
}

// Coarse facets: both colours are clamped at the vertices, and interpolated apart from each other.
void separate_coarse(const GlTable& gl) {
  draw_plastic(gl, GL_SEPARATE_SPECULAR_COLOR, GL_SMOOTH, 12);
}
void separate_flat(const GlTable& gl) {
  draw_plastic(gl, GL_SEPARATE_SPECULAR_COLOR, GL_FLAT, 24);
}

void separate_two_sided(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.7f, 0.7f, 0.7f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.09f, 0.71f, 0.63f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.3f, 0.2f, 1});
  material(gl, GL_BACK, GL_DIFFUSE, {0.2f, 0.3f, 0.8f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.2f, 0.7f, 0.2f, 1});
  material(gl, GL_BACK, GL_SPECULAR, {0.8f, 0.7f, 0.2f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 12);
  gl.Materialf(GL_BACK, GL_SHININESS, 30);
  const Matrix view = look(gl, {.distance = 6.9f, .pitch_deg = 41, .yaw_deg = 14});
  const Surface pipe = half_pipe(0.9f, 1.9f, 12, 32);
  load_model_view(gl, multiply(view, translation(-1, 0.4f, 0)));
  draw_surface(gl, pipe);
  load_model_view(gl, multiply(view, multiply(translation(1, -0.3f, 0), rotation(168, 2))));
  draw_surface(gl, pipe);
}

}  // namespace

SceneList color_sum_scenes() {
  constexpr auto section = "§3.9";
  return {
      {.name = "specular_single",
       .section = section,
       .shows = "A red ring with broad highlights in one colour sum.",
       .draw = single},
      {.name = "specular_separate",
       .section = section,
       .shows = "The same ring with separate specular colour: nearly the same.",
       .draw = separate},
      {.name = "specular_separate_coarse",
       .section = section,
       .shows = "A coarse ring with separate specular colour, its highlights in facets.",
       .draw = separate_coarse},
      {.name = "specular_separate_flat",
       .section = section,
       .shows = "A flat ring: both colours of the provoking vertex.",
       .draw = separate_flat},
      {.name = "specular_separate_two_sided",
       .section = section,
       .shows = "Half pipes: red with green sheen inside, blue with gold sheen outside.",
       .draw = separate_two_sided},
  };
}

}  // namespace gouraud::conformance
