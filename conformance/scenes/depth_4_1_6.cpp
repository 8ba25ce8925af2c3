// The depth test: functions, mask, other depths, passes over the same geometry. [GL1.5 §4.1.6]
#include <array>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr std::array<GLenum, 8> functions = {GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                             GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};

// Constant depths, exact in every driver: nearer, equal and farther stripes over a rectangle.
void depth_functions(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 128);
  gl.Enable(GL_DEPTH_TEST);
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const float x = 64 * static_cast<float>(i % 4), y = 64 * static_cast<float>(i / 4);
    gl.DepthFunc(GL_ALWAYS);
    gl.Color3f(0.4f, 0.4f, 0.4f);
    draw_rectangle(gl, x + 6.3f, y + 14.2f, x + 57.6f, y + 50.4f, 0);
    gl.DepthFunc(functions[i]);
    gl.Color3f(0.8f, 0.2f, 0.2f);
    draw_rectangle(gl, x + 10.2f, y + 4.3f, x + 22.7f, y + 59.6f, -0.5f);
    gl.Color3f(0.2f, 0.8f, 0.2f);
    draw_rectangle(gl, x + 26.1f, y + 4.3f, x + 38.3f, y + 59.6f, 0);
    gl.Color3f(0.2f, 0.2f, 0.8f);
    draw_rectangle(gl, x + 42.4f, y + 4.3f, x + 54.2f, y + 59.6f, 0.5f);
  }
}

/// Planes that cut through each other in several lines.
void draw_intersecting(const GlTable& gl) {
  const float planes[5][3] = {
      {0.2f, -0.7f, 0.05f}, {-0.6f, 0.3f, 0.1f}, {0.5f, 0.6f, -0.1f}, {-0.1f, -0.2f, 0.2f}, {0.85f, 0.1f, 0}};
  const float colors[5][3] = {
      {0.8f, 0.2f, 0.2f}, {0.2f, 0.8f, 0.2f}, {0.2f, 0.2f, 0.8f}, {0.8f, 0.8f, 0.2f}, {0.2f, 0.8f, 0.8f}};
  for (int i = 0; i < 5; ++i) {
    const float reach = 0.93f - 0.11f * static_cast<float>(i);
    gl.Color3fv(colors[i]);
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int corner = 0; corner < 4; ++corner) {
      const float x = corner % 2 == 0 ? -reach : reach, y = corner < 2 ? -0.97f * reach : 0.95f * reach;
      gl.Vertex3f(x, y, planes[i][0] * x + planes[i][1] * y + planes[i][2]);
    }
    gl.End();
  }
}

void intersecting_planes(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  draw_intersecting(gl);
}

void intersecting_planes_greater(const GlTable& gl) {
  clear_background(gl);
  gl.ClearDepth(0);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_GREATER);
  draw_intersecting(gl);
}

void interlocked_rings(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  const Matrix view = look(gl, {.distance = 5.6f, .pitch_deg = 33, .yaw_deg = 21});
  const Surface ring = torus(0.85f, 0.27f, 40, 20);
  for (int i = 0; i < 3; ++i) {
    const Matrix turned = multiply(rotation(67 * static_cast<float>(i), 0), rotation(31 * static_cast<float>(i), 2));
    load_model_view(
        gl, multiply(view, multiply(translation(0.75f * static_cast<float>(i - 1), 0.1f * static_cast<float>(i), 0),
                                    turned)));
    draw_surface(gl, ring, [&](const Surface::Point& point) {
      gl.Color3f(i == 0 ? 0.8f : 0.32f, 0.21f + 0.53f * point.v, i == 2 ? 0.8f : 0.37f * point.u);
    });
  }
}

// Without a depth test, and with a buffer of no bits, the last one drawn is seen.
void depth_test_off(const GlTable& gl) {
  clear_background(gl);
  draw_intersecting(gl);
}

// Lower planes pass, but leave the depth that was there: those after them are tested against it.
void depth_mask_off(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  pixel_space(gl, 256, 256);
  Random random(221);
  for (int i = 0; i < 24; ++i) {
    gl.DepthMask(i % 3 == 0 ? GL_TRUE : GL_FALSE);
    const float x = random.range(5, 150), y = random.range(5, 150), z = random.range(-0.9f, 0.9f);
    color_of(gl, random);
    const float width = random.range(30, 100), height = random.range(30, 100);
    draw_rectangle(gl, x, y, x + width, y + height, z);
  }
  gl.DepthMask(GL_FALSE);
  gl.ClearDepth(0);
  gl.Clear(GL_DEPTH_BUFFER_BIT);  // masked: the depths stay
  gl.Color3f(0.8f, 0.8f, 0.75f);
  draw_rectangle(gl, 100.3f, 3.1f, 130.7f, 252.4f, 0);
}

void begin_ring(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 38});
}

// A second pass over the same vertices in another colour passes everywhere under GL_LEQUAL, third ones elsewhere do
// not.
void lequal_redraw(const GlTable& gl) {
  begin_ring(gl);
  const Surface ring = torus(0.95f, 0.38f, 40, 20);
  gl.DepthFunc(GL_LEQUAL);
  gl.Color3f(0.8f, 0, 0);
  draw_surface(gl, ring);
  draw_surface(gl, ring, [&](const Surface::Point& point) { gl.Color3f(0.2f, 0.2f + 0.6f * point.u, 0.8f * point.v); });
}

