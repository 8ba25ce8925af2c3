// Smooth points, lines and polygons: alpha is the share of the pixel that is covered. [GL1.5 §3.3.1, §3.4.2, §3.5.3, §3.11]
// The oracle judges: Mesa's smooth points select the wrong pixels, its smooth lines err by up to 0.13, and it has no smooth
// polygons (MESA-RULES 5.3, 14).
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void smooth(const GlTable& gl, GLenum cap, bool blended = true) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(cap);
  if (!blended) return;
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

void draw_points(const GlTable& gl, float first_size, float step) {
  Random random(331);
  for (int i = 0; i < 49; ++i) {
    gl.PointSize(first_size + step * static_cast<float>(i));
    gl.Begin(GL_POINTS);
    color_of(gl, random);
    const float x = random.range(-0.5f, 0.5f), y = random.range(-0.5f, 0.5f);
    gl.Vertex2f(18 + 36 * static_cast<float>(i % 7) + x, 18 + 36 * static_cast<float>(i / 7) + y);
    gl.End();
  }
}

void points(const GlTable& gl) {
  smooth(gl, GL_POINT_SMOOTH);
  draw_points(gl, 1, 0.61f);
}
void points_as_alpha(const GlTable& gl) {
  smooth(gl, GL_POINT_SMOOTH, false);
  draw_points(gl, 0.5f, 0.37f);
}
void large_point(const GlTable& gl) {
  smooth(gl, GL_POINT_SMOOTH);
  gl.PointSize(900);
  gl.Begin(GL_POINTS);
  gl.Color4f(0.88f, 0.72f, 0.2f, 0.8f);
  gl.Vertex2f(141.3f, 120.7f);
  gl.End();
}

// One colour a line: blended bytes of colours that vary hang on how they are rounded.
void star(const GlTable& gl, int rays) {
  gl.Begin(GL_LINES);
  for (int i = 0; i < rays; ++i) {
    const double angle = 2 * std::numbers::pi * i / rays;
    const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
    gl.Color3f(0.88f, static_cast<float>(i % 5) * 0.2f, static_cast<float>(i % 7) * 0.13f);
    gl.Vertex2f(128.3f + 33.3f * c, 127.6f + 33.3f * s);
    gl.Vertex2f(128.3f + 121.7f * c, 127.6f + 121.7f * s);
  }
  gl.End();
}

void lines(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH);
  star(gl, 72);
}
void wide_lines(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH);
  gl.LineWidth(4.7f);
  star(gl, 32);
}
void lines_as_alpha(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH, false);
  gl.LineWidth(2.5f);
  star(gl, 40);
}
void stippled_lines(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH);
  gl.LineWidth(3);
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(4, 0x9999);
  star(gl, 28);
}

// Shorter than a pixel, axis-parallel, on pixel borders.
void short_lines(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH);
  gl.Begin(GL_LINES);
  gl.Color3f(1, 1, 0.4f);
  for (int i = 0; i < 240; ++i) {
    const float x = 8 + 16 * static_cast<float>(i % 16), y = 8 + 16 * static_cast<float>(i / 16);
    gl.Vertex2f(x, y);
    gl.Vertex2f(x + 0.4f * static_cast<float>(i % 16 - 8), y + 0.4f * static_cast<float>(i / 16 - 7));
  }
  gl.End();
}

void smooth_outlines(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.LineWidth(1.5f);
  Random random(333);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 60; ++i) {
    if (i % 3 == 0) color_of(gl, random);
    const float x = random.range(10, 246);
    gl.Vertex2f(x, random.range(10, 246));
  }
  gl.End();
}

void triangles(const GlTable& gl) {
  Random random(335);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 36; ++i) {
    const float cx = 22 + 42 * static_cast<float>(i % 6), cy = 22 + 42 * static_cast<float>(i / 6);
    color_of(gl, random);
    for (int k = 0; k < 3; ++k) {
      const float x = random.range(-20, 20);
      gl.Vertex2f(cx + x, cy + random.range(-20, 20));
    }
  }
  gl.End();
}

void polygons(const GlTable& gl) {
  smooth(gl, GL_POLYGON_SMOOTH);
  triangles(gl);
}
void polygons_as_alpha(const GlTable& gl) {
  smooth(gl, GL_POLYGON_SMOOTH, false);
  triangles(gl);
}

