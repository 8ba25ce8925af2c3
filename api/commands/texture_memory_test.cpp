// What a texture costs beside its texels: less than one part in a hundred, as uploaded, with mipmaps made, and drawn with.
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "api/commands/test_screen.h"

#if defined(__GLIBC__)
#include <malloc.h>

namespace gouraud::api {
namespace {

std::size_t allocated_bytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

struct Shape {
  GLenum internal_format;
  std::size_t bytes_per_texel, size;
  bool mipmaps;
};

std::size_t texel_bytes(const Shape& shape) {
  std::size_t bytes = 0;
  for (std::size_t size = shape.size; size > 0; size /= 2) {
    bytes += size * size * shape.bytes_per_texel;
    if (!shape.mipmaps) break;
  }
  return bytes;
}

TEST(TextureMemory, IsTheTexelsAndLessThanAHundredthMore) {
  Screen screen;
  const std::vector<std::uint8_t> pixels(std::size_t{1024} * 1024 * 4, std::uint8_t{77});
  const auto draw = [] {
    glEnable(GL_TEXTURE_2D);
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) glVertex2i(i, i * i);
    glEnd();
    glFinish();
  };
  GLuint name = 1;
  for (const Shape& shape : {Shape{GL_RGBA8, 4, 1024, false}, Shape{GL_RGBA8, 4, 1024, true}, Shape{GL_RGB8, 4, 512, true},
                             Shape{GL_LUMINANCE8, 1, 1024, true}, Shape{GL_LUMINANCE8_ALPHA8, 2, 512, true},
                             Shape{GL_RGBA16, 8, 512, false}, Shape{GL_DEPTH_COMPONENT24, 4, 1024, false}}) {
    const bool depth = shape.internal_format == GL_DEPTH_COMPONENT24;
    const auto side = static_cast<GLsizei>(shape.size);
    draw();  // what drawing takes once
    const std::size_t before = allocated_bytes();
    glBindTexture(GL_TEXTURE_2D, name++);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, shape.mipmaps ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, shape.mipmaps ? GL_TRUE : GL_FALSE);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(shape.internal_format), side, side, 0, depth ? GL_DEPTH_COMPONENT : GL_RGBA,
                 GL_UNSIGNED_BYTE, pixels.data());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 64, 64, depth ? GL_DEPTH_COMPONENT : GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    draw();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    const std::size_t texels = texel_bytes(shape);
    EXPECT_LT(static_cast<double>(allocated_bytes() - before), 1.01 * static_cast<double>(texels)) << texels;
  }
}

}  // namespace
}  // namespace gouraud::api
#endif
