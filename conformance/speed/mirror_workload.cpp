// The scene of demos/mirror: textured and cube-mapped bodies under two lights, one of which throws shadows through a map
// of 4096 x 4096, on a tiled floor of 10,000 quads that reflects them and runs into the fog; and a line of bitmap text.
// Bodies and floor are display lists. Once into the window, and once as a simulator's viewer does it: into a framebuffer
// object with four samples a pixel, which the window then shows.
#include "conformance/speed/mirror_workload.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace gouraud::speed {
namespace {

constexpr int width_px = 1280, height_px = 720, shadow_map_size = 4096;
constexpr float pi = std::numbers::pi_v<float>;
constexpr float air[4] = {0.55f, 0.65f, 0.75f, 1}, black[4] = {0, 0, 0, 1}, ambient[4] = {0.25f, 0.25f, 0.28f, 1};
enum Texture : GLuint { tiles = 1, wood, chrome, shadow_map };
enum List : GLuint { floor_list = 1, ball_list, box_list, ring_list, glyph_list };

std::array<float, 3> unit(const std::array<float, 3>& v) {
  const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}
std::array<float, 3> cross(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

void look_at(const GlTable& gl, const std::array<float, 3>& eye, const std::array<float, 3>& target) {
  const auto forward = unit({target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]});
  const auto side = unit(cross(forward, {0, 1, 0})), above = cross(side, forward);
  const float matrix[16] = {side[0], above[0], -forward[0], 0, side[1], above[1], -forward[1], 0,
                            side[2], above[2], -forward[2], 0, 0,       0,        0,           1};
  gl.MultMatrixf(matrix);
  gl.Translatef(-eye[0], -eye[1], -eye[2]);
}

void perspective(const GlTable& gl, double field_of_view_deg, double aspect, double near_z, double far_z) {
  const double top = near_z * std::tan(field_of_view_deg * std::numbers::pi / 360);
  gl.Frustum(-top * aspect, top * aspect, -top, top, near_z, far_z);
}

constexpr std::array<float, 3> lamp{3.5f, 6, 4};
void lamp_projection(const GlTable& gl) { perspective(gl, 80, 1, 2, 30); }
void lamp_view(const GlTable& gl) { look_at(gl, lamp, {0, 0.5f, 0}); }

/// A checkerboard with its mipmap.
void make_checkers(const GlTable& gl, Texture name, std::uint8_t tone) {
  constexpr std::size_t size = 256;
  std::vector<std::uint8_t> texels;
  for (std::size_t i = 0; i < size * size; ++i) {
    const bool even = (i / 64 + i / size / 64) % 2 == 0;
    const std::uint8_t light = even ? 200 : 120;
    for (const std::uint8_t channel : {light, static_cast<std::uint8_t>(light - tone / 2), static_cast<std::uint8_t>(light - tone)}) {
      texels.push_back(channel);
    }
  }
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
}

/// Brighter towards the top.
void make_chrome(const GlTable& gl) {
  constexpr std::size_t size = 64;
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, chrome);
  gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl.TexParameteri(GL_TEXTURE_CUBE_MAP, wrap, GL_CLAMP_TO_EDGE);
  for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face) {
    std::vector<std::uint8_t> texels;
    for (std::size_t i = 0; i < size * size * 3; ++i) {
      const std::size_t row = face == GL_TEXTURE_CUBE_MAP_POSITIVE_Y ? 0 : face == GL_TEXTURE_CUBE_MAP_NEGATIVE_Y ? size : i / 3 / size;
      texels.push_back(static_cast<std::uint8_t>(220 - 2 * row));
    }
    gl.TexImage2D(face, 0, GL_RGB, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, texels.data());
  }
}

/// A depth texture and the framebuffer object, number 1, that draws into it.
void make_shadow_map(const GlTable& gl) {
  gl.BindTexture(GL_TEXTURE_2D, shadow_map);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, shadow_map_size, shadow_map_size, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  gl.TexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_INTENSITY);
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, shadow_map, 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

/// A framebuffer object with four samples a pixel. Returns its name.
GLuint make_samples(const GlTable& gl) {
  GLuint framebuffer = 0, pictures[2] = {};
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.GenRenderbuffers(2, pictures);
  constexpr GLenum attachments[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_STENCIL_ATTACHMENT}, formats[] = {GL_RGBA8, GL_DEPTH24_STENCIL8};
  for (std::size_t i = 0; i < 2; ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, pictures[i]);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, 4, formats[i], width_px, height_px);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, pictures[i]);
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  return framebuffer;
}

