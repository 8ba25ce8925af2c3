#include "conformance/speed/pixel_workloads.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace gouraud::speed {
namespace {

constexpr int width_px = 1920, height_px = 1080, texture_size = 1024;
/// A frame does its work so often: what Finish shows of it counts for little.
constexpr int times = 10;

std::vector<std::uint8_t> noise(int width, int height, int bytes_per_pixel) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                  static_cast<std::size_t>(bytes_per_pixel));
  std::uint32_t state = 1;
  for (std::uint8_t& byte : bytes) {
    state = state * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(state >> 24);
  }
  return bytes;
}

/// A triangle over most of the picture, so that there is something to read.
void draw_something(const GlTable& gl) {
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Begin(GL_TRIANGLES);
  gl.Color3f(1, 0, 0);
  gl.Vertex3f(-1, -1, 0);
  gl.Color3f(0, 1, 0);
  gl.Vertex3f(1, -1, 0.5f);
  gl.Color3f(0, 0, 1);
  gl.Vertex3f(0, 1, -0.5f);
  gl.End();
}

template <GLenum format, GLenum type, int bytes_per_pixel>
Frame read_pixels(const GlTable& gl) {
  draw_something(gl);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  return [memory = noise(width_px, height_px, bytes_per_pixel)](const GlTable& table) mutable {
    for (int i = 0; i < times; ++i) table.ReadPixels(0, 0, width_px, height_px, format, type, memory.data());
  };
}

template <GLenum format, int bytes_per_pixel>
Frame draw_pixels(const GlTable& gl) {
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.RasterPos2i(-1, -1);
  return [image = noise(width_px, height_px, bytes_per_pixel)](const GlTable& table) {
    for (int i = 0; i < times; ++i) table.DrawPixels(width_px, height_px, format, GL_UNSIGNED_BYTE, image.data());
  };
}

Frame copy_pixels(const GlTable& gl) {
  draw_something(gl);
  gl.Disable(GL_DEPTH_TEST);
  gl.RasterPos2i(-1, -1);
  return [](const GlTable& table) {
    for (int i = 0; i < times; ++i) table.CopyPixels(0, 0, width_px, height_px, GL_COLOR);
  };
}

void bind_texture(const GlTable& gl, GLint min_filter) {
  gl.BindTexture(GL_TEXTURE_2D, 1);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min_filter);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, texture_size, texture_size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.Enable(GL_TEXTURE_2D);
}

/// A small quad that uses the texture: what changes it next has to know.
void draw_a_little(const GlTable& gl) {
  gl.Begin(GL_QUADS);
  for (const auto& [s, t] : {std::pair{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
    gl.TexCoord2f(s, t);
    gl.Vertex2f(0.1f * s, 0.1f * t);
  }
  gl.End();
}

Frame copy_to_texture(const GlTable& gl) {
  draw_something(gl);
  gl.Disable(GL_DEPTH_TEST);
  bind_texture(gl, GL_LINEAR);
  return [](const GlTable& table) {
    for (int i = 0; i < times; ++i) {
      table.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 100 + i, 20, texture_size, texture_size);
      draw_a_little(table);
    }
  };
}

template <GLenum format, int bytes_per_pixel>
Frame upload(const GlTable& gl) {
  bind_texture(gl, GL_LINEAR);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  return [image = noise(texture_size, texture_size, bytes_per_pixel)](const GlTable& table) {
    for (int i = 0; i < times; ++i) {
      table.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, texture_size, texture_size, format, GL_UNSIGNED_BYTE, image.data());
      draw_a_little(table);
    }
  };
}

/// What no driver can undercut where pixels are stored as the program has them: the C library's copy, by neither driver.
template <int width, int height>
Frame copy_bytes(const GlTable&) {
  return [from = noise(width, height, 4), to = noise(width, height, 4)](const GlTable&) mutable {
    for (int i = 0; i < times; ++i) {
      std::memcpy(to.data(), from.data(), to.size());
      asm volatile("" : : "r"(to.data()) : "memory");  // somebody reads it
    }
  };
}

/// New images with their levels, as a program that loads its textures.
Frame upload_with_mipmaps(const GlTable& gl) {
  bind_texture(gl, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  return [image = noise(texture_size, texture_size, 4)](const GlTable& table) {
    for (int i = 0; i < times; ++i) {
      table.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, texture_size, texture_size, 0, GL_RGBA, GL_UNSIGNED_BYTE, image.data());
      draw_a_little(table);
    }
  };
}

}  // namespace

std::vector<Workload> pixel_workloads() {
  return {
      {"read_pixels", "10 ReadPixels of all, RGBA", width_px, height_px, read_pixels<GL_RGBA, GL_UNSIGNED_BYTE, 4>},
      {"read_pixels_bound", "10 memcpy of as many bytes, no driver", width_px, height_px, copy_bytes<width_px, height_px>},
      {"read_pixels_bgra", "10 ReadPixels of all, BGRA", width_px, height_px, read_pixels<GL_BGRA, GL_UNSIGNED_BYTE, 4>},
      {"read_pixels_rgb", "10 ReadPixels of all, RGB", width_px, height_px, read_pixels<GL_RGB, GL_UNSIGNED_BYTE, 3>},
      {"read_pixels_depth", "10 ReadPixels of all, depth as float", width_px, height_px,
       read_pixels<GL_DEPTH_COMPONENT, GL_FLOAT, 4>},
      {"draw_pixels", "10 DrawPixels of all, RGBA", width_px, height_px, draw_pixels<GL_RGBA, 4>},
      {"draw_pixels_rgb", "10 DrawPixels of all, RGB", width_px, height_px, draw_pixels<GL_RGB, 3>},
      {"copy_pixels", "10 CopyPixels of all", width_px, height_px, copy_pixels},
      {"copy_to_texture", "10 CopyTexSubImage of 1024 x 1024", width_px, height_px, copy_to_texture},
      {"upload", "10 TexSubImage of 1024 x 1024, RGBA", width_px, height_px, upload<GL_RGBA, 4>},
      {"upload_bound", "10 memcpy of as many bytes, no driver", width_px, height_px, copy_bytes<texture_size, texture_size>},
      {"upload_bgra", "the same, BGRA", width_px, height_px, upload<GL_BGRA, 4>},
      {"upload_rgb", "the same, RGB", width_px, height_px, upload<GL_RGB, 3>},
      {"upload_mipmaps", "10 TexImage of 1024 x 1024, mipmaps made", width_px, height_px, upload_with_mipmaps},
  };
}

}  // namespace gouraud::speed
