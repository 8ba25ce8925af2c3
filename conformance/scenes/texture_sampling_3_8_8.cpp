// Sampling [GL1.5 §3.8.6-3.8.10, §3.8.14]. Where a nearest texel or a level hangs on less than rounding, the oracle takes
// either; where levels of detail decide, Mesa's pictures are reported and not judged: it takes them from 2x2 quads and
// with a logarithm of pieces. So it is where llvmpipe's float and our fixed point round more than 1 % of a noise
// differently: both are within 0.51/255 of the oracle.
#include "conformance/scenes/scene_lists.h"
#include "conformance/scenes/texture_shapes.h"

namespace gouraud::conformance {
namespace {

void begin(const GlTable& gl) {
  clear_background(gl);
  pixel_space(gl, 256, 256);
  environment_mode(gl, GL_REPLACE);
}

// Nine patches: coordinates far out of [0, 1], turned and sheared, in one wrap mode for each row, both filters.
template <GLint mode, int width, int height>
void wrap_2d(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, width, height, GL_RGBA, 5);
  wraps(gl, GL_TEXTURE_2D, mode);
  const float border[4] = {0.8f, 0.4f, 0.12f, 0.72f};
  gl.TexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, border);
  gl.Enable(GL_TEXTURE_2D);
  filters(gl, GL_TEXTURE_2D, GL_NEAREST, GL_NEAREST);
  textured_rectangle(gl, 4, 4, 124, 124, -1.3f, -1.27f, 2.21f, 2.4f);
  textured_rectangle(gl, 4, 132, 124, 252, -0.11f, 1.1318f, 0.4f, -0.2273f);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  textured_rectangle(gl, 132, 4, 252, 124, -1.3f, -1.27f, 2.21f, 2.4f);
  textured_rectangle(gl, 132, 132, 252, 252, -0.11f, 1.1318f, 0.4f, -0.2273f);
}

struct Format {
  GLint internal;
  GLenum format;
};

// One patch a format, over a checkered ground of two colours, modulated.
template <int filter>
void formats(const GlTable& gl) {
  begin(gl);
  gl.Enable(GL_TEXTURE_2D);
  environment_mode(gl, GL_MODULATE);
  filters(gl, GL_TEXTURE_2D, filter, filter);
  constexpr Format all[] = {{GL_ALPHA8, GL_ALPHA}, {GL_LUMINANCE8, GL_LUMINANCE}, {GL_LUMINANCE8_ALPHA8, GL_LUMINANCE_ALPHA},
                            {GL_INTENSITY8, GL_LUMINANCE}, {GL_RGB8, GL_RGB}, {GL_RGBA8, GL_RGBA}, {GL_LUMINANCE16, GL_LUMINANCE},
                            {GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA}, {GL_RGBA16, GL_RGBA}};
  int cell = 0;
  for (const Format& f : all) {
    noise_image(gl, GL_TEXTURE_2D, 0, f.internal, 16, 16, f.format, 9);
    const float x = 4 + 84 * static_cast<float>(cell % 3), y = 4 + 84 * static_cast<float>(cell / 3);
    gl.Color4f(0.9f, 0.8f, 0.7f, 0.6f);
    textured_rectangle(gl, x, y, x + 78, y + 78, 0.13f, -0.21f, 1.52f, 1.17f);
    ++cell;
  }
}

template <GLint minify>
void minified_noise(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  int level = 0;
  for (int size = 64; size > 0; size /= 2, ++level) noise_image(gl, GL_TEXTURE_2D, level, GL_RGBA, size, size, GL_RGBA, 40 + static_cast<std::uint32_t>(level));
  filters(gl, GL_TEXTURE_2D, minify, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 6);
}

// Patches of one floor seen flat, and of one turned wall: as many samples as the footprint is long, at most so many.
template <GLint minify, int most>
void anisotropic(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  for (int size = 64, level = 0; size > 0; size /= 2, ++level) noise_image(gl, GL_TEXTURE_2D, level, GL_RGBA, size, size, GL_RGBA, 40 + static_cast<std::uint32_t>(level));
  filters(gl, GL_TEXTURE_2D, minify, GL_LINEAR);
  gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, static_cast<float>(most) + 0.5f);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 3);
}

template <int most>
void anisotropic_levels(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  colored_levels(gl, GL_TEXTURE_2D, 128);
  filters(gl, GL_TEXTURE_2D, GL_NEAREST_MIPMAP_LINEAR, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, most);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 5);
}