/// A surface of strips: place(u, v) sends the vertex at shares u, v of the way.
template <class Place>
void strips(const GlTable& gl, int columns, int rows, Place place) {
  for (int row = 0; row < rows; ++row) {
    gl.Begin(GL_QUAD_STRIP);
    for (int column = 0; column <= columns; ++column) {
      for (const int side : {1, 0}) {
        place(static_cast<float>(column) / static_cast<float>(columns), static_cast<float>(row + side) / static_cast<float>(rows));
      }
    }
    gl.End();
  }
}

void compile_bodies(const GlTable& gl) {
  gl.NewList(floor_list, GL_COMPILE);
  gl.Normal3f(0, 1, 0);
  strips(gl, 100, 100, [&](float u, float v) {
    gl.TexCoord2f(40 * u, 40 * v);
    gl.Vertex3f(40 * (2 * u - 1), 0, 40 * (1 - 2 * v));
  });
  gl.EndList();
  gl.NewList(ball_list, GL_COMPILE);
  strips(gl, 64, 32, [&](float u, float v) {
    const float latitude = pi * (v - 0.5f), longitude = 2 * pi * u;
    const float x = std::cos(latitude) * std::sin(longitude), y = std::sin(latitude), z = std::cos(latitude) * std::cos(longitude);
    gl.Normal3f(x, y, z);
    gl.Vertex3f(0.9f * x, 0.9f * y, 0.9f * z);
  });
  gl.EndList();
  gl.NewList(ring_list, GL_COMPILE);
  strips(gl, 48, 24, [&](float u, float v) {
    const float around = 2 * pi * u, tube = -2 * pi * v;
    const float x = std::cos(tube) * std::cos(around), y = std::cos(tube) * std::sin(around), z = std::sin(tube);
    gl.Normal3f(x, y, z);
    gl.Vertex3f(0.8f * std::cos(around) + 0.15f * x, 0.8f * std::sin(around) + 0.15f * y, 0.15f * z);
  });
  gl.EndList();
  gl.NewList(box_list, GL_COMPILE);
  gl.Begin(GL_QUADS);
  for (int face = 0; face < 6; ++face) {
    const float sign = face < 3 ? 0.5f : -0.5f;
    std::array<float, 3> normal{}, right{}, up{};
    const auto axis = static_cast<std::size_t>(face % 3);
    normal[axis] = sign;
    right[(axis + 1) % 3] = 0.5f;
    up[(axis + 2) % 3] = sign;
    gl.Normal3f(2 * normal[0], 2 * normal[1], 2 * normal[2]);
    for (const auto& [s, t] : {std::array{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
      gl.TexCoord2f(0.5f + 0.5f * s, 0.5f + 0.5f * t);
      gl.Vertex3f(normal[0] + s * right[0] + t * up[0], normal[1] + s * right[1] + t * up[1], normal[2] + s * right[2] + t * up[2]);
    }
  }
  gl.End();
  gl.EndList();
  constexpr std::uint8_t glyph[8] = {0xC6, 0xC6, 0xFE, 0xC6, 0xC6, 0x6C, 0x38, 0x10};
  gl.NewList(glyph_list, GL_COMPILE);
  gl.Bitmap(8, 8, 0, 0, 9, 0, glyph);
  gl.EndList();
}

void place_lights(const GlTable& gl) {
  const float sky[4] = {-0.4f, 1, 0.3f, 0}, at[4] = {lamp[0], lamp[1], lamp[2], 1}, down[3] = {-lamp[0], 0.5f - lamp[1], -lamp[2]};
  gl.Lightfv(GL_LIGHT0, GL_POSITION, sky);
  gl.Lightfv(GL_LIGHT1, GL_POSITION, at);
  gl.Lightfv(GL_LIGHT1, GL_SPOT_DIRECTION, down);
}

void chrome_ball(const GlTable& gl) {
  constexpr GLenum coordinates[] = {GL_S, GL_T, GL_R};
  constexpr GLenum generators[] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R};
  gl.BindTexture(GL_TEXTURE_CUBE_MAP, chrome);
  gl.Enable(GL_TEXTURE_CUBE_MAP);
  for (std::size_t i = 0; i < 3; ++i) {
    gl.TexGeni(coordinates[i], GL_TEXTURE_GEN_MODE, GL_REFLECTION_MAP);
    gl.Enable(generators[i]);
  }
  gl.Color3f(0.9f, 0.9f, 0.95f);
  gl.PushMatrix();
  gl.Translatef(0, 1.2f, 0);
  gl.CallList(ball_list);
  gl.PopMatrix();
  for (const GLenum generator : generators) gl.Disable(generator);
  gl.Disable(GL_TEXTURE_CUBE_MAP);
}

void bodies(const GlTable& gl) {
  chrome_ball(gl);
  gl.BindTexture(GL_TEXTURE_2D, wood);
  gl.Enable(GL_TEXTURE_2D);
  gl.Color3f(1, 1, 1);
  for (int i = 0; i < 5; ++i) {
    gl.PushMatrix();
    gl.Rotatef(72.0f * static_cast<float>(i), 0, 1, 0);
    gl.Translatef(2.6f, 0.55f, 0);
    gl.CallList(box_list);
    gl.PopMatrix();
  }
  gl.Disable(GL_TEXTURE_2D);
  const float shine[4] = {0.8f, 0.8f, 0.8f, 1};
  gl.Materialfv(GL_FRONT, GL_SPECULAR, shine);
  gl.Materialf(GL_FRONT, GL_SHININESS, 60);
  gl.Color3f(0.8f, 0.2f, 0.15f);
  gl.PushMatrix();
  gl.Translatef(0, 2.9f, 0);
  gl.Rotatef(40, 1, 0.3f, 0);
  gl.CallList(ring_list);
  gl.PopMatrix();
  gl.Materialfv(GL_FRONT, GL_SPECULAR, black);
}

void tiled_floor(const GlTable& gl, float alpha) {
  gl.BindTexture(GL_TEXTURE_2D, tiles);
  gl.Enable(GL_TEXTURE_2D);
  gl.Color4f(1, 1, 1, alpha);
  gl.CallList(floor_list);
  gl.Disable(GL_TEXTURE_2D);
}

void render_shadow_map(const GlTable& gl) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, 1);
  gl.Viewport(0, 0, shadow_map_size, shadow_map_size);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.MatrixMode(GL_PROJECTION);
  gl.PushMatrix();
  gl.LoadIdentity();
  lamp_projection(gl);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  lamp_view(gl);
  gl.Disable(GL_LIGHTING);
  gl.Enable(GL_POLYGON_OFFSET_FILL);
  bodies(gl);
  gl.CallList(floor_list);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
  gl.Enable(GL_LIGHTING);
  gl.MatrixMode(GL_PROJECTION);
  gl.PopMatrix();
  gl.MatrixMode(GL_MODELVIEW);
}

