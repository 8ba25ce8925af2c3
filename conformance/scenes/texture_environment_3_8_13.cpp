// Texture functions and combiners [GL1.5 §3.8.13].
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

struct Format {
  GLint internal;
  GLenum format;
};
constexpr Format base_formats[] = {{GL_ALPHA8, GL_ALPHA}, {GL_LUMINANCE8, GL_LUMINANCE}, {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA},
                                   {GL_INTENSITY8, GL_LUMINANCE}, {GL_RGB8, GL_RGB}, {GL_RGBA8, GL_RGBA}};

void begin(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
}

// A quad whose colours and coordinates vary.
void patch(const GlTable& gl, float x, float y, float width, float height) {
  const float corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  gl.Begin(GL_QUADS);
  for (const auto& [s, t] : corners) {
    gl.Color4f(0.9f - 0.7f * s, 0.2f + 0.6f * t, 0.3f + 0.5f * s * t, 0.25f + 0.7f * t);
    gl.MultiTexCoord2f(GL_TEXTURE0, 1.3f * s, 1.2f * t);
    gl.MultiTexCoord2f(GL_TEXTURE1, 0.7f * t, 0.9f * s);
    gl.MultiTexCoord2f(GL_TEXTURE2, 0.4f + 0.5f * t, 0.9f - s);
    gl.Vertex2f(x + width * s, y + height * t);
  }
  gl.End();
}

// Six base formats under one mode.
template <GLint mode>
void modes(const GlTable& gl) {
  begin(gl);
  environment_mode(gl, mode);
  const float constant[4] = {0.2f, 0.9f, 0.6f, 0.35f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
  int cell = 0;
  for (const Format& f : base_formats) {
    noise_image(gl, GL_TEXTURE_2D, 0, f.internal, 16, 16, f.format, 19);
    patch(gl, 4 + 84 * static_cast<float>(cell % 3), 4 + 126 * static_cast<float>(cell / 3), 78, 120);
    ++cell;
  }
}

constexpr GLint sources[] = {GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS, GL_TEXTURE0, GL_TEXTURE1, GL_TEXTURE2};
constexpr GLint operands[] = {GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA};
constexpr GLint rgb_functions[] = {GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA};

void random_combiner(const GlTable& gl, Random& random, GLint function, int source_count) {
  environment_mode(gl, GL_COMBINE);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, function);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, rgb_functions[random.below(6)]);
  for (GLenum i = 0; i < 3; ++i) {
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_RGB + i, sources[random.below(source_count)]);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_RGB + i, operands[random.below(4)]);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_SOURCE0_ALPHA + i, sources[random.below(source_count)]);
    gl.TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA + i, operands[2 + random.below(2)]);
  }
  gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, static_cast<float>(1 << random.below(3)));
  gl.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, static_cast<float>(1 << random.below(3)));
  const float constant[4] = {0.35f, 0.75f, 0.15f, 0.55f};
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
}

void three_units(const GlTable& gl) {
  for (GLuint unit = 0; unit < 3; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, unit + 1);
    noise_image(gl, GL_TEXTURE_2D, 0, unit == 1 ? GL_RGB : GL_RGBA, 16, 8, unit == 1 ? GL_RGB : GL_RGBA, 90 + unit);
    filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
  }
}

// 64 random combiners: eight of each function, one unit.
void combiners(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, GL_RGBA, 19);
  Random random(101);
  for (int i = 0; i < 64; ++i) {
    random_combiner(gl, random, rgb_functions[i / 8], 4);
    patch(gl, 3 + 32 * static_cast<float>(i % 8), 3 + 32 * static_cast<float>(i / 8), 28, 28);
  }
}

// 64 random pairs of combiners on three units that read each other's textures.
void crossbar(const GlTable& gl) {
  begin(gl);
  three_units(gl);
  Random random(202);
  for (int i = 0; i < 64; ++i) {
    for (GLenum unit = 0; unit < 3; ++unit) {
      gl.ActiveTexture(GL_TEXTURE0 + unit);
      random_combiner(gl, random, rgb_functions[random.below(8)], 7);
    }
    patch(gl, 3 + 32 * static_cast<float>(i % 8), 3 + 32 * static_cast<float>(i / 8), 28, 28);
  }
}

