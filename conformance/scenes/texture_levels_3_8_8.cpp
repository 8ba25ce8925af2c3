// Levels of detail of all targets [GL1.5 §3.8.8]: cube maps by the derivatives of the coordinates on the face that a fragment
// hits, up to the face's edge; volumes and lines of texels; rectangles, which have one level and two filters.
//
// The oracle judges: Mesa takes levels from differences over 2x2 pixels, some of them on another face.
#include <algorithm>

#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

void begin(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
}

enum class Texels { noise, one_color_a_level };

/// Six faces with all their levels.
template <Texels texels>
void cube_levels(const GlTable& gl, int size) {
  for (GLenum face = 0; face < 6; ++face) {
    const GLenum target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + face;
    if (texels == Texels::one_color_a_level) {
      colored_levels(gl, target, size);
      continue;
    }
    int level = 0;
    for (int side = size; side > 0; side /= 2, ++level) noise_image(gl, target, level, GL_RGBA, side, side, GL_RGBA, 90 + face + 6 * static_cast<std::uint32_t>(level));
  }
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  wraps(gl, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
}

void generate(const GlTable& gl, GLint mode) {
  for (const GLenum coordinate : {GL_S, GL_T, GL_R}) {
    gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, mode);
    gl.Enable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
  }
}

// A ball and a box that mirror what is around them.
template <GLint minify, bool seamless, Texels texels>
void reflections(const GlTable& gl) {
  begin(gl);
  cube_levels<texels>(gl, seamless ? 61 : 64);  // 61, 30, 15, 7, 3, 1
  filters(gl, GL_TEXTURE_CUBE_MAP, minify, GL_LINEAR);
  if (seamless) gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  generate(gl, GL_REFLECTION_MAP);
  look(gl, {.distance = 4, .pitch_deg = 25});
  draw_surface(gl, sphere(0.9f, 20, 28));
  gl.Translatef(-0.9f, -0.2f, 1.1f);
  gl.Rotatef(21, 0.2f, 1, 0.3f);
  draw_box(gl, 0.9f, 0.7f, 0.5f);
}

// The cube's faces as the coordinates have them: a room seen from its middle, and a small box from outside.
template <GLint minify, bool seamless>
void positions(const GlTable& gl) {
  begin(gl);
  gl.Disable(GL_CULL_FACE);
  cube_levels<Texels::noise>(gl, 32);
  filters(gl, GL_TEXTURE_CUBE_MAP, minify, GL_NEAREST);
  gl.TexParameterf(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_LOD_BIAS, 0.6f);
  if (seamless) gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  generate(gl, GL_OBJECT_LINEAR);
  gl.TexGenfv(GL_R, GL_OBJECT_PLANE, Four{0, 0, 1, 0}.data());
  look(gl, {.distance = 6, .pitch_deg = 35, .yaw_deg = 40});
  draw_box(gl, 1.6f, 1.6f, 1.6f);
  gl.Translatef(1.9f, -1.2f, 0);
  draw_box(gl, 0.4f, 0.4f, 0.4f);
  gl.Translatef(-3.4f, 2.2f, 0);
  draw_surface(gl, sphere(0.8f, 16, 20));
}

