// Attenuation and spot lights, equations 2.4 and 2.5, over finely tessellated floors. [GL1.5 §2.14.1]
// No floor vertex lies on the rim of a cone.
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr int cells = 36;

/// A lamp in eye coordinates over a floor that faces the eye at z = -5.
struct Lamp {
  Four position = {0.13f, 0.17f, -3.9f, 1};
  std::array<float, 3> direction = {0.03f, -0.02f, -1};
  float cutoff_deg = 180, exponent = 0;
  std::array<float, 3> attenuation = {1, 0, 0};
};

void set(const GlTable& gl, GLenum name, const Lamp& lamp) {
  light(gl, name, GL_POSITION, lamp.position);
  gl.Lightfv(name, GL_SPOT_DIRECTION, lamp.direction.data());
  gl.Lightf(name, GL_SPOT_CUTOFF, lamp.cutoff_deg);
  gl.Lightf(name, GL_SPOT_EXPONENT, lamp.exponent);
  gl.Lightf(name, GL_CONSTANT_ATTENUATION, lamp.attenuation[0]);
  gl.Lightf(name, GL_LINEAR_ATTENUATION, lamp.attenuation[1]);
  gl.Lightf(name, GL_QUADRATIC_ATTENUATION, lamp.attenuation[2]);
}

void prepare(const GlTable& gl, int lights) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, lights);
  for (GLenum i = 0; i < static_cast<GLenum>(lights); ++i) light(gl, GL_LIGHT0 + i, GL_DIFFUSE, {1, 1, 1, 1});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.9f, 0.85f, 0.7f, 1});
}

/// The floor, seen straight on, of 2.6 units; a faint emission keeps its dark parts off the background.
void draw_panel(const GlTable& gl) {
  material(gl, GL_FRONT, GL_EMISSION, {0.03f, 0.05f, 0.04f, 1});
  load_projection(gl, perspective(30, 1, 1, 20));
  load_model_view(gl, multiply(translation(0, 0, -5), rotation(90, 0)));
  draw_surface(gl, floor_grid(2.6f, cells));
}

/// Lamps side by side, three panels a row, bottom row first, in a picture of 390 pixels.
template <std::size_t count>
void draw_panels(const GlTable& gl, const std::array<Lamp, count>& lamps) {
  prepare(gl, 1);
  for (std::size_t i = 0; i < count; ++i) {
    gl.Viewport(static_cast<GLint>(130 * (i % 3)), static_cast<GLint>(130 * (i / 3)), 130, 130);
    load_model_view(gl, translation(0, 0, 0));
    set(gl, GL_LIGHT0, lamps[i]);
    draw_panel(gl);
  }
}

void attenuation_kinds(const GlTable& gl) {
  draw_panels(gl, std::array<Lamp, 6>{{{.attenuation = {1, 0, 0}},
                                       {.attenuation = {2.3f, 0, 0}},
                                       {.attenuation = {0, 0.9f, 0}},
                                       {.attenuation = {0, 0, 0.8f}},
                                       {.attenuation = {0.3f, 0.4f, 0.5f}},
                                       {.attenuation = {0, 0, 12}}}});
}

// A directional light is not attenuated, whatever its factors are.
void attenuation_directional(const GlTable& gl) {
  prepare(gl, 1);
  set(gl, GL_LIGHT0, {.position = {0.31f, 0.27f, 0.89f, 0}, .attenuation = {9, 9, 9}});
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.2f, 0.7f, 0.75f, 1});
  draw_surface(gl, torus(0.95f, 0.38f, 48, 24));
}

void spot_cutoffs(const GlTable& gl) {
  draw_panels(gl, std::array<Lamp, 6>{{{.cutoff_deg = 7.3f},
                                       {.cutoff_deg = 15.1f},
                                       {.cutoff_deg = 30.2f},
                                       {.cutoff_deg = 45.3f},
                                       {.cutoff_deg = 60.4f},
                                       {.cutoff_deg = 90}}});
}

void spot_exponents(const GlTable& gl) {
  draw_panels(gl, std::array<Lamp, 6>{{{.cutoff_deg = 48.3f, .exponent = 0},
                                       {.cutoff_deg = 48.3f, .exponent = 0.7f},
                                       {.cutoff_deg = 48.3f, .exponent = 3},
                                       {.cutoff_deg = 48.3f, .exponent = 13.6f},
                                       {.cutoff_deg = 48.3f, .exponent = 64},
                                       {.cutoff_deg = 48.3f, .exponent = 128}}});
}

// Directions need no unit length; a lamp that looks away lights nothing, with cut-off 180 everything.
void spot_directions(const GlTable& gl) {
  draw_panels(gl, std::array<Lamp, 6>{{{.direction = {1.7f, 0.4f, -2.3f}, .cutoff_deg = 33.7f, .exponent = 2},
                                       {.direction = {-0.02f, 0.013f, -0.04f}, .cutoff_deg = 33.7f, .exponent = 2},
                                       {.direction = {-31, -44, -52}, .cutoff_deg = 33.7f, .exponent = 2},
                                       {.direction = {0.1f, 0.2f, 1}, .cutoff_deg = 77.7f},
                                       {.direction = {0.1f, 0.2f, 1}, .cutoff_deg = 180, .exponent = 5},
                                       {.direction = {0.97f, 0.21f, -0.13f}, .cutoff_deg = 87.7f, .exponent = 1}}});
}

