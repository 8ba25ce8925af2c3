// Polygon stipple: 32 x 32 bits, aligned with the window. [GL1.5 §3.5.2]
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

/// Bits that no mirror and no shift maps onto themselves.
std::array<GLubyte, 128> uneven_pattern() {
  std::array<GLubyte, 128> bytes;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const std::size_t row = i / 4, column = i % 4;
    bytes[i] = static_cast<GLubyte>(row < 8 ? 0xFFu << column : row % 4 == 0 ? 0x35u + 16 * column : row % 3 == 0 ? 0xC1u : 0x0Fu + row);
  }
  return bytes;
}

void stippled(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_POLYGON_STIPPLE);
  const auto bytes = uneven_pattern();
  gl.PolygonStipple(bytes.data());
}

void aligned_with_the_window(const GlTable& gl) {
  stippled(gl);
  pixel_space(gl, 250, 117);
  gl.Color3f(0.9f, 0.7f, 0.2f);
  draw_rectangle(gl, 5.5f, 3.5f, 120.5f, 110.5f, 0);
  gl.Color3f(0.2f, 0.7f, 0.9f);
  draw_rectangle(gl, 131, 7, 239, 101, 0);
}

void with_depth(const GlTable& gl) {
  stippled(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.4f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, 48, 24), [&](const Surface::Point& point) { gl.Color3f(0.3f + 0.6f * point.u, 0.8f - 0.5f * point.v, 0.4f); });
}

// Lines and points are not stippled, whether they are polygons or not.
void not_on_lines(const GlTable& gl) {
  stippled(gl);
  pixel_space(gl, 128, 128);
  gl.PolygonMode(GL_FRONT, GL_LINE);
  gl.Color3f(0.9f, 0.7f, 0.2f);
  const float places[3][2] = {{10.3f, 8.6f}, {110.4f, 30.3f}, {40.7f, 117.2f}};
  gl.Begin(GL_TRIANGLES);
  for (const auto& place : places) gl.Vertex2fv(place);
  gl.End();
  gl.LineWidth(3);
  gl.Begin(GL_LINES);
  gl.Vertex2f(15.3f, 110.6f);
  gl.Vertex2f(117.4f, 70.2f);
  gl.End();
  gl.PointSize(20);
  gl.Begin(GL_POINTS);
  gl.Vertex2f(100.3f, 100.7f);
  gl.End();
}

// The pattern goes through the pixel store.
void unpacked(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  gl.Enable(GL_POLYGON_STIPPLE);
  std::array<GLubyte, 600> bytes{};
  Random random(341);
  for (GLubyte& byte : bytes) byte = static_cast<GLubyte>(random.next() >> 8);
  const auto quarter = [&](float x, float y) {
    gl.PolygonStipple(bytes.data());
    gl.Color3f(0.9f, 0.7f, 0.2f);
    draw_rectangle(gl, x, y, x + 64, y + 64, 0);
  };
  gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
  quarter(0, 0);
  gl.PixelStorei(GL_UNPACK_LSB_FIRST, 0);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 77);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  quarter(64, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 21);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 3);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
  quarter(0, 64);
  gl.PixelStorei(GL_UNPACK_LSB_FIRST, 1);
  quarter(64, 64);
}

// What GetPolygonStipple gives is what PolygonStipple was given; and a list keeps the pattern of when it was compiled.
void read_back_and_listed(const GlTable& gl) {
  stippled(gl);
  pixel_space(gl, 128, 64);
  std::array<GLubyte, 128> bytes{};
  gl.GetPolygonStipple(bytes.data());
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.PolygonStipple(bytes.data());
  gl.EndList();
  bytes.fill(0x81);
  gl.PolygonStipple(bytes.data());
  gl.PushAttrib(GL_POLYGON_STIPPLE_BIT);
  gl.CallList(list);
  gl.Color3f(0.9f, 0.7f, 0.2f);
  draw_rectangle(gl, 2, 2, 60, 60, 0);
  gl.PopAttrib();
  draw_rectangle(gl, 66, 2, 124, 60, 0);
  gl.DeleteLists(list, 1);
}

}  // namespace

SceneList polygon_stipple_scenes() {
  constexpr auto section = "§3.5.2";
  return {
      {.name = "polygon_stipple_aligned", .section = section, .shows = "Two stippled rectangles with one pattern through both.", .width_px = 250, .height_px = 117, .draw = aligned_with_the_window},
      {.name = "polygon_stipple_depth", .section = section, .shows = "A stippled ring, seen through itself.", .draw = with_depth},
      {.name = "polygon_stipple_not_lines", .section = section, .shows = "Whole lines and a whole point.", .judge = Judge::lines_and_points, .width_px = 128, .height_px = 128, .draw = not_on_lines},
      {.name = "polygon_stipple_unpacked", .section = section, .shows = "Four patterns, by four sets of pixel store parameters.", .width_px = 128, .height_px = 128, .draw = unpacked},
      {.name = "polygon_stipple_read_back", .section = section, .shows = "The pattern, read back and listed; and vertical bars.", .width_px = 128, .height_px = 64, .draw = read_back_and_listed},
  };
}

}  // namespace gouraud::conformance
