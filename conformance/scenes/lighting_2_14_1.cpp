// The lighting equation 2.1 term by term, then all of it [GL1.5 §2.14.1]. Spot lights and attenuation have their own
// file. Directions are generic: no vertex lies where n . VP is 0, on which a highlight or the lit side would hang.
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr Four key_direction = {0.43f, 0.67f, 0.59f, 0};

/// The exhibit: a tilted ring around a ball. `eye_lights` sets light and material while eye space is object space.
template <class EyeLights>
void show(const GlTable& gl, int lights, EyeLights eye_lights) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, lights);
  load_model_view(gl, translation(0, 0, 0));
  eye_lights();
  look(gl, {.distance = 4.4f, .pitch_deg = 36, .yaw_deg = 27});
  draw_surface(gl, torus(0.97f, 0.34f, 48, 24));
  draw_surface(gl, sphere(0.52f, 20, 40));
}

void emission(const GlTable& gl) {
  show(gl, 0, [&] { material(gl, GL_FRONT, GL_EMISSION, {0.8f, 0.4f, 0.2f, 1}); });
}

void model_ambient(const GlTable& gl) {
  show(gl, 0, [&] {
    const Four ambient = {0.4f, 0.8f, 0.6f, 1};
    gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient.data());
    material(gl, GL_FRONT, GL_AMBIENT, {0.55f, 0.9f, 0.35f, 1});
  });
}

void ambient(const GlTable& gl) {
  show(gl, 1, [&] {
    light(gl, GL_LIGHT0, GL_AMBIENT, {0.6f, 0.4f, 0.8f, 1});
    light(gl, GL_LIGHT0, GL_POSITION, key_direction);
    material(gl, GL_FRONT, GL_AMBIENT, {0.9f, 0.7f, 0.2f, 1});
  });
}

void diffuse(const GlTable& gl) {
  show(gl, 1, [&] {
    light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.8f, 0.7f, 1});
    light(gl, GL_LIGHT0, GL_POSITION, key_direction);
    material(gl, GL_FRONT, GL_DIFFUSE, {0.3f, 0.7f, 0.9f, 0.6f});
  });
}

void specular(const GlTable& gl) {
  show(gl, 1, [&] {
    light(gl, GL_LIGHT0, GL_SPECULAR, {0.9f, 0.9f, 0.7f, 1});
    light(gl, GL_LIGHT0, GL_POSITION, key_direction);
    material(gl, GL_FRONT, GL_SPECULAR, {0.8f, 0.9f, 0.9f, 1});
    gl.Materialf(GL_FRONT, GL_SHININESS, 9);
  });
}

void plastic(const GlTable& gl) {
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.15f, 0.15f, 0.2f, 1});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.8f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.8f, 0.8f, 0.8f, 1});
  material(gl, GL_FRONT, GL_AMBIENT, {0.8f, 0.3f, 0.3f, 1});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.3f, 0.3f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.7f, 0.7f, 0.7f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 35);
}

void directional_plastic(const GlTable& gl) {
  show(gl, 1, [&] {
    plastic(gl);
    light(gl, GL_LIGHT0, GL_POSITION, {4.3f, 6.7f, 5.9f, 0});  // its length does not matter
  });
}

void positional_plastic(const GlTable& gl) {
  show(gl, 1, [&] {
    plastic(gl);
    light(gl, GL_LIGHT0, GL_POSITION, {1.13f, 0.91f, -3.17f, 1});
  });
}

// (x, y, z, w) stands for the place (x, y, z) / w.
void position_with_w(const GlTable& gl) {
  show(gl, 1, [&] {
    plastic(gl);
    light(gl, GL_LIGHT0, GL_POSITION, {-0.61f, 0.52f, -1.21f, 0.4f});
  });
}

void local_viewer(const GlTable& gl) {
  show(gl, 1, [&] {
    plastic(gl);
    gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    light(gl, GL_LIGHT0, GL_POSITION, key_direction);
  });
}

