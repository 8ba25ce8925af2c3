// Texture images in and out: formats, borders, sub-images, proxies, errors [GL1.5 §3.8.1, §3.8.2, §3.8.11, §6.1.4].
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "api/commands/client_pixels.h"
#include "api/commands/test_screen.h"
#include "api/commands/texel_formats.h"

namespace gouraud::api {
namespace {

void expect_error(GLenum error, int line) { EXPECT_EQ(glGetError(), error) << "line " << line; }
#define EXPECT_GL(error, call) \
  do {                         \
    call;                      \
    expect_error(error, __LINE__); \
  } while (false)

using Bytes = std::vector<std::uint8_t>;

GLint level_parameter(GLenum pname, GLenum target = GL_TEXTURE_2D, GLint level = 0) {
  GLint value = -1;
  glGetTexLevelParameteriv(target, level, pname, &value);
  return value;
}

Bytes numbered(std::size_t count) {
  Bytes bytes(count);
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(i * 37 + 11);
  return bytes;
}

/// The image as bytes, tightly packed.
Bytes texels(GLenum target, GLenum format, std::size_t count, GLint level = 0) {
  Bytes bytes(count, 0xEE);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(target, level, format, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

void tex_image(GLsizei width, GLsizei height, GLint internal_format, GLenum format, const Bytes& bytes, GLint border = 0) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, border, format, GL_UNSIGNED_BYTE, bytes.data());
}

TEST(TexImage, BytesComeBackAsTheyWent) {
  Screen screen;
  struct Case {
    GLint internal_format;
    GLenum format;
    std::size_t bytes;
  };
  for (const Case& c : {Case{4, GL_RGBA, 4}, Case{GL_RGBA8, GL_BGRA, 4}, Case{3, GL_RGB, 3}, Case{GL_RGB5, GL_BGR, 3},
                        Case{1, GL_LUMINANCE, 1}, Case{2, GL_LUMINANCE_ALPHA, 2}, Case{GL_ALPHA, GL_ALPHA, 1},
                        Case{GL_RGBA16, GL_RGBA, 4}, Case{GL_RGB12, GL_RGB, 3}, Case{GL_LUMINANCE16, GL_LUMINANCE, 1},
                        Case{GL_LUMINANCE16_ALPHA16, GL_LUMINANCE_ALPHA, 2}, Case{GL_ALPHA12, GL_ALPHA, 1},
                        Case{GL_SRGB8_ALPHA8_EXT, GL_RGBA, 4}, Case{GL_SLUMINANCE_EXT, GL_LUMINANCE, 1},
                        Case{GL_COMPRESSED_RGBA, GL_RGBA, 4}, Case{GL_RG, GL_RG, 2}, Case{GL_RG16, GL_RG, 2},
                        Case{GL_R8, GL_RED, 1}, Case{GL_RGBA8, GL_RG, 2}}) {
    const Bytes bytes = numbered(37 * 5 * c.bytes);
    EXPECT_GL(GL_NO_ERROR, tex_image(37, 5, c.internal_format, c.format, bytes));
    EXPECT_EQ(texels(GL_TEXTURE_2D, c.format, bytes.size()), bytes) << c.internal_format;
  }
}

TEST(TexImage, ComponentsAreThoseOfTheBaseFormat) {
  Screen screen;
  const Bytes pixel{10, 20, 30, 40};
  struct Case {
    GLint internal_format;
    Bytes rgba;
  };
  for (const Case& c : {Case{GL_ALPHA, {0, 0, 0, 40}}, Case{GL_LUMINANCE, {10, 0, 0, 255}}, Case{GL_INTENSITY, {10, 0, 0, 255}},
                        Case{GL_LUMINANCE_ALPHA, {10, 0, 0, 40}}, Case{GL_RGB, {10, 20, 30, 255}},
                        Case{GL_RGBA, pixel}, Case{GL_INTENSITY16, {10, 0, 0, 255}}, Case{GL_RED, {10, 0, 0, 255}},
                        Case{GL_R16, {10, 0, 0, 255}}, Case{GL_RG, {10, 20, 0, 255}}, Case{GL_RG16, {10, 20, 0, 255}}}) {
    tex_image(1, 1, c.internal_format, GL_RGBA, pixel);
    EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, 4), c.rgba) << c.internal_format;
  }
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TexImage, StoredSizesAreTold) {
  Screen screen;
  tex_image(1, 1, GL_RGB4, GL_RGBA, {1, 2, 3, 4});
  EXPECT_EQ(level_parameter(GL_TEXTURE_INTERNAL_FORMAT), GL_RGB4);
  EXPECT_EQ(level_parameter(GL_TEXTURE_RED_SIZE), 8);
  EXPECT_EQ(level_parameter(GL_TEXTURE_ALPHA_SIZE), 0);
  EXPECT_EQ(level_parameter(GL_TEXTURE_COMPRESSED), GL_FALSE);
  tex_image(1, 1, GL_RG, GL_RGBA, {1, 2, 3, 4});
  EXPECT_EQ(level_parameter(GL_TEXTURE_RED_SIZE), 8);
  EXPECT_EQ(level_parameter(GL_TEXTURE_GREEN_SIZE), 8);
  EXPECT_EQ(level_parameter(GL_TEXTURE_BLUE_SIZE), 0);
  constexpr GLint compressed_red = 0x8225;
  tex_image(1, 1, compressed_red, GL_RGBA, {1, 2, 3, 4});
  EXPECT_EQ(level_parameter(GL_TEXTURE_INTERNAL_FORMAT), GL_RED);
  EXPECT_EQ(level_parameter(GL_TEXTURE_RED_SIZE), 8);
  EXPECT_EQ(level_parameter(GL_TEXTURE_GREEN_SIZE), 0);
  tex_image(1, 1, GL_LUMINANCE12_ALPHA4, GL_RGBA, {1, 2, 3, 4});
  EXPECT_EQ(level_parameter(GL_TEXTURE_LUMINANCE_SIZE), 16);
  EXPECT_EQ(level_parameter(GL_TEXTURE_ALPHA_SIZE), 16);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8_EXT, 2, 2, 0, GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT, nullptr);
  EXPECT_EQ(level_parameter(GL_TEXTURE_DEPTH_SIZE), 24);
  EXPECT_EQ(level_parameter(GL_TEXTURE_STENCIL_SIZE_EXT), 8);
  EXPECT_EQ(level_parameter(GL_TEXTURE_RED_SIZE), 0);
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH, GL_TEXTURE_2D, 3), 0);
  EXPECT_EQ(level_parameter(GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_2D, 3), 1);
  EXPECT_EQ(level_parameter(GL_TEXTURE_RED_SIZE, GL_TEXTURE_2D, 3), 0);
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TexImage, BordersAreKept) {
  Screen screen;
  const Bytes bytes = numbered(6 * 4 * 4);
  EXPECT_GL(GL_NO_ERROR, tex_image(6, 4, 4, GL_RGBA, bytes, 1));
  EXPECT_EQ(level_parameter(GL_TEXTURE_BORDER), 1);
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH), 6);
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, bytes.size()), bytes);
  // The lower left border texel is (-1, -1).
  const Bytes red{255, 0, 0, 255};
  EXPECT_GL(GL_NO_ERROR, glTexSubImage2D(GL_TEXTURE_2D, 0, -1, -1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, red.data()));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RED, 24)[0], 255);
  EXPECT_GL(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, -2, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, red.data()));
  EXPECT_GL(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, 5, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, red.data()));
}

