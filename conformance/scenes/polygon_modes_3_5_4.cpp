// Polygon modes: points, lines and fills per face. [GL1.5 §3.5.4]
// Nothing that is drawn as lines is clipped, save where a scene says so.
#include <array>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void colored(const GlTable& gl, const Surface::Point& point) {
  gl.Color3f(0.26f + 0.53f * point.u, 0.87f - 0.61f * point.v, 0.19f + 0.57f * point.v);
}

void draw_ring(const GlTable& gl, GLenum front, GLenum back, int rings = 24) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.4f, .pitch_deg = 38});
  gl.PolygonMode(GL_FRONT, front);
  gl.PolygonMode(GL_BACK, back);
  draw_surface(gl, torus(0.95f, 0.38f, rings, rings / 2), [&](const Surface::Point& point) { colored(gl, point); });
}

void ring_of_lines(const GlTable& gl) {
  draw_ring(gl, GL_LINE, GL_LINE);
}
void ring_of_points(const GlTable& gl) {
  draw_ring(gl, GL_POINT, GL_POINT, 90);
}

void ring_of_lines_culled(const GlTable& gl) {
  gl.Enable(GL_CULL_FACE);
  draw_ring(gl, GL_LINE, GL_FILL);
}

/// A ring cut open by its own rows: front and back faces both show.
void draw_open_ring(const GlTable& gl, GLenum front, GLenum back) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.PolygonMode(GL_FRONT, front);
  gl.PolygonMode(GL_BACK, back);
  const Matrix view = look(gl, {.distance = 6.9f, .pitch_deg = 41, .yaw_deg = 14});
  const Surface pipe = half_pipe(0.9f, 1.9f, 7, 14);
  load_model_view(gl, multiply(view, translation(-1, 0.45f, 0)));
  draw_surface(gl, pipe, [&](const Surface::Point& point) { colored(gl, point); });
  load_model_view(gl, multiply(view, multiply(translation(1, -0.35f, 0), rotation(168, 2))));
  draw_surface(gl, pipe, [&](const Surface::Point& point) { colored(gl, point); });
}

void fill_and_line(const GlTable& gl) {
  draw_open_ring(gl, GL_FILL, GL_LINE);
}
void line_and_fill(const GlTable& gl) {
  draw_open_ring(gl, GL_LINE, GL_FILL);
}
void point_and_line(const GlTable& gl) {
  draw_open_ring(gl, GL_POINT, GL_LINE);
}
void fill_and_point(const GlTable& gl) {
  draw_open_ring(gl, GL_FILL, GL_POINT);
}

using Points = std::vector<std::array<float, 2>>;
const Points zigzag = {{6.3f, 8.6f},  {10.1f, 55.2f}, {19.8f, 5.3f}, {26.4f, 57.9f},
                       {36.2f, 9.1f}, {41.7f, 51.6f}, {52.3f, 6.4f}, {57.6f, 56.7f}};
const Points octagon = {{58.2f, 41.3f}, {42.6f, 57.1f}, {21.4f, 58.3f}, {6.2f, 42.8f},
                        {5.9f, 21.7f},  {20.6f, 6.4f},  {42.1f, 5.7f},  {57.4f, 20.3f}};
const Points two_quads = {{5.2f, 6.3f},   {28.7f, 7.1f},  {27.6f, 57.4f}, {6.4f, 56.2f},
                          {35.3f, 12.6f}, {58.1f, 30.2f}, {50.7f, 58.3f}, {30.4f, 40.7f}};

// The diagonals of quads and polygons are no edges; those of strips and fans are.
void all_modes(const GlTable& gl, GLenum polygon_mode) {
  clear_background(gl);
  pixel_space(gl, 192, 128);
  gl.PolygonMode(GL_FRONT_AND_BACK, polygon_mode);
  const GLenum modes[6] = {GL_QUADS, GL_QUAD_STRIP, GL_POLYGON, GL_TRIANGLES, GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN};
  Random random(201);
  for (int i = 0; i < 6; ++i) {
    const float x = 64 * static_cast<float>(i % 3), y = 64 * static_cast<float>(i / 3);
    gl.Begin(modes[i]);
    for (const auto& [px, py] : i == 0 ? two_quads : i % 3 == 2 ? octagon : zigzag) {
      color_of(gl, random);
      gl.Vertex2f(x + px, y + py);
    }
    gl.End();
  }
}