void reflection(const GlTable& gl) {
  const double above_the_floor[4] = {0, 1, 0, 0};
  gl.ColorMask(0, 0, 0, 0);
  gl.DepthMask(0);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_ALWAYS, 1, 0xFF);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  gl.CallList(floor_list);
  gl.ColorMask(1, 1, 1, 1);
  gl.DepthMask(1);
  gl.StencilFunc(GL_EQUAL, 1, 0xFF);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  gl.PushMatrix();
  gl.Scalef(1, -1, 1);
  place_lights(gl);
  gl.ClipPlane(GL_CLIP_PLANE0, above_the_floor);
  gl.Enable(GL_CLIP_PLANE0);
  gl.FrontFace(GL_CW);
  bodies(gl);
  gl.FrontFace(GL_CCW);
  gl.Disable(GL_CLIP_PLANE0);
  gl.PopMatrix();
  gl.Disable(GL_STENCIL_TEST);
  place_lights(gl);
}

constexpr GLenum generators[] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q};

void enable_shadows(const GlTable& gl) {
  constexpr GLenum coordinates[] = {GL_S, GL_T, GL_R, GL_Q};
  constexpr float axes[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, shadow_map);
  gl.Enable(GL_TEXTURE_2D);
  for (std::size_t i = 0; i < 4; ++i) {
    gl.TexGeni(coordinates[i], GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
    gl.TexGenfv(coordinates[i], GL_EYE_PLANE, axes[i]);
    gl.Enable(generators[i]);
  }
  gl.MatrixMode(GL_TEXTURE);
  gl.LoadIdentity();
  gl.Translatef(0.5f, 0.5f, 0.5f);
  gl.Scalef(0.5f, 0.5f, 0.5f);
  lamp_projection(gl);
  lamp_view(gl);
  gl.MatrixMode(GL_MODELVIEW);
  gl.ActiveTexture(GL_TEXTURE0);
}

void disable_shadows(const GlTable& gl) {
  gl.ActiveTexture(GL_TEXTURE1);
  gl.Disable(GL_TEXTURE_2D);
  for (const GLenum generator : generators) gl.Disable(generator);
  gl.ActiveTexture(GL_TEXTURE0);
}

/// The lamp's light, and nothing else, where it reaches.
void lamp_light(const GlTable& gl) {
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  gl.Fogfv(GL_FOG_COLOR, black);
  gl.Disable(GL_LIGHT0);
  gl.Enable(GL_LIGHT1);
  enable_shadows(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  tiled_floor(gl, 1);
  bodies(gl);
  gl.Disable(GL_BLEND);
  disable_shadows(gl);
  gl.Fogfv(GL_FOG_COLOR, air);
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.Disable(GL_LIGHT1);
  gl.Enable(GL_LIGHT0);
}

void legend(const GlTable& gl) {
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_FOG);
  gl.Color3f(0.1f, 0.1f, 0.15f);
  gl.WindowPos2i(10, height_px - 24);
  for (int i = 0; i < 80; ++i) gl.CallList(glyph_list);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_FOG);
}

