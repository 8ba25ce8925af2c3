// The viewport and the depth range: partly outside the target, many in one picture, targets that are not square.
// [GL1.5 §2.11.1]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

/// A star of smooth triangles that reaches beyond [-1, 1].
void draw_star(const GlTable& gl, std::uint32_t seed, float reach) {
  static constexpr float rim[8][2] = {{0.97f, 0.13f},   {0.51f, 0.83f},   {-0.22f, 0.98f}, {-0.78f, 0.54f},
                                      {-0.96f, -0.31f}, {-0.43f, -0.91f}, {0.27f, -0.93f}, {0.81f, -0.56f}};
  Random random(seed);
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 8; ++i) {
    const auto& from = rim[i];
    const auto& to = rim[(i + 3) % 8];
    color_of(gl, random);
    gl.Vertex2f(0.03f, -0.02f);
    color_of(gl, random);
    gl.Vertex2f(reach * from[0], reach * from[1]);
    color_of(gl, random);
    gl.Vertex2f(reach * to[0], reach * to[1]);
  }
  gl.End();
}

void viewport_partly_outside(const GlTable& gl) {
  clear_background(gl);
  gl.Viewport(-90, -70, 220, 200);
  draw_star(gl, 61, 0.9f);
  gl.Viewport(170, 150, 190, 170);
  draw_star(gl, 62, 1.3f);
  gl.Viewport(-40, 160, 130, 60);
  draw_star(gl, 63, 1.3f);
  gl.Viewport(150, -300, 90, 420);
  draw_star(gl, 64, 0.95f);
}

void viewport_larger_than_target(const GlTable& gl) {
  clear_background(gl);
  gl.Viewport(-211, -173, 701, 613);
  draw_star(gl, 65, 0.95f);
}

void viewport_grid(const GlTable& gl) {
  clear_background(gl);
  const int lefts[6] = {0, 31, 98, 203, 220, 377}, bottoms[5] = {0, 77, 90, 191, 333};
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 5; ++column) {
      gl.Viewport(lefts[column], bottoms[row], lefts[column + 1] - lefts[column], bottoms[row + 1] - bottoms[row]);
      draw_star(gl, static_cast<std::uint32_t>(70 + 5 * row + column), column % 2 == 0 ? 0.95f : 1.4f);
    }
  }
}

void light_key(const GlTable& gl) {
  light(gl, GL_LIGHT0, GL_POSITION, {0.41f, 0.73f, 0.55f, 0});
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_DEPTH_TEST);
}

void wide_1000x200(const GlTable& gl) {
  clear_background(gl);
  light_key(gl);
  const Matrix view = look(gl, {.distance = 6, .pitch_deg = 12, .yaw_deg = 4, .aspect = 5, .fov_y_deg = 34});
  const Surface ring = torus(0.9f, 0.36f, 36, 18);
  for (int i = -4; i <= 4; ++i) {
    const float at = static_cast<float>(i);
    const Matrix place = multiply(translation(2.05f * at, 0, -0.1f * at), rotation(23 * at + 61, 0));
    load_model_view(gl, multiply(view, place));
    material(gl, GL_FRONT, GL_DIFFUSE, {0.55f + 0.1f * at, 0.6f, 0.55f - 0.1f * at, 1});
    draw_surface(gl, ring);
  }
}

void tiny_64x48(const GlTable& gl) {
  clear_background(gl);
  light_key(gl);
  look(gl, {.distance = 4, .pitch_deg = 38, .aspect = 4.0f / 3});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.6f, 0.2f, 1});
  draw_surface(gl, torus(0.95f, 0.4f, 48, 24));
}

// A target of one row and one of one column have viewports too.
void one_row(const GlTable& gl) {
  clear_background(gl);
  draw_star(gl, 91, 1.5f);
}

void depth_range_halves(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  look(gl, {.distance = 4.2f, .pitch_deg = 34});
  const Surface ring = torus(0.95f, 0.4f, 40, 20);
  const auto colored = [&](float red, float blue) {
    draw_surface(gl, ring, [&](const Surface::Point& point) { gl.Color3f(red, 0.2f + 0.6f * point.v, blue); });
  };
  load_model_view(gl, multiply(translation(-0.35f, 0.2f, -4.2f), rotation(63, 0)));
  gl.DepthRange(0.45, 0.9);  // the first ring lies behind, whatever its z
  colored(0.8f, 0.2f);
  load_model_view(gl, multiply(translation(0.35f, -0.2f, -4.6f), rotation(117, 0)));
  gl.DepthRange(0.1, 0.4);
  colored(0.2f, 0.8f);
}