// A slope through a volume that recedes, its sides of different lengths.
template <GLint minify>
void volume(const GlTable& gl) {
  begin(gl);
  gl.Disable(GL_CULL_FACE);
  for (int level = 0; level < 6; ++level) {
    const auto side = [level](int size) { return std::max(size >> level, 1); };
    const int width = side(32), height = side(16), depth = side(8);
    const auto texels = noise(4 * width * height * depth, 130 + static_cast<std::uint32_t>(level));
    gl.TexImage3D(GL_TEXTURE_3D, level, GL_RGBA, width, height, depth, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
  filters(gl, GL_TEXTURE_3D, minify, GL_LINEAR);
  gl.Enable(GL_TEXTURE_3D);
  look(gl, {.distance = 2.4f, .pitch_deg = 24});
  draw_surface(gl, floor_grid(3, 2), [&](const Surface::Point& p) { gl.TexCoord4f(4 * p.u, 5 * p.v, 9 * p.u * p.v, 1 + 0.3f * p.v); });
}

// A strip of texels over a floor that recedes.
template <GLint minify>
void line_of_texels(const GlTable& gl) {
  begin(gl);
  gl.Disable(GL_CULL_FACE);
  for (int size = 64, level = 0; size > 0; size /= 2, ++level) {
    const auto texels = noise(4 * size, 150 + static_cast<std::uint32_t>(level));
    gl.TexImage1D(GL_TEXTURE_1D, level, GL_RGBA, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
  filters(gl, GL_TEXTURE_1D, minify, GL_NEAREST);
  gl.Enable(GL_TEXTURE_1D);
  look(gl, {.distance = 2.4f, .pitch_deg = 24});
  draw_surface(gl, floor_grid(3, 2), [&](const Surface::Point& p) { gl.TexCoord1f(3 * p.u + 2 * p.v); });
}

// Rectangles: where a texel is larger than a pixel the other filter.
template <GLint minify, GLint magnify>
void switched_rectangle(const GlTable& gl) {
  begin(gl);
  gl.Disable(GL_CULL_FACE);
  noise_image(gl, GL_TEXTURE_RECTANGLE_ARB, 0, GL_RGBA, 70, 50, GL_RGBA, 8);
  filters(gl, GL_TEXTURE_RECTANGLE_ARB, minify, magnify);
  gl.Enable(GL_TEXTURE_RECTANGLE_ARB);
  look(gl, {.distance = 2.4f, .pitch_deg = 24});
  draw_surface(gl, floor_grid(3, 1), [&](const Surface::Point& p) { gl.TexCoord2f(200 * p.u - 60, 230 * p.v - 70); });
}

}  // namespace

SceneList texture_level_scenes() {
  constexpr auto lod = "§3.8.8", cube = "§3.8.6";
  constexpr Judge oracle = Judge::oracle_only;
  constexpr Texels noise = Texels::noise, colors = Texels::one_color_a_level;
  return {
      {.name = "cube_reflection_trilinear", .section = cube, .shows = "A ball and a box that mirror noise, with seams.", .judge = oracle, .draw = reflections<GL_LINEAR_MIPMAP_LINEAR, false, noise>},
      {.name = "cube_reflection_seamless", .section = cube, .shows = "The same without seams.", .judge = oracle, .draw = reflections<GL_LINEAR_MIPMAP_LINEAR, true, noise>},
      {.name = "cube_reflection_nearest_level", .section = cube, .shows = "The same in the nearest level.", .judge = oracle, .draw = reflections<GL_LINEAR_MIPMAP_NEAREST, true, noise>},
      {.name = "cube_reflection_levels", .section = cube, .shows = "Bands of colour, one a level.", .judge = oracle, .draw = reflections<GL_NEAREST_MIPMAP_LINEAR, false, colors>},
      {.name = "cube_positions_trilinear", .section = cube, .shows = "Two boxes and a ball of noise, with seams.", .judge = oracle, .draw = positions<GL_LINEAR_MIPMAP_LINEAR, false>},
      {.name = "cube_positions_seamless", .section = cube, .shows = "The same without seams.", .judge = oracle, .draw = positions<GL_LINEAR_MIPMAP_LINEAR, true>},
      {.name = "cube_positions_nearest", .section = cube, .shows = "The same in squares.", .judge = oracle, .draw = positions<GL_NEAREST_MIPMAP_NEAREST, true>},
      {.name = "volume_trilinear", .section = lod, .shows = "A slope through a volume that recedes.", .judge = oracle, .draw = volume<GL_LINEAR_MIPMAP_LINEAR>},
      {.name = "volume_nearest_level", .section = lod, .shows = "The same in squares.", .judge = oracle, .draw = volume<GL_NEAREST_MIPMAP_NEAREST>},
      {.name = "texels_1d_trilinear", .section = lod, .shows = "Stripes that run into each other in the distance.", .judge = oracle, .draw = line_of_texels<GL_LINEAR_MIPMAP_LINEAR>},
      {.name = "texels_1d_nearest_level", .section = lod, .shows = "The same with hard edges.", .judge = oracle, .draw = line_of_texels<GL_NEAREST_MIPMAP_NEAREST>},
      {.name = "rectangle_minified_linear", .section = lod, .shows = "A floor of squares in front and blurred behind.", .judge = oracle, .draw = switched_rectangle<GL_LINEAR, GL_NEAREST>},
      {.name = "rectangle_minified_nearest", .section = lod, .shows = "A floor blurred in front and of squares behind.", .judge = oracle, .draw = switched_rectangle<GL_NEAREST, GL_LINEAR>},
  };
}

}  // namespace gouraud::conformance
