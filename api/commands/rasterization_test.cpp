#include <algorithm>
#include <array>
#include <limits>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

float real(GLenum pname) {
  std::array<GLfloat, 16> v{};
  glGetFloatv(pname, v.data());
  return v[0];
}

TEST(PointParameter, RefusesNegativeSizesAndKeepsWhatItHas) {
  Screen screen;
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  for (const GLenum pname : {GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX, GL_POINT_FADE_THRESHOLD_SIZE}) {
    const float before = real(pname);
    for (const float bad : {-1.0f, nan}) {
      glPointParameterf(pname, bad);
      EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
      EXPECT_EQ(real(pname), before);
    }
    glPointParameteri(pname, 3);
    EXPECT_EQ(real(pname), 3.0f);
  }
  glPointParameterf(GL_POINT_DISTANCE_ATTENUATION, 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  const GLfloat terms[3] = {0.5f, 0.25f, -1.0f};
  glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, terms);
  std::array<GLfloat, 3> read{};
  glGetFloatv(GL_POINT_DISTANCE_ATTENUATION, read.data());
  EXPECT_EQ(read, (std::array<GLfloat, 3>{0.5f, 0.25f, -1.0f}));
  glPointParameterf(GL_LINE_WIDTH, 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST(LineStipple, ClampsItsFactor) {
  Screen screen;
  EXPECT_EQ(real(GL_LINE_STIPPLE_PATTERN), 65535.0f);
  for (const auto& [given, kept] : {std::array{0, 1}, {-7, 1}, {256, 256}, {100000, 256}}) {
    glLineStipple(given, 0x1234);
    EXPECT_EQ(real(GL_LINE_STIPPLE_REPEAT), static_cast<float>(kept));
  }
  EXPECT_EQ(real(GL_LINE_STIPPLE_PATTERN), static_cast<float>(0x1234));
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(PolygonStipple, ComesBackAsItWent) {
  Screen screen;
  std::array<GLubyte, 128> all{}, given{}, read{};
  glGetPolygonStipple(all.data());
  for (const GLubyte byte : all) EXPECT_EQ(byte, 0xFF);
  for (std::size_t i = 0; i < given.size(); ++i) given[i] = static_cast<GLubyte>(7 * i + 3);
  glPolygonStipple(given.data());
  glGetPolygonStipple(read.data());
  EXPECT_EQ(read, given);

  // The other order of bits in a byte, and what PopAttrib brings back.
  glPushAttrib(GL_POLYGON_STIPPLE_BIT);
  glPixelStorei(GL_UNPACK_LSB_FIRST, 1);
  glPolygonStipple(given.data());
  glGetPolygonStipple(read.data());
  for (std::size_t i = 0; i < given.size(); ++i) {
    GLubyte turned = 0;
    for (int bit = 0; bit < 8; ++bit) turned |= static_cast<GLubyte>((given[i] >> bit & 1) << (7 - bit));
    EXPECT_EQ(read[i], turned);
  }
  glPopAttrib();
  glGetPolygonStipple(read.data());
  EXPECT_EQ(read, given);
  glPolygonStipple(nullptr);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Rasterization, CapsCanBeEnabledAndAskedFor) {
  Screen screen;
  for (const GLenum cap : {GL_POINT_SMOOTH, GL_POINT_SPRITE_ARB, GL_LINE_SMOOTH, GL_LINE_STIPPLE, GL_POLYGON_SMOOTH, GL_POLYGON_STIPPLE,
                           GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT}) {
    EXPECT_EQ(glIsEnabled(cap), GL_FALSE);
    glEnable(cap);
    EXPECT_EQ(glIsEnabled(cap), GL_TRUE);
    EXPECT_EQ(real(cap), 1.0f);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST(PolygonOffset, IsKeptAsGiven) {
  Screen screen;
  glPolygonOffset(-1.5f, -4.0f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_FACTOR), -1.5f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_UNITS), -4.0f);
}

TEST(PolygonOffset, KeepsTheLastOfUnitsAndBias) {
  Screen screen;
  glPolygonOffset(-1.5f, -4.0f);
  glPolygonOffsetEXT(2.0f, 0.25f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_FACTOR_EXT), 2.0f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_BIAS_EXT), 0.25f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_UNITS), 0.0f);
  glPushAttrib(GL_POLYGON_BIT);
  glPolygonOffset(1.0f, 8.0f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_BIAS_EXT), 0.0f);
  glPopAttrib();
  EXPECT_EQ(real(GL_POLYGON_OFFSET_BIAS_EXT), 0.25f);
  EXPECT_EQ(real(GL_POLYGON_OFFSET_UNITS), 0.0f);
}

