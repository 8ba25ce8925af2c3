#include "conformance/speed/necessity_scenes.h"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "conformance/scenes/texture_shapes.h"

namespace gouraud::speed {
namespace {

using conformance::Matrix;

constexpr float aspect = static_cast<float>(necessity_width_px) / necessity_height_px;
constexpr int shadow_map_size = 256;
long vertex_count = 0;

void vertex(const GlTable& gl, double x, double y, double z) {
  ++vertex_count;
  gl.Vertex3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
}

void camera(const GlTable& gl, const Matrix& view) {
  gl.Viewport(0, 0, necessity_width_px, necessity_height_px);
  conformance::load_projection(gl, conformance::perspective(35, aspect, 1, 60));
  conformance::load_model_view(gl, view);
}

// Gears: the sides flat, the bore smooth, as in the demo.

struct Gear {
  double inner, outer, width, tooth;
  int teeth;
  double x, y, phase_deg;
  std::array<float, 4> color;
};
constexpr std::array gears{Gear{1.0, 4.0, 1.0, 0.7, 20, -3.0, -2.0, 0, {0.8f, 0.1f, 0.0f, 1}},
                           Gear{0.5, 2.0, 2.0, 0.7, 10, 3.1, -2.0, -9, {0.0f, 0.8f, 0.2f, 1}},
                           Gear{1.3, 2.0, 0.5, 0.7, 10, -3.1, 4.2, -25, {0.2f, 0.2f, 1.0f, 1}}};

void gear(const GlTable& gl, const Gear& g) {
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / (4 * g.teeth);
    const bool tip = i % 4 == 1 || i % 4 == 2;
    const double radius = g.outer + (tip ? 0.5 : -0.5) * g.tooth;
    return std::array{radius * std::cos(angle), radius * std::sin(angle), g.inner * std::cos(angle), g.inner * std::sin(angle)};
  };
  gl.Materialfv(GL_FRONT, GL_AMBIENT_AND_DIFFUSE, g.color.data());
  gl.ShadeModel(GL_FLAT);
  for (const int side : {1, -1}) {
    gl.Normal3f(0, 0, static_cast<float>(side));
    gl.Begin(GL_QUAD_STRIP);
    for (int i = 0; i <= 4 * g.teeth; ++i) {
      const auto [x, y, inner_x, inner_y] = at(i);
      side > 0 ? vertex(gl, inner_x, inner_y, g.width / 2) : vertex(gl, x, y, -g.width / 2);
      side > 0 ? vertex(gl, x, y, g.width / 2) : vertex(gl, inner_x, inner_y, -g.width / 2);
    }
    gl.End();
  }
  gl.Begin(GL_QUADS);
  for (int i = 0; i < 4 * g.teeth; ++i) {
    const auto a = at(i), b = at(i + 1);
    gl.Normal3f(static_cast<float>(b[1] - a[1]), static_cast<float>(a[0] - b[0]), 0);
    vertex(gl, a[0], a[1], g.width / 2);
    vertex(gl, a[0], a[1], -g.width / 2);
    vertex(gl, b[0], b[1], -g.width / 2);
    vertex(gl, b[0], b[1], g.width / 2);
  }
  gl.End();
  gl.ShadeModel(GL_SMOOTH);
  gl.Begin(GL_QUAD_STRIP);
  for (int i = 0; i <= 4 * g.teeth; ++i) {
    const auto [x, y, inner_x, inner_y] = at(i);
    gl.Normal3f(static_cast<float>(-inner_x), static_cast<float>(-inner_y), 0);
    vertex(gl, inner_x, inner_y, -g.width / 2);
    vertex(gl, inner_x, inner_y, g.width / 2);
  }
  gl.End();
}

void set_gears(const GlTable& gl) {
  camera(gl, conformance::multiply(conformance::translation(0, 0, -26), conformance::multiply(conformance::rotation(20, 0), conformance::rotation(30, 1))));
  gl.Lightfv(GL_LIGHT0, GL_POSITION, std::array{5.0f, 5.0f, 10.0f, 0.0f}.data());
  for (const GLenum feature : {GL_CULL_FACE, GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_NORMALIZE}) gl.Enable(feature);
}

void draw_gears(const GlTable& gl) {
  for (const Gear& g : gears) {
    gl.PushMatrix();
    gl.Translated(g.x, g.y, 0);
    gl.Rotated(g.phase_deg, 0, 0, 1);
    gear(gl, g);
    gl.PopMatrix();
  }
}

// A floor of one texture, trilinear.

void checker(const GlTable& gl) {
  constexpr int size = 64;
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < size * size; ++i) texels.push_back((i / 8 + i / size / 8) % 2 == 0 ? 220 : 60);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size, size, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
  conformance::filters(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  gl.Enable(GL_TEXTURE_2D);
}

void set_floor(const GlTable& gl) {
  camera(gl, conformance::multiply(conformance::rotation(14, 0), conformance::translation(0, -1.5f, -2)));
  checker(gl);
  conformance::environment_mode(gl, GL_REPLACE);
  gl.Enable(GL_DEPTH_TEST);
}

void ground(const GlTable& gl, int cells) {
  gl.Normal3f(0, 1, 0);
  for (int row = 0; row < cells; ++row) {
    gl.Begin(GL_TRIANGLE_STRIP);
    for (int column = 0; column <= cells; ++column) {
      for (const int z : {row + 1, row}) {
        const double s = 1.0 * column / cells, t = 1.0 * z / cells;
        gl.TexCoord2d(8 * s, 8 * t);
        vertex(gl, 12 * (s - 0.5), 0, -14 * (1 - t));
      }
    }
    gl.End();
  }
}

void draw_floor(const GlTable& gl) { ground(gl, 24); }

// A ball and its shadow by a depth texture [GL1.5 §3.8.14].

GLuint shadow_framebuffer = 0;

void ball(const GlTable& gl) {
  static const conformance::Surface mesh = conformance::sphere(1, 24, 36);
  gl.PushMatrix();
  gl.Translatef(0, 1.2f, -6);
  draw_surface(gl, mesh, [](const conformance::Surface::Point&) { ++vertex_count; });
  gl.PopMatrix();
}

void draw_depths(const GlTable& gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer);
  gl.Viewport(0, 0, shadow_map_size, shadow_map_size);
  gl.PushAttrib(GL_ENABLE_BIT | GL_POLYGON_BIT | GL_SCISSOR_BIT);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  conformance::load_projection(gl, conformance::perspective(60, 1, 2, 20));
  conformance::load_model_view(gl, conformance::multiply(conformance::rotation(60, 0), conformance::translation(0, -7, 2)));
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_TEXTURE_2D);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  gl.PolygonOffset(2, 4);
  ball(gl);
  gl.PopAttrib();
}

