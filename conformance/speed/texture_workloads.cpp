#include "conformance/speed/texture_workloads.h"

#include <cstddef>
#include <cstdint>

namespace gouraud::speed {
namespace {

constexpr int width_px = 1920, height_px = 1080, texture_size = 512;

/// A texture of noise with its mipmap, bound to the active unit.
void bind_noise(const GlTable& gl, GLuint name, GLint min_filter, GLint mag_filter) {
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min_filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag_filter);
  std::uint32_t state = name;
  for (int size = texture_size, level = 0; size > 0; size /= 2, ++level) {
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 4);
    for (std::uint8_t& byte : texels) {
      state = state * 1664525u + 1013904223u;
      byte = static_cast<std::uint8_t>(state >> 24);
    }
    gl.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
  gl.Enable(GL_TEXTURE_2D);
}

/// w = 1 - z/2: what leans is in perspective.
void lean(const GlTable& gl) {
  const float projection[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.5f, -0.5f, 0, 0, 0, 1};
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixf(projection);
  gl.MatrixMode(GL_MODELVIEW);
}

/// A full-screen quad that leans back, `repeats` textures across.
void draw_leaning_quad(const GlTable& gl, float repeats, bool two_units) {
  const float corners[4][2] = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  gl.Begin(GL_QUADS);
  for (const auto& [x, y] : corners) {
    const float s = repeats * (x + 2) / 4, t = repeats * (y + 2) / 4;
    if (two_units) {
      gl.MultiTexCoord2f(GL_TEXTURE0, s, t);
      gl.MultiTexCoord2f(GL_TEXTURE1, 0.3f * t, 0.3f * s);
    } else {
      gl.TexCoord2f(s, t);
    }
    gl.Vertex3f(x, y, -0.5f - 0.25f * (y + 2));
  }
  gl.End();
}

constexpr int layers = 10;

Frame quads(const GlTable& gl, GLint min_filter, GLint mag_filter, float repeats) {
  lean(gl);
  bind_noise(gl, 1, min_filter, mag_filter);
  gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  return [repeats](const GlTable& table) {
    table.Clear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < layers; ++i) draw_leaning_quad(table, repeats + 0.01f * static_cast<float>(i), false);
  };
}

Frame multitexture(const GlTable& gl) {
  lean(gl);
  bind_noise(gl, 1, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  gl.ActiveTexture(GL_TEXTURE1);
  bind_noise(gl, 2, GL_LINEAR, GL_LINEAR);
  gl.ActiveTexture(GL_TEXTURE0);
  return [](const GlTable& table) {
    table.Clear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < layers; ++i) draw_leaning_quad(table, 8 + 0.01f * static_cast<float>(i), true);
  };
}

Frame blended_layers(const GlTable& gl) {
  bind_noise(gl, 1, GL_LINEAR, GL_LINEAR);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return [](const GlTable& table) {
    table.Clear(GL_COLOR_BUFFER_BIT);
    for (int i = 0; i < 50; ++i) {
      const float shift = 0.013f * static_cast<float>(i);
      table.Color4f(1, 0.9f, 0.8f, 0.3f);
      table.Begin(GL_QUADS);
      table.TexCoord2f(shift, 0);
      table.Vertex2f(-1, -1);
      table.TexCoord2f(3 + shift, 0);
      table.Vertex2f(1, -1);
      table.TexCoord2f(3 + shift, 2);
      table.Vertex2f(1, 1);
      table.TexCoord2f(shift, 2);
      table.Vertex2f(-1, 1);
      table.End();
    }
  };
}

}  // namespace

std::vector<Workload> texture_workloads() {
  return {
      {"texture_nearest", "10 textured layers in perspective, nearest", width_px, height_px,
       [](const GlTable& gl) { return quads(gl, GL_NEAREST, GL_NEAREST, 4); }},
      {"texture_bilinear", "the same, bilinear", width_px, height_px,
       [](const GlTable& gl) { return quads(gl, GL_LINEAR, GL_LINEAR, 4); }},
      {"texture_trilinear", "the same, trilinear, 16 repeats", width_px, height_px,
       [](const GlTable& gl) { return quads(gl, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, 16); }},
      {"texture_two_units", "10 layers of two textures, trilinear and bilinear", width_px, height_px, multitexture},
      {"texture_blended", "50 blended textured layers, bilinear", width_px, height_px, blended_layers},
  };
}

}  // namespace gouraud::speed
