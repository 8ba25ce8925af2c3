// Begin and End: the ten modes, what is left over, and what happens between many small primitives. [GL1.5 §2.6.1]
#include <array>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

using Points = std::vector<std::array<float, 2>>;

const Points zigzag = {{6.3f, 8.6f},  {10.1f, 55.2f}, {19.8f, 5.3f}, {26.4f, 57.9f},
                       {36.2f, 9.1f}, {41.7f, 51.6f}, {52.3f, 6.4f}, {57.6f, 56.7f}};
const Points octagon = {{58.2f, 41.3f}, {42.6f, 57.1f}, {21.4f, 58.3f}, {6.2f, 42.8f},
                        {5.9f, 21.7f},  {20.6f, 6.4f},  {42.1f, 5.7f},  {57.4f, 20.3f}};
const Points two_quads = {{5.2f, 6.3f},   {28.7f, 6.3f},  {28.7f, 57.4f}, {5.2f, 57.4f},
                          {35.3f, 12.6f}, {58.1f, 30.2f}, {50.7f, 58.3f}, {27.9f, 40.7f}};

/// Vertices of a mode at `x`, `y`. Colours of quads are affine in the position, so that either diagonal gives the same.
void draw(const GlTable& gl, GLenum mode, const Points& points, float x, float y, std::uint32_t seed) {
  Random random(seed);
  gl.Begin(mode);
  for (const auto& [px, py] : points) {
    if (mode == GL_QUADS) {
      gl.Color3f(px / 64, py / 64, 0.8f - px / 128);
    } else {
      color_of(gl, random);
    }
    gl.Vertex2f(x + px, y + py);
  }
  gl.End();
}

void ten_modes(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 320, 128);
  draw(gl, GL_POINTS, zigzag, 0, 64, 11);
  draw(gl, GL_LINES, zigzag, 64, 64, 12);
  draw(gl, GL_LINE_STRIP, zigzag, 128, 64, 13);
  draw(gl, GL_LINE_LOOP, octagon, 192, 64, 14);
  draw(gl, GL_TRIANGLES, zigzag, 256, 64, 15);
  draw(gl, GL_TRIANGLE_STRIP, zigzag, 0, 0, 16);
  draw(gl, GL_TRIANGLE_FAN, octagon, 64, 0, 17);
  draw(gl, GL_QUADS, two_quads, 128, 0, 18);
  draw(gl, GL_QUAD_STRIP, zigzag, 192, 0, 19);
  draw(gl, GL_POLYGON, octagon, 256, 0, 20);
}

void filled_modes(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 192, 128);
  draw(gl, GL_TRIANGLES, zigzag, 0, 64, 21);
  draw(gl, GL_TRIANGLE_STRIP, zigzag, 64, 64, 22);
  draw(gl, GL_TRIANGLE_FAN, octagon, 128, 64, 23);
  draw(gl, GL_QUADS, two_quads, 0, 0, 24);
  draw(gl, GL_QUAD_STRIP, zigzag, 64, 0, 25);
  draw(gl, GL_POLYGON, octagon, 128, 0, 26);
}

// Every mode with 0 .. 7 vertices: a row a mode, a column a count.
void incomplete_grid(const GlTable& gl, bool flush_each) {
  constexpr std::array<GLenum, 10> modes = {GL_POINTS,     GL_LINES,          GL_LINE_STRIP,   GL_LINE_LOOP,
                                            GL_TRIANGLES,  GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,
                                            GL_QUAD_STRIP, GL_POLYGON};
  clear_background(gl);
  pixel_space(gl, 512, 640);
  for (std::size_t row = 0; row < modes.size(); ++row) {
    const GLenum mode = modes[row];
    const Points& all = mode == GL_QUADS                                                        ? two_quads
                        : mode == GL_TRIANGLE_FAN || mode == GL_POLYGON || mode == GL_LINE_LOOP ? octagon
                                                                                                : zigzag;
    for (int count = 0; count < 8; ++count) {
      const Points some(all.begin(), all.begin() + count);
      const auto seed = static_cast<std::uint32_t>(100 + 8 * static_cast<int>(row) + count);
      draw(gl, mode, some, static_cast<float>(64 * count), static_cast<float>(64 * row), seed);
      if (flush_each) gl.Flush();
    }
  }
}

