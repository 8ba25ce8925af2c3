// Tens of thousands of vertices between one Begin and End: what crosses the limits of batches. [GL1.5 §2.6.1]
#include <cmath>
#include <numbers>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr int vertices = 50'000;

void prepare(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
}

struct Spot {
  float x, y;
};

Spot on_circle(double turns, double radius) {
  const double angle = 2 * std::numbers::pi * turns;
  return {static_cast<float>(127.7 + radius * std::cos(angle)), static_cast<float>(128.2 + radius * std::sin(angle))};
}

/// A colour that changes slowly along a path; `turns` counts its cycles.
void path_color(const GlTable& gl, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  gl.Color3f(static_cast<float>(0.5 + 0.45 * std::sin(angle)), static_cast<float>(0.5 + 0.45 * std::sin(angle + 2)),
             static_cast<float>(0.5 + 0.45 * std::sin(angle + 4)));
}

// A ribbon: successive pairs of vertices across a spiral of 12 turns.
void spiral_ribbon(const GlTable& gl, GLenum mode) {
  prepare(gl);
  gl.Begin(mode);
  for (int i = 0; i < vertices / 2; ++i) {
    const double way = 2.0 * i / vertices, radius = 122 * std::sqrt(way), turns = 12 * std::sqrt(way);
    const Spot outer = on_circle(turns, radius), inner = on_circle(turns, radius - 7);
    path_color(gl, 40 * way);
    gl.Vertex2f(inner.x, inner.y);
    gl.Vertex2f(outer.x, outer.y);
  }
  gl.End();
}

void strip_50k(const GlTable& gl) {
  spiral_ribbon(gl, GL_TRIANGLE_STRIP);
}
void quad_strip_50k(const GlTable& gl) {
  spiral_ribbon(gl, GL_QUAD_STRIP);
}

// Around the hub 50 times, each time nearer to it: every turn lies over the one before.
void fan_50k(const GlTable& gl) {
  prepare(gl);
  gl.Begin(GL_TRIANGLE_FAN);
  gl.Color3f(0.8f, 0.8f, 0.75f);
  gl.Vertex2f(127.7f, 128.2f);
  for (int i = 1; i < vertices; ++i) {
    const double way = 1.0 * i / vertices;
    const Spot rim = on_circle(50 * way, 121.3 - 100 * way);
    path_color(gl, 53 * way);
    gl.Vertex2f(rim.x, rim.y);
  }
  gl.End();
}

// Vertices 1/65 pixel apart: slivers that share the first vertex. Colours are affine in the position, as nothing else
// is well-conditioned on them.
void polygon_50k(const GlTable& gl) {
  prepare(gl);
  gl.Begin(GL_POLYGON);
  for (int i = 0; i < vertices; ++i) {
    const Spot rim = on_circle(1.0 * i / vertices, 121.3);
    gl.Color3f(rim.x / 270, rim.y / 262, 0.9f - rim.x / 600 - rim.y / 700);
    gl.Vertex2f(rim.x, rim.y);
  }
  gl.End();
}

// Parallelograms with colours affine in the position: either diagonal gives the same.
void quads_50k(const GlTable& gl) {
  prepare(gl);
  gl.Begin(GL_QUADS);
  for (int i = 0; i < vertices / 4; ++i) {
    const float x = 3.1f + 2 * static_cast<float>(i % 125), y = 5.3f + 2.5f * static_cast<float>(i / 125);
    const float red = 0.004f * static_cast<float>(i * 7 % 230), green = static_cast<float>(i % 125) / 130;
    gl.Color3f(red, green, 0.2f);
    gl.Vertex2f(x, y);
    gl.Color3f(red, green, 0.6f);
    gl.Vertex2f(x + 1.9f, y + 0.3f);
    gl.Color3f(red, green, 0.8f);
    gl.Vertex2f(x + 1.7f, y + 2.6f);
    gl.Color3f(red, green, 0.4f);
    gl.Vertex2f(x - 0.2f, y + 2.3f);
  }
  gl.End();
}

