// Polygon offset. [GL1.5 §3.5.5]
// r is two steps of the depth buffer, as in Mesa; the least that the specification allows is one.
// deviation: offsets of lines and points are for lines and points alone (Mesa applies them to filled polygons as well), and
// depths are clamped by fragment.
#include <cstring>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void colored(const GlTable& gl, const Surface::Point& point) { gl.Color3f(0.3f + 0.5f * point.u, 0.8f - 0.6f * point.v, 0.3f); }

// A filled ring and, on top of the same triangles, what `again` draws: offset towards the eye.
void ring(const GlTable& gl, GLenum mode, GLenum cap, float factor, float units) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  look(gl, {.distance = 4.4f, .pitch_deg = 38});
  const Surface surface = torus(0.95f, 0.38f, 24, 12);
  draw_surface(gl, surface, [&](const Surface::Point& point) { colored(gl, point); });
  gl.PolygonMode(GL_FRONT_AND_BACK, mode);
  gl.Enable(cap);
  gl.PolygonOffset(factor, units);
  gl.Color3f(1, 1, 1);
  draw_surface(gl, surface, [](const Surface::Point&) {});
}

void lines_towards(const GlTable& gl) { ring(gl, GL_LINE, GL_POLYGON_OFFSET_LINE, -2, -20000); }
void points_towards(const GlTable& gl) {
  gl.PointSize(3);
  ring(gl, GL_POINT, GL_POLYGON_OFFSET_POINT, -2, -20000);
}
void fill_towards(const GlTable& gl) { ring(gl, GL_FILL, GL_POLYGON_OFFSET_FILL, -1.5f, -4); }
void fill_away(const GlTable& gl) { ring(gl, GL_FILL, GL_POLYGON_OFFSET_FILL, 1, 4); }

// Only the mode that is enabled is offset.
void other_mode(const GlTable& gl) { ring(gl, GL_FILL, GL_POLYGON_OFFSET_LINE, 1, 1000); }

// Depths are written as offset: read back by the harness. Slopes of all sizes, both signs of both terms.
void depths(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  Random random(351);
  for (int i = 0; i < 36; ++i) {
    gl.PolygonOffset(static_cast<float>(i % 5 - 2), 1000.0f * static_cast<float>(i % 7 - 3));
    const float x = 3 + 42 * static_cast<float>(i % 6), y = 3 + 42 * static_cast<float>(i / 6);
    gl.Begin(GL_TRIANGLES);
    color_of(gl, random);
    const float places[3][2] = {{1.3f, 2.4f}, {38.6f, 7.2f}, {17.1f, 39.3f}};
    for (const auto& place : places) gl.Vertex3f(x + place[0], y + place[1], random.range(-0.6f, 0.6f));
    gl.End();
  }
}

// The bias of EXT_polygon_offset is in window z. Mesa has left the extension: there, units of the 24 bits say the same.
void offset_by_bias(const GlTable& gl, float factor, float bias) {
  const auto* const extensions = reinterpret_cast<const char*>(gl.GetString(GL_EXTENSIONS));
  if (std::strstr(extensions, "GL_EXT_polygon_offset ") != nullptr) return gl.PolygonOffsetEXT(factor, bias);
  gl.PolygonOffset(factor, bias * 16777215.0f / 2.0f);
}

// Cards that lean, from a hundredth towards the eye to a hundredth away.
void bias(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_POLYGON_OFFSET_EXT);
  for (int i = 0; i < 16; ++i) {
    const float x = 64 * static_cast<float>(i % 4), y = 64 * static_cast<float>(i / 4);
    const auto card = [&](float low, float high) {
      gl.Begin(GL_QUADS);
      gl.Vertex3f(x + low, y + low, -0.2f);
      gl.Vertex3f(x + high, y + low, 0.2f);
      gl.Vertex3f(x + high, y + high, 0.2f);
      gl.Vertex3f(x + low, y + high, -0.2f);
      gl.End();
    };
    gl.PolygonOffset(0, 0);
    gl.Color3f(0.3f, 0.3f, 0.7f);
    card(4.3f, 59.6f);
    offset_by_bias(gl, static_cast<float>(i % 3 - 1), 0.01f * (static_cast<float>(i) / 7.5f - 1.0f));
    gl.Color3f(0.9f, 0.7f, 0.2f);
    card(14.2f, 48.9f);
  }
}

// Near 0 and 1 the depth of each fragment is clamped, not that of the vertices.
void clamped(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  for (int i = 0; i < 2; ++i) {
    const float sign = i == 0 ? -1.0f : 1.0f, x = 128 * static_cast<float>(i);
    gl.PolygonOffset(0, sign * 3000000);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(0.9f, 0.4f, 0.4f);
    gl.Vertex3f(x + 5.2f, 7.1f, sign * 0.99f);
    gl.Vertex3f(x + 121.7f, 11.6f, sign * 0.99f);
    gl.Vertex3f(x + 60.3f, 120.2f, sign * 0.1f);
    gl.End();
  }
}

// Absurd terms: everything lies at the border of the range, and nothing else happens.
void absurd(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 128, 128);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  const float terms[4][2] = {{1e30f, 0}, {-1e30f, 0}, {0, 1e38f}, {0, -1e38f}};
  for (int i = 0; i < 4; ++i) {
    gl.PolygonOffset(terms[i][0], terms[i][1]);
    const float x = 64 * static_cast<float>(i % 2), y = 64 * static_cast<float>(i / 2);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(0.4f, 0.2f * static_cast<float>(i), 0.9f);
    gl.Vertex3f(x + 4.3f, y + 5.1f, -0.3f);
    gl.Vertex3f(x + 58.2f, y + 9.4f, 0.2f);
    gl.Vertex3f(x + 31.1f, y + 60.3f, 0.5f);
    gl.End();
  }
}

}  // namespace

SceneList polygon_offset_scenes() {
  constexpr auto section = "§3.5.5";
  constexpr auto judge = Judge::oracle_only;
  return {
      {.name = "polygon_offset_lines", .section = section, .shows = "A ring with its edges drawn on it in white.", .judge = judge, .draw = lines_towards},
      {.name = "polygon_offset_points", .section = section, .shows = "A ring with its vertices drawn on it in white.", .judge = judge, .draw = points_towards},
      {.name = "polygon_offset_fill_towards", .section = section, .shows = "A white ring: drawn again, a little nearer.", .judge = judge, .draw = fill_towards},
      {.name = "polygon_offset_fill_away", .section = section, .shows = "A coloured ring: what was drawn again lies behind it.", .judge = judge, .draw = fill_away},
      {.name = "polygon_offset_other_mode", .section = section, .shows = "A white ring: the offset of lines does not move what is filled.", .judge = judge, .draw = other_mode},
      {.name = "polygon_offset_depths", .section = section, .shows = "Triangles of all slopes, whose depths are judged.", .judge = judge, .draw = depths},
      {.name = "polygon_offset_bias", .section = section, .shows = "Leaning cards, each with a smaller one before or behind it.", .judge = judge, .draw = bias},
      {.name = "polygon_offset_clamped", .section = section, .shows = "Two triangles whose depths reach 0 and 1.", .judge = judge, .width_px = 256, .height_px = 128, .draw = clamped},
      {.name = "polygon_offset_absurd", .section = section, .shows = "Four triangles at the ends of the depth range.", .judge = judge, .width_px = 128, .height_px = 128, .draw = absurd},
  };
}

}  // namespace gouraud::conformance
