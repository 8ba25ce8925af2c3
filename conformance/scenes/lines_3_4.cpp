// Lines of width 1: diamond exit, at generic end points and at pixel centres. [GL1.5 §3.4]
// End points elsewhere are not used: there Mesa's emulation differs from the rule in up to 40 % (MESA-RULES 5.1).
#include <cmath>
#include <numbers>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr double turn = 2 * std::numbers::pi;

void line_star(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 120; ++i) {
    const double angle = turn * i / 120 + 0.01;
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    gl.Color3f(0.8f, static_cast<float>(i % 5) * 0.2f, 0.2f);
    gl.Vertex2f(128.3f + 17.3f * c, 127.6f + 17.3f * s);
    gl.Color3f(0.2f, static_cast<float>(i % 7) * 0.13f, 0.8f);
    gl.Vertex2f(128.3f + 121.7f * c, 127.6f + 121.7f * s);
  }
  gl.End();
}

// Every vector of -7 .. 7 pixels in both axes, from centre to centre: horizontal, vertical, diagonal, all octants.
void lines_between_centers(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Begin(GL_LINES);
  for (int dy = -7; dy <= 7; ++dy) {
    for (int dx = -7; dx <= 7; ++dx) {
      const float x = 8.5f + 17 * static_cast<float>(dx + 7), y = 8.5f + 17 * static_cast<float>(dy + 7);
      gl.Color3f(0.83f, 0.78f, 0.41f);
      gl.Vertex2f(x, y);
      gl.Color3f(0.22f, 0.353f, 0.874f);
      gl.Vertex2f(x + static_cast<float>(dx), y + static_cast<float>(dy));
    }
  }
  gl.End();
}

// Long lines across the picture between centres: horizontal, vertical, at 45 degrees, and of slope 1/2, both ways.
void long_lines_between_centers(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Begin(GL_LINES);
  const auto line = [&](int x0, int y0, int x1, int y1) {
    gl.Color3f(0.83f, 0.21f, 0.41f);
    gl.Vertex2f(static_cast<float>(x0) + 0.5f, static_cast<float>(y0) + 0.5f);
    gl.Color3f(0.19f, 0.78f, 0.43f);
    gl.Vertex2f(static_cast<float>(x1) + 0.5f, static_cast<float>(y1) + 0.5f);
  };
  for (int i = 0; i < 8; ++i) {
    line(10, 10 + 8 * i, 110, 10 + 8 * i);
    line(110, 14 + 8 * i, 10, 14 + 8 * i);
    line(140 + 8 * i, 10, 140 + 8 * i, 110);
    line(144 + 8 * i, 110, 144 + 8 * i, 10);
    line(10 + 8 * i, 130, 70 + 8 * i, 190);
    line(74 + 8 * i, 190, 14 + 8 * i, 130);
    line(150 + 8 * i, 190, 210 + 8 * i, 130);
    line(10 + 8 * i, 200, 90 + 8 * i, 240);
    line(150 + 4 * i, 245, 176 + 4 * i, 193);
  }
  gl.End();
}

void lines_random(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 500, 333);
  Random random(171);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 400; ++i) {
    for (int end = 0; end < 2; ++end) {
      color_of(gl, random);
      const float x = random.range(3, 497);
      gl.Vertex2f(x, random.range(3, 330));
    }
  }
  gl.End();
}

void lines_short(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(172);
  gl.Begin(GL_LINES);
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) {
      color_of(gl, random);
      const float x = 8 * static_cast<float>(column) + random.range(0, 8),
                  y = 8 * static_cast<float>(row) + random.range(0, 8);
      gl.Vertex2f(x, y);
      const float dx = random.range(-8, 8), dy = random.range(-8, 8);
      gl.Vertex2f(x + dx, y + dy);
    }
  }
  gl.End();
}

// Shallower than 1:60 and steeper than 60:1, crossing few rows or columns.
void lines_steep_and_flat(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(173);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 60; ++i) {
    const float at = 6.3f + 4.07f * static_cast<float>(i), slant = random.range(-2.4f, 2.4f);
    color_of(gl, random);
    gl.Vertex2f(9.7f, at);
    gl.Vertex2f(121.2f, at + slant);
    color_of(gl, random);
    gl.Vertex2f(133.4f + 0.48f * at, 247.6f);
    gl.Vertex2f(133.4f + 0.48f * at + slant / 2, 11.3f);
  }
  gl.End();
}

// Lines without length draw nothing: at centres and elsewhere, as lines, strips and loops; crosses stand beside them.
void lines_of_no_length(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  for (int i = 0; i < 16; ++i) {
    const float x = 16.5f + 32 * static_cast<float>(i % 4) + (i % 3 == 0 ? 0.0f : 0.21f),
                y = 16.5f + 32 * static_cast<float>(i / 4);
    gl.Color3f(0.8f, 0.2f, 0.2f);
    gl.Begin(i % 2 == 0 ? GL_LINES : GL_LINE_LOOP);
    gl.Vertex2f(x, y);
    gl.Vertex2f(x, y);
    gl.End();
    gl.Color3f(0.2f, 0.8f, 0.4f);
    gl.Begin(GL_LINES);
    gl.Vertex2f(x - 8.3f, y + 3.2f);
    gl.Vertex2f(x + 8.1f, y + 5.3f);
    gl.Vertex2f(x + 3.4f, y - 8.2f);
    gl.Vertex2f(x + 5.7f, y + 9.1f);
    gl.End();
  }
}

