// Input that no program should give: it draws nothing, or as Mesa does, and never harms its neighbours. [GL1.5 §2.12]
// The specification leaves it undefined (§2.1.1); these scenes hold what programs are used to (MESA-RULES 2.4).
#include <array>
#include <limits>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A 4 x 4 grid of triangles; in every second one, vertex i % 3 has `bad` for its component i % 4.
void draw_grid(const GlTable& gl, GLenum mode, float bad, std::uint32_t seed) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  constexpr std::array<std::array<float, 2>, 3> corners = {{{5.3f, 7.1f}, {57.6f, 12.4f}, {31.2f, 56.9f}}};
  Random random(seed);
  for (int i = 0; i < 16; ++i) {
    gl.Begin(mode);
    for (int corner = 0; corner < 3; ++corner) {
      const auto& [x, y] = corners[static_cast<std::size_t>(corner)];
      std::array<float, 4> position = {x + static_cast<float>(64 * (i % 4)), y + static_cast<float>(64 * (i / 4)), 0,
                                       1};
      if ((i + i / 4) % 2 == 1 && corner == i % 3) position[static_cast<std::size_t>(i / 2 % 4)] = bad;
      color_of(gl, random);
      gl.Vertex4fv(position.data());
    }
    gl.End();
  }
}

void nan_positions(const GlTable& gl) {
  draw_grid(gl, GL_TRIANGLES, nan, 131);
}
void infinite_positions(const GlTable& gl) {
  draw_grid(gl, GL_TRIANGLES, infinity, 132);
}
void negative_infinite_positions(const GlTable& gl) {
  draw_grid(gl, GL_TRIANGLES, -infinity, 133);
}
void nan_line_positions(const GlTable& gl) {
  draw_grid(gl, GL_LINE_LOOP, nan, 134);
}
void infinite_point_positions(const GlTable& gl) {
  draw_grid(gl, GL_POINTS, infinity, 135);
}

// A strip and a fan in which one vertex of many is bad: the triangles that touch it vanish.
void nan_in_strip_and_fan(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(136);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 24; ++i) {
    color_of(gl, random);
    gl.Vertex2f(7.3f + 10.2f * static_cast<float>(i), i == 11 ? nan : i % 2 == 0 ? 11.6f : 117.2f);
  }
  gl.End();
  constexpr std::array<std::array<float, 2>, 8> rim = {{{247.2f, 191.3f},
                                                        {211.6f, 234.7f},
                                                        {128.4f, 248.1f},
                                                        {44.9f, 233.2f},
                                                        {8.7f, 191.6f},
                                                        {43.8f, 149.4f},
                                                        {127.3f, 131.8f},
                                                        {212.1f, 148.7f}}};
  gl.Begin(GL_TRIANGLE_FAN);
  gl.Color3f(0.8f, 0.8f, 0.8f);
  gl.Vertex2f(128.6f, 190.3f);
  for (std::size_t i = 0; i <= rim.size(); ++i) {
    color_of(gl, random);
    gl.Vertex2f(i == 3 ? infinity : rim[i % 8][0], rim[i % 8][1]);
  }
  gl.End();
}

// A model-view matrix of NaN draws nothing; the next matrix draws as ever.
void nan_matrix(const GlTable& gl) {
  clear_background(gl);
  const std::array<std::array<float, 2>, 3> corners = {{{-0.81f, -0.73f}, {0.77f, -0.62f}, {0.09f, 0.84f}}};
  Random random(137);
  for (const float bad : {nan, infinity, 0.0f}) {
    Matrix matrix = scaling(0.9f, 0.9f, 0.9f);
    matrix[13] = bad;
    load_model_view(gl, matrix);
    gl.Begin(GL_TRIANGLES);
    for (const auto& [x, y] : corners) {
      color_of(gl, random);
      gl.Vertex2f(x, y);
    }
    gl.End();
  }
}

