// Features of random pictures that give fragments other colours: texture images, their parameters, environments, generated
// coordinates and matrices; colour sum and fog.
#include <array>

#include "conformance/fuzz/pictures.h"

namespace gouraud::conformance {
namespace {

/// Cells of few colours with room between their edges; every format takes its components from these bytes. There are more
/// of them than the image has, for any pixel storage.
std::vector<GLubyte> cells(Brush& b, int width, int height) {
  std::vector<GLubyte> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4 + 8192);
  std::array<GLubyte, 64> palette{};
  for (GLubyte& value : palette) value = static_cast<GLubyte>(17 * b.below(16));
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = palette[((i / 4 / 2) % 5 * 12 + i % 4 + i / (16 * 4) % 3) % palette.size()];
  return texels;
}

GLint wrap(Brush& b) {
  return static_cast<GLint>(b.one_of({GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT}));
}

void parameters(Brush& b, GLenum target) {
  const GlTable& gl = b.gl;
  const GLint mag = static_cast<GLint>(b.one_of({GL_NEAREST, GL_LINEAR}));
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, mag);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, b.chance(3) ? GL_LINEAR_MIPMAP_LINEAR : mag);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap(b));
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap(b));
  gl.TexParameteri(target, GL_TEXTURE_WRAP_R, wrap(b));
  gl.TexParameterfv(target, GL_TEXTURE_BORDER_COLOR, b.color().v);
}

GLenum internal_format(Brush& b) {
  return b.one_of({GL_RGBA, GL_RGB, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA, GL_INTENSITY, GL_RGBA8, GL_RGB8, GL_LUMINANCE8,
                   GL_ALPHA8, GL_LUMINANCE8_ALPHA8, GL_INTENSITY8, 1, 2, 3, 4, GL_SRGB8_ALPHA8_EXT, GL_RGBA16});
}

GLenum format(Brush& b) {
  return b.one_of({GL_RGBA, GL_RGBA, GL_BGRA, GL_RGB, GL_BGR, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RED, GL_ALPHA});
}

void environment(Brush& b) {
  b.gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(b.one_of({GL_MODULATE, GL_REPLACE, GL_DECAL, GL_BLEND, GL_ADD})));
  b.gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, b.color().v);
}

void combine(Brush& b) {
  const GlTable& gl = b.gl;
  const auto set = [&gl](GLenum name, GLenum value) { gl.TexEnvi(GL_TEXTURE_ENV, name, static_cast<GLint>(value)); };
  set(GL_TEXTURE_ENV_MODE, GL_COMBINE);
  set(GL_COMBINE_RGB, b.one_of({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT, GL_DOT3_RGB, GL_DOT3_RGBA}));
  set(GL_COMBINE_ALPHA, b.one_of({GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, GL_SUBTRACT}));
  for (GLenum i = 0; i < 3; ++i) {
    set(GL_SOURCE0_RGB + i, b.one_of({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}));
    set(GL_SOURCE0_ALPHA + i, b.one_of({GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS}));
    set(GL_OPERAND0_RGB + i, b.one_of({GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
    set(GL_OPERAND0_ALPHA + i, b.one_of({GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}));
  }
  gl.TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, static_cast<float>(1 << b.below(3)));
  gl.TexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, static_cast<float>(1 << b.below(3)));
  gl.TexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, b.color().v);
}

void image_2d(Brush& b, GLenum target) {
  const GLsizei width = 8 << b.below(2), height = 8 << b.below(2);
  const GLenum stored = internal_format(b), given = format(b);
  b.gl.TexImage2D(target, 0, static_cast<GLint>(stored), width, height, 0, given, GL_UNSIGNED_BYTE, cells(b, width, height).data());
}

void texture_2d(Brush& b) {
  b.gl.BindTexture(GL_TEXTURE_2D, 1);
  parameters(b, GL_TEXTURE_2D);
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  image_2d(b, GL_TEXTURE_2D);
  if (b.chance(3)) b.gl.TexSubImage2D(GL_TEXTURE_2D, 0, 2, 3, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, cells(b, 4, 4).data());
  b.gl.Enable(GL_TEXTURE_2D);
  environment(b);
}

void texture_1d(Brush& b) {
  b.gl.BindTexture(GL_TEXTURE_1D, 2);
  parameters(b, GL_TEXTURE_1D);
  b.gl.TexParameteri(GL_TEXTURE_1D, GL_GENERATE_MIPMAP, GL_TRUE);
  const GLenum stored = internal_format(b), given = format(b);
  b.gl.TexImage1D(GL_TEXTURE_1D, 0, static_cast<GLint>(stored), 16, 0, given, GL_UNSIGNED_BYTE, cells(b, 16, 1).data());
  b.gl.Enable(GL_TEXTURE_1D);
  environment(b);
}

void texture_3d(Brush& b) {
  b.gl.BindTexture(GL_TEXTURE_3D, 3);
  parameters(b, GL_TEXTURE_3D);
  b.gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  const GLenum stored = internal_format(b);
  b.gl.TexImage3D(GL_TEXTURE_3D, 0, static_cast<GLint>(stored), 8, 8, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, cells(b, 8, 32).data());
  b.gl.Enable(GL_TEXTURE_3D);
  environment(b);
}

void texture_cube(Brush& b) {
  b.gl.BindTexture(GL_TEXTURE_CUBE_MAP, 4);
  parameters(b, GL_TEXTURE_CUBE_MAP);
  // Mesa's linear filters differ from each other at seams.
  b.gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  b.gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const GLenum stored = internal_format(b);
  for (GLenum face = 0; face < 6; ++face) {
    b.gl.TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, static_cast<GLint>(stored), 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, cells(b, 8, 8).data());
  }
  b.gl.Enable(GL_TEXTURE_CUBE_MAP);
  environment(b);
}

