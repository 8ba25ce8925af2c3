// The whole framebuffer: choosing the buffer that is drawn to, clearing stencil and accumulation buffer, accumulating.
// [GL1.5 §4.2.1, §4.2.3, §4.2.4]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// Without a colour buffer depth is written, and nothing is seen.
void no_color_buffer(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  gl.DrawBuffer(GL_NONE);
  gl.ClearColor(1, 1, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  draw_surface(gl, sphere(0.85f, 24, 48));
  gl.DrawBuffer(GL_FRONT);
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20), [&](const Surface::Point& point) {
    gl.Color3f(0.81f - 0.53f * point.v, 0.29f + 0.47f * point.u, 0.31f);
  });
}

// Every name of the one buffer, some after names of buffers that are not there.
void all_names(const GlTable& gl) {
  constexpr GLenum names[] = {GL_FRONT, GL_FRONT_LEFT, GL_LEFT, GL_FRONT_AND_BACK, GL_NONE, GL_FRONT};
  clear_background(gl);
  pixel_space(gl, 256, 256);
  for (int i = 0; i < 6; ++i) {
    gl.DrawBuffer(names[i]);
    const float x = 42 * static_cast<float>(i);
    gl.Color3ub(static_cast<GLubyte>(30 + 40 * i), 220, static_cast<GLubyte>(240 - 35 * i));
    draw_rectangle(gl, x + 3.5f, 20.5f, x + 36.5f, 200.5f, 0);
  }
}

