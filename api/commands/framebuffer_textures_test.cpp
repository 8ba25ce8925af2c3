// Textures as attachments: levels, faces, depth; the same texels for whoever samples or queries them.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

GLenum status() { return glCheckFramebufferStatus(GL_FRAMEBUFFER); }

void framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
}

GLuint texture_2d(GLenum internal_format, GLenum format, GLenum type, GLsizei side) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal_format), side, side, 0, format, type, nullptr);
  return name;
}

std::vector<std::uint32_t> texels(GLenum target, GLint level, std::size_t count) {
  std::vector<std::uint32_t> result(count);
  glGetTexImage(target, level, GL_RGBA, GL_UNSIGNED_BYTE, result.data());
  return result;
}

void clear_to(float r, float g, float b) {
  glClearColor(r, g, b, 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

constexpr std::uint32_t red = 0xFF0000FF, green = 0xFF00FF00, blue = 0xFFFF0000;

TEST(FramebufferTextures, WhatIsDrawnIsInTheTexture) {
  const Screen screen;
  const GLuint name = texture_2d(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 100);
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  clear_to(1, 0, 0);
  EXPECT_EQ(texels(GL_TEXTURE_2D, 0, 10000), std::vector<std::uint32_t>(10000, red));
  const std::uint32_t dot = green;
  glTexSubImage2D(GL_TEXTURE_2D, 0, 99, 98, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &dot);
  std::uint32_t read = 0;
  glReadPixels(99, 98, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &read);
  EXPECT_EQ(read, green);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferTextures, TexelsStayWhenAnImageIsAttached) {
  const Screen screen;
  const GLuint name = texture_2d(GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 2);
  const std::uint8_t given[12] = {1, 2, 3, 4, 5, 6, 0, 0, 7, 8, 9, 10};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 2, 1, 0, GL_RGB, GL_UNSIGNED_BYTE, given);
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  std::uint32_t read[2] = {};
  glReadPixels(0, 0, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[0], 0xFF030201u);
  EXPECT_EQ(read[1], 0xFF060504u);
}

TEST(FramebufferTextures, LevelsAndFacesAreDrawnApart) {
  const Screen screen;
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_CUBE_MAP, name);
  for (GLenum face = GL_TEXTURE_CUBE_MAP_POSITIVE_X; face <= GL_TEXTURE_CUBE_MAP_NEGATIVE_Z; ++face) {
    glTexImage2D(face, 0, GL_RGBA8, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexImage2D(face, 1, GL_RGBA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  }
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, name, 1);
  clear_to(0, 0, 1);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_CUBE_MAP_POSITIVE_Z, name, 0);
  clear_to(1, 0, 0);
  EXPECT_EQ(texels(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 1, 4), std::vector<std::uint32_t>(4, blue));
  EXPECT_EQ(texels(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, 16), std::vector<std::uint32_t>(16, 0));
  EXPECT_EQ(texels(GL_TEXTURE_CUBE_MAP_POSITIVE_Z, 0, 16), std::vector<std::uint32_t>(16, red));
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                        GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE, &value);
  EXPECT_EQ(value, GL_TEXTURE_CUBE_MAP_POSITIVE_Z);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

TEST(FramebufferTextures, ShadowMapsAreDepthAlone) {
  const Screen screen;
  struct {
    GLenum internal_format, format, type;
  } const cases[] = {{GL_DEPTH_COMPONENT, GL_DEPTH_COMPONENT, GL_FLOAT},
                     {GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8}};
  for (const auto& test : cases) {
    const GLuint name = texture_2d(test.internal_format, test.format, test.type, 64);
    framebuffer();
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, name, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
    glClearDepth(0.5);
    glClear(GL_DEPTH_BUFFER_BIT);
    std::vector<float> depths(64 * 64);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    for (const float depth : depths) ASSERT_NEAR(depth, 0.5, 1e-6);
    EXPECT_EQ(glGetError(), GL_NO_ERROR);
  }
}