void draw_shadowed(const GlTable& gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  camera(gl, conformance::multiply(conformance::rotation(14, 0), conformance::translation(0, -2, -2)));
  ground(gl, 24);
  ball(gl);
}

void set_shadow(const GlTable& gl) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, shadow_map_size, shadow_map_size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  conformance::filters(gl, GL_TEXTURE_2D, GL_LINEAR, GL_LINEAR);
  conformance::wraps(gl, GL_TEXTURE_2D, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  gl.GenFramebuffers(1, &shadow_framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, shadow_framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);

  // Coordinates of the world, taken to the map by the texture matrix.
  camera(gl, conformance::multiply(conformance::rotation(14, 0), conformance::translation(0, -2, -2)));
  constexpr std::array<std::array<float, 4>, 4> axes{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  for (GLenum i = 0; i < 4; ++i) {
    gl.TexGeni(GL_S + i, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
    gl.TexGenfv(GL_S + i, GL_EYE_PLANE, axes[i].data());
    gl.Enable(GL_TEXTURE_GEN_S + i);
  }
  Matrix to_map = conformance::multiply(conformance::translation(0.5f, 0.5f, 0.5f), conformance::scaling(0.5f, 0.5f, 0.5f));
  to_map = conformance::multiply(to_map, conformance::perspective(60, 1, 2, 20));
  to_map = conformance::multiply(to_map, conformance::multiply(conformance::rotation(60, 0), conformance::translation(0, -7, 2)));
  gl.MatrixMode(GL_TEXTURE);
  gl.LoadMatrixf(to_map.data());
  gl.MatrixMode(GL_MODELVIEW);
  gl.Lightfv(GL_LIGHT0, GL_POSITION, std::array{0.0f, 7.0f, -2.0f, 1.0f}.data());
  for (const GLenum feature : {GL_LIGHTING, GL_LIGHT0, GL_DEPTH_TEST, GL_TEXTURE_2D}) gl.Enable(feature);
}

void enable_lights(const GlTable& gl) {
  for (GLenum i = 0; i < 8; ++i) {
    const GLenum light = GL_LIGHT0 + i;
    const auto x = static_cast<float>(i);
    gl.Lightfv(light, GL_DIFFUSE, std::array{0.1f, 0.1f + 0.01f * x, 0.1f, 1.0f}.data());
    gl.Lightfv(light, GL_SPECULAR, std::array{0.1f, 0.1f, 0.1f, 1.0f}.data());
    gl.Lightfv(light, GL_POSITION, std::array{x - 4, 6.0f, 2.0f, 1.0f}.data());
    gl.Lightf(light, GL_LINEAR_ATTENUATION, 0.02f);
    gl.Lightf(light, GL_SPOT_CUTOFF, 80);
    gl.Lightf(light, GL_SPOT_EXPONENT, 2);
    gl.Enable(light);
  }
  gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, std::array{0.4f, 0.4f, 0.4f, 1.0f}.data());
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 20);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  gl.LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
}

}  // namespace