// Boxes cleared to a stencil value each under a mask each, then shown.
void stencil_clears(const GlTable& gl) {
  clear_background(gl);
  gl.ClearStencil(0x1F0);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  gl.Enable(GL_SCISSOR_TEST);
  for (int i = 0; i < 64; ++i) {
    gl.Scissor(3 + 32 * (i % 8), 5 + 32 * (i / 8), 27, 23);
    gl.StencilMask(static_cast<GLuint>(7 * i));
    gl.ClearStencil(37 * i);
    gl.Clear(i % 3 == 0 ? GL_STENCIL_BUFFER_BIT : GL_STENCIL_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  gl.Disable(GL_SCISSOR_TEST);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_STENCIL_TEST);
  for (int value = 0; value < 256; ++value) {
    gl.StencilFunc(GL_EQUAL, value, ~0u);
    gl.Color3ub(static_cast<GLubyte>(value), static_cast<GLubyte>(91 * value % 256), static_cast<GLubyte>(255 - value));
    draw_rectangle(gl, 0, 0, 256, 256, 0);
  }
}

// Whole clears, cut clears and masked clears after each other, with a drawing in some tiles between them.
void clears_on_clears(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Color3f(0.8f, 0.4f, 0.2f);
  draw_rectangle(gl, 40.5f, 30.5f, 100.5f, 90.5f, 0);
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  gl.ClearColor(0.2f, 0.8f, 0.6f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(64, 64, 128, 64);
  gl.ClearColor(0.8f, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Scissor(150, 100, 90, 110);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearColor(0.4f, 0.2f, 0.8f, 0.6f);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

// A picture of one colour, drawn and not cleared: so that every pixel counts as drawn.
void cover(const GlTable& gl) {
  gl.Disable(GL_DEPTH_TEST);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  pixel_space(gl, 256, 256);
  gl.Color4ub(102, 51, 153, 204);
  draw_rectangle(gl, 0, 0, 256, 256, 0);
}

void moving_square(const GlTable& gl, float phase) {
  cover(gl);
  gl.Color4ub(255, 204, 51, 255);
  draw_rectangle(gl, 20.5f + 100 * phase, 60.5f, 110.5f + 100 * phase, 190.5f, 0);
  gl.Color4ub(51, 255, 204, 255);
  draw_rectangle(gl, 130.5f, 10.5f + 150 * phase, 170.5f, 60.5f + 150 * phase, 0);
}

// Eight phases of a motion, an eighth each.
void motion_blur(const GlTable& gl) {
  gl.Clear(GL_ACCUM_BUFFER_BIT);
  for (int i = 0; i < 8; ++i) {
    moving_square(gl, static_cast<float>(i) / 8);
    gl.Accum(GL_ACCUM, 0.125f);
  }
  gl.Accum(GL_RETURN, 1);
}

// The same as a weighted mean that starts with a load, of a scene in perspective.
void fading(const GlTable& gl) {
  for (int i = 0; i < 4; ++i) {
    cover(gl);
    gl.Enable(GL_DEPTH_TEST);
    look(gl, {.distance = 4.1f, .pitch_deg = 30, .yaw_deg = 20 + 13 * static_cast<float>(i)});
    gl.ShadeModel(GL_FLAT);
    draw_surface(gl, torus(0.8f, 0.35f, 24, 14), [&](const Surface::Point& point) {
      const auto byte = [](float value) { return static_cast<GLubyte>(255 * value); };
      gl.Color4ub(byte(0.2f + 0.7f * point.u), byte(0.9f - 0.6f * point.v), byte(point.v), 255);
    });
    gl.Accum(i == 0 ? GL_LOAD : GL_ACCUM, i == 3 ? 0.5f : i == 2 ? 0.25f : 0.125f);
  }
  gl.Accum(GL_RETURN, 1);
}

// ADD and MULT with both signs; boxes, each with operations of its own by the scissor.
void arithmetic(const GlTable& gl) {
  moving_square(gl, 0.5f);
  gl.Accum(GL_LOAD, 0.5f);
  gl.Enable(GL_SCISSOR_TEST);
  for (int i = 0; i < 16; ++i) {
    gl.Scissor(5 + 64 * (i % 4), 3 + 64 * (i / 4), 55, 57);
    gl.Accum(GL_ADD, 0.125f * static_cast<float>(i % 4) - 0.25f);
    gl.Accum(GL_MULT, i % 3 == 0 ? -0.75f : 0.5f);
    gl.Accum(GL_RETURN, i % 3 == 0 ? -1.5f : 1.75f);
  }
}

// The colour mask is in force on return, not on load.
void masked_return(const GlTable& gl) {
  moving_square(gl, 0.25f);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  gl.Accum(GL_LOAD, 1);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  moving_square(gl, 0.75f);
  gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
  gl.Accum(GL_RETURN, 1);
}

// The accumulation buffer is cleared in boxes, to values of both signs.
void accum_clears(const GlTable& gl) {
  cover(gl);
  gl.ClearAccum(0.2f, 0.4f, 0.8f, 1);
  gl.Clear(GL_ACCUM_BUFFER_BIT);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(60, 70, 131, 67);
  gl.ClearAccum(-0.4f, 7, 0.6f, -3);
  gl.Clear(GL_ACCUM_BUFFER_BIT);
  gl.Scissor(10, 20, 230, 190);
  gl.Accum(GL_RETURN, 1);
}

// Sums beyond one stay at one.
void clamped_sums(const GlTable& gl) {
  gl.Clear(GL_ACCUM_BUFFER_BIT);
  for (int i = 0; i < 6; ++i) {
    moving_square(gl, static_cast<float>(i) / 6);
    gl.Accum(GL_ACCUM, 0.75f);
  }
  gl.Accum(GL_RETURN, 0.8f);
}

}  // namespace

SceneList buffer_scenes() {
  constexpr auto choosing = "§4.2.1", clearing = "§4.2.3", accumulating = "§4.2.4";
  return {
      {.name = "draw_buffer_none",
       .section = choosing,
       .shows = "A ring with a ball-shaped piece missing: the ball was drawn to no colour buffer.",
       .draw = no_color_buffer},
      {.name = "draw_buffer_names",
       .section = choosing,
       .shows = "Six columns without the fifth, which was drawn to no buffer.",
       .draw = all_names},
      {.name = "stencil_clears",
       .section = clearing,
       .shows = "64 boxes, coloured by their stencil values.",
       .draw = stencil_clears},
      {.name = "clears_on_clears",
       .section = clearing,
       .shows = "A rectangle and two boxes that overlap, in colours mixed by masks.",
       .draw = clears_on_clears},
      {.name = "accum_motion_blur",
       .section = accumulating,
       .shows = "Two squares that move to the right and up, blurred.",
       .judge = Judge::oracle_only,  // Mesa rounds every sum to 16 bits
       .draw = motion_blur},
      {.name = "accum_fading",
       .section = accumulating,
       .shows = "Four rings over each other, the last one strongest.",
       .judge = Judge::oracle_only,  // Mesa rounds every sum to 16 bits
       .draw = fading},
      {.name = "accum_arithmetic",
       .section = accumulating,
       .shows = "16 boxes of squares in changed colours, some of them negative.",
       .draw = arithmetic},
      {.name = "accum_masked",
       .section = accumulating,
       .shows = "Squares at one place in red and blue, at another in green.",
       .draw = masked_return},
      {.name = "accum_clears",
       .section = accumulating,
       .shows = "A blue box with a turquoise one inside.",
       .draw = accum_clears},
      {.name = "accum_clamped",
       .section = accumulating,
       .shows = "Squares that overlap six times; nothing is darker for being brighter than white.",
       .judge = Judge::oracle_only,  // Mesa's sums wrap (MESA-RULES 14)
       .draw = clamped_sums},
  };
}

}  // namespace gouraud::conformance
