// Clipping against the six planes of the view volume, in clip coordinates. [GL1.5 §2.12]
// No clipped quads here: Mesa's choice of their diagonal depends on clipping (MESA-RULES 2.5).
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

struct Vertex {
  float x, y, z, w;
  std::array<float, 3> color;
};

void draw_triangle(const GlTable& gl, const std::array<Vertex, 3>& vertices) {
  gl.Begin(GL_TRIANGLES);
  for (const Vertex& vertex : vertices) {
    gl.Color3fv(vertex.color.data());
    gl.Vertex4f(vertex.x, vertex.y, vertex.z, vertex.w);
  }
  gl.End();
}

constexpr std::array<float, 3> red = {0.8f, 0.2f, 0.2f}, green = {0.2f, 0.8f, 0.2f}, blue = {0.2f, 0.2f, 0.8f};
constexpr std::array<float, 3> yellow = {0.8f, 0.8f, 0.2f}, cyan = {0.2f, 0.8f, 0.8f}, white = {0.8f, 0.8f, 0.8f};

void each_plane(const GlTable& gl) {
  clear_background(gl);
  const std::array<std::array<Vertex, 3>, 6> triangles = {{
      {{{0.53f, -0.31f, 0, 1, red}, {1.47f, 0.07f, 0, 1, green}, {0.61f, 0.42f, 0, 1, blue}}},
      {{{-0.53f, -0.31f, 0, 1, green}, {-0.61f, 0.42f, 0, 1, red}, {-1.47f, 0.07f, 0, 1, yellow}}},
      {{{-0.33f, 0.57f, 0, 1, yellow}, {0.29f, 0.63f, 0, 1, blue}, {0.04f, 1.39f, 0, 1, red}}},
      {{{-0.33f, -0.57f, 0, 1, cyan}, {0.04f, -1.39f, 0, 1, white}, {0.29f, -0.63f, 0, 1, red}}},
      {{{-0.43f, -0.42f, -0.4f, 1, red}, {0.02f, -0.37f, -0.2f, 1, green}, {-0.13f, 0.47f, -2.1f, 1, blue}}},
      {{{0.03f, -0.41f, 0.3f, 1, yellow}, {0.44f, -0.39f, 2.7f, 1, cyan}, {0.17f, 0.46f, 0.4f, 1, red}}},
  }};
  for (const auto& triangle : triangles) draw_triangle(gl, triangle);
}

void random_beyond_all_planes(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  Random random(121);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3 * 60; ++i) {
    color_of(gl, random);
    const float x = random.range(-3, 3), y = random.range(-3, 3);
    gl.Vertex3f(x, y, random.range(-2, 2));
  }
  gl.End();
}

// Checks of a floor that runs from behind the eye to the horizon.
void near_plane_floor(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 0, .pitch_deg = 17, .yaw_deg = 21, .fov_y_deg = 70, .near = 0.5f, .far = 60});
  const Surface ground = floor_grid(90, 30);
  Random random(122);
  gl.Translatef(0, -1.1f, 0);
  draw_checks(gl, ground, random);
}

// Two triangles whose vertices lie behind the eye, beside it and before it.
void one_big_floor_triangle(const GlTable& gl) {
  clear_background(gl);
  load_projection(gl, perspective(60, 1, 0.25f, 400));
  draw_triangle(gl,
                {{{-37.3f, -1.2f, 21.7f, 1, red}, {33.9f, -1.4f, 17.1f, 1, green}, {3.7f, -0.9f, -93.8f, 1, blue}}});
  draw_triangle(gl, {{{-41.1f, 2.2f, 3.9f, 1, white}, {2.8f, 2.7f, -71.3f, 1, cyan}, {39.4f, 3.1f, 6.2f, 1, yellow}}});
}

