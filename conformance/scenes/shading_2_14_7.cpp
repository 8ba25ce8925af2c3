// Clamping of vertex colours, flat shading and its provoking vertices. [GL1.5 §2.14.6, §2.14.7]
#include <array>
#include <vector>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

// Colours are clamped at the vertices, before they are interpolated: ramps end where clamped corners are.
void color_clamping(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 192);
  const float tops[3] = {1.7f, 4.2f, -0.9f};
  for (int i = 0; i < 3; ++i) {
    const float y = 64 * static_cast<float>(i);
    gl.Begin(GL_TRIANGLE_STRIP);
    gl.Color3f(-1.3f, 0.2f, 0.4f);
    gl.Vertex2f(6.3f, y + 5.7f);
    gl.Vertex2f(8.9f, y + 57.2f);
    gl.Color3f(tops[i], 1.6f, -0.7f);
    gl.Vertex2f(246.8f, y + 9.4f);
    gl.Vertex2f(250.1f, y + 60.6f);
    gl.End();
  }
}

void overbright_lights(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 2);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {3.7f, 2.1f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.51f, 0.47f, 0.67f, 0});
  light(gl, GL_LIGHT1, GL_DIFFUSE, {-1.7f, 0.3f, 1.4f, 1});
  light(gl, GL_LIGHT1, GL_POSITION, {-0.71f, 0.37f, 0.55f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.7f, 0.9f, 1});
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20));
}

using Points = std::vector<std::array<float, 2>>;
const Points zigzag = {{6.3f, 8.6f},  {10.1f, 55.2f}, {19.8f, 5.3f}, {26.4f, 57.9f},
                       {36.2f, 9.1f}, {41.7f, 51.6f}, {52.3f, 6.4f}, {57.6f, 56.7f}};
const Points octagon = {{58.2f, 41.3f}, {42.6f, 57.1f}, {21.4f, 58.3f}, {6.2f, 42.8f},
                        {5.9f, 21.7f},  {20.6f, 6.4f},  {42.1f, 5.7f},  {57.4f, 20.3f}};
const Points two_quads = {{5.2f, 6.3f},   {28.7f, 6.3f},  {28.7f, 57.4f}, {5.2f, 57.4f},
                          {35.3f, 12.6f}, {58.1f, 30.2f}, {50.7f, 58.3f}, {27.9f, 40.7f}};
// Vertex i has the colour i of these, so that the picture tells who provoked.
constexpr std::array<std::array<float, 3>, 8> palette = {{{0.8f, 0.2f, 0.2f},
                                                          {0.2f, 0.8f, 0.2f},
                                                          {0.2f, 0.2f, 0.8f},
                                                          {0.8f, 0.8f, 0.2f},
                                                          {0.8f, 0.2f, 0.8f},
                                                          {0.2f, 0.8f, 0.8f},
                                                          {0.8f, 0.8f, 0.8f},
                                                          {0.8f, 0.4f, 0}}};

void draw(const GlTable& gl, GLenum mode, const Points& points, float x, float y) {
  gl.Begin(mode);
  for (std::size_t i = 0; i < points.size(); ++i) {
    gl.Color3fv(palette[i].data());
    gl.Vertex2f(x + points[i][0], y + points[i][1]);
  }
  gl.End();
}

void flat_filled(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 192, 128);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_TRIANGLES, zigzag, 0, 64);
  draw(gl, GL_TRIANGLE_STRIP, zigzag, 64, 64);
  draw(gl, GL_TRIANGLE_FAN, octagon, 128, 64);
  draw(gl, GL_QUADS, two_quads, 0, 0);
  draw(gl, GL_QUAD_STRIP, zigzag, 64, 0);
  draw(gl, GL_POLYGON, octagon, 128, 0);
}

void flat_lines_and_points(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 64);
  gl.ShadeModel(GL_FLAT);
  draw(gl, GL_POINTS, zigzag, 0, 0);
  draw(gl, GL_LINES, zigzag, 64, 0);
  draw(gl, GL_LINE_STRIP, zigzag, 128, 0);
  draw(gl, GL_LINE_LOOP, octagon, 192, 0);
}

void flat_lit(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(GL_FLAT);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.7f, 0.7f, 0.7f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.39f, 0.67f, 0.61f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.3f, 0.6f, 0.8f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.6f, 0.6f, 0.6f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 16);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
  draw_surface(gl, torus(0.95f, 0.38f, 20, 12));
}