// Slices of a volume are pictures of their own, and are sampled where they lie.
TEST(FramebufferTextures, SlicesOfAVolume) {
  const Screen screen;
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_3D, name);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const std::vector<std::uint32_t> given(70 * 5 * 4, blue);
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 70, 5, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, given.data());
  framebuffer();
  glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, name, 0, 2);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  clear_to(0, 1, 0);
  std::vector<std::uint32_t> expected = given;
  std::fill(expected.begin() + 70 * 5 * 2, expected.begin() + 70 * 5 * 3, green);
  EXPECT_EQ(texels(GL_TEXTURE_3D, 0, 70 * 5 * 4), expected);
  glTexSubImage3D(GL_TEXTURE_3D, 0, 69, 4, 3, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &green);
  expected.back() = green;
  EXPECT_EQ(texels(GL_TEXTURE_3D, 0, 70 * 5 * 4), expected);
  glFramebufferTexture3D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, name, 0, 4);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT) << "there is no such slice";

  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glEnable(GL_TEXTURE_3D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  for (const float r : {0.6f, 0.9f}) {
    glBegin(GL_QUADS);
    for (const auto& [s, t] : {std::array{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
      glTexCoord3f(s, t, r);
      glVertex2f(2 * s - 1, 2 * t - 1);
    }
    glEnd();
    std::uint32_t pixel = 0;
    glReadPixels(9, 9, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    EXPECT_EQ(pixel, r < 0.7f ? green : blue) << r;
  }
}

TEST(FramebufferTextures, WithoutAlphaItReadsOne) {
  const Screen screen;
  const GLuint name = texture_2d(GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, 8);
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  std::uint8_t rgba[4] = {};
  glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  EXPECT_EQ(rgba[3], 255);
  glClearColor(0, 1, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  EXPECT_EQ(rgba[1], 255);
  EXPECT_EQ(rgba[3], 255);
}

TEST(FramebufferTextures, FloatDepthWithStencil) {
  const Screen screen;
  struct Texel {
    float depth;
    std::uint32_t stencil;
    bool operator==(const Texel&) const = default;
  };
  std::vector<Texel> given(64, {0.25f, 7});
  given[9] = {0.75f, 200};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH32F_STENCIL8, 8, 8, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, given.data());
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, name, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  std::uint8_t stencil = 0;
  glReadPixels(1, 1, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &stencil);
  EXPECT_EQ(stencil, 200);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 1, 1);
  glClearStencil(33);
  glClear(GL_STENCIL_BUFFER_BIT);
  given[0].stencil = 33;
  std::vector<Texel> got(64);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, got.data());
  EXPECT_EQ(got, given);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
}

// Its border is part of the picture.
TEST(FramebufferTextures, BorderedImages) {
  const Screen screen;
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 10, 10, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 1, 10);
  clear_to(0, 1, 0);
  const auto all = texels(GL_TEXTURE_2D, 0, 100);
  EXPECT_EQ(all[0], green);
  EXPECT_EQ(all[1], 0u);
  EXPECT_EQ(all[90], green);
}