void inside_a_tunnel(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_POSITION, {0.43f, 0.51f, -1.6f, 1});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {0.6f, 0.6f, 0.6f, 1});
  gl.Lightf(GL_LIGHT0, GL_QUADRATIC_ATTENUATION, 0.03f);
  material(gl, GL_FRONT_AND_BACK, GL_DIFFUSE, {0.8f, 0.55f, 0.3f, 1});
  material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0.5f, 0.5f, 0.5f, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 12);
  const float two_sided = 1;
  gl.LightModelfv(GL_LIGHT_MODEL_TWO_SIDE, &two_sided);
  load_projection(gl, perspective(85, 1, 0.7f, 20));
  const Matrix turned = multiply(rotation(7, 0), rotation(71, 1));
  load_model_view(gl, multiply(turned, translation(0.1f, -0.2f, -5.3f)));
  draw_surface(gl, torus(5, 1.6f, 80, 24));
}

// The visible part of each lies where w > 0 (and |x|, |y|, |z| <= w).
void w_zero_and_negative(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_triangle(gl,
                {{{-0.91f, -0.83f, 0.1f, 1, red}, {-0.12f, -0.87f, 0.1f, 1, green}, {-0.21f, 0.9f, 0.05f, 0, blue}}});
  draw_triangle(gl,
                {{{0.11f, -0.93f, 0.2f, 1, yellow}, {0.92f, -0.71f, 0.2f, 1, cyan}, {0.37f, -0.63f, 0.1f, -1, white}}});
  draw_triangle(gl, {{{0.57f, 0.27f, 0.3f, 1, white}, {-1.8f, -0.2f, -0.2f, -2, red}, {-0.7f, 0.2f, 0.1f, -1, blue}}});
  // Behind the eye altogether, and all at infinity: nothing.
  draw_triangle(gl, {{{-0.2f, -0.2f, 0, -1, white}, {0.3f, -0.1f, 0, -1, white}, {0.1f, 0.4f, 0, -3, white}}});
  draw_triangle(gl, {{{-0.2f, -0.2f, 0, 0, white}, {0.3f, -0.1f, 0, 0, white}, {0.1f, 0.4f, 0, 0, white}}});
}

void random_w(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  Random random(123);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3 * 50; ++i) {
    color_of(gl, random);
    const float x = random.range(-1.5f, 1.5f), y = random.range(-1.5f, 1.5f), z = random.range(-1, 1);
    gl.Vertex4f(x, y, z, random.range(-1, 2.5f));
  }
  gl.End();
}

// Fans of triangles with corners ever farther away: 10 to 10^12.
void huge_coordinates(const GlTable& gl) {
  clear_background(gl);
  const float reach[6] = {1e1f, 1e2f, 1e4f, 1e6f, 1e9f, 1e12f};
  for (int i = 0; i < 6; ++i) {
    const float far = reach[i], x = -0.85f + 0.31f * static_cast<float>(i);
    draw_triangle(gl, {{{x, -0.77f, 0, 1, red}, {x + 0.23f, -0.69f, 0.1f, 1, green}, {0.07f * far, far, 0, 1, blue}}});
    draw_triangle(gl, {{{x, -0.81f, 0, 1, white}, {-0.2f * far, -far, 0, 1, cyan}, {x + 0.21f, -0.83f, 0, 1, yellow}}});
  }
}

// The view volume lies wholly inside these triangles.
void covering_triangles(const GlTable& gl) {
  clear_background(gl);
  draw_triangle(gl, {{{-7.3f, -5.1f, 0, 1, red}, {9.2f, -3.7f, 0, 1, green}, {-0.4f, 11.9f, 0, 1, blue}}});
  gl.Viewport(64, 64, 131, 127);
  draw_triangle(gl, {{{-71, -51, 0.3f, 1, white}, {84, -63, -0.2f, 1, blue}, {13, 117, 0.4f, 1, yellow}}});
}

