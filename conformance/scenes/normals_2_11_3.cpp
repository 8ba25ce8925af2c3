// Normals through the inverse transpose, with GL_NORMALIZE, GL_RESCALE_NORMAL and neither. [GL1.5 §2.11.3]
#include <initializer_list>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

void prepare(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  black_lighting(gl, 1);
  light(gl, GL_LIGHT0, GL_DIFFUSE, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_SPECULAR, {1, 1, 1, 1});
  light(gl, GL_LIGHT0, GL_POSITION, {0.47f, 0.62f, 0.71f, 0});
  material(gl, GL_FRONT, GL_DIFFUSE, {0.55f, 0.4f, 0.2f, 1});
  material(gl, GL_FRONT, GL_SPECULAR, {0.3f, 0.3f, 0.35f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 20);
}

enum class Normals { as_given, rescaled, normalized };

void set(const GlTable& gl, Normals normals) {
  (normals == Normals::rescaled ? gl.Enable : gl.Disable)(GL_RESCALE_NORMAL);
  (normals == Normals::normalized ? gl.Enable : gl.Disable)(GL_NORMALIZE);
}

/// A row of rings; the size that is seen stays equal: the mesh has the inverse of `factor`.
void draw_row(const GlTable& gl, std::initializer_list<float> factors) {
  const Matrix view = look(gl, {.distance = 6, .pitch_deg = 0, .yaw_deg = 0, .aspect = 3, .fov_y_deg = 26});
  float x = -2.75f;
  for (const float factor : factors) {
    const Matrix place = multiply(translation(x, 0, 0), multiply(rotation(57, 0), scaling(factor, factor, factor)));
    load_model_view(gl, multiply(view, place));
    draw_surface(gl, torus(0.62f / factor, 0.28f / factor, 36, 18));
    x += 1.83f;
  }
}

template <Normals normals>
void uniform_scale(const GlTable& gl) {
  prepare(gl);
  set(gl, normals);
  draw_row(gl, {0.625f, 0.9f, 1.0f, 1.7f});
}

void draw_stretched(const GlTable& gl, Normals normals) {
  prepare(gl);
  set(gl, normals);
  const Matrix view = look(gl, {.distance = 5.2f, .pitch_deg = 15, .yaw_deg = 20});
  load_model_view(gl, multiply(view, scaling(0.7f, 1.7f, 1.15f)));
  draw_surface(gl, sphere(0.9f, 24, 48));
}

void stretched_as_given(const GlTable& gl) {
  draw_stretched(gl, Normals::as_given);
}
void stretched_normalized(const GlTable& gl) {
  draw_stretched(gl, Normals::normalized);
}

// Every stretch with the z axis last leaves another factor: it is the length of the inverse's third row (eq of
// §2.11.3).
void stretched_rescaled(const GlTable& gl) {
  draw_stretched(gl, Normals::rescaled);
}

void sheared_normalized(const GlTable& gl) {
  prepare(gl);
  set(gl, Normals::normalized);
  const Matrix view = look(gl, {.distance = 5.2f, .pitch_deg = 15, .yaw_deg = 20});
  load_model_view(gl, multiply(view, Matrix{1, 0.35f, 0, 0, 0.8f, 1, -0.3f, 0, 0, 0.2f, 1, 0, 0, 0, 0, 1}));
  draw_surface(gl, sphere(0.9f, 24, 48));
}

// Lengths from 0.2 to 5, another for each vertex.
void draw_uneven_lengths(const GlTable& gl, Normals normals) {
  prepare(gl);
  set(gl, normals);
  look(gl, {.distance = 4});
  Random random(111);
  const Surface ball = sphere(1, 16, 32);
  for (int row = 0; row + 1 < ball.rows; ++row) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int column = 0; column < ball.columns; ++column) {
      for (const int r : {row + 1, row}) {
        const Surface::Point& point = ball.at(r, column);
        const float length = column % 8 < 2 ? random.range(2, 5) : random.range(0.2f, 1);
        gl.Normal3f(length * point.normal[0], length * point.normal[1], length * point.normal[2]);
        gl.Vertex3fv(point.position.data());
      }
    }
    gl.End();
  }
}

void uneven_lengths_normalized(const GlTable& gl) {
  draw_uneven_lengths(gl, Normals::normalized);
}
void uneven_lengths_as_given(const GlTable& gl) {
  draw_uneven_lengths(gl, Normals::as_given);
}