TEST(TexImage, EveryTargetAndDimension) {
  Screen screen;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const Bytes bytes = numbered(5 * 5 * 5 * 3);
  glTexImage1D(GL_TEXTURE_1D, 0, GL_RGB, 5, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  EXPECT_EQ(texels(GL_TEXTURE_1D, GL_RGB, 15), Bytes(bytes.begin(), bytes.begin() + 15));
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 5, 5, 5, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  EXPECT_EQ(texels(GL_TEXTURE_3D, GL_RGB, bytes.size()), bytes);
  for (GLenum face = 0; face < 6; ++face) {
    const Bytes color(12, static_cast<std::uint8_t>(face));
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGB, 2, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, color.data());
  }
  EXPECT_EQ(texels(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, GL_RGB, 12), Bytes(12, 3));
  glTexImage2D(GL_TEXTURE_RECTANGLE_ARB, 0, GL_RGB, 3, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
  EXPECT_EQ(level_parameter(GL_TEXTURE_HEIGHT, GL_TEXTURE_RECTANGLE_ARB), 4);
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TexImage, PixelTransferActs) {
  Screen screen;
  glPixelTransferf(GL_GREEN_SCALE, 0.0f);
  glPixelTransferf(GL_BLUE_BIAS, 1.0f);
  tex_image(1, 1, GL_RGB, GL_RGB, {10, 20, 30});
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGB, 3), (Bytes{10, 0, 255}));
}