void local_viewer_positional(const GlTable& gl) {
  show(gl, 1, [&] {
    plastic(gl);
    gl.LightModelf(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
    light(gl, GL_LIGHT0, GL_POSITION, {1.13f, 0.91f, -3.17f, 1});
  });
}

void light_behind(const GlTable& gl) {
  show(gl, 1, [&] {
    plastic(gl);
    light(gl, GL_LIGHT0, GL_POSITION, {-0.43f, 0.47f, -0.81f, 0});
  });
}

// A light may have negative colours: it takes from what another gives.
void negative_light(const GlTable& gl) {
  show(gl, 2, [&] {
    plastic(gl);
    light(gl, GL_LIGHT0, GL_POSITION, key_direction);
    light(gl, GL_LIGHT1, GL_DIFFUSE, {-0.9f, 0.2f, -0.4f, 1});
    light(gl, GL_LIGHT1, GL_POSITION, {0.83f, -0.11f, 0.57f, 0});
  });
}

void disabled_lights_between(const GlTable& gl) {
  show(gl, 8, [&] {
    plastic(gl);
    light(gl, GL_LIGHT0, GL_POSITION, key_direction);
    material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.8f, 0.8f, 1});
    light(gl, GL_LIGHT3, GL_DIFFUSE, {0.2f, 0.9f, 0.3f, 1});
    light(gl, GL_LIGHT3, GL_POSITION, {-0.77f, 0.13f, 0.41f, 0});
    light(gl, GL_LIGHT6, GL_DIFFUSE, {0.9f, 0.1f, 0.9f, 1});
    light(gl, GL_LIGHT6, GL_POSITION, {0.11f, -0.93f, 0.29f, 0});
    gl.Disable(GL_LIGHT0);
    gl.Disable(GL_LIGHT6);
  });
}

void eight_lights(const GlTable& gl) {
  show(gl, 8, [&] {
    material(gl, GL_FRONT, GL_DIFFUSE, {0.6f, 0.6f, 0.6f, 1});
    material(gl, GL_FRONT, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
    gl.Materialf(GL_FRONT, GL_SHININESS, 60);
    const float places[8][4] = {{0.91f, 0.23f, 0.41f, 0},  {0.57f, 0.79f, 0.37f, 0}, {-0.17f, 0.93f, 0.43f, 0},
                                {-0.83f, 0.47f, 0.39f, 0}, {-1.9f, -0.3f, -3.1f, 1}, {-1.1f, -1.7f, -2.9f, 1},
                                {0.4f, -1.9f, -3.2f, 1},   {1.8f, -1.1f, -3.3f, 1}};
    for (GLenum i = 0; i < 8; ++i) {
      const Four color = {i & 1 ? 0.45f : 0, i & 2 ? 0.45f : 0, i & 4 ? 0.5f : 0.05f, 1};
      light(gl, GL_LIGHT0 + i, GL_DIFFUSE, color);
      light(gl, GL_LIGHT0 + i, GL_SPECULAR, color);
      gl.Lightfv(GL_LIGHT0 + i, GL_POSITION, places[i]);
    }
  });
}

/// Two half pipes, seen from within (left) and from without (right); normals point inward.
void draw_pipes(const GlTable& gl) {
  const Matrix view = look(gl, {.distance = 6, .pitch_deg = 38, .yaw_deg = 12, .aspect = 1.6f});
  const Surface pipe = half_pipe(0.9f, 2, 12, 32);
  load_model_view(gl, multiply(view, multiply(translation(-1.35f, 0.3f, 0), rotation(-14, 2))));
  draw_surface(gl, pipe);
  load_model_view(gl, multiply(view, multiply(translation(1.35f, -0.3f, 0), rotation(163, 2))));
  draw_surface(gl, pipe);
}

void light_pipes(const GlTable& gl, bool two_sided) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 3);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, two_sided ? 1 : 0);
  for (const GLenum i : {GL_LIGHT0, GL_LIGHT1, GL_LIGHT2}) {
    light(gl, i, GL_DIFFUSE, {0.55f, 0.55f, 0.55f, 1});
    light(gl, i, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
  }
  light(gl, GL_LIGHT0, GL_POSITION, {0.37f, 0.71f, 0.63f, 0});
  light(gl, GL_LIGHT1, GL_POSITION, {-2.3f, 0.9f, -2.7f, 1});
  light(gl, GL_LIGHT2, GL_POSITION, {0.27f, -0.53f, -0.81f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.6f, 0.2f, 1});
  material(gl, GL_BACK, GL_DIFFUSE, {0.2f, 0.5f, 0.8f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.8f, 0.8f, 0.8f, 1});
  material(gl, GL_BACK, GL_SPECULAR, {0.2f, 0.9f, 0.3f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 25);
  gl.Materialf(GL_BACK, GL_SHININESS, 6);
  draw_pipes(gl);
}

void two_sided(const GlTable& gl) {
  light_pipes(gl, true);
}
void one_sided(const GlTable& gl) {
  light_pipes(gl, false);
}

// Which face is the back is glFrontFace's choice; culling and lighting follow the same one.
void two_sided_clockwise(const GlTable& gl) {
  gl.FrontFace(GL_CW);
  light_pipes(gl, true);
}

void shininess_row(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.6f, 0.6f, 0.6f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.31f, 0.53f, 0.79f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.3f, 0.5f, 0.3f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.6f, 0.6f, 0.6f, 1});
  const Matrix view = look(gl, {.distance = 9, .pitch_deg = 0, .yaw_deg = 0, .aspect = 2, .fov_y_deg = 29});
  const float exponents[8] = {0, 0.5f, 1, 4, 17.3f, 40, 100, 128};
  for (int i = 0; i < 8; ++i) {
    const float x = -3.3f + 2.2f * static_cast<float>(i % 4), y = i < 4 ? 1.1f : -1.1f;
    gl.Materialf(GL_FRONT, GL_SHININESS, exponents[i]);
    load_model_view(gl, multiply(view, multiply(translation(x, y, 0), rotation(17, 0))));
    draw_surface(gl, sphere(0.97f, 40, 80));
  }
}