// Coordinates whose products overflow; triangles that are farther out than the arithmetic reaches.
void overflowing_positions(const GlTable& gl) {
  clear_background(gl);
  Random random(138);
  for (const float far : {1e20f, 1e30f, 3e38f}) {
    load_model_view(gl, scaling(3, 3, 3));
    gl.Begin(GL_TRIANGLES);
    for (const auto& [x, y] :
         std::array<std::array<float, 2>, 3>{{{-far, -far}, {far, -0.7f * far}, {0.1f * far, far}}}) {
      color_of(gl, random);
      gl.Vertex2f(x, y);
    }
    gl.End();
  }
  load_model_view(gl, scaling(0.7f, 0.6f, 1));
  draw_rectangle(gl, -0.63f, -0.71f, 0.57f, 0.69f, 0);
}

// Colours of NaN and infinity: the clamp before rasterization makes them 0 and 1.
void bad_colors(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 64);
  const float bad[4] = {infinity, -infinity, 1e38f, nan};
  for (int i = 0; i < 4; ++i) {
    gl.Color3f(0.2f, bad[i], 0.8f);
    const float x = static_cast<float>(64 * i);
    draw_rectangle(gl, x + 5.2f, 6.3f, x + 58.7f, 57.1f, 0);
  }
}

// Normals of length 0, of infinite length and of NaN under GL_NORMALIZE: the scene's colour is all that is certain.
void bad_normals(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 64);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.4f, 0.8f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.6f, 0.6f, 0.2f, 1});
  material(gl, GL_FRONT, GL_EMISSION, {0.2f, 0, 0.2f, 1});
  gl.Enable(GL_NORMALIZE);
  const float lengths[4] = {1, 0, infinity, nan};
  for (int i = 0; i < 4; ++i) {
    gl.Normal3f(0, 0, lengths[i]);
    const float x = static_cast<float>(64 * i);
    draw_rectangle(gl, x + 5.2f, 6.3f, x + 58.7f, 57.1f, 0);
  }
}

}  // namespace

SceneList bad_input_scenes() {
  constexpr auto section = "§2.12";
  return {
      {.name = "nan_positions",
       .section = section,
       .shows = "Every second triangle of 16 has a NaN in one vertex, and is missing.",
       .draw = nan_positions},
      {.name = "infinite_positions",
       .section = section,
       .shows = "Every second triangle of 16 has an infinite coordinate, and is missing.",
       .draw = infinite_positions},
      {.name = "negative_infinite_positions",
       .section = section,
       .shows = "Every second triangle of 16 has a coordinate of minus infinity, and is missing.",
       .draw = negative_infinite_positions},
      {.name = "nan_line_positions",
       .section = section,
       .shows = "16 triangles of lines; of every second one only the edge without the NaN is left.",
       .judge = Judge::lines_and_points,
       .draw = nan_line_positions},
      {.name = "infinite_point_positions",
       .section = section,
       .shows = "40 points; eight more have an infinite coordinate and are missing.",
       .judge = Judge::lines_and_points,
       .draw = infinite_point_positions},
      {.name = "nan_in_strip_and_fan",
       .section = section,
       .shows = "A strip without its three triangles at a NaN, a fan without its two at an infinity.",
       .draw = nan_in_strip_and_fan},
      {.name = "nan_matrix",
       .section = section,
       .shows = "One triangle: those through matrices with a NaN and an infinity are missing.",
       .draw = nan_matrix},
      // Oracle only: what is left of a triangle whose clip coordinates overflow depends on the order of additions.
      {.name = "overflowing_positions",
       .section = section,
       .shows = "A plain rectangle over what 1e20, 1e30 and 3e38 leave of their triangles.",
       .judge = Judge::oracle_only,
       .draw = overflowing_positions},
      // Oracle only: the specification does not say what a NaN becomes.
      {.name = "bad_colors",
       .section = section,
       .shows = "Four rectangles whose green is infinite, minus infinite, 1e38 and NaN.",
       .judge = Judge::oracle_only,
       .width_px = 256,
       .height_px = 64,
       .draw = bad_colors},
      // Oracle only: likewise.
      {.name = "bad_normals",
       .section = section,
       .shows = "Four rectangles with normals of length 1, 0, infinity and NaN.",
       .judge = Judge::oracle_only,
       .width_px = 256,
       .height_px = 64,
       .draw = bad_normals},
  };
}

}  // namespace gouraud::conformance