TEST(TexImage, DepthAndStencil) {
  Screen screen;
  const std::array<GLuint, 2> words{0x80000012, 0xFFFFFF34};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8_EXT, 2, 1, 0, GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT, words.data());
  std::array<GLuint, 2> back{};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL_EXT, GL_UNSIGNED_INT_24_8_EXT, back.data());
  EXPECT_EQ(back, words);
  const std::array<GLfloat, 3> depths{-1.0f, 0.25f, std::nanf("")};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, 3, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  std::array<GLfloat, 3> got{};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, got.data());
  EXPECT_EQ(got, (std::array<GLfloat, 3>{0.0f, 0.25f, 0.0f}));
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TexImage, RefusesWhatIsNoImage) {
  Screen screen;
  const Bytes bytes(64);
  const void* const p = bytes.data();
  const GLenum ub = GL_UNSIGNED_BYTE;
  EXPECT_GL(GL_INVALID_ENUM, glTexImage2D(GL_TEXTURE_1D, 0, 4, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_ENUM, glTexImage2D(GL_TEXTURE_CUBE_MAP, 0, 4, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_ENUM, glTexImage1D(GL_TEXTURE_2D, 0, 4, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_ENUM, glTexImage2D(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_STENCIL_INDEX, ub, p));
  EXPECT_GL(GL_INVALID_ENUM, glTexImage2D(GL_TEXTURE_2D, 0, 4, 1, 1, 0, 0xBAD, ub, p));
  EXPECT_GL(GL_INVALID_ENUM, glTexImage2D(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_RGBA, 0xBAD, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, -1, 4, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 15, 4, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage3D(GL_TEXTURE_3D, 12, 4, 1, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_RECTANGLE_ARB, 1, 4, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, 5, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, GL_BGRA, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, 4, -1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, 4, 16385, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 1, 4, 8193, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage3D(GL_TEXTURE_3D, 0, 4, 1, 1, 2049, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 2, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, -1, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_2D, 0, 4, 2, 4, 1, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_RECTANGLE_ARB, 0, 4, 4, 4, 1, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, 4, 2, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_DEPTH_COMPONENT, ub, p));
  EXPECT_GL(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 1, 1, 0, GL_RGBA, ub, p));
  EXPECT_GL(GL_INVALID_OPERATION, glTexImage3D(GL_TEXTURE_3D, 0, GL_DEPTH_COMPONENT, 1, 1, 1, 0, GL_DEPTH_COMPONENT, ub, p));
  EXPECT_GL(GL_INVALID_OPERATION, glTexImage2D(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_RGBA, GL_UNSIGNED_SHORT_5_6_5, p));
  EXPECT_GL(GL_INVALID_OPERATION,
            glTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 6, 6, 1, GL_RGBA, ub, p));
  glBegin(GL_POINTS);
  glTexImage2D(GL_TEXTURE_2D, 0, 4, 1, 1, 0, GL_RGBA, ub, p);
  glEnd();
  expect_error(GL_INVALID_OPERATION, __LINE__);
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH), 0) << "nothing has changed";
}

TEST(TexImage, TooLargeForMemoryIsOutOfMemory) {
  Screen screen;
  EXPECT_GL(GL_OUT_OF_MEMORY, glTexImage3D(GL_TEXTURE_3D, 0, 4, 2048, 2048, 2048, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr));
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH, GL_TEXTURE_3D), 0);
}