void texture_rectangle(Brush& b) {
  b.gl.BindTexture(GL_TEXTURE_RECTANGLE_ARB, 6);
  const GLint filter = static_cast<GLint>(b.one_of({GL_NEAREST, GL_LINEAR}));
  b.gl.TexParameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_MIN_FILTER, filter);
  b.gl.TexParameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_MAG_FILTER, filter);
  b.gl.TexImage2D(GL_TEXTURE_RECTANGLE_ARB, 0, GL_RGBA, 12, 7, 0, GL_RGBA, GL_UNSIGNED_BYTE, cells(b, 12, 7).data());
  b.gl.Enable(GL_TEXTURE_RECTANGLE_ARB);
  b.gl.MatrixMode(GL_TEXTURE);
  b.gl.Scalef(12.0f, 7.0f, 1.0f);
  b.gl.MatrixMode(GL_MODELVIEW);
  environment(b);
}

void shadow(Brush& b) {
  b.gl.BindTexture(GL_TEXTURE_2D, 8);
  parameters(b, GL_TEXTURE_2D);
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  if (b.chance(2)) b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, static_cast<GLint>(b.comparison()));
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, static_cast<GLint>(b.one_of({GL_LUMINANCE, GL_INTENSITY, GL_ALPHA})));
  std::array<float, 1024> depths{};  // as many as any pixel storage reads
  for (float& depth : depths) depth = b.level();
  b.gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 8, 8, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  b.gl.Enable(GL_TEXTURE_2D);
  environment(b);
}

void second_unit(Brush& b) {
  b.gl.ActiveTexture(GL_TEXTURE1);
  b.gl.BindTexture(GL_TEXTURE_2D, 9);
  parameters(b, GL_TEXTURE_2D);
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  image_2d(b, GL_TEXTURE_2D);
  b.gl.Enable(GL_TEXTURE_2D);
  if (b.chance(2)) {
    environment(b);
  } else {
    combine(b);
  }
  b.gl.ActiveTexture(GL_TEXTURE0);
}

void generated(Brush& b) {
  const auto mode = b.one_of({GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP, GL_REFLECTION_MAP, GL_NORMAL_MAP});
  const GLenum last = mode == GL_SPHERE_MAP ? GL_T : mode >= GL_NORMAL_MAP ? GL_R : GL_Q;
  for (GLenum coordinate = GL_S; coordinate <= last; ++coordinate) {
    if (coordinate == GL_Q && !b.chance(4)) continue;
    b.gl.TexGeni(coordinate, GL_TEXTURE_GEN_MODE, static_cast<GLint>(mode));
    Brush::Four plane = b.point();
    if (coordinate == GL_Q) plane.v[3] = 2.0f;
    b.gl.TexGenfv(coordinate, GL_OBJECT_PLANE, plane.v);
    b.gl.TexGenfv(coordinate, GL_EYE_PLANE, plane.v);
    b.gl.Enable(GL_TEXTURE_GEN_S + (coordinate - GL_S));
  }
}

void texture_matrix(Brush& b) {
  b.gl.MatrixMode(GL_TEXTURE);
  b.gl.Rotatef(b.range(-90.0f, 90.0f), 0.0f, 0.0f, 1.0f);
  in_order(b.gl.Scalef, std::tuple{b.range(0.4f, 2.0f), b.range(0.4f, 2.0f), 1.0f});
  b.gl.MatrixMode(GL_MODELVIEW);
}

void lod_control(Brush& b) {
  b.gl.TexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, static_cast<float>(b.below(7) - 3));
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, b.below(3));
  b.gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1 + b.below(4));
}

void fog(Brush& b) {
  b.gl.Enable(GL_FOG);
  b.gl.Fogi(GL_FOG_MODE, static_cast<GLint>(b.one_of({GL_LINEAR, GL_EXP, GL_EXP2})));
  b.gl.Fogf(GL_FOG_DENSITY, b.range(0.2f, 2.0f));
  b.gl.Fogf(GL_FOG_START, b.range(-0.5f, 0.5f));
  b.gl.Fogf(GL_FOG_END, b.range(0.7f, 4.0f));
  b.gl.Fogfv(GL_FOG_COLOR, b.color().v);
  if (b.chance(2)) b.gl.Fogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
}

/// Not with fog: sums of Mesa's are not clamped before it.
void color_sum(Brush& b) {
  if (b.gl.IsEnabled(GL_FOG) == GL_FALSE) b.gl.Enable(GL_COLOR_SUM);
}
void separate_specular(Brush& b) {
  if (b.gl.IsEnabled(GL_FOG) == GL_FALSE) b.gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
}
constexpr Feature features[] = {
    {"texture_1d", texture_1d},
    {"texture_2d", texture_2d},
    {"texture_3d", texture_3d},
    {"texture_cube", texture_cube},
    {"texture_rectangle", texture_rectangle},
    {"shadow", shadow},
    {"combine", combine},
    {"second_unit", second_unit},
    {"generated", generated},
    {"texture_matrix", texture_matrix},
    {"lod_control", lod_control},
    {"fog", fog},
    {"color_sum", color_sum},
    {"separate_specular", separate_specular},
};

}  // namespace

std::span<const Feature> fragment_color_features() { return features; }

}  // namespace gouraud::conformance