void incomplete_primitives(const GlTable& gl) {
  incomplete_grid(gl, true);
}
// Oracle only: without a flush llvmpipe collects primitives, and an empty Begin/End that is the first of its mode after
// another mode takes all of its mode that follow with it (strip of 5, loop of 0, loop of 6: no loop). softpipe does
// not.
void incomplete_primitives_batched(const GlTable& gl) {
  incomplete_grid(gl, false);
}

void current_color_persists(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  const auto triangle = [&](float x, float y) {
    gl.Vertex2f(x + 4.3f, y + 5.2f);
    gl.Vertex2f(x + 58.6f, y + 9.7f);
    gl.Vertex2f(x + 29.4f, y + 57.1f);
  };
  for (int row = 0; row < 4; ++row) {
    const float y = static_cast<float>(64 * row);
    gl.Color3f(0.2f * static_cast<float>(row + 1), 0.8f, 0.2f);
    gl.Begin(GL_TRIANGLES);
    triangle(0, y);             // the colour from before Begin
    gl.Color3f(0.8f, 0.2f, 0);  // for all vertices to come
    triangle(64, y);
    gl.Vertex2f(131.2f, y + 6.1f);
    gl.Color3f(0, 0.4f, 0.8f);  // in the middle of a triangle
    gl.Vertex2f(187.5f, y + 8.3f);
    gl.Vertex2f(160.3f, y + 57.4f);
    gl.Color3f(0.6f, 0.6f, 0.2f * static_cast<float>(row));  // after the last vertex: the next Begin has it
    gl.End();
    gl.Begin(GL_TRIANGLES);
    triangle(192, y);
    gl.End();
  }
}

void many_tiny_begin_ends(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(31);
  for (int i = 0; i < 64 * 64; ++i) {
    const float x = static_cast<float>(4 * (i % 64)), y = static_cast<float>(4 * (i / 64));
    color_of(gl, random);
    gl.Begin(GL_TRIANGLES);
    const float left = random.range(0, 1), right = random.range(3, 5), middle = random.range(1, 3);
    const float top = random.range(3, 5);
    gl.Vertex2f(x + left, y + random.range(0, 1));
    gl.Vertex2f(x + right, y + random.range(0, 1));
    gl.Vertex2f(x + middle, y + top);
    gl.End();
  }
}

void state_between_primitives(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 5});
  light(gl, GL_LIGHT0, GL_POSITION, {0.4f, 0.7f, 0.6f, 0});
  light(gl, GL_LIGHT1, GL_DIFFUSE, {0.8f, 0.4f, 0.2f, 1});
  light(gl, GL_LIGHT1, GL_POSITION, {-2.3f, 0.4f, 1.7f, 1});
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_DEPTH_TEST);
  const Surface ball = sphere(1.3f, 24, 48);
  Random random(32);
  for (int row = 0; row + 1 < ball.rows; ++row) {
    for (int column = 0; column + 1 < ball.columns; ++column) {
      const int kind = random.below(64);
      (kind & 1 ? gl.Enable : gl.Disable)(GL_LIGHTING);
      (kind & 2 ? gl.Enable : gl.Disable)(GL_LIGHT1);
      gl.ShadeModel(kind & 4 ? GL_FLAT : GL_SMOOTH);
      gl.DepthFunc(kind & 8 ? GL_LEQUAL : GL_LESS);
      (kind & 16 ? gl.Enable : gl.Disable)(GL_CULL_FACE);
      gl.ColorMask(GL_TRUE, GL_TRUE, kind & 32 ? GL_TRUE : GL_FALSE, GL_TRUE);
      color_of(gl, random);
      gl.Begin(GL_TRIANGLE_STRIP);
      for (const auto& [r, c] :
           {std::array{row + 1, column}, {row, column}, {row + 1, column + 1}, {row, column + 1}}) {
        gl.Normal3fv(ball.at(r, c).normal.data());
        gl.Vertex3fv(ball.at(r, c).position.data());
      }
      gl.End();
    }
  }
}