TEST(TexSubImage, ReplacesARegion) {
  Screen screen;
  tex_image(4, 4, GL_LUMINANCE, GL_LUMINANCE, Bytes(16, 1));
  const Bytes twos(4, 2);
  EXPECT_GL(GL_NO_ERROR, glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 2, 2, 2, GL_LUMINANCE, GL_UNSIGNED_BYTE, twos.data()));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_LUMINANCE, 16), (Bytes{1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 1, 1, 2, 2, 1}));
  const void* const p = twos.data();
  const GLenum ub = GL_UNSIGNED_BYTE;
  EXPECT_GL(GL_NO_ERROR, glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 0, 0, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_OPERATION, glTexSubImage2D(GL_TEXTURE_2D, 1, 0, 0, 1, 1, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 0, 2, 1, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, 2147483647, 0, 2, 1, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, -1, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_VALUE, glTexSubImage2D(GL_TEXTURE_2D, 20, 0, 0, 1, 1, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_ENUM, glTexSubImage2D(GL_PROXY_TEXTURE_2D, 0, 0, 0, 1, 1, GL_LUMINANCE, ub, p));
  EXPECT_GL(GL_INVALID_OPERATION, glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_DEPTH_COMPONENT, ub, p));
}

TEST(Proxies, TellWhatWouldFit) {
  Screen screen;
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA16, 64, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH, GL_PROXY_TEXTURE_2D), 64);
  EXPECT_EQ(level_parameter(GL_TEXTURE_GREEN_SIZE, GL_PROXY_TEXTURE_2D), 16);
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH), 0);
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGBA16, 16385, 32, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(level_parameter(GL_TEXTURE_WIDTH, GL_PROXY_TEXTURE_2D), 0);
  EXPECT_EQ(level_parameter(GL_TEXTURE_GREEN_SIZE, GL_PROXY_TEXTURE_2D), 0);
  glTexImage3D(GL_PROXY_TEXTURE_3D, 0, GL_RGBA, 2048, 2048, 2048, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(level_parameter(GL_TEXTURE_DEPTH, GL_PROXY_TEXTURE_3D), 0);
  expect_error(GL_NO_ERROR, __LINE__);
  GLint value = 0;
  std::array<GLubyte, 4> pixel{};
  EXPECT_GL(GL_INVALID_ENUM, glGetTexImage(GL_PROXY_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data()));
  EXPECT_GL(GL_INVALID_ENUM, glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WRAP_S, &value));
  EXPECT_GL(GL_INVALID_ENUM, glGetTexLevelParameteriv(GL_TEXTURE_CUBE_MAP, 0, GL_TEXTURE_WIDTH, &value));
  EXPECT_GL(GL_INVALID_VALUE, glGetTexLevelParameteriv(GL_TEXTURE_2D, -1, GL_TEXTURE_WIDTH, &value));
  EXPECT_GL(GL_INVALID_OPERATION, glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_COMPRESSED_IMAGE_SIZE, &value));
}

TEST(GetTexImage, RefusesWhatItCannotGive) {
  Screen screen;
  tex_image(1, 1, 4, GL_RGBA, {1, 2, 3, 4});
  std::array<GLubyte, 4> out{};
  EXPECT_GL(GL_INVALID_ENUM, glGetTexImage(GL_TEXTURE_CUBE_MAP, 0, GL_RGBA, GL_UNSIGNED_BYTE, out.data()));
  EXPECT_GL(GL_INVALID_ENUM, glGetTexImage(GL_TEXTURE_2D, 0, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, out.data()));
  EXPECT_GL(GL_INVALID_VALUE, glGetTexImage(GL_TEXTURE_2D, 15, GL_RGBA, GL_UNSIGNED_BYTE, out.data()));
  EXPECT_GL(GL_INVALID_OPERATION, glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, out.data()));
  EXPECT_GL(GL_INVALID_OPERATION, glGetCompressedTexImage(GL_TEXTURE_2D, 0, out.data()));
  EXPECT_GL(GL_NO_ERROR, glGetTexImage(GL_TEXTURE_2D, 5, GL_RGBA, GL_UNSIGNED_BYTE, out.data()));
  EXPECT_EQ(out, (std::array<GLubyte, 4>{}));
}

