// Texture images from the framebuffer, compressed, and through display lists [GL1.5 §3.8.2, §3.8.3, §5.4].
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

void expect_error(GLenum error, int line) { EXPECT_EQ(glGetError(), error) << "line " << line; }
#define EXPECT_GL(error, call) \
  do {                         \
    call;                      \
    expect_error(error, __LINE__); \
  } while (false)

using Bytes = std::vector<std::uint8_t>;

Bytes texels(GLenum target, GLenum format, std::size_t count, GLint level = 0) {
  Bytes bytes(count, 0xEE);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(target, level, format, GL_UNSIGNED_BYTE, bytes.data());
  return bytes;
}

/// Pixel (x, y) has red x and green y, in bytes, and alpha 128.
void paint() {
  glEnable(GL_SCISSOR_TEST);
  for (int y = 0; y < side_px; ++y) {
    for (int x = 0; x < side_px; ++x) {
      glScissor(x, y, 1, 1);
      glClearColor(static_cast<float>(x) / 255.0f, static_cast<float>(y) / 255.0f, 1.0f, 128.0f / 255.0f);
      glClear(GL_COLOR_BUFFER_BIT);
    }
  }
  glDisable(GL_SCISSOR_TEST);
}

TEST(CopyTexture, TakesColorsOfTheFramebuffer) {
  Screen screen;
  paint();
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 3, 5, 2, 2, 0));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, 16), (Bytes{3, 5, 255, 128, 4, 5, 255, 128, 3, 6, 255, 128, 4, 6, 255, 128}));
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 3, 5, 1, 1, 0));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, 4), (Bytes{3, 5, 255, 255}));
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RED, 3, 5, 1, 1, 0));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, 4), (Bytes{3, 0, 0, 255}));
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RG16, 3, 5, 1, 1, 0));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGBA, 4), (Bytes{3, 5, 0, 255}));
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 3, 5, 1, 1, 0));
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE_ALPHA, 7, 9, 2, 0));
  EXPECT_EQ(texels(GL_TEXTURE_1D, GL_LUMINANCE_ALPHA, 4), (Bytes{7, 128, 8, 128}));
  EXPECT_GL(GL_NO_ERROR, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 20, 21, 1, 1));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGB, 3), (Bytes{20, 21, 255}));
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGB, 1, 1, 2, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_GL(GL_NO_ERROR, glCopyTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 1, 2, 3, 1, 1));
  EXPECT_EQ(texels(GL_TEXTURE_3D, GL_RGB, 6), (Bytes{0, 0, 0, 2, 3, 255}));
}

TEST(CopyTexture, WhatLiesOutsideChangesNothing) {
  Screen screen;
  paint();
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 31, -1, 2, 2, 0));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_LUMINANCE, 4), (Bytes{0, 0, 31, 0}));
  EXPECT_GL(GL_NO_ERROR, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, -2147483647 - 1, 2147483647, 2, 2));
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_LUMINANCE, 4), (Bytes{0, 0, 31, 0}));
}

TEST(CopyTexture, TakesDepthAndPixelTransfer) {
  Screen screen;
  glClearDepth(0.25);
  glClear(GL_DEPTH_BUFFER_BIT);
  EXPECT_GL(GL_NO_ERROR, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, 1, 1, 0));
  GLfloat depth = 0;
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  EXPECT_NEAR(depth, 0.25f, 1e-7);
  paint();
  glPixelTransferf(GL_BLUE_SCALE, 0.0f);
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 3, 4, 1, 1, 0);
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RGB, 3), (Bytes{3, 4, 0}));
}

TEST(CopyTexture, Refuses) {
  Screen screen;
  EXPECT_GL(GL_INVALID_ENUM, glCopyTexImage2D(GL_TEXTURE_2D, 0, 3, 0, 0, 1, 1, 0));
  EXPECT_GL(GL_INVALID_ENUM, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_BGRA, 0, 0, 1, 1, 0));
  EXPECT_GL(GL_INVALID_ENUM, glCopyTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 0, 0, 1, 1, 0));
  EXPECT_GL(GL_INVALID_ENUM, glCopyTexImage2D(GL_TEXTURE_1D, 0, GL_RGB, 0, 0, 1, 1, 0));
  EXPECT_GL(GL_INVALID_VALUE, glCopyTexImage2D(GL_TEXTURE_2D, -1, GL_RGB, 0, 0, 1, 1, 0));
  EXPECT_GL(GL_INVALID_VALUE, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 16385, 1, 0));
  EXPECT_GL(GL_INVALID_VALUE, glCopyTexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 0, GL_RGB, 0, 0, 2, 1, 0));
  EXPECT_GL(GL_INVALID_OPERATION, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 1, 1));
  glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 4, 4, 0);
  EXPECT_GL(GL_INVALID_VALUE, glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 3, 3, 0, 0, 2, 1));
  Context no_depth({0, 0, 0}, nullptr);
  ASSERT_TRUE(no_depth.set_window_size(8, 8, pipeline::ColorFormat::rgba8));
  make_current(&no_depth);
  EXPECT_GL(GL_INVALID_OPERATION, glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 0, 0, 1, 1, 0));
}