void less_redraw(const GlTable& gl) {
  begin_ring(gl);
  const Surface ring = torus(0.95f, 0.38f, 40, 20);
  draw_surface(gl, ring, [&](const Surface::Point& point) { gl.Color3f(0.2f, 0.2f + 0.6f * point.u, 0.8f * point.v); });
  gl.Color3f(0.8f, 0, 0);
  draw_surface(gl, ring);
}

// First depth alone, then light where the depth is equal: each of three passes adds one colour channel.
void equal_multi_pass(const GlTable& gl) {
  begin_ring(gl);
  const Surface ring = torus(0.95f, 0.38f, 40, 20), ball = sphere(0.6f, 20, 40);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_surface(gl, ring);
  draw_surface(gl, ball);
  gl.DepthFunc(GL_EQUAL);
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  const float places[3][4] = {{0.83f, 0.31f, 0.47f, 0}, {-0.71f, 0.53f, 0.41f, 0}, {0.17f, -0.61f, 0.77f, 0}};
  for (int pass = 0; pass < 3; ++pass) {
    gl.ColorMask(pass == 0, pass == 1, pass == 2, GL_TRUE);
    gl.PushMatrix();
    gl.LoadIdentity();
    gl.Lightfv(GL_LIGHT0, GL_POSITION, places[pass]);
    gl.PopMatrix();
    draw_surface(gl, ring);
    draw_surface(gl, ball);
  }
}

// A smaller near plane by far: most depths crowd near 1.
void steep_depths(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 38, .near = 0.02f, .far = 5000});
  draw_surface(gl, torus(0.95f, 0.38f, 40, 20),
               [&](const Surface::Point& point) { gl.Color3f(0.8f * point.u, 0.68f, 0.8f * point.v); });
  draw_surface(gl, sphere(0.6f, 20, 40), [&](const Surface::Point& point) { gl.Color3f(0.8f, 0.6f * point.v, 0.2f); });
}

// Triangles a few pixels large that run through the whole depth range.
void small_steep_triangles(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  pixel_space(gl, 256, 256);
  Random random(222);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 3000; ++i) {
    const float x = random.range(4, 252), y = random.range(4, 252);
    color_of(gl, random);
    for (int corner = 0; corner < 3; ++corner) {
      const float vx = x + random.range(-4, 4), vy = y + random.range(-4, 4);
      gl.Vertex3f(vx, vy, random.range(-0.99f, 0.99f));
    }
  }
  gl.End();
}

}  // namespace

SceneList depth_scenes() {
  constexpr auto section = "§4.1.6";
  return {
      {.name = "depth_functions",
       .section = section,
       .shows = "A nearer red, an equal green and a farther blue stripe over grey, under all functions: never, less, "
                "equal, lequal; above, greater ... always.",
       .width_px = 256,
       .height_px = 128,
       .draw = depth_functions},
      {.name = "depth_intersecting",
       .section = section,
       .shows = "Five planes that cut each other in straight lines.",
       .draw = intersecting_planes},
      {.name = "depth_intersecting_greater",
       .section = section,
       .shows = "The same planes seen from behind: the farther ones win.",
       .draw = intersecting_planes_greater},
      {.name = "depth_interlocked", .section = section, .shows = "Three interlocked rings.", .draw = interlocked_rings},
      {.name = "depth_16_bits",
       .section = section,
       .shows = "The interlocked rings in a depth buffer of 16 bits.",
       .draw = interlocked_rings,
       .depth_bits = 16},
      {.name = "depth_0_bits",
       .section = section,
       .shows = "The rings without a depth buffer: in the order drawn.",
       .draw = interlocked_rings,
       .depth_bits = 0},
      {.name = "depth_test_off",
       .section = section,
       .shows = "Five planes over each other in the order drawn.",
       .draw = depth_test_off},
      {.name = "depth_mask",
       .section = section,
       .shows = "Rectangles of which only every third leaves its depth, and a pale bar that lies among them.",
       .draw = depth_mask_off},
      {.name = "depth_lequal_redraw",
       .section = section,
       .shows = "A green to blue ring; no red of the first pass is left.",
       .draw = lequal_redraw},
      {.name = "depth_less_redraw",
       .section = section,
       .shows = "The same ring; no red of the second pass gets through.",
       .draw = less_redraw},
      {.name = "depth_equal_multi_pass",
       .section = section,
       .shows = "A ring and a ball lit red from the right, green from the left, blue from below, in three passes under "
                "GL_EQUAL.",
       .draw = equal_multi_pass},
      {.name = "depth_steep_range",
       .section = section,
       .shows = "A ball in a ring in a frustum of 0.02 to 5000: the order holds, depths crowd at the far end.",
       .draw = steep_depths},
      {.name = "depth_small_steep_triangles",
       .section = section,
       .shows = "3,000 small triangles through the whole depth range.",
       .draw = small_steep_triangles},
      {.name = "depth_small_steep_16_bits",
       .section = section,
       .shows = "The same in 16 bits.",
       .draw = small_steep_triangles,
       .depth_bits = 16},
  };
}

}  // namespace gouraud::conformance