// Curves of long loops and strips: connected segments leave no gaps and hit no pixel twice.
void lissajous(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  for (int curve = 0; curve < 3; ++curve) {
    const int points = curve == 0 ? 37 : curve == 1 ? 90 : 300;
    const double shrink = 120 - 37 * curve;
    gl.Begin(curve == 1 ? GL_LINE_STRIP : GL_LINE_LOOP);
    for (int i = 0; i < points; ++i) {
      const double t = turn * i / points + 0.03;
      gl.Color3f(static_cast<float>(0.5 + 0.4 * std::sin(t)), 0.25f * static_cast<float>(curve + 1),
                 static_cast<float>(0.5 - 0.4 * std::sin(2 * t)));
      gl.Vertex2f(static_cast<float>(128.2 + shrink * std::sin(3 * t)),
                  static_cast<float>(127.9 + shrink * std::cos(2 * t + 0.4)));
    }
    gl.End();
  }
}

// A wire frame in perspective, in front of and behind a ring; colours and depth along the lines.
void lines_in_depth(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 30});
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20),
               [&](const Surface::Point& point) { gl.Color3f(0.2f + 0.3f * point.u, 0.25f, 0.3f + 0.4f * point.v); });
  gl.Begin(GL_LINES);
  for (int i = -6; i <= 6; ++i) {
    const float at = 0.23f * static_cast<float>(i) + 0.011f;
    for (const float height : {-0.171f, 0.143f}) {
      gl.Color3f(0.8f, 0.8f, 0.2f);
      gl.Vertex3f(-1.7f, height, at);
      gl.Color3f(0.2f, 0.8f, 0.8f);
      gl.Vertex3f(1.7f, height, at);
      gl.Color3f(0.8f, 0.4f, 0.4f);
      gl.Vertex3f(at, height, -1.7f);
      gl.Color3f(0.8f, 0.8f, 0.75f);
      gl.Vertex3f(at, height, 1.7f);
    }
  }
  gl.End();
}

// A corridor of lines to the horizon: their colours are perspective-correct.
void lines_perspective(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 0, .pitch_deg = 4, .yaw_deg = 5, .fov_y_deg = 60, .near = 0.5f, .far = 100});
  gl.Begin(GL_LINES);
  for (int i = 0; i < 40; ++i) {
    const double angle = turn * i / 40 + 0.02;
    const float x = static_cast<float>(1.6 * std::cos(angle)), y = static_cast<float>(1.3 * std::sin(angle));
    gl.Color3f(0.8f, 0.2f, 0);
    gl.Vertex3f(x, y, -2.7f);
    gl.Color3f(0, 0.2f, 0.8f);
    gl.Vertex3f(x, y, -71.3f);
  }
  gl.End();
}

}  // namespace

SceneList line_scenes() {
  constexpr auto section = "§3.4";
  constexpr auto judge = Judge::lines_and_points;
  return {
      {.name = "line_star",
       .section = section,
       .shows = "A star of 120 smooth-coloured rays.",
       .judge = judge,
       .draw = line_star},
      {.name = "lines_between_centers",
       .section = section,
       .shows = "225 short lines between pixel centres, in every direction; the middle one has no length.",
       .judge = judge,
       .draw = lines_between_centers},
      {.name = "long_lines_between_centers",
       .section = section,
       .shows = "Parallel lines between pixel centres: horizontal, vertical, diagonal, slopes 1/2 and -2.",
       .judge = judge,
       .draw = long_lines_between_centers},
      {.name = "lines_random",
       .section = section,
       .shows = "400 random lines.",
       .judge = judge,
       .width_px = 500,
       .height_px = 333,
       .draw = lines_random},
      {.name = "lines_short",
       .section = section,
       .shows = "1024 random lines of up to 8 pixels.",
       .judge = judge,
       .draw = lines_short},
      {.name = "lines_steep_and_flat",
       .section = section,
       .shows = "60 nearly horizontal and 60 nearly vertical lines.",
       .judge = judge,
       .draw = lines_steep_and_flat},
      {.name = "lines_of_no_length",
       .section = section,
       .shows = "16 green crosses; nothing red: lines without length leave no pixel.",
       .judge = judge,
       .width_px = 128,
       .height_px = 128,
       .draw = lines_of_no_length},
      {.name = "line_lissajous",
       .section = section,
       .shows = "Three nested curves of line loops and a strip.",
       .judge = judge,
       .draw = lissajous},
      {.name = "lines_in_depth",
       .section = section,
       .shows = "Two grids of lines through a ring, hidden where it is nearer.",
       .judge = judge,
       .draw = lines_in_depth},
      {.name = "lines_perspective",
       .section = section,
       .shows = "40 lines from near (red) to far (blue) that meet at a point: mostly blue, as perspective has it.",
       .judge = judge,
       .draw = lines_perspective},
  };
}

}  // namespace gouraud::conformance