void triangles_51k(const GlTable& gl) {
  prepare(gl);
  gl.Enable(GL_DEPTH_TEST);
  Random random(41);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 17'000; ++i) {
    const float x = random.range(-5, 261), y = random.range(-5, 261);
    for (int corner = 0; corner < 3; ++corner) {
      color_of(gl, random);
      const float vx = x + random.range(-6, 6), vy = y + random.range(-6, 6);
      gl.Vertex3f(vx, vy, random.range(-1, 1));
    }
  }
  gl.End();
}

// From pixel centre to pixel centre, row by row there and back: each step lights the pixel it leaves.
void loop_50k(const GlTable& gl) {
  prepare(gl);
  gl.Begin(GL_LINE_LOOP);
  for (int i = 0; i < vertices; ++i) {
    const int row = i / 250, column = row % 2 == 0 ? i % 250 : 249 - i % 250;
    path_color(gl, 0.003 * column + 0.00004 * row * row);
    gl.Vertex2f(static_cast<float>(column) + 3.5f, static_cast<float>(row) + 28.5f);
  }
  gl.End();
}

void line_strip_50k(const GlTable& gl) {
  prepare(gl);
  gl.Begin(GL_LINE_STRIP);
  for (int i = 0; i < vertices; ++i) {
    const double way = 1.0 * i / vertices;
    const Spot spot = on_circle(1.0 * i / 97.3, 4 + 118 * way);
    path_color(gl, 30 * way);
    gl.Vertex2f(spot.x, spot.y);
  }
  gl.End();
}

void lines_50k(const GlTable& gl) {
  prepare(gl);
  Random random(42);
  gl.Begin(GL_LINES);
  for (int i = 0; i < vertices / 2; ++i) {
    const float x = random.range(10, 246), y = random.range(10, 246);
    color_of(gl, random);
    gl.Vertex2f(x, y);
    const float dx = random.range(-9, 9), dy = random.range(-9, 9);
    gl.Vertex2f(x + dx, y + dy);
  }
  gl.End();
}

void points_50k(const GlTable& gl) {
  prepare(gl);
  Random random(43);
  gl.Begin(GL_POINTS);
  for (int i = 0; i < vertices; ++i) {
    color_of(gl, random);
    const int x = random.below(250), y = random.below(250);
    gl.Vertex2f(static_cast<float>(x) + 3.25f, static_cast<float>(y) + 3.625f);
  }
  gl.End();
}

}  // namespace

SceneList large_begin_end_scenes() {
  constexpr auto section = "§2.6.1";
  return {
      {.name = "strip_50k",
       .section = section,
       .shows = "A spiral ribbon of one triangle strip of 50,000 vertices.",
       .draw = strip_50k},
      {.name = "quad_strip_50k",
       .section = section,
       .shows = "The same spiral ribbon as one quad strip.",
       .draw = quad_strip_50k},
      {.name = "fan_50k",
       .section = section,
       .shows = "A fan of 50,000 vertices that winds 50 times around its hub, ever nearer: rings of rainbow colours, "
                "grey within.",
       .draw = fan_50k},
      {.name = "polygon_50k",
       .section = section,
       .shows = "A disc of one polygon of 50,000 vertices in a smooth colour gradient.",
       .draw = polygon_50k},
      {.name = "quads_50k",
       .section = section,
       .shows = "A field of 12,500 tiny parallelograms in one Begin/End.",
       .draw = quads_50k},
      {.name = "triangles_51k",
       .section = section,
       .shows = "17,000 random small triangles in one Begin/End, depth tested.",
       .draw = triangles_51k},
      {.name = "loop_50k",
       .section = section,
       .shows = "A line loop through 50,000 pixel centres, row by row: a full rectangle, and its closing diagonal.",
       .judge = Judge::lines_and_points,
       .draw = loop_50k},
      {.name = "line_strip_50k",
       .section = section,
       .shows = "A line strip of 50,000 vertices that winds outward 514 times.",
       .judge = Judge::lines_and_points,
       .draw = line_strip_50k},
      {.name = "lines_50k",
       .section = section,
       .shows = "25,000 short random lines in one Begin/End.",
       .judge = Judge::lines_and_points,
       .draw = lines_50k},
      {.name = "points_50k",
       .section = section,
       .shows = "50,000 random points in one Begin/End.",
       .judge = Judge::lines_and_points,
       .draw = points_50k},
  };
}

}  // namespace gouraud::conformance
