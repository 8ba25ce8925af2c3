#include "conformance/scenes/texture_shapes.h"

#include <algorithm>

namespace gouraud::conformance {
namespace {

int channels_of(GLenum format) {
  switch (format) {
    case GL_ALPHA:
    case GL_LUMINANCE:
    case GL_INTENSITY: return 1;
    case GL_LUMINANCE_ALPHA: return 2;
    case GL_RGB: return 3;
    default: return 4;
  }
}

}  // namespace

std::vector<std::uint8_t> noise(int count, std::uint32_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(count));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

std::vector<std::uint8_t> smooth_texels(int width, int height, int channels, std::uint32_t seed) {
  Random random(seed);
  std::vector<std::uint8_t> bytes;
  std::array<int, 4> phase;
  for (int& p : phase) p = random.below(512);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int k = 0; k < channels; ++k) {
        // Triangle waves.
        const int place = (phase[static_cast<std::size_t>(k)] + 512 * (k + 1) * x / width + 512 * (4 - k) * y / height) % 512;
        bytes.push_back(static_cast<std::uint8_t>(place < 256 ? place : 511 - place));
      }
    }
  }
  return bytes;
}

void noise_image(const GlTable& gl, GLenum target, GLint level, GLint internal_format, int width, int height, GLenum format, std::uint32_t seed) {
  const std::vector<std::uint8_t> texels = noise(width * height * channels_of(format), seed);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexImage2D(target, level, internal_format, width, height, 0, format, GL_UNSIGNED_BYTE, texels.data());
}

void colored_levels(const GlTable& gl, GLenum target, int size) {
  constexpr std::array<std::array<std::uint8_t, 4>, 8> colors{{{255, 64, 64, 255}, {64, 255, 64, 255}, {64, 64, 255, 255}, {255, 255, 64, 255},
                                                               {64, 255, 255, 255}, {255, 64, 255, 255}, {230, 230, 230, 255}, {20, 20, 20, 255}}};
  for (int level = 0; size > 0; size /= 2, ++level) {
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < size * size; ++i) texels.insert(texels.end(), colors[static_cast<std::size_t>(level % 8)].begin(), colors[static_cast<std::size_t>(level % 8)].end());
    gl.TexImage2D(target, level, GL_RGBA, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  }
}

void filters(const GlTable& gl, GLenum target, GLint minify, GLint magnify) {
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, minify);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, magnify);
}

void wraps(const GlTable& gl, GLenum target, GLint mode) {
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) gl.TexParameteri(target, axis, mode);
}

void environment_mode(const GlTable& gl, GLint mode) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, mode); }

void textured_rectangle(const GlTable& gl, float left, float bottom, float right, float top, float s0, float t0, float s1, float t1) {
  gl.Begin(GL_QUADS);
  gl.TexCoord2f(s0, t0);
  gl.Vertex2f(left, bottom);
  gl.TexCoord2f(s1, t0);
  gl.Vertex2f(right, bottom);
  gl.TexCoord2f(s1, t1);
  gl.Vertex2f(right, top);
  gl.TexCoord2f(s0, t1);
  gl.Vertex2f(left, top);
  gl.End();
}

void textured_floor(const GlTable& gl, float repeats) {
  look(gl, {.distance = 5, .pitch_deg = 17, .yaw_deg = 21});
  gl.Begin(GL_QUADS);
  for (const auto& [x, z] : {std::array{-3.0f, 3.0f}, {3.0f, 3.0f}, {3.0f, -3.0f}, {-3.0f, -3.0f}}) {
    gl.TexCoord2f(repeats * (x + 3) / 6, repeats * (3 - z) / 6);
    gl.Vertex3f(x, 0, z);
  }
  gl.End();
}

}  // namespace gouraud::conformance
