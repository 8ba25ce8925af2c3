// Matrix commands, their double and transposed forms, and the stacks. [GL1.5 §2.11.2]
#include <array>
#include <functional>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

Matrix transposed(const Matrix& matrix) {
  Matrix result;
  for (std::size_t i = 0; i < 16; ++i) result[i] = matrix[4 * (i % 4) + i / 4];
  return result;
}

std::array<double, 16> doubled(const Matrix& matrix) {
  std::array<double, 16> result;
  for (std::size_t i = 0; i < 16; ++i) result[i] = matrix[i];
  return result;
}

/// An arrow of four colours within [-1, 1], without symmetry.
void draw_arrow(const GlTable& gl) {
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(0.8f, 0.2f, 0.2f);
  gl.Vertex3f(0.86f, 0.07f, 0.11f);
  gl.Color3f(0.2f, 0.8f, 0.2f);
  gl.Vertex3f(0.12f, 0.74f, -0.13f);
  gl.Color3f(0.2f, 0.2f, 0.8f);
  gl.Vertex3f(0.17f, -0.52f, 0.05f);
  gl.Color3f(0.8f, 0.8f, 0.2f);
  gl.Vertex3f(0.14f, 0.33f, 0.21f);
  gl.Vertex3f(-0.83f, 0.24f, -0.09f);
  gl.Color3f(0.2f, 0.8f, 0.8f);
  gl.Vertex3f(0.16f, -0.17f, 0.02f);
  gl.End();
}

// One cell per command. Each lands on its own place of the grid by what stands in the matrix before.
void matrix_commands(const GlTable& gl) {
  const Matrix turned = multiply(rotation(37, 2), scaling(0.9f, 0.7f, 0.8f));
  const Matrix projected = multiply(turned, Matrix{1, 0, 0, 0.15f, 0, 1, 0, -0.1f, 0, 0, 1, 0, 0, 0, 0, 1});
  const Matrix backwards = transposed(projected);
  const std::array<double, 16> projected_d = doubled(projected), backwards_d = doubled(backwards);
  const std::array<std::function<void()>, 16> commands = {
      [&] { gl.LoadIdentity(); },
      [&] { gl.LoadMatrixf(projected.data()); },
      [&] { gl.LoadMatrixd(projected_d.data()); },
      [&] { gl.LoadTransposeMatrixf(backwards.data()); },
      [&] { gl.LoadTransposeMatrixd(backwards_d.data()); },
      [&] { gl.MultMatrixf(projected.data()); },
      [&] { gl.MultMatrixd(projected_d.data()); },
      [&] { gl.MultTransposeMatrixf(backwards.data()); },
      [&] { gl.MultTransposeMatrixd(backwards_d.data()); },
      [&] { gl.Translatef(0.12f, -0.21f, 0.3f); },
      [&] { gl.Translated(-0.17, 0.23, -0.3); },
      [&] { gl.Scalef(0.5f, 1.1f, 0.7f); },
      [&] { gl.Scaled(1.1, -0.4, 0.7); },
      [&] { gl.Rotatef(71, 0, 0, 1); },
      [&] { gl.Rotated(-129, 0.3, -0.5, 0.8); },
      [&] { gl.Rotatef(200, 2, 1, 0.5f); },
  };
  clear_background(gl);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    gl.Viewport(static_cast<GLint>(64 * (i % 4)), static_cast<GLint>(64 * (i / 4)), 64, 64);
    const Matrix before = multiply(rotation(180, 0), scaling(0.95f, 0.8f, 0.6f));
    gl.LoadMatrixf(before.data());
    commands[i]();
    draw_arrow(gl);
  }
}

void ortho_and_frustum(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  const auto scene = [&] {
    Random random(101);
    const Matrix view = multiply(translation(0.2f, -0.3f, -5), multiply(rotation(29, 0), rotation(41, 1)));
    for (int i = 0; i < 27; ++i) {
      const float x = static_cast<float>(i % 3 - 1), y = static_cast<float>(i / 3 % 3 - 1);
      const float z = static_cast<float>(i / 9 - 1);
      load_model_view(gl, multiply(view, translation(1.1f * x, 1.1f * y, 1.1f * z)));
      gl.ShadeModel(GL_SMOOTH);
      color_of(gl, random);
      draw_box(gl, 0.7f, 0.6f, 0.5f);
    }
  };
  gl.Viewport(0, 0, 250, 250);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Ortho(-2.2, 2.1, -2.0, 2.3, 1.5, 9.25);
  scene();
  gl.Viewport(250, 0, 250, 250);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.9, 1.1, -1.0, 0.9, 2.25, 9.75);
  scene();
}

void branch(const GlTable& gl, int depth) {
  const float green = 0.2f + 0.07f * static_cast<float>(9 - depth);
  gl.Color3f(0.75f - 0.06f * static_cast<float>(9 - depth), green, 0.2f);
  gl.Begin(GL_TRIANGLE_STRIP);
  gl.Vertex2f(-0.06f, 0);
  gl.Vertex2f(0.06f, 0);
  gl.Vertex2f(-0.045f, 0.5f);
  gl.Vertex2f(0.045f, 0.5f);
  gl.End();
  if (depth == 0) return;
  for (const float angle_deg : {31.0f, -24.0f}) {
    const Matrix turn = rotation(angle_deg, 2);
    gl.PushMatrix();
    gl.Translatef(0, 0.49f, 0);
    gl.MultMatrixf(turn.data());
    gl.Scalef(0.78f, 0.78f, 0.78f);
    branch(gl, depth - 1);
    gl.PopMatrix();
  }
}

void stack_tree(const GlTable& gl) {
  clear_background(gl);
  gl.Translatef(0.03f, -0.87f, 0);
  gl.Scalef(0.79f, 0.79f, 1);
  branch(gl, 9);
}

