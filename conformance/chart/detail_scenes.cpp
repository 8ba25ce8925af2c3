// Detail: lines, points, glyphs, slivers, triangles as small as pixels.
#include <array>
#include <cmath>
#include <numbers>

#include "conformance/chart/scenes.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::chart {
namespace {

using conformance::color_of;
using conformance::Random;

constexpr double pi = std::numbers::pi;
constexpr int width = chart_width_px, height = chart_height_px;

struct Ray {
  float x, y;
};

Ray on_circle(double radius, double turn) {
  return {static_cast<float>(width / 2.0 + radius * std::cos(2 * pi * turn)),
          static_cast<float>(height / 2.0 + radius * std::sin(2 * pi * turn))};
}

/// Every second one of 720 thin triangles about a centre.
Drawing slivers(const GlTable& gl, double) {
  project_pixels(gl, width, height);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    Random random(3);
    table.Begin(GL_TRIANGLES);
    constexpr int rays = 720;
    for (int i = 0; i < rays; i += 2) {
      for (const auto& [x, y] : {on_circle(1, (i + 0.3) / rays), on_circle(140, (i + 0.1) / rays), on_circle(140, (i + 0.9) / rays)}) {
        color_of(table, random);
        table.Vertex3f(x, y, random.range(-0.9f, 0.9f));
      }
    }
    table.End();
  }};
}

Drawing lines(const GlTable& gl, bool smooth) {
  project_pixels(gl, width, height);
  if (smooth) {
    gl.Enable(GL_LINE_SMOOTH);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    Random random(9);
    table.Begin(GL_LINES);
    for (int i = 0; i < 300; ++i) {
      for (const double radius : {20.3, 90.0 + i % 50}) {
        color_of(table, random);
        const auto [x, y] = on_circle(radius, (i + 0.21) / 300.0);
        table.Vertex2f(x, y);
      }
    }
    table.End();
  }};
}

Drawing thin_lines(const GlTable& gl, double) { return lines(gl, false); }
Drawing smooth_lines(const GlTable& gl, double) { return lines(gl, true); }

/// A page of glyphs of 5 x 7 dots from a texture of 64 of them, alpha tested; positions are not on whole pixels.
Drawing text(const GlTable& gl, double) {
  constexpr int glyphs = 64, cell = 8;
  Random random(77);
  std::vector<std::uint8_t> texels(glyphs * cell * cell);
  for (int glyph = 0; glyph < glyphs; ++glyph) {
    for (int y = 0; y < 7; ++y) {
      for (int x = 0; x < 5; ++x) {
        texels[static_cast<std::size_t>(y * glyphs * cell + glyph * cell + x)] = random.below(100) < 45 ? 255 : 0;
      }
    }
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, glyphs * cell, cell, 0, GL_ALPHA, GL_UNSIGNED_BYTE, texels.data());
  conformance::filters(gl, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.5f);
  project_pixels(gl, width, height);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    table.Color4f(0.95f, 0.9f, 0.7f, 1);
    Random letters(4);
    for (int line = 0; line < 28; ++line) {
      for (int column = 0; column < 48; ++column) {
        const auto x = static_cast<float>(8.23 + 8.01 * column), y = static_cast<float>(8.31 + 10.13 * line);
        const int glyph = letters.below(64);
        const auto s = static_cast<float>(glyph / 64.0), next = static_cast<float>((glyph + 1) / 64.0);
        conformance::textured_rectangle(table, x, y, x + 8, y + 8, s, 0, next, 1);
      }
    }
  }};
}

Drawing points(const GlTable& gl, double) {
  project_pixels(gl, width, height);
  gl.Enable(GL_DEPTH_TEST);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    Random random(12);
    for (int size = 1; size <= 6; ++size) {
      table.PointSize(static_cast<float>(size));
      table.Begin(GL_POINTS);
      for (int i = 0; i < 3000; ++i) {
        color_of(table, random);
        const float x = random.range(3, width - 3), y = random.range(3, height - 3);
        table.Vertex3f(x, y, random.range(-1, 1));
      }
      table.End();
    }
  }};
}

/// Triangles of a few pixels, steep in depth.
Drawing small_triangles(const GlTable& gl, double) {
  project_pixels(gl, width, height);
  gl.Enable(GL_DEPTH_TEST);
  return {[](const GlTable& table) {
    conformance::clear_background(table);
    Random random(31);
    table.Begin(GL_TRIANGLES);
    for (int i = 0; i < 12000; ++i) {
      const float x = random.range(6, width - 6), y = random.range(6, height - 6), z = random.range(-0.9f, 0.9f);
      for (int corner = 0; corner < 3; ++corner) {
        color_of(table, random);
        const float dx = random.range(-3, 3), dy = random.range(-3, 3);
        table.Vertex3f(x + dx, y + dy, z + random.range(-0.1f, 0.1f));
      }
    }
    table.End();
  }};
}

Probe probe(std::string_view name, std::string_view shows, Drawing (*setup)(const GlTable&, double)) {
  return {name, shows, width, height, setup};
}

}  // namespace

std::vector<ChartScene> detail_scenes() {
  return {
      {probe("slivers", "360 triangles, one degree wide, with colours and depths of their own", slivers), polygon_steps},
      {probe("small_triangles", "12,000 triangles of some pixels, steep in depth", small_triangles), polygon_steps},
      {probe("thin_lines", "300 lines of width 1 in all directions", thin_lines), line_steps},
      {probe("smooth_lines", "the same lines, antialiased and blended", smooth_lines), line_steps},
      {probe("text", "1,344 glyphs: alpha tested texels, not on whole pixels", text), polygon_steps},
      {probe("points", "18,000 points of sizes 1 to 6 with depth", points), point_steps},
  };
}

}  // namespace gouraud::chart