// Modes after each other: 25 pairs.
void mode_pairs(const GlTable& gl) {
  begin(gl);
  three_units(gl);
  gl.Disable(GL_TEXTURE_2D);
  constexpr GLint all[] = {GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD};
  const float constant[4] = {0.6f, 0.1f, 0.8f, 0.4f};
  for (int i = 0; i < 25; ++i) {
    gl.ActiveTexture(GL_TEXTURE0);
    gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
    environment_mode(gl, all[i % 5]);
    gl.ActiveTexture(GL_TEXTURE1);
    environment_mode(gl, all[i / 5]);
    patch(gl, 3 + 51 * static_cast<float>(i % 5), 3 + 51 * static_cast<float>(i / 5), 46, 46);
  }
}

void base_map_and_light_map(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  for (GLuint unit = 0; unit < 2; ++unit) {
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, unit + 1);
    const int size = unit == 0 ? 64 : 16;
    const auto texels = smooth_texels(size, size, unit == 0 ? 3 : 1, 7 + unit);
    const GLenum format = unit == 0 ? GL_RGB : GL_LUMINANCE;
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size, size, 0, format, GL_UNSIGNED_BYTE, texels.data());
    filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
    gl.Enable(GL_TEXTURE_2D);
  }
  look(gl, {.distance = 4.2f, .pitch_deg = 31});
  draw_surface(gl, torus(0.9f, 0.45f, 24, 16), [&](const Surface::Point& point) {
    gl.Color3f(0.9f, 0.8f + 0.2f * point.u, 0.7f);
    gl.MultiTexCoord2f(GL_TEXTURE0, 4 * point.u, 2 * point.v);
    gl.MultiTexCoord2f(GL_TEXTURE1, point.v, point.u);
  });
}

// A lit ball in modulation and decal.
template <GLint mode>
void lit(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  const auto texels = smooth_texels(32, 32, 4, 5);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  environment_mode(gl, mode);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  light(gl, GL_LIGHT0, GL_POSITION, {1, 2, 3, 0});
  look(gl, {.distance = 4.2f, .pitch_deg = 21});
  draw_surface(gl, sphere(1.2f, 24, 36), [&](const Surface::Point& point) { gl.TexCoord2f(3 * point.u, 2 * point.v); });
}

}  // namespace

SceneList texture_environment_scenes() {
  constexpr auto section = "§3.8.13";
  return {
      {.name = "texture_env_modulate", .section = section, .shows = "Six base formats times a colour that varies.", .judge = Judge::textures, .draw = modes<GL_MODULATE>},
      {.name = "texture_env_replace", .section = section, .shows = "Six base formats in place of the colour.", .judge = Judge::textures, .draw = modes<GL_REPLACE>},
      {.name = "texture_env_decal", .section = section, .shows = "RGB replaces, RGBA lies over the colour; the rest changes nothing.", .judge = Judge::textures, .draw = modes<GL_DECAL>},
      {.name = "texture_env_blend", .section = section, .shows = "Six base formats mix in a green.", .judge = Judge::textures, .draw = modes<GL_BLEND>},
      {.name = "texture_env_add", .section = section, .shows = "Six base formats added.", .judge = Judge::textures, .draw = modes<GL_ADD>},
      {.name = "texture_combiners", .section = section, .shows = "64 random combiners, eight of a function in each row.", .judge = Judge::textures, .draw = combiners},
      {.name = "texture_crossbar", .section = section, .shows = "64 times three random combiners that read all units.", .judge = Judge::textures, .draw = crossbar},
      {.name = "texture_mode_pairs", .section = section, .shows = "25 pairs of modes on two units.", .judge = Judge::textures, .draw = mode_pairs},
      {.name = "texture_light_map", .section = section, .shows = "A ring with a base map and a light map.", .judge = Judge::oracle_only, .draw = base_map_and_light_map},
      {.name = "texture_lit_modulate", .section = section, .shows = "A lit ball times a texture.", .judge = Judge::textures, .draw = lit<GL_MODULATE>},
      {.name = "texture_lit_decal", .section = section, .shows = "A lit ball under a decal.", .judge = Judge::textures, .draw = lit<GL_DECAL>},
  };
}

}  // namespace gouraud::conformance