// Stretched cells: the longer side along x, along y, across; of a texture with mipmaps, of one without, of a rectangle.
void anisotropic_cells(const GlTable& gl) {
  begin(gl);
  for (int kind = 0; kind < 3; ++kind) {
    const GLenum target = kind == 2 ? GL_TEXTURE_RECTANGLE_ARB : GL_TEXTURE_2D;
    for (int size = 32, level = 0; size > (kind == 0 ? 0 : 31); size /= 2, ++level) noise_image(gl, target, level, GL_RGBA, size, size, GL_RGBA, 70 + static_cast<std::uint32_t>(level));
    filters(gl, target, kind == 0 ? GL_LINEAR_MIPMAP_NEAREST : GL_LINEAR, GL_LINEAR);
    gl.TexParameteri(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
    gl.Enable(target);
    const float unit = kind == 2 ? 32 : 1, y = 4 + 84 * static_cast<float>(kind);
    textured_rectangle(gl, 4, y, 84, y + 78, 0, 0, 9.3f * unit, 1.7f * unit);
    textured_rectangle(gl, 88, y, 168, y + 78, 0.1f * unit, 0.2f * unit, 1.3f * unit, 11.9f * unit);
    gl.Begin(GL_QUADS);
    gl.TexCoord2f(0, 0);
    gl.Vertex2f(172, y);
    gl.TexCoord2f(5.1f * unit, 4.2f * unit);
    gl.Vertex2f(252, y);
    gl.TexCoord2f(8.8f * unit, 9.4f * unit);
    gl.Vertex2f(252, y + 78);
    gl.TexCoord2f(3.7f * unit, 5.2f * unit);
    gl.Vertex2f(172, y + 78);
    gl.End();
  }
}

template <GLint minify>
void level_colors(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  colored_levels(gl, GL_TEXTURE_2D, 128);
  filters(gl, GL_TEXTURE_2D, minify, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 5);
}

void biased_levels(const GlTable& gl) {
  begin(gl);
  colored_levels(gl, GL_TEXTURE_2D, 64);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  int row = 0;
  for (const float bias : {-1.3f, 0.4f, 2.2f}) {
    gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_LOD_BIAS, bias);
    for (int i = 0; i < 6; ++i) {
      const float x = 4 + 42 * static_cast<float>(i), y = 4 + 84 * static_cast<float>(row), scale = 0.35f * static_cast<float>(1 << i);
      textured_rectangle(gl, x, y, x + 38, y + 78, 0, 0, 38 * scale / 64, 78 * scale / 64);
    }
    ++row;
  }
}

void clamped_levels(const GlTable& gl) {
  begin(gl);
  colored_levels(gl, GL_TEXTURE_2D, 64);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  for (int row = 0; row < 3; ++row) {
    if (row == 0) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, 1.6f);
    if (row == 1) gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 2.3f);
    if (row == 2) {
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
      gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 3);
    }
    for (int i = 0; i < 6; ++i) {
      const float x = 4 + 42 * static_cast<float>(i), y = 4 + 84 * static_cast<float>(row), scale = 0.35f * static_cast<float>(1 << i);
      textured_rectangle(gl, x, y, x + 38, y + 78, 0, 0, 38 * scale / 64, 78 * scale / 64);
    }
  }
}

void one_d(const GlTable& gl) {
  begin(gl);
  const auto texels = noise(4 * 32, 3);
  gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.Enable(GL_TEXTURE_1D);
  int row = 0;
  for (const GLint mode : {GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT}) {
    wraps(gl, GL_TEXTURE_1D, mode);
    for (const GLint filter : {GL_NEAREST, GL_LINEAR}) {
      filters(gl, GL_TEXTURE_1D, filter, filter);
      const float y = 4 + 31 * static_cast<float>(row++);
      textured_rectangle(gl, 4, y, 252, y + 28, -1.23f, 0, 2.31f, 0);
    }
  }
}

// Slices of a volume, across it.
template <GLint filter>
void three_d(const GlTable& gl) {
  begin(gl);
  const auto texels = noise(4 * 8 * 8 * 8, 21);
  gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RGBA, 8, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  gl.Enable(GL_TEXTURE_3D);
  filters(gl, GL_TEXTURE_3D, filter, filter);
  wraps(gl, GL_TEXTURE_3D, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_WRAP_R, GL_CLAMP_TO_EDGE);
  gl.Begin(GL_QUADS);
  gl.TexCoord3f(-0.31f, 0.12f, -0.2f);
  gl.Vertex2f(4, 4);
  gl.TexCoord3f(1.43f, 0.02f, 0.3f);
  gl.Vertex2f(252, 4);
  gl.TexCoord3f(1.43f, 1.61f, 1.3f);
  gl.Vertex2f(252, 252);
  gl.TexCoord3f(-0.31f, 1.71f, 0.8f);
  gl.Vertex2f(4, 252);
  gl.End();
}

