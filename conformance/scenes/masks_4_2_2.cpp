// Colour masks, depth masks, and what glClear makes of them. [GL1.5 §4.2.2, §4.2.3]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void set_mask(const GlTable& gl, int bits) {
  gl.ColorMask((bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0);
}

// A smooth rectangle through each of the 16 masks.
void color_masks(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  for (int mask = 0; mask < 16; ++mask) {
    const float x = 64 * static_cast<float>(mask % 4), y = 64 * static_cast<float>(mask / 4);
    set_mask(gl, mask);
    gl.Begin(GL_TRIANGLE_STRIP);
    gl.Color4f(0.9f, 0.2f, 0.1f, 0.9f);
    gl.Vertex2f(x + 5.3f, y + 4.2f);
    gl.Color4f(0.2f, 0.9f, 0.1f, 0.6f);
    gl.Vertex2f(x + 59.7f, y + 6.1f);
    gl.Color4f(0.1f, 0.2f, 0.9f, 0.3f);
    gl.Vertex2f(x + 4.6f, y + 58.4f);
    gl.Color4f(0.9f, 0.9f, 0.85f, 1);
    gl.Vertex2f(x + 58.2f, y + 57.3f);
    gl.End();
  }
}

// The same by glClear: each box is cleared twice, the second time with the mask.
void masked_clears(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_SCISSOR_TEST);
  for (int mask = 0; mask < 16; ++mask) {
    gl.Scissor(5 + 64 * (mask % 4), 6 + 64 * (mask / 4), 53, 51);
    set_mask(gl, 15);
    gl.ClearColor(0.2f, 0.4f, 0.6f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    set_mask(gl, mask);
    gl.ClearColor(0.8f, 0.7f, 0.2f, 0.4f);
    gl.Clear(GL_COLOR_BUFFER_BIT);
  }
}

// Three rings over each other, each into one colour channel of its own.
void channels(const GlTable& gl) {
  clear_background(gl);
  const Matrix view = look(gl, {.distance = 4.6f, .pitch_deg = 62, .yaw_deg = 0});
  const float shifts[3][2] = {{-0.45f, -0.3f}, {0.45f, -0.3f}, {0, 0.5f}};
  for (int i = 0; i < 3; ++i) {
    set_mask(gl, 8 | 1 << i);
    load_model_view(gl, multiply(view, translation(shifts[i][0], 0, -shifts[i][1])));
    draw_surface(gl, torus(0.65f, 0.22f, 40, 20), [&](const Surface::Point& point) {
      const float shade = 0.45f + 0.5f * point.u;
      gl.Color3f(shade, shade, shade);
    });
  }
}

// Depth is written where all colours are masked: an invisible ball hides what lies behind it.
void invisible_occluder(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_surface(gl, sphere(0.85f, 24, 48));
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20), [&](const Surface::Point& point) {
    gl.Color3f(0.81f - 0.53f * point.v, 0.29f + 0.47f * point.u, 0.31f);
  });
}

// Clear values beyond [0, 1] are clamped; a clear in the middle of the scene removes what was drawn before.
void clear_between(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_rectangle(gl, -0.9f, -0.9f, 0.9f, 0.9f, -0.8f);
  gl.ClearColor(-1, 1.7f, 0.6f, 0);
  gl.ClearDepth(3);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Color3f(0.8f, 0.2f, 0.2f);
  draw_rectangle(gl, -0.73f, -0.61f, 0.31f, 0.47f, 0.5f);
  gl.ClearDepth(-1);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Color3f(0.2f, 0.2f, 0.8f);
  draw_rectangle(gl, -0.33f, -0.27f, 0.71f, 0.83f, -0.5f);
  gl.ClearDepth(0.5);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Color3f(0.8f, 0.8f, 0.2f);
  draw_rectangle(gl, 0.07f, -0.83f, 0.87f, 0.13f, -0.25f);
  gl.Color3f(0.8f, 0.8f, 0.8f);
  draw_rectangle(gl, -0.87f, 0.07f, 0.27f, 0.93f, 0.25f);
}

}  // namespace

SceneList mask_and_clear_scenes() {
  constexpr auto masks = "§4.2.2", clears = "§4.2.3";
  return {
      {.name = "color_masks",
       .section = masks,
       .shows = "A rainbow square through each of the 16 colour masks, none to all.",
       .draw = color_masks},
      {.name = "color_mask_channels",
       .section = masks,
       .shows = "Red, green and blue rings that mix where they overlap.",
       .draw = channels},
      {.name = "color_mask_occluder",
       .section = masks,
       .shows = "A ring with a ball-shaped piece missing: the ball wrote depth alone.",
       .draw = invisible_occluder},
      {.name = "masked_clears",
       .section = clears,
       .shows = "16 blue boxes, cleared again to yellow through the 16 masks.",
       .draw = masked_clears},
      {.name = "clear_between",
       .section = clears,
       .shows = "On green: a red rectangle and a yellow one; a blue and a white one fail against the cleared depth.",
       .draw = clear_between},
  };
}

}  // namespace gouraud::conformance
