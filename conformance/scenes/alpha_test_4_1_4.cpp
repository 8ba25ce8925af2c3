// The alpha test: its functions, its reference, and its place before the depth test. [GL1.5 §4.1.4]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// Squares whose alphas are 64 steps about the reference, row by row, each step a flat square; a function a row.
void functions(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_ALPHA_TEST);
  for (int row = 0; row < 8; ++row) {
    gl.AlphaFunc(GL_NEVER + static_cast<GLenum>(row), 129.0f / 255.0f);
    for (int column = 0; column < 64; ++column) {
      const float x = 4 * static_cast<float>(column), y = 32 * static_cast<float>(row);
      gl.Color4ub(static_cast<GLubyte>(40 + 3 * column), 200, static_cast<GLubyte>(30 * row),
                  static_cast<GLubyte>(97 + column));
      draw_rectangle(gl, x + 0.5f, y + 3.5f, x + 3.5f, y + 28.5f, 0);
    }
  }
}

// A reference between two 8-bit values counts as the nearer one.
void rounded_references(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_ALPHA_TEST);
  const float references[] = {-0.5f, 0.0f, 0.3f, 0.5f, 100.4f / 255, 100.6f / 255, 1.0f, 7.0f};
  for (int row = 0; row < 8; ++row) {
    gl.AlphaFunc(row % 2 == 0 ? GL_GEQUAL : GL_LEQUAL, references[row]);
    for (int column = 0; column < 32; ++column) {
      const float x = 8 * static_cast<float>(column), y = 32 * static_cast<float>(row);
      const int alpha = row == 4 || row == 5 ? 85 + column : 8 * column + column / 4;
      gl.Color4ub(220, static_cast<GLubyte>(7 * column), 90, static_cast<GLubyte>(alpha));
      draw_rectangle(gl, x + 0.5f, y + 3.5f, x + 7.5f, y + 28.5f, 0);
    }
  }
}

// What fails leaves no depth: a ball is seen through the holes of a sheet drawn before it.
void before_depth(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.52f);
  const Matrix view = look(gl, {.distance = 4.2f, .pitch_deg = 48});
  load_model_view(gl, multiply(view, translation(0, 0.55f, 0)));
  draw_surface(gl, floor_grid(2.4f, 9), [&](const Surface::Point& point) {
    const bool dense = static_cast<int>(point.u * 9.01f) % 2 == static_cast<int>(point.v * 9.01f) % 2;
    gl.Color4f(0.91f, 0.31f + 0.53f * point.u, 0.21f, dense ? 0.93f : 0.11f);
  });
  load_model_view(gl, view);
  draw_surface(gl, sphere(0.9f, 20, 32),
               [&](const Surface::Point& point) { gl.Color4f(0.21f, 0.83f * point.v, 0.91f, 0.31f + 0.67f * point.u); });
}

// Depth alone is written where alpha passes; colours are masked.
void invisible(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_LESS, 0.4f);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.Begin(GL_TRIANGLES);
  gl.Color4f(1, 1, 1, 0.013f);
  gl.Vertex3f(20.3f, 31.7f, -0.5f);
  gl.Color4f(1, 1, 1, 0.471f);
  gl.Vertex3f(231.2f, 60.4f, -0.5f);
  gl.Color4f(1, 1, 1, 0.929f);
  gl.Vertex3f(90.8f, 240.1f, -0.5f);
  gl.End();
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_ALPHA_TEST);
  gl.Color3f(0.2f, 0.7f, 0.5f);
  draw_rectangle(gl, 5.5f, 9.5f, 249.5f, 244.5f, 0.25f);
}

// Alpha test and blending together, as sprites are drawn.
void blended(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  gl.ShadeModel(GL_FLAT);  // blended colours are whole multiples of 1/255, whatever interpolation rounds
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_NOTEQUAL, 0);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  draw_surface(gl, torus(0.95f, 0.38f, 24, 16), [&](const Surface::Point& point) {
    gl.Color4ub(230, static_cast<GLubyte>(200 * point.u), 77, static_cast<GLubyte>(point.v < 0.3f ? 0 : 255 * point.v));
  });
}

}  // namespace

SceneList alpha_test_scenes() {
  constexpr auto section = "§4.1.4";
  return {
      {.name = "alpha_functions",
       .section = section,
       .shows = "Eight rows of 64 bars, alpha 97 to 160 against 129: from below: none, the left half, one bar, ...",
       .draw = functions},
      {.name = "alpha_references",
       .section = section,
       .shows = "Rows of bars cut off at references that are clamped to [0, 1] and rounded to 8 bits.",
       .draw = rounded_references},
      {.name = "alpha_before_depth",
       .section = section,
       .shows = "A chequered sheet; a ball is seen through its holes, though it was drawn later and lies behind.",
       .draw = before_depth},
      {.name = "alpha_depth_only",
       .section = section,
       .shows = "A green square without a triangle's corner: there an invisible triangle passed the alpha test.",
       .draw = invisible},
      {.name = "alpha_blended",
       .section = section,
       .shows = "A ring that fades out and has no pixels at all where alpha is 0.",
       .draw = blended},
  };
}

}  // namespace gouraud::conformance