// 31 pushes on the model-view stack, 9 on the texture stack, 1 on the projection stack; then all of them undone.
void stacks_to_the_limit(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.MatrixMode(GL_PROJECTION);
  gl.PushMatrix();
  gl.Scalef(0.5f, 0.5f, 1);
  gl.MatrixMode(GL_TEXTURE);
  for (int i = 0; i < 9; ++i) {
    gl.PushMatrix();
    gl.Scalef(3, 2, 1);
  }
  gl.MatrixMode(GL_MODELVIEW);
  Random random(102);
  for (int i = 0; i < 31; ++i) {
    color_of(gl, random);
    draw_rectangle(gl, 10.3f, 11.2f, 250.3f, 251.2f, 0);
    gl.PushMatrix();
    gl.Translatef(3.1f, 2.7f, 0);
    gl.Scalef(0.97f, 0.95f, 1);
  }
  gl.MatrixMode(GL_PROJECTION);
  gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW);
  for (int i = 0; i < 31; ++i) {
    gl.PopMatrix();
    color_of(gl, random);
    draw_rectangle(gl, 131.4f, 131.2f, 251.1f, 134.3f, 0);
  }
  gl.MatrixMode(GL_TEXTURE);
  for (int i = 0; i < 9; ++i) gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW);
}

void robot_arm(const GlTable& gl) {
  clear_background(gl);
  light(gl, GL_LIGHT0, GL_POSITION, {0.52f, 0.61f, 0.72f, 0});
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 9, .pitch_deg = 18, .yaw_deg = 27});
  const auto part = [&](float red, float green, float blue, float length) {
    material(gl, GL_FRONT, GL_AMBIENT_AND_DIFFUSE, {red, green, blue, 1});
    gl.PushMatrix();
    gl.Translatef(0, length / 2, 0);
    draw_box(gl, 0.5f, length, 0.45f);
    gl.PopMatrix();
    gl.Translatef(0, length, 0);
  };
  gl.Translatef(-1.3f, -2.4f, 0.2f);
  part(0.8f, 0.2f, 0.2f, 2.1f);
  gl.Rotatef(-38, 0, 0, 1);
  part(0.8f, 0.6f, 0.2f, 1.9f);
  gl.Rotated(-61, 0.1, 0.3, 1);
  part(0.2f, 0.8f, 0.4f, 1.3f);
  for (const float side : {-1.0f, 1.0f}) {
    gl.PushMatrix();
    gl.Rotatef(33 * side, 0, 0, 1);
    gl.Translatef(0.2f * side, 0, 0);
    gl.Scalef(0.4f, 1, 1);
    part(0.2f, 0.4f, 0.8f, 0.9f);
    gl.PopMatrix();
  }
}

// A mirror turns front faces into back faces: with culling, glFrontFace must follow.
void mirrored(const GlTable& gl) {
  clear_background(gl);
  light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.8f, 0.52f, 0});
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  const Surface ring = torus(0.8f, 0.33f, 40, 20);
  const Matrix view = look(gl, {.distance = 6.5f, .pitch_deg = 20, .yaw_deg = 0});
  const auto draw = [&](float mirror, float shift) {
    const Matrix place = multiply(translation(0, shift, 0), multiply(scaling(1, mirror, 1), rotation(52, 0)));
    load_model_view(gl, multiply(view, place));
    draw_surface(gl, ring);
  };
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.7f, 0.2f, 1});
  draw(1, 0.9f);
  material(gl, GL_FRONT, GL_DIFFUSE, {0.2f, 0.4f, 0.75f, 1});
  gl.FrontFace(GL_CW);
  draw(-1, -0.9f);
}

// x and y are scaled to nothing, or all of it is: what remains has no area.
void singular(const GlTable& gl) {
  clear_background(gl);
  const Matrix places[3] = {scaling(0, 0.9f, 1), scaling(0.8f, 0, 1), scaling(0, 0, 0)};
  for (const Matrix& place : places) {
    load_model_view(gl, place);
    draw_arrow(gl);
  }
  load_model_view(gl, scaling(0.9f, 0.9f, 0));
  draw_arrow(gl);
}

}  // namespace

SceneList matrix_scenes() {
  constexpr auto section = "§2.11.2";
  return {
      {.name = "matrix_commands",
       .section = section,
       .shows = "16 arrows: the first by glLoadIdentity, four alike by the loads, four alike by the products, then "
                "moves, scales, turns.",
       .draw = matrix_commands},
      {.name = "ortho_and_frustum",
       .section = section,
       .shows = "27 boxes, left through glOrtho, right through an asymmetric glFrustum.",
       .width_px = 500,
       .height_px = 250,
       .draw = ortho_and_frustum},
      {.name = "stack_tree",
       .section = section,
       .shows = "A tree of 1023 branches, brown to green, by push and pop.",
       .draw = stack_tree},
      {.name = "stacks_to_the_limit",
       .section = section,
       .shows = "31 nested squares in the lower left quarter, drawn while pushing; 31 bars, the highest last, while "
                "popping.",
       .draw = stacks_to_the_limit},
      {.name = "robot_arm",
       .section = section,
       .shows = "A lit arm of three joints and a hand, by Translate, Rotate, Scale.",
       .draw = robot_arm},
      {.name = "mirrored",
       .section = section,
       .shows = "A gold ring and its blue mirror image below, both whole under face culling.",
       .draw = mirrored},
      {.name = "singular",
       .section = section,
       .shows = "One arrow: those scaled to a line or a point draw nothing, the one flattened in z is whole.",
       .draw = singular},
  };
}

}  // namespace gouraud::conformance