void far_plane_hills(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 5, .pitch_deg = 21, .yaw_deg = 27, .near = 3.9f, .far = 6.3f});
  Random random(124);
  const Surface ground = floor_grid(5, 24);
  std::array<float, 25 * 25> heights{};
  for (float& height : heights) height = random.range(-0.25f, 0.25f);
  for (int row = 0; row < 24; ++row) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int column = 0; column <= 24; ++column) {
      for (const int r : {row + 1, row}) {
        const Surface::Point& point = ground.at(r, column);
        const float height = heights[static_cast<std::size_t>(25 * r + column)];
        gl.Color3f(0.4f + 1.5f * height, 0.7f * point.u, 0.7f * point.v);
        gl.Vertex3f(point.position[0], height, point.position[2]);
      }
    }
    gl.End();
  }
}

void clipped_lines(const GlTable& gl) {
  clear_background(gl);
  look(gl, {.distance = 0.3f, .pitch_deg = 13, .yaw_deg = 24, .fov_y_deg = 65, .near = 0.35f, .far = 9});
  Random random(125);
  gl.Begin(GL_LINES);
  for (int i = 0; i < 180; ++i) {
    for (int end = 0; end < 2; ++end) {
      color_of(gl, random);
      const float x = random.range(-5, 5), y = random.range(-4, 4);
      gl.Vertex3f(x, y, random.range(-12, 3));
    }
  }
  gl.End();
}

// Points are drawn if their centre lies in the volume, else not.
void clipped_points(const GlTable& gl) {
  clear_background(gl);
  Random random(126);
  gl.Viewport(32, 48, 192, 160);
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 12'000; ++i) {
    color_of(gl, random);
    const float x = random.range(-1.4f, 1.4f), y = random.range(-1.4f, 1.4f);
    gl.Vertex3f(x, y, random.range(-1.4f, 1.4f));
  }
  gl.End();
}

}  // namespace

SceneList clipping_scenes() {
  constexpr auto section = "§2.12";
  return {
      {.name = "each_plane",
       .section = section,
       .shows = "Six triangles, each cut by one plane: right, left, top, bottom; in the middle by near (left) and far "
                "(right).",
       .draw = each_plane},
      {.name = "random_beyond_all_planes",
       .section = section,
       .shows = "60 random triangles that reach three times as far as the volume, in all directions.",
       .draw = random_beyond_all_planes},
      {.name = "near_plane_floor",
       .section = section,
       .shows = "A checked floor from behind the eye to the horizon, its nearest checks cut by the near plane.",
       .draw = near_plane_floor},
      {.name = "one_big_floor_triangle",
       .section = section,
       .shows = "A floor and a ceiling of one triangle each, with vertices behind the eye.",
       .draw = one_big_floor_triangle},
      {.name = "inside_a_tunnel",
       .section = section,
       .shows = "From within a lit ring-shaped tunnel: walls all round, cut by the near plane and by all sides.",
       .draw = inside_a_tunnel},
      {.name = "w_zero_and_negative",
       .section = section,
       .shows = "Triangles with one vertex at w = 0, at w = -1, and with two at negative w: stripes that run off the "
                "picture.",
       .draw = w_zero_and_negative},
      {.name = "random_w",
       .section = section,
       .shows = "50 random triangles in clip space with w between -1 and 2.5.",
       .draw = random_w},
      {.name = "huge_coordinates",
       .section = section,
       .shows = "Six rays up and six down, of triangles whose tips lie 10 to 10^12 units away.",
       .draw = huge_coordinates},
      {.name = "covering_triangles",
       .section = section,
       .shows = "One triangle fills the picture, another a viewport in its middle, edge to edge.",
       .draw = covering_triangles},
      {.name = "far_plane_hills",
       .section = section,
       .shows = "Hills cut by the near plane at the bottom and by the far plane at the back.",
       .draw = far_plane_hills},
      {.name = "clipped_lines",
       .section = section,
       .shows = "180 lines through a frustum, many with ends outside or behind the eye.",
       .judge = Judge::lines_and_points,
       .draw = clipped_lines},
      {.name = "clipped_points",
       .section = section,
       .shows = "A rectangle of random points, none outside the viewport in the middle.",
       .judge = Judge::lines_and_points,
       .draw = clipped_points},
  };
}

}  // namespace gouraud::conformance