// Each pipe's facets are flat on both sides; the provoking vertex is the same, its colour is the face's.
void flat_two_sided(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(GL_FLAT);
  black_lighting(gl, 1);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.9f, 0.9f, 0.9f, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.29f, 0.67f, 0.71f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.5f, 0.2f, 1});
  material(gl, GL_BACK, GL_DIFFUSE, {0.2f, 0.6f, 0.5f, 1});
  const Matrix view = look(gl, {.distance = 6.2f, .pitch_deg = 44, .yaw_deg = 14});
  const Surface pipe = half_pipe(0.9f, 2, 5, 12);
  load_model_view(gl, multiply(view, translation(-1.05f, 0.5f, 0)));
  draw_surface(gl, pipe);
  load_model_view(gl, multiply(view, multiply(translation(1.05f, -0.2f, 0), rotation(171, 2))));
  draw_surface(gl, pipe);
}

// What clipping cuts off may be the provoking vertex: its colour stays.
void flat_clipped(const GlTable& gl) {
  clear_background(gl);
  gl.ShadeModel(GL_FLAT);
  Random random(151);
  const auto star = [&](GLenum mode, float x, float y) {
    constexpr std::array<std::array<float, 2>, 7> rim = {{{0.73f, 0.11f},
                                                          {0.42f, 0.61f},
                                                          {-0.19f, 0.74f},
                                                          {-0.68f, 0.27f},
                                                          {-0.57f, -0.42f},
                                                          {-0.07f, -0.71f},
                                                          {0.51f, -0.53f}}};
    gl.Begin(mode);
    for (const auto& [px, py] : rim) {
      color_of(gl, random);
      gl.Vertex2f(x + px, y + py);
    }
    gl.End();
  };
  star(GL_POLYGON, -0.8f, -0.85f);
  star(GL_POLYGON, 0.83f, -0.77f);
  star(GL_TRIANGLE_FAN, -0.79f, 0.81f);
  star(GL_TRIANGLE_STRIP, 0.86f, 0.8f);
}

void flat_and_smooth_alternate(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(152);
  for (int i = 0; i < 64; ++i) {
    gl.ShadeModel((i + i / 8) % 2 == 0 ? GL_FLAT : GL_SMOOTH);
    const float x = static_cast<float>(32 * (i % 8)), y = static_cast<float>(32 * (i / 8));
    gl.Begin(GL_TRIANGLE_STRIP);
    for (const auto& [px, py] :
         std::array<std::array<float, 2>, 4>{{{2.3f, 2.7f}, {29.6f, 3.2f}, {3.1f, 28.8f}, {30.2f, 29.4f}}}) {
      color_of(gl, random);
      gl.Vertex2f(x + px, y + py);
    }
    gl.End();
  }
}

}  // namespace

SceneList shading_scenes() {
  constexpr auto clamping = "§2.14.6", flat = "§2.14.7";
  return {
      {.name = "color_clamping",
       .section = clamping,
       .shows =
           "Three ramps of out-of-range colours: clamped at their ends, straight between them; the lowest two alike.",
       .width_px = 256,
       .height_px = 192,
       .draw = color_clamping},
      {.name = "overbright_lights",
       .section = clamping,
       .shows = "A ring in glaring yellow and blue: lights above 1 and below 0, clamped at the vertices.",
       .draw = overbright_lights},
      {.name = "flat_filled",
       .section = flat,
       .shows =
           "Flat triangles, strip, fan; quads, quad strip, polygon: each piece in the colour of its provoking vertex.",
       .width_px = 192,
       .height_px = 128,
       .draw = flat_filled},
      {.name = "flat_lines_and_points",
       .section = flat,
       .shows = "Flat points, lines, strip and loop: each segment in the colour of its end.",
       .judge = Judge::lines_and_points,
       .width_px = 256,
       .height_px = 64,
       .draw = flat_lines_and_points},
      {.name = "flat_lit", .section = flat, .shows = "A faceted blue ring with highlights.", .draw = flat_lit},
      {.name = "flat_two_sided",
       .section = flat,
       .shows = "Faceted half pipes, orange inside and green outside.",
       .draw = flat_two_sided},
      {.name = "flat_clipped",
       .section = flat,
       .shows = "Flat polygons, a fan and a strip cut by the picture's corners, in whole colours.",
       .draw = flat_clipped},
      {.name = "flat_and_smooth_alternate",
       .section = flat,
       .shows = "A chessboard of flat and smooth squares.",
       .draw = flat_and_smooth_alternate},
  };
}

}  // namespace gouraud::conformance