/// A quad that shows its diagonal: along the one from the first vertex it is red, along the other it is green.
void saddle(const GlTable& gl, float x, float y) {
  const std::array<std::array<float, 2>, 4> corners{{{6.2f, 5.4f}, {57.3f, 8.6f}, {54.1f, 55.8f}, {8.7f, 58.3f}}};
  for (std::size_t i = 0; i < 4; ++i) {
    gl.Color3f(i % 2 == 0 ? 1.0f : 0.1f, i % 2 == 0 ? 0.1f : 1.0f, 0.2f);
    gl.Vertex2f(x + corners[i][0], y + corners[i][1]);
  }
}

// What decides on the diagonal of quads: lists, indices, stipple, and whether one of those that are drawn together is clipped.
void quad_diagonals(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  const auto quads = [&](std::initializer_list<std::array<float, 2>> places) {
    gl.Begin(GL_QUADS);
    for (const auto& [x, y] : places) saddle(gl, x, y);
    gl.End();
  };
  quads({{0, 64}});
  gl.Flush();
  quads({{64, 64}});
  quads({{230, 0}});
  gl.Flush();
  gl.NewList(1, GL_COMPILE);
  quads({{128, 64}});
  gl.EndList();
  gl.CallList(1);
  gl.Flush();
  const std::array<float, 8> corners{198, 70, 250, 73, 246, 120, 201, 122};
  const std::array<float, 12> colors{1, 0.1f, 0.2f, 0.1f, 1, 0.2f, 1, 0.1f, 0.2f, 0.1f, 1, 0.2f};
  const std::array<GLushort, 4> indices{0, 1, 2, 3};
  gl.VertexPointer(2, GL_FLOAT, 0, corners.data());
  gl.ColorPointer(3, GL_FLOAT, 0, colors.data());
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.DrawElements(GL_QUADS, 4, GL_UNSIGNED_SHORT, indices.data());
  gl.Translatef(-192, -64, 0);
  gl.DrawArrays(GL_QUADS, 0, 4);
  gl.Translatef(192, 64, 0);
  gl.Flush();
  std::array<GLubyte, 128> stipple;
  stipple.fill(0xE7);
  gl.PolygonStipple(stipple.data());
  gl.Enable(GL_POLYGON_STIPPLE);
  quads({{64, 0}});
  gl.Disable(GL_POLYGON_STIPPLE);
  quads({{128, 0}});
}

}  // namespace

SceneList begin_end_scenes() {
  constexpr auto section = "§2.6.1";
  return {
      {.name = "ten_modes",
       .section = section,
       .shows = "All ten primitive modes, five a row: points, lines, strip, loop, triangles; strip, fan, quads, quad "
                "strip, polygon.",
       .judge = Judge::lines_and_points,
       .width_px = 320,
       .height_px = 128,
       .draw = ten_modes},
      {.name = "filled_modes",
       .section = section,
       .shows = "The six filled modes in smooth random colours: triangles, strip, fan; quads, quad strip, polygon.",
       .width_px = 192,
       .height_px = 128,
       .draw = filled_modes},
      {.name = "quad_diagonals",
       .section = section,
       .shows = "Above, quads that are split from the first vertex (red diagonal), and from the second (green), since a later "
                "one is clipped, in a list, by indices; below from arrays, stippled, smooth again.",
       .width_px = 256,
       .height_px = 128,
       .draw = quad_diagonals},
      {.name = "incomplete_primitives",
       .section = section,
       .shows = "Each mode (points at the bottom, polygons at the top) with 0 to 7 vertices from left to right: what "
                "is left over draws nothing.",
       .judge = Judge::lines_and_points,
       .width_px = 512,
       .height_px = 640,
       .draw = incomplete_primitives},
      {.name = "incomplete_primitives_batched",
       .section = section,
       .shows = "The same without a flush between them.",
       .judge = Judge::oracle_only,
       .width_px = 512,
       .height_px = 640,
       .draw = incomplete_primitives_batched},
      {.name = "current_color_persists",
       .section = section,
       .shows = "Colours set before, between and after vertices: the first column greens, then red, then red into "
                "blue, then olive.",
       .draw = current_color_persists},
      {.name = "many_tiny_begin_ends",
       .section = section,
       .shows = "4096 small triangles, each in its own Begin/End and colour.",
       .draw = many_tiny_begin_ends},
      {.name = "state_between_primitives",
       .section = section,
       .shows = "A sphere of 1152 patches, each with another mix of lighting, lights, shade model, depth function, "
                "culling and colour mask.",
       .draw = state_between_primitives},
  };
}

}  // namespace gouraud::conformance