// The factor 1 / (k0 + k1 d + k2 d^2) beside the cone: both at once, with highlights.
void spot_with_attenuation(const GlTable& gl) {
  prepare(gl, 1);
  light(gl, GL_LIGHT0, GL_SPECULAR, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.2f, 0.2f, 0.3f, 1});
  material(gl, GL_FRONT, GL_AMBIENT, {0.6f, 0.5f, 0.5f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.6f, 0.6f, 0.6f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 22);
  set(gl, GL_LIGHT0,
      {.position = {1.1f, 1.7f, -3.6f, 1},
       .direction = {-0.7f, -1.3f, -1.1f},
       .cutoff_deg = 34.3f,
       .exponent = 9,
       .attenuation = {0.5f, 0.2f, 0.06f}});
  const Matrix view = look(gl, {.distance = 5.5f, .pitch_deg = 33, .yaw_deg = 30});
  load_model_view(gl, multiply(view, translation(0, -0.5f, 0)));
  draw_surface(gl, floor_grid(5, 50));
  load_model_view(gl, multiply(view, translation(0.1f, 0.2f, 0.1f)));
  draw_surface(gl, sphere(0.7f, 24, 48));
}

void three_colored_spots(const GlTable& gl) {
  prepare(gl, 3);
  const Four colors[3] = {{0.9f, 0.1f, 0.1f, 1}, {0.1f, 0.9f, 0.1f, 1}, {0.1f, 0.1f, 0.9f, 1}};
  const float places[3][2] = {{-0.43f, -0.31f}, {0.47f, -0.29f}, {0.03f, 0.51f}};
  for (GLenum i = 0; i < 3; ++i) {
    light(gl, GL_LIGHT0 + i, GL_DIFFUSE, colors[i]);
    set(gl, GL_LIGHT0 + i, {.position = {places[i][0], places[i][1], -3.6f, 1}, .cutoff_deg = 26.3f, .exponent = 3.3f});
  }
  draw_panel(gl);
}

// Position and direction are taken into eye space by the model-view matrix of the moment they are given.
void spots_under_model_view(const GlTable& gl) {
  prepare(gl, 4);
  const Matrix view = look(gl, {.distance = 5.5f, .pitch_deg = 52, .yaw_deg = 25});
  for (GLenum i = 0; i < 4; ++i) {
    light(gl, GL_LIGHT0 + i, GL_DIFFUSE, {i & 1 ? 0.9f : 0.3f, i & 2 ? 0.9f : 0.3f, 0.5f, 1});
    const float turn_deg = 90 * static_cast<float>(i) + 17;
    load_model_view(gl, multiply(view, multiply(rotation(turn_deg, 1), scaling(1.3f, 0.8f, 1))));
    set(gl, GL_LIGHT0 + i,
        {.position = {0.6f, 1.1f, 0.2f, 1}, .direction = {0.4f, -1, 0.1f}, .cutoff_deg = 37.3f, .exponent = 1.5f});
  }
  load_model_view(gl, view);
  material(gl, GL_FRONT, GL_EMISSION, {0.03f, 0.05f, 0.04f, 1});
  draw_surface(gl, floor_grid(4, 48));
}

}  // namespace

SceneList spot_light_scenes() {
  constexpr auto section = "§2.14.1";
  return {
      {.name = "attenuation_kinds",
       .section = section,
       .shows = "A lamp over six floors: constant 1, constant 2.3, linear; above them quadratic, all three, strongly "
                "quadratic.",
       .width_px = 390,
       .height_px = 260,
       .draw = attenuation_kinds},
      {.name = "attenuation_directional",
       .section = section,
       .shows = "A bright ring: attenuation factors of 9 do nothing to a directional light.",
       .draw = attenuation_directional},
      {.name = "spot_cutoffs",
       .section = section,
       .shows = "Six spots: cones of 7.3, 15.1 and 30.2 degrees; above them 45.3, 60.4 and 90.",
       .width_px = 390,
       .height_px = 260,
       .draw = spot_cutoffs},
      {.name = "spot_exponents",
       .section = section,
       .shows = "Six equal cones with exponents 0, 0.7, 3; above them 13.6, 64, 128: ever more concentrated.",
       .width_px = 390,
       .height_px = 260,
       .draw = spot_exponents},
      {.name = "spot_directions",
       .section = section,
       .shows = "Spots to the right, the upper left, the lower left; above them one turned away, one that shines "
                "everywhere, a grazing one.",
       .width_px = 390,
       .height_px = 260,
       .draw = spot_directions},
      {.name = "spot_with_attenuation",
       .section = section,
       .shows = "An attenuated spot from the upper right on a ball over a floor, its pool of light fading to the left.",
       .draw = spot_with_attenuation},
      {.name = "spots_overlapping",
       .section = section,
       .shows = "Red, green and blue pools of light that mix in the middle.",
       .draw = three_colored_spots},
      {.name = "spots_under_model_view",
       .section = section,
       .shows = "Four pools of light around the middle of a floor, placed by four model-view matrices.",
       .draw = spots_under_model_view},
  };
}

}  // namespace gouraud::conformance