void everything_together(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_NORMALIZE);
  black_lighting(gl, 5);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, 1);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
  const Four model = {0.12f, 0.08f, 0.16f, 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, model.data());
  for (GLenum i = 0; i < 5; ++i) {
    light(gl, GL_LIGHT0 + i, GL_AMBIENT, {0.02f, 0.04f, 0.03f, 1});
    light(gl, GL_LIGHT0 + i, GL_DIFFUSE, {i == 1 ? 0.6f : 0.25f, i == 2 ? 0.6f : 0.2f, i == 3 ? 0.7f : 0.15f, 1});
    light(gl, GL_LIGHT0 + i, GL_SPECULAR, {0.4f, 0.4f, 0.5f, 1});
  }
  light(gl, GL_LIGHT0, GL_POSITION, key_direction);
  light(gl, GL_LIGHT1, GL_POSITION, {-2.1f, 1.3f, -2.8f, 1});
  gl.Lightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.21f);
  for (const GLenum spot : {GL_LIGHT2, GL_LIGHT3}) {
    const float side = spot == GL_LIGHT2 ? -1.0f : 1.0f;
    light(gl, spot, GL_POSITION, {1.7f * side, 1.9f, -3.3f, 1});
    const float direction[3] = {-0.5f * side, -0.8f, -0.63f};
    gl.Lightfv(spot, GL_SPOT_DIRECTION, direction);
    gl.Lightf(spot, GL_SPOT_CUTOFF, 41.7f);
    gl.Lightf(spot, GL_SPOT_EXPONENT, 7.5f);
    gl.Lightf(spot, GL_QUADRATIC_ATTENUATION, 0.07f);
  }
  light(gl, GL_LIGHT4, GL_POSITION, {0.21f, -0.87f, 0.33f, 0});
  for (const GLenum face : {GL_FRONT, GL_BACK}) {
    const float back = face == GL_BACK ? 0.5f : 0.0f;
    material(gl, face, GL_AMBIENT, {0.8f, 0.6f, 0.4f, 1});
    material(gl, face, GL_SPECULAR, {0.7f, 0.7f - back, 0.7f, 1});
    material(gl, face, GL_EMISSION, {0.04f, back * 0.2f, 0.06f, 1});
    gl.Materialf(face, GL_SHININESS, face == GL_BACK ? 11.0f : 43.0f);
  }
  gl.ColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  const Matrix view = look(gl, {.distance = 4.9f, .pitch_deg = 38, .yaw_deg = 22});
  const auto by_place = [&](const Surface::Point& point) {
    gl.Color3f(0.9f - 0.7f * point.u, 0.3f + 0.5f * point.v, 0.6f);
  };
  draw_surface(gl, torus(1.1f, 0.4f, 48, 24), by_place);
  load_model_view(gl, multiply(view, multiply(translation(-0.1f, 0.9f, 0.1f), scaling(1.1f, 1.2f, 0.5f))));
  draw_surface(gl, half_pipe(0.9f, 2.2f, 16, 32), by_place);
}

}  // namespace