TEST(PolygonOffset, TakesABiasInWindowDepth) {
  Screen screen;
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_POLYGON_OFFSET_EXT);
  const auto depth_with = [](float bias) {
    glClear(GL_DEPTH_BUFFER_BIT);
    glPolygonOffsetEXT(0.0f, bias);
    glRectf(-1.0f, -1.0f, 1.0f, 1.0f);
    float depth = -1.0f;
    glReadPixels(3, 3, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    return depth;
  };
  for (const float bias : {0.0f, 0.25f, -0.125f, 1e-5f, -0.5f, -3.0f}) {
    EXPECT_NEAR(depth_with(bias), std::max(0.5f + bias, 0.0f), 1.0f / 16777215) << bias;
  }
  EXPECT_NEAR(depth_with(std::numeric_limits<float>::quiet_NaN()), 0.5f, 1.0f / 16777215);
}

// [GL1.5 §3.5.5]: the sum is clamped to [0, 1], however far it lies outside.
TEST(PolygonOffset, KeepsDepthsInTheirRange) {
  Screen screen;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glEnable(GL_POLYGON_OFFSET_FILL);
  for (float steps = -4e7f; steps <= 4e7f; steps += 1e6f) {
    glPolygonOffset(0.0f, steps / 2);  // a unit is two steps
    glRectf(-1.0f, -1.0f, 1.0f, 1.0f);
    float depth = -1.0f;
    glReadPixels(3, 3, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
    EXPECT_NEAR(depth, std::clamp(0.5f + steps / 16777215, 0.0f, 1.0f), 2.0f / 16777215) << steps;
  }
}

// Whatever is asked for: nothing crashes, nothing is read or written out of range.
TEST(Rasterization, SurvivesAbsurdSizesAndPlaces) {
  Screen screen;
  const float values[] = {1e-30f, 0.5f, 1.0f, 254.6f, 255.0f, 1e5f, 1e38f, std::numeric_limits<float>::infinity()};
  const float places[] = {-1e30f, -1e5f, -1.0f, -0.3f, 0.0f, 0.99f, 1.0f, 3.0f, 1e30f, std::numeric_limits<float>::quiet_NaN()};
  const GLenum caps[] = {GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_LINE_STIPPLE, GL_POLYGON_SMOOTH, GL_POLYGON_OFFSET_FILL, GL_POINT_SPRITE_ARB};
  glEnable(GL_DEPTH_TEST);
  glLineStipple(3, 0x5A5A);
  for (unsigned set = 0; set < 64; set += 3) {
    for (unsigned k = 0; k < 6; ++k) (set >> k & 1) != 0 ? glEnable(caps[k]) : glDisable(caps[k]);
    for (const float value : values) {
      glPointSize(value);
      glLineWidth(value);
      glPolygonOffset(value, -value);
      for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_TRIANGLES}) {
        glPolygonMode(GL_FRONT_AND_BACK, set % 2 == 0 ? GL_FILL : GL_LINE);
        glBegin(mode);
        for (const float x : places) {
          for (const float y : places) glVertex3f(x, y, 0.5f * x);
        }
        glEnd();
      }
    }
  }
  glFinish();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace gouraud::api
