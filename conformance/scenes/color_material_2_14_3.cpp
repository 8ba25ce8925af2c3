// ColorMaterial: the current colour drives a material. [GL1.5 §2.14.3]
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void prepare(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.35f, 0.35f, 0.35f, 1});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.8f, 0.8f, 0.8f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.8f, 0.8f, 0.8f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.41f, 0.57f, 0.73f, 0});
  for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR}) {
    material(gl, GL_FRONT_AND_BACK, pname, {0.3f, 0.3f, 0.3f, 1});
  }
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 18);
}

void rainbow(const GlTable& gl, const Surface::Point& point) {
  gl.Color4f(0.9f * point.u, 0.9f - 0.8f * point.v, 0.2f + 0.6f * point.v, 0.4f + 0.5f * point.u);
}

constexpr std::array<GLenum, 5> modes = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_AMBIENT_AND_DIFFUSE};

void color_material_modes(const GlTable& gl) {
  prepare(gl);
  const Matrix view = look(gl, {.distance = 8, .pitch_deg = 0, .yaw_deg = 0, .aspect = 3, .fov_y_deg = 26});
  const Surface ball = sphere(1, 20, 40);
  for (std::size_t i = 0; i < modes.size(); ++i) {
    load_model_view(gl, multiply(view, translation(2.15f * static_cast<float>(i) - 4.3f, 0, 0)));
    gl.ColorMaterial(GL_FRONT, modes[i]);
    gl.Enable(GL_COLOR_MATERIAL);
    draw_surface(gl, ball, [&](const Surface::Point& point) { rainbow(gl, point); });
    gl.Disable(GL_COLOR_MATERIAL);
    for (const GLenum pname : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR})
      material(gl, GL_FRONT, pname, {0.3f, 0.3f, 0.3f, 1});
    material(gl, GL_FRONT, GL_EMISSION, {0, 0, 0, 1});
  }
}

/// A pipe's inside above, its outside below, at `column` 0 or 1; the colour drives `face`.
void draw_pipes(const GlTable& gl, GLenum face, int column) {
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  const Matrix view = look(gl, {.distance = 7, .pitch_deg = 47, .yaw_deg = 8, .aspect = 1.5f});
  const Surface pipe = half_pipe(0.8f, 1.5f, 10, 30);
  const float x = 2.2f * static_cast<float>(column) - 1.1f;
  material(gl, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {0.4f, 0.4f, 0.4f, 1});
  gl.ColorMaterial(face, GL_AMBIENT_AND_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  load_model_view(gl, multiply(view, translation(x, 0.2f, -1.1f)));
  draw_surface(gl, pipe, [&](const Surface::Point& point) { rainbow(gl, point); });
  load_model_view(gl, multiply(view, multiply(translation(x, -0.2f, 1.1f), rotation(180, 2))));
  draw_surface(gl, pipe, [&](const Surface::Point& point) { rainbow(gl, point); });
  gl.Disable(GL_COLOR_MATERIAL);
}

void color_material_faces(const GlTable& gl) {
  prepare(gl);
  draw_pipes(gl, GL_FRONT, 0);
  draw_pipes(gl, GL_FRONT_AND_BACK, 1);
}

// Oracle only: for GL_BACK alone Mesa takes the back colours from nowhere; another colour in every driver and CPU mode.
void color_material_back(const GlTable& gl) {
  prepare(gl);
  draw_pipes(gl, GL_BACK, 0);
}

// glEnable takes the current colour over at once; glDisable leaves the material as it is; glMaterial does not
// change a parameter that the colour drives, but those that it does not.
void color_material_tracking(const GlTable& gl) {
  prepare(gl);
  const Matrix view = look(gl, {.distance = 8, .pitch_deg = 0, .yaw_deg = 0, .aspect = 3, .fov_y_deg = 26});
  const Surface ball = sphere(1, 20, 40);
  float x = -4.3f;
  const auto draw = [&] {
    load_model_view(gl, multiply(view, translation(x, 0, 0)));
    draw_surface(gl, ball);
    x += 2.15f;
  };
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
  gl.Color3f(0.8f, 0.2f, 0.2f);
  draw();  // not enabled: grey
  gl.Enable(GL_COLOR_MATERIAL);
  draw();  // red
  gl.Color3f(0.2f, 0.8f, 0.2f);
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.8f, 0.8f, 1});
  material(gl, GL_FRONT, GL_EMISSION, {0, 0, 0.35f, 1});
  draw();  // green with a blue glow
  gl.Disable(GL_COLOR_MATERIAL);
  gl.Color3f(0.8f, 0.8f, 0.2f);
  draw();  // still green
  gl.Enable(GL_COLOR_MATERIAL);
  gl.ColorMaterial(GL_FRONT, GL_AMBIENT);
  gl.Color3f(0.2f, 0.9f, 0.9f);
  draw();  // diffuse yellow from the moment of enabling, ambient cyan
}

// Colour and normal in every order, and several colours for one vertex: the last one counts.
void color_material_per_triangle(const GlTable& gl) {
  prepare(gl);
  gl.Enable(GL_COLOR_MATERIAL);  // initially ambient and diffuse of both faces
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  const Surface ring = torus(0.95f, 0.38f, 24, 12);
  Random random(141);
  for (int row = 0; row + 1 < ring.rows; ++row) {
    for (int column = 0; column + 1 < ring.columns; ++column) {
      gl.Begin(GL_TRIANGLE_STRIP);
      color_of(gl, random);
      for (const auto& [r, c] :
           {std::array{row + 1, column}, {row, column}, {row + 1, column + 1}, {row, column + 1}}) {
        gl.Normal3fv(ring.at(r, c).normal.data());
        if (random.below(3) == 0) {
          color_of(gl, random);
          color_of(gl, random);
        }
        gl.Vertex3fv(ring.at(r, c).position.data());
      }
      gl.End();
    }
  }
}

}  // namespace

SceneList color_material_scenes() {
  constexpr auto section = "§2.14.3";
  return {
      {.name = "color_material_modes",
       .section = section,
       .shows =
           "Five balls whose rainbow colours drive emission, ambient, diffuse, specular, and ambient with diffuse.",
       .width_px = 480,
       .height_px = 160,
       .draw = color_material_modes},
      {.name = "color_material_faces",
       .section = section,
       .shows = "Two pipes, inside above and outside below: the left one has the rainbow inside only, the right one on "
                "both sides.",
       .width_px = 390,
       .height_px = 260,
       .draw = color_material_faces},
      {.name = "color_material_back",
       .section = section,
       .shows = "A pipe in grey inside, the rainbow outside.",
       .judge = Judge::oracle_only,
       .width_px = 390,
       .height_px = 260,
       .draw = color_material_back},
      {.name = "color_material_tracking",
       .section = section,
       .shows = "Balls in grey, red, green glowing blue, the same, and yellow with cyan in its shade.",
       .width_px = 480,
       .height_px = 160,
       .draw = color_material_tracking},
      {.name = "color_material_per_triangle",
       .section = section,
       .shows = "A lit ring of patches in random colours, blending where a vertex changed the colour.",
       .draw = color_material_per_triangle},
  };
}

}  // namespace gouraud::conformance