TEST(GenerateMipmap, FollowsEveryChangeOfTheBaseLevel) {
  Screen screen;
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  tex_image(4, 4, GL_LUMINANCE, GL_LUMINANCE, Bytes(16, 100));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_LUMINANCE, 1, 2), Bytes{100});
  const Bytes black(8, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 4, GL_LUMINANCE, GL_UNSIGNED_BYTE, black.data());
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_LUMINANCE, 4, 1), (Bytes{0, 100, 0, 100}));
  EXPECT_EQ(level_parameter(GL_TEXTURE_INTERNAL_FORMAT, GL_TEXTURE_2D, 2), GL_LUMINANCE);
  expect_error(GL_NO_ERROR, __LINE__);
}

/// The same image again and again takes the place of its forerunner, but never under the feet of draws that wait.
TEST(TexImage, DrawsThatWaitKeepTheTexelsTheyWereGiven) {
  for (const bool mipmap : {false, true}) {
    for (const GLsizei size : {16, 512}) {
      Screen screen;
      glMatrixMode(GL_PROJECTION);
      glOrtho(0, side_px, 0, side_px, -1, 1);
      glEnable(GL_TEXTURE_2D);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, mipmap ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, mipmap ? GL_TRUE : GL_FALSE);
      constexpr int stripes = 8, stripe_px = side_px / stripes;
      for (int i = 0; i < stripes; ++i) {
        tex_image(size, size, GL_RGBA, GL_RGBA, Bytes(static_cast<std::size_t>(size * size * 4), static_cast<std::uint8_t>(20 * i + 7)));
        glBegin(GL_QUADS);
        for (const auto& [x, y] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          glTexCoord2i(x, y);
          glVertex2i(x * side_px, (i + y) * stripe_px);
        }
        glEnd();
      }
      const std::vector<std::uint32_t> pixels = screen.pixels();
      for (int i = 0; i < stripes; ++i) {
        EXPECT_EQ(pixels[static_cast<std::size_t>(i * stripe_px * side_px)], 0x01010101u * static_cast<std::uint32_t>(20 * i + 7));
      }
      EXPECT_GL(static_cast<GLenum>(GL_NO_ERROR), static_cast<void>(0));
    }
  }
}

TEST(GenerateMipmap, AnImageOfTheSameShapeRemakesItsLevels) {
  Screen screen;
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  for (const std::uint8_t value : {std::uint8_t{10}, std::uint8_t{200}, std::uint8_t{99}}) {
    tex_image(512, 256, GL_RGBA, GL_RGBA, Bytes(512 * 256 * 4, value));
    for (const GLint level : {0, 1, 5, 9}) EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, std::size_t{512} * 256 * 4, level)[0], value) << level;
  }
}

TEST(S3tc, ImagesAreCompressedAndKept) {
  Screen screen;
  Bytes bytes(8 * 8 * 4);
  for (std::size_t i = 0; i < 64; ++i) {
    const auto value = static_cast<std::uint8_t>((i % 8) * 32);
    bytes[4 * i] = bytes[4 * i + 1] = value;
    bytes[4 * i + 3] = 255;
  }
  struct Case {
    GLint format;
    GLint size;
  };
  for (const Case& c : {Case{GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 32}, Case{GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 32},
                        Case{GL_COMPRESSED_RGBA_S3TC_DXT3_EXT, 64}, Case{GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 64}}) {
    tex_image(8, 8, c.format, GL_RGBA, bytes);
    EXPECT_EQ(level_parameter(GL_TEXTURE_COMPRESSED), GL_TRUE);
    EXPECT_EQ(level_parameter(GL_TEXTURE_COMPRESSED_IMAGE_SIZE), c.size);
    const Bytes back = texels(GL_TEXTURE_2D, GL_RGBA, bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) EXPECT_NEAR(back[i], bytes[i], 6) << c.format << " " << i;
    Bytes blocks(static_cast<std::size_t>(c.size));
    glGetCompressedTexImage(GL_TEXTURE_2D, 0, blocks.data());
    EXPECT_NE(blocks, Bytes(blocks.size()));
  }
  const Bytes few(4 * 4 * 4, 9);
  EXPECT_GL(GL_NO_ERROR, glTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, few.data()));
  EXPECT_GL(GL_INVALID_OPERATION, glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, few.data()));
  EXPECT_GL(GL_INVALID_OPERATION, glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 4, GL_RGBA, GL_UNSIGNED_BYTE, few.data()));
}