// One block of DXT1: red and blue, the left half of each row red.
constexpr std::array<std::uint8_t, 8> red_and_blue{0x00, 0xF8, 0x1F, 0x00, 0x50, 0x50, 0x50, 0x50};

TEST(CompressedTexture, IsDecodedAndKept) {
  Screen screen;
  EXPECT_GL(GL_NO_ERROR, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, 8, red_and_blue.data()));
  const Bytes row{255, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 255};
  const Bytes all = texels(GL_TEXTURE_2D, GL_RGB, 48);
  EXPECT_EQ(Bytes(all.begin(), all.begin() + 12), row);
  std::array<std::uint8_t, 8> back{};
  glGetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
  EXPECT_EQ(back, red_and_blue);
  GLint count = 0;
  glGetIntegerv(GL_NUM_COMPRESSED_TEXTURE_FORMATS, &count);
  ASSERT_EQ(count, 3);
  std::array<GLint, 3> formats{};
  glGetIntegerv(GL_COMPRESSED_TEXTURE_FORMATS, formats.data());
  EXPECT_EQ(formats[2], GL_COMPRESSED_RGBA_S3TC_DXT5_EXT);
}

TEST(CompressedTexture, BlocksAreReplacedWhole) {
  Screen screen;
  const Bytes zeros(32);
  glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 7, 5, 0, 32, zeros.data());
  EXPECT_GL(GL_NO_ERROR, glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 4, 4, 3, 1, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, red_and_blue.data()));
  Bytes blocks(32);
  glGetCompressedTexImage(GL_TEXTURE_2D, 0, blocks.data());
  EXPECT_EQ(std::memcmp(blocks.data() + 24, red_and_blue.data(), 8), 0);
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_RED, 35)[32], 255);
  EXPECT_GL(GL_INVALID_OPERATION, glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 2, 0, 4, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, zeros.data()));
  EXPECT_GL(GL_INVALID_OPERATION, glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT1_EXT, 8, zeros.data()));
  EXPECT_GL(GL_INVALID_VALUE, glCompressedTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 9, zeros.data()));
}

TEST(CompressedTexture, Refuses) {
  Screen screen;
  const Bytes blocks(64);
  const void* const p = blocks.data();
  EXPECT_GL(GL_INVALID_ENUM, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB, 4, 4, 0, 8, p));
  EXPECT_GL(GL_INVALID_ENUM, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, 8, p));
  EXPECT_GL(GL_INVALID_ENUM, glCompressedTexImage1D(GL_TEXTURE_1D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 0, 8, p));
  EXPECT_GL(GL_INVALID_ENUM, glCompressedTexImage3D(GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 1, 0, 8, p));
  EXPECT_GL(GL_INVALID_VALUE, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 5, 4, 0, 8, p));
  EXPECT_GL(GL_INVALID_VALUE, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 0, -8, p));
  EXPECT_GL(GL_INVALID_OPERATION, glCompressedTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 4, 4, 1, 8, p));
}

TEST(TextureLists, ProxiesAreAskedAtOnce) {
  Screen screen;
  glNewList(1, GL_COMPILE);
  glTexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 64, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  glEndList();
  GLint width = -1;
  glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
  EXPECT_EQ(width, 64);
}

/// The state that the context's next draw has.
const pipeline::TextureUnitState& drawn_unit(Screen& screen) {
  screen.context.refresh();
  EXPECT_EQ(screen.context.draw_state().texturing.count, 1);
  return screen.context.draw_state().texturing.unit[0];
}

TEST(TextureLifetime, ADrawKeepsItsTextureAndAChangeInPlaceKeepsTheTexture) {
  Screen screen;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glEnable(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  Bytes grey(16, 100);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey.data());
  const pipeline::Texture* const first = drawn_unit(screen).texture;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey.data());
  EXPECT_EQ(drawn_unit(screen).texture, first) << "nobody else has it";
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey.data());
  EXPECT_NE(drawn_unit(screen).texture, first);
}

TEST(TextureLifetime, WhatAnotherContextUsesIsCopiedBeforeAChange) {
  Screen first;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glBindTexture(GL_TEXTURE_2D, 1);
  glEnable(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  const Bytes grey(16, 100);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 4, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey.data());
  const pipeline::Texture* const texture = drawn_unit(first).texture;
  Screen second(&first.context);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glBindTexture(GL_TEXTURE_2D, 1);
  const Bytes white(1, 255);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, white.data());
  EXPECT_EQ(texels(GL_TEXTURE_2D, GL_LUMINANCE, 16)[0], 255);
  EXPECT_EQ(std::to_integer<int>(texture->faces[0][0].texels[0]), 100);
  make_current(&first.context);
  glBindTexture(GL_TEXTURE_2D, 1);
  EXPECT_NE(drawn_unit(first).texture, texture) << "seen when it is bound";
}

}  // namespace
}  // namespace gouraud::api