TEST(FramebufferTextures, ANewImageTakesTheOldOnesPlace) {
  const Screen screen;
  const GLuint name = texture_2d(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 8);
  framebuffer();
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
  clear_to(1, 0, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 70, 70, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  clear_to(0, 1, 0);
  EXPECT_EQ(texels(GL_TEXTURE_2D, 0, 4900), std::vector<std::uint32_t>(4900, green));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, 8, 8, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_S3TC_DXT1_EXT, 8, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 0, 0, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  glDeleteTextures(1, &name);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
}

TEST(FramebufferTextures, OfFewChannelsAreDrawnAndSampled) {
  const Screen screen;
  const struct {
    GLenum internal_format;
    std::array<int, 4> drawn;  ///< what is read back of 255 * (0.8, 0.4, 0.2, 0.6)
    std::array<int, 4> seen;   ///< and what REPLACE makes of the texel over (0, 51, 102, 153)
  } cases[] = {{GL_LUMINANCE8, {204, 0, 0, 255}, {204, 204, 204, 153}},   {GL_ALPHA8, {0, 0, 0, 153}, {0, 51, 102, 153}},
               {GL_LUMINANCE8_ALPHA8, {204, 0, 0, 153}, {204, 204, 204, 153}}, {GL_INTENSITY8, {204, 0, 0, 255}, {204, 204, 204, 204}},
               {GL_LUMINANCE16, {204, 0, 0, 255}, {204, 204, 204, 153}},  {GL_ALPHA16, {0, 0, 0, 153}, {0, 51, 102, 153}},
               {GL_LUMINANCE16_ALPHA16, {204, 0, 0, 153}, {204, 204, 204, 153}}, {GL_INTENSITY16, {204, 0, 0, 255}, {204, 204, 204, 204}},
               {GL_RED, {204, 0, 0, 255}, {204, 0, 0, 153}}, {GL_RG16, {204, 102, 0, 255}, {204, 102, 0, 153}}};
  const auto pixel = [] {
    std::array<GLubyte, 4> bytes{};
    glReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return std::array<int, 4>{bytes[0], bytes[1], bytes[2], bytes[3]};
  };
  const std::vector<GLubyte> grey(16 * 16, 100);
  for (const auto& c : cases) {
    GLuint name = 0, object = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
    for (int level = 0; level < 5; ++level) {
      glTexImage2D(GL_TEXTURE_2D, level, static_cast<GLint>(c.internal_format), 16 >> level, 16 >> level, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey.data());
    }
    glGenFramebuffers(1, &object);
    glBindFramebuffer(GL_FRAMEBUFFER, object);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
    ASSERT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
    EXPECT_EQ(pixel()[3], 255) << "grey pixels are opaque";
    glClearColor(0.8f, 0.4f, 0.2f, 0.6f);
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(pixel(), c.drawn) << std::hex << c.internal_format;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glColor4ub(0, 51, 102, 153);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(pixel(), c.seen) << std::hex << c.internal_format;
    // A level that is specified anew goes with the others.
    glTexImage2D(GL_TEXTURE_2D, 1, static_cast<GLint>(c.internal_format), 8, 8, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, grey.data());
    glClear(GL_COLOR_BUFFER_BIT);
    glRectf(-1, -1, 1, 1);
    EXPECT_EQ(pixel(), c.seen) << std::hex << c.internal_format;
    glDisable(GL_TEXTURE_2D);
    glDeleteFramebuffers(1, &object);
    glDeleteTextures(1, &name);
  }
}

TEST(FramebufferTextures, Errors) {
  const Screen screen;
  const GLuint name = texture_2d(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 8);
  const auto error_of = [](GLenum textarget, GLuint texture, GLint level) {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, textarget, texture, level);
    return glGetError();
  };
  EXPECT_EQ(error_of(GL_TEXTURE_2D, name, 0), GL_INVALID_OPERATION) << "the window";
  framebuffer();
  EXPECT_EQ(error_of(GL_TEXTURE_2D, 99, 0), GL_INVALID_OPERATION);
  EXPECT_EQ(error_of(GL_TEXTURE_CUBE_MAP_POSITIVE_X, name, 0), GL_INVALID_OPERATION);
  EXPECT_EQ(error_of(GL_TEXTURE_3D, name, 0), GL_INVALID_ENUM);
  EXPECT_EQ(error_of(GL_TEXTURE_2D, name, -1), GL_INVALID_VALUE);
  EXPECT_EQ(error_of(GL_TEXTURE_2D, name, 15), GL_INVALID_VALUE);
  EXPECT_EQ(error_of(GL_TEXTURE_2D, name, 1), GL_NO_ERROR);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
  glGenerateMipmap(GL_TEXTURE_RECTANGLE_ARB);
  EXPECT_EQ(glGetError(), GL_INVALID_ENUM);
  glGenerateMipmap(GL_TEXTURE_2D);
  EXPECT_EQ(glGetError(), GL_NO_ERROR);
  EXPECT_EQ(status(), GL_FRAMEBUFFER_COMPLETE);
}

}  // namespace
}  // namespace gouraud::api