void cube_faces(const GlTable& gl, int size) {
  for (GLenum face = 0; face < 6; ++face) {
    noise_image(gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA, size, size, GL_RGBA, 60 + face);
  }
}

// A torus that shows what its normals see.
template <GLint filter, bool seamless>
void cube_map(const GlTable& gl) {
  clear_background(gl);
  gl.Enable(GL_DEPTH_TEST);
  gl.Enable(GL_CULL_FACE);
  environment_mode(gl, GL_REPLACE);
  cube_faces(gl, 8);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  filters(gl, GL_TEXTURE_CUBE_MAP, filter, filter);
  wraps(gl, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
  if (seamless) gl.Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  look(gl, {.distance = 4.2f, .pitch_deg = 31});
  draw_surface(gl, torus(0.9f, 0.45f, 24, 16), [&](const Surface::Point& point) { gl.TexCoord3fv(point.normal.data()); });
}

template <GLint filter>
void rectangle(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_RECTANGLE_ARB, 0, GL_RGBA, 21, 13, GL_RGBA, 8);
  gl.Enable(GL_TEXTURE_RECTANGLE_ARB);
  filters(gl, GL_TEXTURE_RECTANGLE_ARB, filter, filter);
  wraps(gl, GL_TEXTURE_RECTANGLE_ARB, GL_CLAMP_TO_EDGE);
  textured_rectangle(gl, 4, 4, 252, 252, -3.4f, -2.1f, 25.2f, 16.3f);
}

// A ramp of depths compared with a slope of r, one function a cell.
template <GLint filter>
void comparison(const GlTable& gl) {
  begin(gl);
  std::vector<float> depths;
  Random random(77);
  for (int i = 0; i < 16 * 16; ++i) depths.push_back(random.range(0.1f, 0.9f));
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 16, 16, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
  filters(gl, GL_TEXTURE_2D, filter, filter);
  gl.Enable(GL_TEXTURE_2D);
  int cell = 0;
  for (const GLint func : {GL_LESS, GL_LEQUAL, GL_GREATER, GL_GEQUAL, GL_ALWAYS, GL_NEVER}) {
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, func);
    const float x = 4 + 84 * static_cast<float>(cell % 3), y = 4 + 126 * static_cast<float>(cell / 3);
    gl.Begin(GL_QUADS);
    gl.TexCoord3f(0, 0, -0.2f);
    gl.Vertex2f(x, y);
    gl.TexCoord3f(1.3f, 0, 0.4f);
    gl.Vertex2f(x + 78, y);
    gl.TexCoord3f(1.3f, 1.2f, 1.2f);
    gl.Vertex2f(x + 78, y + 120);
    gl.TexCoord3f(0, 1.2f, 0.6f);
    gl.Vertex2f(x, y + 120);
    gl.End();
    ++cell;
  }
}

// q varies over the quad: a projected texture.
void projected(const GlTable& gl) {
  begin(gl);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 16, 16, GL_RGBA, 31);
  filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
  gl.MatrixMode(GL_TEXTURE);
  const float matrix[16] = {1, 0.2f, 0, 0.3f, -0.1f, 1, 0, 0.15f, 0, 0, 1, 0, 0.1f, 0.05f, 0, 1};
  gl.LoadMatrixf(matrix);
  gl.MatrixMode(GL_MODELVIEW);
  gl.Begin(GL_QUADS);
  gl.TexCoord4f(0, 0, 0, 1);
  gl.Vertex2f(4, 4);
  gl.TexCoord4f(1.5f, 0, 0, 0.8f);
  gl.Vertex2f(252, 4);
  gl.TexCoord4f(1.5f, 1.5f, 0, 1.9f);
  gl.Vertex2f(252, 252);
  gl.TexCoord4f(0, 1.5f, 0, 1.2f);
  gl.Vertex2f(4, 252);
  gl.End();
}

// A receding floor with nearest and linear filters alone.
template <GLint filter>
void receding(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, GL_RGBA, 12);
  filters(gl, GL_TEXTURE_2D, filter, filter);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 1.5f);
}