void depth_range_reversed(const GlTable& gl) {
  clear_background(gl);
  gl.ClearDepth(0);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthRange(1, 0);
  gl.DepthFunc(GL_GREATER);
  light_key(gl);
  look(gl, {.distance = 4.2f, .pitch_deg = 40});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.2f, 0.75f, 0.6f, 1});
  draw_surface(gl, torus(0.95f, 0.4f, 40, 20));
  material(gl, GL_FRONT, GL_DIFFUSE, {0.8f, 0.4f, 0.2f, 1});
  draw_surface(gl, sphere(0.7f, 20, 40));
}

// Values beyond [0, 1] are clamped when they are specified.
void depth_range_clamped(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_ALWAYS);
  pixel_space(gl, 256, 128);
  const double ranges[4][2] = {{-0.5, 0.7}, {0.3, 1.8}, {-3, 4}, {0.62, 0.62}};
  for (int i = 0; i < 4; ++i) {
    const float x = static_cast<float>(64 * i);
    gl.DepthRange(ranges[i][0], ranges[i][1]);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(0.8f, 0.2f, 0.2f * static_cast<float>(i));
    gl.Vertex3f(x + 5.3f, 9.2f, -0.97f);
    gl.Color3f(0.2f, 0.8f, 0.2f * static_cast<float>(i));
    gl.Vertex3f(x + 59.6f, 23.7f, 0.13f);
    gl.Color3f(0.8f, 0.8f, 0.2f * static_cast<float>(i));
    gl.Vertex3f(x + 28.1f, 118.4f, 0.94f);
    gl.End();
  }
}

}  // namespace

SceneList viewport_scenes() {
  constexpr auto section = "§2.11.1";
  return {
      {.name = "viewport_partly_outside",
       .section = section,
       .shows =
           "Four viewports that hang over the target's edges, each with a star of triangles cut off at the viewport.",
       .draw = viewport_partly_outside},
      {.name = "viewport_larger_than_target",
       .section = section,
       .shows = "The middle of a star in a viewport of 701 x 613 pixels around a target of 256 x 256.",
       .draw = viewport_larger_than_target},
      {.name = "viewport_grid",
       .section = section,
       .shows =
           "20 viewports of unequal sizes tile the target; in every second column the stars fill theirs to the edge.",
       .width_px = 377,
       .height_px = 333,
       .draw = viewport_grid},
      {.name = "wide_1000x200",
       .section = section,
       .shows = "Nine lit rings in a row, turned ever further, wider at the ends of the wide perspective.",
       .width_px = 1000,
       .height_px = 200,
       .draw = wide_1000x200},
      {.name = "tiny_64x48",
       .section = section,
       .shows = "A golden lit ring in a picture of 64 x 48 pixels: triangles smaller than pixels.",
       .width_px = 64,
       .height_px = 48,
       .draw = tiny_64x48},
      {.name = "one_row",
       .section = section,
       .shows = "A star of triangles seen through a target one pixel high.",
       .width_px = 301,
       .height_px = 1,
       .draw = one_row},
      {.name = "one_column",
       .section = section,
       .shows = "A star of triangles seen through a target one pixel wide.",
       .width_px = 1,
       .height_px = 203,
       .draw = one_row},
      {.name = "depth_range_halves",
       .section = section,
       .shows = "A blue ring wholly over a red one that stands nearer: each has its own half of the depth range.",
       .draw = depth_range_halves},
      {.name = "depth_range_reversed",
       .section = section,
       .shows = "An orange ball in a green ring, depth running from 1 to 0 under GL_GREATER.",
       .draw = depth_range_reversed},
      {.name = "depth_range_clamped",
       .section = section,
       .shows = "Four triangles whose depth ranges are clamped to [0, 0.7], [0.3, 1], [0, 1] and 0.62 alone.",
       .width_px = 256,
       .height_px = 128,
       .draw = depth_range_clamped},
  };
}

}  // namespace gouraud::conformance
