// Blending: every factor, every equation, over random colours and alphas of source and destination. [GL1.5 §4.1.8]
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/shapes.h"

namespace gouraud::conformance {
namespace {

constexpr GLenum factors[] = {GL_ZERO,
                              GL_ONE,
                              GL_SRC_COLOR,
                              GL_ONE_MINUS_SRC_COLOR,
                              GL_DST_COLOR,
                              GL_ONE_MINUS_DST_COLOR,
                              GL_SRC_ALPHA,
                              GL_ONE_MINUS_SRC_ALPHA,
                              GL_DST_ALPHA,
                              GL_ONE_MINUS_DST_ALPHA,
                              GL_CONSTANT_COLOR,
                              GL_ONE_MINUS_CONSTANT_COLOR,
                              GL_CONSTANT_ALPHA,
                              GL_ONE_MINUS_CONSTANT_ALPHA,
                              GL_SRC_ALPHA_SATURATE};
constexpr int factor_count = 15;

// Tiles of random colours and alphas, all whole multiples of 1/255: what blending makes of them hangs on no rounding of
// interpolated colours.
void random_tiles(const GlTable& gl, Random& random, float x, float y, int count, float size) {
  for (int i = 0; i < count * count; ++i) {
    const auto byte = [&random] { return static_cast<GLubyte>(random.below(256)); };
    const GLubyte color[4] = {byte(), byte(), byte(), byte()};
    gl.Color4ubv(color);
    const float left = x + size * static_cast<float>(i % count), bottom = y + size * static_cast<float>(i / count);
    draw_rectangle(gl, left, bottom, left + size, bottom + size, 0);
  }
}

// What is blended with.
void backdrop(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  Random random(3);
  random_tiles(gl, random, 0, 0, 64, 4);
}

void source_patch(const GlTable& gl, Random& random, float x, float y, float size) {
  random_tiles(gl, random, x, y, 5, size / 5);
}

// Each cell blends with its own pair of factors: sources upwards, destinations to the right.
void all_pairs(const GlTable& gl, GLenum equation) {
  backdrop(gl);
  gl.Enable(GL_BLEND);
  gl.BlendEquation(equation);
  gl.BlendColor(0.37f, 0.72f, 0.18f, 0.61f);
  Random random(17);
  for (int s = 0; s < factor_count; ++s) {
    for (int d = 0; d < factor_count - 1; ++d) {
      gl.BlendFunc(factors[s], factors[d]);
      source_patch(gl, random, 4.5f + 17 * static_cast<float>(d), 1.5f + 17 * static_cast<float>(s), 15);
    }
  }
}

// Colour and alpha by factors of their own.
void separate(const GlTable& gl) {
  backdrop(gl);
  gl.Enable(GL_BLEND);
  gl.BlendColor(0.37f, 0.72f, 0.18f, 0.61f);
  Random random(11);
  for (int cell = 0; cell < 225; ++cell) {
    const int chosen[4] = {random.below(factor_count), random.below(factor_count - 1), random.below(factor_count),
                           random.below(factor_count - 1)};
    gl.BlendFuncSeparate(factors[chosen[0]], factors[chosen[1]], factors[chosen[2]], factors[chosen[3]]);
    source_patch(gl, random, 1.5f + 17 * static_cast<float>(cell % 15), 1.5f + 17 * static_cast<float>(cell / 15), 15);
  }
}

// The 16 colour masks over blending, by rows with another equation.
void masked(const GlTable& gl) {
  constexpr GLenum equations[] = {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
  backdrop(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  Random random(23);
  for (int row = 0; row < 5; ++row) {
    gl.BlendEquation(equations[row]);
    for (int mask = 0; mask < 16; ++mask) {
      gl.ColorMask((mask & 1) != 0, (mask & 2) != 0, (mask & 4) != 0, (mask & 8) != 0);
      source_patch(gl, random, 1.5f + 16 * static_cast<float>(mask), 10.5f + 48 * static_cast<float>(row), 13);
    }
  }
}

GLubyte unorm8(float value) {
  return static_cast<GLubyte>(255.0f * value);
}

// Transparent surfaces behind each other, in perspective, tested against an opaque one.
void layers(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.ShadeModel(GL_FLAT);
  const Matrix view = look(gl, {.distance = 4.4f, .pitch_deg = 31});
  draw_surface(gl, torus(0.7f, 0.3f, 32, 20),
               [&](const Surface::Point& point) { gl.Color3ub(204, unorm8(0.3f + 0.5f * point.u), unorm8(point.v)); });
  gl.DepthMask(GL_FALSE);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  for (int i = 0; i < 7; ++i) {
    load_model_view(gl, multiply(view, translation(0, -0.9f + 0.3f * static_cast<float>(i), 0)));
    draw_surface(gl, floor_grid(2.2f, 6), [&](const Surface::Point& point) {
      gl.Color4ub(unorm8(0.2f + 0.6f * point.u), unorm8(0.9f - 0.6f * point.v), static_cast<GLubyte>(70 + 23 * i),
                  unorm8(0.15f + 0.5f * point.v));
    });
  }
}

// Sums beyond one and below zero are clamped after every layer.
void overflowing(const GlTable& gl) {
  backdrop(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  Random random(29);
  for (int i = 0; i < 6; ++i) {
    const float shift = 19.5f * static_cast<float>(i);
    gl.BlendEquation(i % 3 == 2 ? GL_FUNC_REVERSE_SUBTRACT : GL_FUNC_ADD);
    source_patch(gl, random, 5.5f + shift, 7.5f + 0.8f * shift, 140);
  }
}

}  // namespace

SceneList blending_scenes() {
  constexpr auto section = "§4.1.8";
  return {
      {.name = "blend_add",
       .section = section,
       .shows = "210 patches on random tiles, one for each pair of factors, added.",
       .draw = [](const GlTable& gl) { all_pairs(gl, GL_FUNC_ADD); }},
      {.name = "blend_subtract",
       .section = section,
       .shows = "The same patches, mostly dark: the weighted destination is taken from the weighted source.",
       .draw = [](const GlTable& gl) { all_pairs(gl, GL_FUNC_SUBTRACT); }},
      {.name = "blend_reverse_subtract",
       .section = section,
       .shows = "The same patches, the weighted source taken from the weighted destination.",
       .draw = [](const GlTable& gl) { all_pairs(gl, GL_FUNC_REVERSE_SUBTRACT); }},
      {.name = "blend_min",
       .section = section,
       .shows = "210 patches: the darker of both colours; factors have no effect.",
       .draw = [](const GlTable& gl) { all_pairs(gl, GL_MIN); }},
      {.name = "blend_max",
       .section = section,
       .shows = "210 patches: the lighter of both colours; factors have no effect.",
       .draw = [](const GlTable& gl) { all_pairs(gl, GL_MAX); }},
      {.name = "blend_separate",
       .section = section,
       .shows = "225 patches with random factors, other ones for alpha than for colour.",
       .draw = separate},
      {.name = "blend_masked",
       .section = section,
       .shows = "Five rows of small patches, one row an equation, one column a colour mask.",
       .draw = masked},
      {.name = "blend_layers",
       .section = section,
       .shows = "Seven transparent floors above each other; a ring is seen through those in front of it.",
       .draw = layers},
      {.name = "blend_overflow",
       .section = section,
       .shows = "Overlapping squares that add up to white, and two that take colour away again.",
       .draw = overflowing},
  };
}

}  // namespace gouraud::conformance