// Minified by one filter, magnified by the other.
template <GLint minify, GLint magnify>
void switched(const GlTable& gl) {
  clear_background(gl);
  environment_mode(gl, GL_REPLACE);
  noise_image(gl, GL_TEXTURE_2D, 0, GL_RGBA, 32, 32, GL_RGBA, 12);
  filters(gl, GL_TEXTURE_2D, minify, magnify);
  gl.Enable(GL_TEXTURE_2D);
  textured_floor(gl, 4);
}

}  // namespace

SceneList texture_sampling_scenes() {
  constexpr auto wrap = "§3.8.7", lod = "§3.8.8";
  constexpr Judge oracle = Judge::oracle_only;
  return {
      {.name = "texture_wrap_repeat", .section = wrap, .shows = "Noise repeated: left nearest, right linear.", .judge = Judge::textures, .draw = wrap_2d<GL_REPEAT, 16, 16>},
      {.name = "texture_wrap_clamp", .section = wrap, .shows = "Noise clamped to [0, 1]: the linear half fades into the border colour.", .judge = Judge::textures, .draw = wrap_2d<GL_CLAMP, 16, 16>},
      {.name = "texture_wrap_edge", .section = wrap, .shows = "Noise whose edge texels go on.", .judge = Judge::textures, .draw = wrap_2d<GL_CLAMP_TO_EDGE, 16, 16>},
      {.name = "texture_wrap_border", .section = wrap, .shows = "Noise in the border colour.", .judge = Judge::textures, .draw = wrap_2d<GL_CLAMP_TO_BORDER, 16, 16>},
      {.name = "texture_wrap_mirrored", .section = wrap, .shows = "Noise mirrored at each repeat.", .judge = Judge::textures, .draw = wrap_2d<GL_MIRRORED_REPEAT, 16, 16>},
      {.name = "texture_wrap_mirror_clamp", .section = wrap, .shows = "Noise mirrored once, then clamped.", .judge = Judge::textures, .draw = wrap_2d<GL_MIRROR_CLAMP_EXT, 16, 16>},
      {.name = "texture_wrap_mirror_edge", .section = wrap, .shows = "Noise mirrored once whose edge texels go on.", .judge = Judge::textures, .draw = wrap_2d<GL_MIRROR_CLAMP_TO_EDGE_EXT, 16, 16>},
      {.name = "texture_wrap_mirror_border", .section = wrap, .shows = "Noise mirrored once in the border colour.", .judge = Judge::textures, .draw = wrap_2d<GL_MIRROR_CLAMP_TO_BORDER_EXT, 16, 16>},
      {.name = "texture_npot_repeat", .section = wrap, .shows = "Noise of 13 x 7 texels, repeated.", .judge = Judge::textures, .draw = wrap_2d<GL_REPEAT, 13, 7>},
      {.name = "texture_npot_edge", .section = wrap, .shows = "Noise of 13 x 7 texels, its edge texels go on.", .judge = Judge::textures, .draw = wrap_2d<GL_CLAMP_TO_EDGE, 13, 7>},
      {.name = "texture_npot_mirrored", .section = wrap, .shows = "Noise of 13 x 7 texels, mirrored.", .judge = Judge::textures, .draw = wrap_2d<GL_MIRRORED_REPEAT, 13, 7>},
      {.name = "texture_formats_nearest", .section = "§3.8.1", .shows = "Nine formats, nearest, modulating one colour.", .judge = Judge::textures, .draw = formats<GL_NEAREST>},
      {.name = "texture_formats_linear", .section = "§3.8.1", .shows = "Nine formats, linear, modulating one colour.", .judge = Judge::textures, .draw = formats<GL_LINEAR>},
      {.name = "texture_floor_nearest", .section = lod, .shows = "A floor of square texels that recedes.", .judge = oracle, .draw = receding<GL_NEAREST>},
      {.name = "texture_floor_linear", .section = lod, .shows = "The floor, bilinear.", .judge = oracle, .draw = receding<GL_LINEAR>},
      {.name = "texture_floor_mip_nearest_nearest", .section = lod, .shows = "A floor of noise, another noise a level.", .judge = oracle, .draw = minified_noise<GL_NEAREST_MIPMAP_NEAREST>},
      {.name = "texture_floor_mip_linear_nearest", .section = lod, .shows = "The floor, bilinear in the nearest level.", .judge = oracle, .draw = minified_noise<GL_LINEAR_MIPMAP_NEAREST>},
      {.name = "texture_floor_mip_nearest_linear", .section = lod, .shows = "The floor, nearest texels of two levels mixed.", .judge = oracle, .draw = minified_noise<GL_NEAREST_MIPMAP_LINEAR>},
      {.name = "texture_floor_trilinear", .section = lod, .shows = "The floor, trilinear.", .judge = oracle, .draw = minified_noise<GL_LINEAR_MIPMAP_LINEAR>},
      {.name = "texture_anisotropic_2", .section = lod, .shows = "A floor of noise, two samples a pixel.", .judge = oracle, .draw = anisotropic<GL_LINEAR_MIPMAP_LINEAR, 2>},
      {.name = "texture_anisotropic_16", .section = lod, .shows = "The floor, sharp into the distance.", .judge = oracle, .draw = anisotropic<GL_LINEAR_MIPMAP_LINEAR, 16>},
      {.name = "texture_anisotropic_nearest_level", .section = lod, .shows = "The floor, up to five samples in the nearest level.", .judge = oracle, .draw = anisotropic<GL_LINEAR_MIPMAP_NEAREST, 5>},
      {.name = "texture_anisotropic_linear", .section = lod, .shows = "The floor without levels.", .judge = oracle, .draw = anisotropic<GL_LINEAR, 4>},
      {.name = "texture_anisotropic_levels", .section = lod, .shows = "Bands of colour, one a level, further away than without anisotropy.", .judge = oracle, .draw = anisotropic_levels<8>},
      {.name = "texture_anisotropic_cells", .section = lod, .shows = "Stretched noise: 2D with levels, 2D without, a rectangle.", .judge = oracle, .draw = anisotropic_cells},
      {.name = "texture_levels_nearest", .section = lod, .shows = "Bands of colour, one a level, over a receding floor.", .judge = oracle, .draw = level_colors<GL_NEAREST_MIPMAP_NEAREST>},
      {.name = "texture_levels_linear", .section = lod, .shows = "The bands run into each other.", .judge = oracle, .draw = level_colors<GL_LINEAR_MIPMAP_LINEAR>},
      {.name = "texture_lod_bias", .section = lod, .shows = "Three rows of six patches, smaller to the right; each row with its own bias.", .judge = oracle, .draw = biased_levels},
      {.name = "texture_lod_range", .section = lod, .shows = "Three rows: least LOD, greatest LOD, levels 1 to 3.", .judge = oracle, .draw = clamped_levels},
      {.name = "texture_switch_nearest_linear", .section = "§3.8.9", .shows = "Minified nearest, magnified linear.", .judge = oracle, .draw = switched<GL_NEAREST, GL_LINEAR>},
      {.name = "texture_switch_linear_nearest", .section = "§3.8.9", .shows = "Minified linear, magnified nearest.", .judge = oracle, .draw = switched<GL_LINEAR, GL_NEAREST>},
      {.name = "texture_1d", .section = wrap, .shows = "Eight bars: four wrap modes, nearest and linear.", .judge = Judge::textures, .draw = one_d},
      {.name = "texture_3d_nearest", .section = lod, .shows = "A slope through a volume of 8 x 8 x 8 texels.", .judge = oracle, .draw = three_d<GL_NEAREST>},
      {.name = "texture_3d_linear", .section = lod, .shows = "The slope, linear.", .judge = Judge::textures, .draw = three_d<GL_LINEAR>},
      {.name = "texture_cube_nearest", .section = "§3.8.6", .shows = "A ring that wears a cube map of 8 x 8 texels by its normals.", .judge = oracle, .draw = cube_map<GL_NEAREST, false>},
      {.name = "texture_cube_linear", .section = "§3.8.6", .shows = "The ring, linear: seams between the faces.", .judge = oracle, .draw = cube_map<GL_LINEAR, false>},
      {.name = "texture_cube_seamless", .section = "§3.8.6", .shows = "The ring without seams.", .judge = oracle, .draw = cube_map<GL_LINEAR, true>},
      {.name = "texture_rectangle_nearest", .section = wrap, .shows = "21 x 13 texels by coordinates that count texels.", .judge = Judge::textures, .draw = rectangle<GL_NEAREST>},
      {.name = "texture_rectangle_linear", .section = wrap, .shows = "The same, linear.", .judge = oracle, .draw = rectangle<GL_LINEAR>},
      {.name = "texture_compare_nearest", .section = "§3.8.14", .shows = "Six cells: less, lequal, greater, gequal, always, never.", .judge = oracle, .draw = comparison<GL_NEAREST>},
      {.name = "texture_compare_linear", .section = "§3.8.14", .shows = "The six cells with soft edges.", .judge = oracle, .draw = comparison<GL_LINEAR>},
      {.name = "texture_projected", .section = "§2.11.2", .shows = "Noise under a texture matrix with perspective.", .judge = oracle, .draw = projected},
  };
}

}  // namespace gouraud::conformance