// Quads and polygons are split into triangles: inside them nothing of that shows. One is cut by the window's edge.
void whole_polygons(const GlTable& gl) {
  Random random(337);
  for (int i = 0; i < 25; ++i) {
    const float cx = 20 + 58 * static_cast<float>(i % 5), cy = 20 + 58 * static_cast<float>(i / 5);
    const int corners = i % 2 == 0 ? 4 : 5 + i % 7;
    color_of(gl, random);
    const float turn = random.range(0, 3);
    gl.Begin(corners == 4 ? GL_QUADS : GL_POLYGON);
    for (int k = 0; k < corners; ++k) {
      const double angle = static_cast<double>(turn) + 2 * std::numbers::pi * k / corners;
      gl.Vertex2f(cx + static_cast<float>(31.7 * std::cos(angle)), cy + static_cast<float>(24.3 * std::sin(angle)));
    }
    gl.End();
  }
}
void blended_whole_polygons(const GlTable& gl) {
  smooth(gl, GL_POLYGON_SMOOTH);
  whole_polygons(gl);
}
void whole_polygons_as_alpha(const GlTable& gl) {
  smooth(gl, GL_POLYGON_SMOOTH, false);
  gl.ClipPlane(GL_CLIP_PLANE0, std::array<double, 4>{1, 0.4, 0, -50}.data());
  gl.Enable(GL_CLIP_PLANE0);
  whole_polygons(gl);
}

// Longer than a batch of vertices: nothing shows where it was cut.
void long_polygons(const GlTable& gl, int corners) {
  smooth(gl, GL_POLYGON_SMOOTH);
  polygon_rings(gl, corners);
}
void polygons_longer_than_a_batch(const GlTable& gl) {
  long_polygons(gl, 2500);
}

// The classic way: front to back, each fragment fills what its pixel has left. The triangles of a fan meet without a seam.
void saturated_fan(const GlTable& gl) {
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_POLYGON_SMOOTH);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA_SATURATE, GL_ONE);
  gl.Begin(GL_TRIANGLE_FAN);
  gl.Color3f(0.88f, 0.6f, 0.2f);
  gl.Vertex2f(120.3f, 130.6f);
  for (int i = 0; i <= 17; ++i) {
    const double angle = 2 * std::numbers::pi * i / 17;
    const double radius = i % 2 == 0 ? 110.0 : 60.0;
    gl.Vertex2f(static_cast<float>(128.3 + radius * std::cos(angle)), static_cast<float>(127.1 + radius * std::sin(angle)));
  }
  gl.End();
}

// Two triangles that cover less than a quarter of most pixels; alpha test sees the product of alpha and coverage.
void alpha_tested(const GlTable& gl) {
  smooth(gl, GL_LINE_SMOOTH, false);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.37f);
  gl.LineWidth(2.2f);
  star(gl, 40);
}

}  // namespace

SceneList smooth_scenes() {
  constexpr auto judge = Judge::oracle_only;
  return {
      {.name = "smooth_points", .section = "§3.3.1", .shows = "Discs of 1 to 30 pixels.", .judge = judge, .draw = points},
      {.name = "smooth_points_as_alpha", .section = "§3.3.1", .shows = "The coverage of discs, left in alpha.", .judge = judge, .draw = points_as_alpha},
      {.name = "smooth_points_large", .section = "§3.3.1", .shows = "The largest disc, 255 pixels wide.", .judge = judge, .draw = large_point},
      {.name = "smooth_lines", .section = "§3.4.2", .shows = "A star of smooth lines.", .judge = judge, .draw = lines},
      {.name = "smooth_lines_wide", .section = "§3.4.2", .shows = "A star of smooth lines, 4.7 pixels wide, with square ends.", .judge = judge, .draw = wide_lines},
      {.name = "smooth_lines_as_alpha", .section = "§3.4.2", .shows = "The coverage of lines, left in alpha.", .judge = judge, .draw = lines_as_alpha},
      {.name = "smooth_lines_stippled", .section = "§3.4.2", .shows = "Smooth dashes, cut across the lines.", .judge = judge, .draw = stippled_lines},
      {.name = "smooth_lines_short", .section = "§3.4.2", .shows = "Lines of a few pixels in every direction.", .judge = judge, .draw = short_lines},
      {.name = "smooth_outlines", .section = "§3.5.4", .shows = "Smooth outlines of triangles.", .judge = judge, .draw = smooth_outlines},
      {.name = "smooth_polygons", .section = "§3.5.3", .shows = "Triangles with smooth edges.", .judge = judge, .draw = polygons},
      {.name = "smooth_polygons_as_alpha", .section = "§3.5.3", .shows = "The coverage of triangles, left in alpha.", .judge = judge, .draw = polygons_as_alpha},
      {.name = "smooth_polygons_whole", .section = "§3.5.3", .shows = "Quads and polygons with smooth edges, and no seams inside.", .judge = judge, .draw = blended_whole_polygons},
      {.name = "smooth_polygons_whole_as_alpha", .section = "§3.5.3", .shows = "The coverage of quads and polygons, some cut by a clip plane.", .judge = judge, .draw = whole_polygons_as_alpha},
      {.name = "smooth_polygons_long", .section = "§3.5.3", .shows = "Polygons of 2500 corners, without a seam.", .judge = judge, .draw = polygons_longer_than_a_batch},
      {.name = "smooth_polygons_saturated", .section = "§3.5.3", .shows = "A star of triangles without a seam.", .judge = judge, .draw = saturated_fan},
      {.name = "smooth_alpha_tested", .section = "§3.11", .shows = "Lines whose faint pixels fail the alpha test.", .judge = judge, .draw = alpha_tested},
  };
}

}  // namespace gouraud::conformance