const std::vector<NecessityScene>& necessity_scenes() {
  static const std::vector<NecessityScene> scenes{
      {"gears", "three gears, one light", set_gears, {draw_gears}},
      {"floor", "a floor, trilinear, GL_REPLACE", set_floor, {draw_floor}},
      {"shadow", "a ball on a floor with its shadow from a depth texture", set_shadow, {draw_depths, draw_shadowed}},
  };
  return scenes;
}

void enable_everything(const GlTable& gl) {
  enable_lights(gl);
  gl.ActiveTexture(GL_TEXTURE1);
  checker(gl);
  conformance::environment_mode(gl, GL_MODULATE);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  gl.Enable(GL_TEXTURE_GEN_S);
  gl.Enable(GL_TEXTURE_GEN_T);
  gl.ActiveTexture(GL_TEXTURE0);
  conformance::environment_mode(gl, GL_MODULATE);
  gl.Fogi(GL_FOG_MODE, GL_EXP2);
  gl.Fogf(GL_FOG_DENSITY, 0.02f);
  gl.ClipPlane(GL_CLIP_PLANE0, std::array{0.0, 1.0, 0.0, 20.0}.data());
  gl.AlphaFunc(GL_GREATER, 0.01f);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.PolygonOffset(0.1f, 1);
  gl.Scissor(1, 1, necessity_width_px - 2, necessity_height_px - 2);
  std::array<std::uint8_t, 128> stipple;
  stipple.fill(0xFF);
  stipple[5] = 0x7F;
  gl.PolygonStipple(stipple.data());
  for (const GLenum feature : {GL_LIGHTING, GL_NORMALIZE, GL_DEPTH_TEST, GL_FOG, GL_CLIP_PLANE0, GL_ALPHA_TEST, GL_STENCIL_TEST, GL_BLEND,
                               GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST, GL_POLYGON_STIPPLE}) {
    gl.Enable(feature);
  }
}

long take_vertex_count() { return std::exchange(vertex_count, 0); }

}  // namespace gouraud::speed