SceneList lighting_scenes() {
  constexpr auto section = "§2.14.1";
  return {
      {.name = "light_emission",
       .section = section,
       .shows = "Ring and ball of one flat orange: emission alone.",
       .draw = emission},
      {.name = "light_model_ambient",
       .section = section,
       .shows = "Ring and ball of one flat green: the model's ambient light alone.",
       .draw = model_ambient},
      {.name = "light_ambient",
       .section = section,
       .shows = "Ring and ball of one flat brown: a light's ambient term alone.",
       .draw = ambient},
      {.name = "light_diffuse",
       .section = section,
       .shows = "Ring and ball in blue, lit from the upper right, black on the far side.",
       .draw = diffuse},
      {.name = "light_specular", .section = section, .shows = "Only broad highlights on black.", .draw = specular},
      {.name = "light_directional",
       .section = section,
       .shows = "Red plastic under a directional light: all terms.",
       .draw = directional_plastic},
      {.name = "light_positional",
       .section = section,
       .shows = "Red plastic under a light close by on the right: brightest around it.",
       .draw = positional_plastic},
      {.name = "light_position_w",
       .section = section,
       .shows = "Red plastic under a light on the left whose position has w = 0.4.",
       .draw = position_with_w},
      {.name = "light_local_viewer",
       .section = section,
       .shows = "The directional scene with a local viewer: the highlights move.",
       .draw = local_viewer},
      {.name = "light_local_viewer_positional",
       .section = section,
       .shows = "The positional scene with a local viewer.",
       .draw = local_viewer_positional},
      {.name = "light_behind",
       .section = section,
       .shows = "A light behind: only rims and tops are lit, no highlight on dark sides.",
       .draw = light_behind},
      {.name = "light_negative",
       .section = section,
       .shows = "Red plastic from which a second, negative light on the right takes red and adds green.",
       .draw = negative_light},
      {.name = "lights_disabled",
       .section = section,
       .shows = "Eight lights, of which only the green one on the left shines: the others are disabled or black.",
       .draw = disabled_lights_between},
      {.name = "lights_eight",
       .section = section,
       .shows = "Grey ring and ball under eight coloured lights from all round.",
       .draw = eight_lights},
      {.name = "two_sided",
       .section = section,
       .shows = "Two half pipes, golden inside and blue with green sheen outside.",
       .width_px = 320,
       .height_px = 200,
       .draw = two_sided},
      {.name = "one_sided",
       .section = section,
       .shows = "The half pipes without two-sided lighting: outside golden too, and lit only where its inward normals "
                "see the light behind.",
       .width_px = 320,
       .height_px = 200,
       .draw = one_sided},
      {.name = "two_sided_clockwise",
       .section = section,
       .shows = "The half pipes with clockwise fronts: blue inside and gold outside, each lit from the other side.",
       .width_px = 320,
       .height_px = 200,
       .draw = two_sided_clockwise},
      {.name = "shininess_row",
       .section = section,
       .shows = "Eight spheres with shininess 0, 0.5, 1, 4; 17.3, 40, 100, 128: highlights from all over to a dot.",
       .width_px = 512,
       .height_px = 256,
       .draw = shininess_row},
      {.name = "light_everything",
       .section = section,
       .shows = "Five lights of all kinds on a striped ring and a stretched pipe, two-sided, separate specular, local "
                "viewer.",
       .draw = everything_together},
  };
}

}  // namespace gouraud::conformance