void draw_scene(const GlTable& gl, GLuint framebuffer) {
  render_shadow_map(gl);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, width_px, height_px);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  gl.LoadIdentity();
  look_at(gl, {0, 3.2f, 9.5f}, {0, 1, 0});
  place_lights(gl);
  reflection(gl);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  tiled_floor(gl, 0.75f);
  gl.Disable(GL_BLEND);
  bodies(gl);
  lamp_light(gl);
  legend(gl);
}

void prepare(const GlTable& gl) {
  make_checkers(gl, tiles, 40);
  make_checkers(gl, wood, 100);
  make_chrome(gl);
  make_shadow_map(gl);
  compile_bodies(gl);
  gl.MatrixMode(GL_PROJECTION);
  perspective(gl, 42, static_cast<double>(width_px) / height_px, 0.5, 80);
  gl.MatrixMode(GL_MODELVIEW);
  const float warm[4] = {0.75f, 0.7f, 0.6f, 1}, cool[4] = {0.2f, 0.25f, 0.35f, 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  gl.Lightfv(GL_LIGHT0, GL_DIFFUSE, cool);
  gl.Lightfv(GL_LIGHT1, GL_DIFFUSE, warm);
  gl.Lightfv(GL_LIGHT1, GL_SPECULAR, warm);
  gl.Lightf(GL_LIGHT1, GL_SPOT_CUTOFF, 40);
  gl.Lightf(GL_LIGHT1, GL_SPOT_EXPONENT, 8);
  gl.PolygonOffset(2, 4);
  for (const GLenum feature : {GL_LIGHT0, GL_LIGHTING, GL_COLOR_MATERIAL, GL_DEPTH_TEST, GL_CULL_FACE, GL_NORMALIZE, GL_FOG}) {
    gl.Enable(feature);
  }
  gl.DepthFunc(GL_LEQUAL);
  gl.Fogfv(GL_FOG_COLOR, air);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_START, 12);
  gl.Fogf(GL_FOG_END, 36);
  gl.ClearColor(air[0], air[1], air[2], 1);
}

Frame mirror(const GlTable& gl) {
  prepare(gl);
  return [](const GlTable& table) { draw_scene(table, 0); };
}

Frame mirror_in_samples(const GlTable& gl) {
  prepare(gl);
  return [framebuffer = make_samples(gl)](const GlTable& table) {
    draw_scene(table, framebuffer);
    table.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    table.BlitFramebuffer(0, 0, width_px, height_px, 0, 0, width_px, height_px, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  };
}

}  // namespace

std::vector<Workload> mirror_workload() {
  return {{"mirror", "shadow map, reflection, cube map, fog, text", width_px, height_px, mirror},
          {"mirror_in_samples", "the same with 4 samples a pixel, resolved", width_px, height_px, mirror_in_samples}};
}

}  // namespace gouraud::speed
