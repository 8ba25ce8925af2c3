// Edge flags: which edges and vertices of separate triangles, quads and polygons are drawn. [GL1.5 §2.6.2]
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr std::array<std::array<float, 2>, 6> places{{{10.3f, 12.6f}, {47.2f, 8.7f}, {58.4f, 33.1f}, {40.6f, 55.2f}, {20.8f, 50.3f}, {6.7f, 30.6f}}};

void draw(const GlTable& gl, GLenum mode, float x, float y, int count, unsigned flags) {
  gl.Begin(mode);
  for (int i = 0; i < count; ++i) {
    gl.EdgeFlag((flags >> i & 1) != 0 ? GL_TRUE : GL_FALSE);
    gl.Color3f(0.9f, 0.15f * static_cast<float>(i), 0.4f);
    const auto& place = places[static_cast<std::size_t>(i)];
    gl.Vertex2f(x + place[0], y + place[1]);
  }
  gl.End();
  gl.EdgeFlag(GL_TRUE);
}

void draw_all(const GlTable& gl, GLenum polygon_mode) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  gl.PolygonMode(GL_FRONT_AND_BACK, polygon_mode);
  gl.PointSize(3);
  draw(gl, GL_TRIANGLES, 0, 0, 6, 0b101011);
  draw(gl, GL_QUADS, 64, 0, 4, 0b1010);
  draw(gl, GL_POLYGON, 128, 0, 6, 0b110101);
  draw(gl, GL_POLYGON, 192, 0, 6, 0b000001);
  draw(gl, GL_QUADS, 0, 64, 4, 0b0111);
  draw(gl, GL_TRIANGLES, 64, 64, 3, 0);
}

void lines(const GlTable& gl) { draw_all(gl, GL_LINE); }
void points(const GlTable& gl) { draw_all(gl, GL_POINT); }
void fills(const GlTable& gl) { draw_all(gl, GL_FILL); }

// deviation: the flags of strips and fans count for nothing [GL1.5 §2.6.2]; Mesa heeds them (MESA-RULES 5.5).
void strips_and_fans(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 192, 64);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  draw(gl, GL_TRIANGLE_STRIP, 0, 0, 5, 0b01010);
  draw(gl, GL_TRIANGLE_FAN, 64, 0, 6, 0b010101);
  draw(gl, GL_QUAD_STRIP, 128, 0, 6, 0b100110);
}

struct Corner {
  float x, y;
  GLubyte flag;
};

void arrays(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 64);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gl.Color3f(0.9f, 0.8f, 0.3f);
  const Corner corners[6] = {{10.3f, 12.6f, 1}, {47.2f, 8.7f, 0}, {58.4f, 33.1f, 1}, {70.6f, 55.2f, 0}, {90.8f, 50.3f, 1}, {116.7f, 10.6f, 1}};
  gl.VertexPointer(2, GL_FLOAT, sizeof(Corner), &corners[0].x);
  gl.EdgeFlagPointer(sizeof(Corner), &corners[0].flag);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_EDGE_FLAG_ARRAY);
  gl.DrawArrays(GL_TRIANGLES, 0, 6);
  gl.DisableClientState(GL_VERTEX_ARRAY);
  gl.DisableClientState(GL_EDGE_FLAG_ARRAY);
}

void lists(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  draw(gl, GL_POLYGON, 0, 0, 6, 0b011011);
  draw(gl, GL_QUADS, 64, 0, 4, 0b1101);
  gl.EdgeFlag(GL_FALSE);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 9; ++i) {
    if (i == 4) gl.EdgeFlag(GL_TRUE);
    gl.Vertex2f(10.3f + 12.1f * static_cast<float>(i), 70.6f + 47.3f * static_cast<float>(i % 2));
  }
  gl.End();
  gl.EndList();
  gl.CallList(list);
  gl.DeleteLists(list, 1);
}

// A polygon of more vertices than a batch holds, every third edge of which is drawn.
void large_polygon(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  gl.Begin(GL_POLYGON);
  gl.Color3f(0.4f, 0.9f, 0.8f);
  const auto corner = [&](int i, float x, float y) {
    gl.EdgeFlag(i % 3 == 0 ? GL_TRUE : GL_FALSE);
    gl.Vertex2f(x, y);
  };
  for (int i = 0; i < 1300; ++i) corner(i, 10.3f + 0.17f * static_cast<float>(i), 10.4f + 0.00015f * static_cast<float>(i) * static_cast<float>(i) / 2);
  for (int i = 1300; i > 0; --i) corner(i, 10.3f + 0.17f * static_cast<float>(i), 230.6f + 0.005f * static_cast<float>(i % 2));
  gl.End();
}

}  // namespace

SceneList edge_flag_scenes() {
  constexpr auto section = "§2.6.2";
  constexpr auto judge = Judge::lines_and_points;
  // So few pixels that the ends where Mesa's emulation of diamonds errs are too large a share.
  constexpr auto few_pixels = Judge::oracle_only;
  return {
      {.name = "edge_flags_lines", .section = section, .shows = "Outlines with gaps where the edge flag is false.", .judge = judge, .width_px = 256, .height_px = 128, .draw = lines},
      {.name = "edge_flags_points", .section = section, .shows = "Only vertices where a boundary edge begins.", .judge = judge, .width_px = 256, .height_px = 128, .draw = points},
      {.name = "edge_flags_fills", .section = section, .shows = "Filled polygons know no edge flags.", .width_px = 256, .height_px = 128, .draw = fills},
      {.name = "edge_flags_strips_and_fans", .section = section, .shows = "Whole outlines of strips and fans.", .judge = Judge::oracle_only, .width_px = 192, .height_px = 64, .draw = strips_and_fans},
      {.name = "edge_flags_arrays", .section = section, .shows = "Two triangles with gaps, from arrays.", .judge = few_pixels, .width_px = 128, .height_px = 64, .draw = arrays},
      {.name = "edge_flags_lists", .section = section, .shows = "Outlines with gaps, from a list.", .judge = few_pixels, .width_px = 128, .height_px = 128, .draw = lists},
      {.name = "edge_flags_large_polygon", .section = section, .shows = "The points of a large polygon, every third.", .judge = Judge::oracle_only, .draw = large_polygon},
  };
}

}  // namespace gouraud::conformance