void all_modes_as_lines(const GlTable& gl) {
  all_modes(gl, GL_LINE);
}
void all_modes_as_points(const GlTable& gl) {
  all_modes(gl, GL_POINT);
}

// In the provoking vertex's colour; two-sided lighting picks the face's colours for lines and points too.
void flat_lit_lines(const GlTable& gl) {
  gl.ShadeModel(GL_FLAT);
  black_lighting(gl, 1);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.29f, 0.67f, 0.71f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 1});
  material(gl, GL_FRONT, GL_EMISSION, {0.12f, 0.08f, 0.04f, 1});
  material(gl, GL_BACK, GL_DIFFUSE, {0.2f, 0.6f, 0.8f, 1});
  material(gl, GL_BACK, GL_EMISSION, {0.04f, 0.08f, 0.12f, 1});
  draw_open_ring(gl, GL_LINE, GL_LINE);
}

// Oracle only: the specification draws the edges that clipping makes, Mesa does not along the frustum (MESA-RULES 2.4).
void clipped_lines(const GlTable& gl) {
  clear_background(gl);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  look(gl, {.distance = 3.6f, .pitch_deg = 38, .near = 3.3f});
  draw_surface(gl, torus(0.95f, 0.38f, 24, 12), [&](const Surface::Point& point) { colored(gl, point); });
}

}  // namespace

SceneList polygon_mode_scenes() {
  constexpr auto section = "§3.5.4";
  constexpr auto judge = Judge::lines_and_points;
  return {
      {.name = "polygon_mode_line",
       .section = section,
       .shows = "A ring of lines, its far side visible through the near one.",
       .judge = judge,
       .draw = ring_of_lines},
      {.name = "polygon_mode_line_culled",
       .section = section,
       .shows = "The ring of lines without its back faces.",
       .judge = judge,
       .draw = ring_of_lines_culled},
      {.name = "polygon_mode_point",
       .section = section,
       .shows = "A ring of points.",
       .judge = judge,
       .draw = ring_of_points},
      {.name = "polygon_mode_fill_line",
       .section = section,
       .shows = "Half pipes, filled inside, lines outside.",
       .judge = judge,
       .draw = fill_and_line},
      {.name = "polygon_mode_line_fill",
       .section = section,
       .shows = "Half pipes, lines inside, filled outside.",
       .judge = judge,
       .draw = line_and_fill},
      {.name = "polygon_mode_point_line",
       .section = section,
       .shows = "Half pipes, points inside, lines outside.",
       .judge = judge,
       .draw = point_and_line},
      {.name = "polygon_mode_fill_point",
       .section = section,
       .shows = "Half pipes, filled inside, points outside.",
       .judge = judge,
       .draw = fill_and_point},
      {.name = "polygon_mode_line_by_mode",
       .section = section,
       .shows = "Quads, quad strip and polygon as lines, without diagonals; above, triangles, strip and fan.",
       .judge = judge,
       .width_px = 192,
       .height_px = 128,
       .draw = all_modes_as_lines},
      {.name = "polygon_mode_point_by_mode",
       .section = section,
       .shows = "The same as points.",
       .judge = judge,
       .width_px = 192,
       .height_px = 128,
       .draw = all_modes_as_points},
      {.name = "polygon_mode_flat_lit",
       .section = section,
       .shows = "Flat lit half pipes of lines, orange inside, blue outside.",
       .judge = judge,
       .draw = flat_lit_lines},
      {.name = "polygon_mode_clipped",
       .section = section,
       .shows = "A ring of lines cut open by the near plane, with the cut's outline.",
       .judge = Judge::oracle_only,
       .draw = clipped_lines},
  };
}

}  // namespace gouraud::conformance