/// Bytes from the pointer to behind the last pixel.
std::size_t extent(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type) {
  constexpr std::uintptr_t pointer = 4096;
  PixelLayout layout;
  layout.element_count = 0;
  ClientImage image;
  if (!find_pixel_layout(context, "", format, type, layout)) glGetError();
  if (width == 0 || height == 0 || layout.element_count == 0) return 0;
  EXPECT_TRUE(locate_unpack(context, "", {width, height}, layout, reinterpret_cast<const void*>(pointer), image));
  return reinterpret_cast<std::uintptr_t>(image.row(height - 1)) + image.row_bytes() - pointer;
}

// Formats x types x sizes x borders: nothing outside the given memory is touched (the sanitizers say so), and floats of
// colours that every format can hold come back.
TEST(TexImage, AnyFormatTypeSizeAndBorder) {
  Screen screen;
  constexpr GLint internal_formats[] = {GL_ALPHA8, GL_LUMINANCE16, GL_LUMINANCE8_ALPHA8, GL_INTENSITY, GL_RGB, GL_RGBA16,
                                        GL_SRGB8_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, GL_DEPTH_COMPONENT16,
                                        GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F};
  constexpr GLenum formats[] = {GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_LUMINANCE,
                                GL_LUMINANCE_ALPHA, GL_COLOR_INDEX, GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL_EXT};
  constexpr GLenum types[] = {GL_BITMAP, GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT,
                              GL_FLOAT, GL_UNSIGNED_BYTE_3_3_2, GL_UNSIGNED_SHORT_5_6_5_REV, GL_UNSIGNED_SHORT_5_5_5_1,
                              GL_UNSIGNED_INT_8_8_8_8_REV, GL_UNSIGNED_INT_2_10_10_10_REV, GL_UNSIGNED_INT_24_8_EXT};
  std::mt19937 random(1);
  const auto pick = [&random](auto& list) { return list[random() % std::size(list)]; };
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    const GLint internal_format = pick(internal_formats);
    const GLenum format = pick(formats), type = pick(types);
    const auto width = static_cast<GLsizei>(random() % 6), height = static_cast<GLsizei>(random() % 6);
    const auto border = static_cast<GLint>(random() % 2);
    const GLint alignment = 1 << random() % 4;
    const auto skip_pixels = static_cast<GLint>(random() % 3), skip_rows = static_cast<GLint>(random() % 3);
    const GLint row_length = random() % 2 == 0 ? 0 : width + skip_pixels;
    const auto store = [&](GLenum unpack, GLenum pack, GLint value) {
      glPixelStorei(unpack, value);
      glPixelStorei(pack, value);
    };
    store(GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT, alignment);
    store(GL_UNPACK_SKIP_PIXELS, GL_PACK_SKIP_PIXELS, skip_pixels);
    store(GL_UNPACK_SKIP_ROWS, GL_PACK_SKIP_ROWS, skip_rows);
    store(GL_UNPACK_ROW_LENGTH, GL_PACK_ROW_LENGTH, row_length);
    // Exactly as much memory as the image takes.
    const std::size_t bytes = extent(screen.context, width, height, format, type);
    const Bytes in(bytes, 0x5A);
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, border, format, type, in.data());
    if (glGetError() != GL_NO_ERROR) continue;
    ++accepted;
    Bytes out(bytes);
    glGetTexImage(GL_TEXTURE_2D, 0, format, type, out.data());
    glGetError();
    if (width > 2 && height > 2 && internal_format != GL_COMPRESSED_RGBA_S3TC_DXT5_EXT) {
      glTexSubImage2D(GL_TEXTURE_2D, 0, 1 - border, 1 - border, width - 1, height - 1, format, type, in.data());
      expect_error(GL_NO_ERROR, __LINE__);
    }
  }
  EXPECT_GT(accepted, 3000);
}

}  // namespace
}  // namespace gouraud::api