// Normals point along the scaled axes only: what is left of a box when its sides are stretched.
void boxes_stretched(const GlTable& gl) {
  prepare(gl);
  set(gl, Normals::normalized);
  const Matrix view = look(gl, {.distance = 7, .pitch_deg = 32, .yaw_deg = 40});
  const float sizes[5][3] = {{1, 1, 1}, {0.3f, 2.1f, 0.4f}, {1.6f, 0.3f, 0.5f}, {0.2f, 0.2f, 2.2f}, {0.7f, 0.4f, 0.9f}};
  float x = -1.7f;
  for (const auto& size : sizes) {
    const Matrix place = multiply(translation(x, 0, 0.3f * x), scaling(size[0] * 0.7f, size[1], size[2]));
    load_model_view(gl, multiply(view, place));
    draw_box(gl, 1, 1, 1);
    x += 0.9f;
  }
}

// The current normal is used as it stands, by many vertices and by the next Begin.
void current_normal_persists(const GlTable& gl) {
  prepare(gl);
  pixel_space(gl, 256, 128);
  load_model_view(gl, translation(0, 0, 0));
  const float normals[4][3] = {{0, 0, 1}, {0.6f, 0, 0.8f}, {-0.36f, 0.48f, 0.8f}, {0.28f, -0.96f, 0}};
  gl.Normal3fv(normals[3]);
  for (int i = 0; i < 4; ++i) {
    const float x = static_cast<float>(64 * i);
    gl.Begin(GL_TRIANGLE_STRIP);
    gl.Vertex2f(x + 4.3f, 8.1f);
    gl.Vertex2f(x + 57.2f, 11.4f);
    gl.Normal3fv(normals[i]);
    gl.Vertex2f(x + 6.7f, 117.3f);
    gl.Vertex2f(x + 59.8f, 113.6f);
    gl.End();
  }
}

}  // namespace

SceneList normal_scenes() {
  constexpr auto section = "§2.11.3";
  return {
      {.name = "scaled_as_given",
       .section = section,
       .shows = "Four equal rings under scales 0.625, 0.9, 1 and 1.7 without GL_NORMALIZE: from overbright to dim.",
       .width_px = 480,
       .height_px = 160,
       .draw = uniform_scale<Normals::as_given>},
      {.name = "scaled_rescaled",
       .section = section,
       .shows = "The four rings under GL_RESCALE_NORMAL: all alike.",
       .width_px = 480,
       .height_px = 160,
       .draw = uniform_scale<Normals::rescaled>},
      {.name = "scaled_normalized",
       .section = section,
       .shows = "The four rings under GL_NORMALIZE: all alike.",
       .width_px = 480,
       .height_px = 160,
       .draw = uniform_scale<Normals::normalized>},
      {.name = "stretched_as_given",
       .section = section,
       .shows = "A sphere stretched to an egg; normals of false lengths leave it without a highlight.",
       .draw = stretched_as_given},
      {.name = "stretched_rescaled",
       .section = section,
       .shows = "The egg under GL_RESCALE_NORMAL: all lengths scaled by one factor, still false.",
       .draw = stretched_rescaled},
      {.name = "stretched_normalized",
       .section = section,
       .shows = "The egg under GL_NORMALIZE: lit as an egg should be.",
       .draw = stretched_normalized},
      {.name = "sheared_normalized",
       .section = section,
       .shows = "A sheared sphere under GL_NORMALIZE: the highlight sits where the sheared surface faces it.",
       .draw = sheared_normalized},
      {.name = "uneven_lengths_normalized",
       .section = section,
       .shows = "A sphere with normals of random lengths, normalised: a plain sphere.",
       .draw = uneven_lengths_normalized},
      {.name = "uneven_lengths_as_given",
       .section = section,
       .shows = "The same normals as they are: bright and dark patches.",
       .draw = uneven_lengths_as_given},
      {.name = "boxes_stretched",
       .section = section,
       .shows = "Five boxes of other proportions, their like faces lit alike.",
       .draw = boxes_stretched},
      {.name = "current_normal_persists",
       .section = section,
       .shows = "Four rectangles; the lower vertices of each have the normal that the one before ended with.",
       .width_px = 256,
       .height_px = 128,
       .draw = current_normal_persists},
  };
}

}  // namespace gouraud::conformance
