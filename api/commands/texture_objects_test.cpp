// Texture objects, their parameters, environments and attribute group [GL1.5 §3.8.4, §3.8.12, §3.8.13, §6.1.14].
#include <gtest/gtest.h>

#include <array>
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

GLint get(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}
GLint parameter(GLenum pname, GLenum target = GL_TEXTURE_2D) {
  GLint value = -1;
  glGetTexParameteriv(target, pname, &value);
  return value;
}

TEST(TextureObjects, NamesBecomeObjectsWhenTheyAreBound) {
  Screen screen;
  std::array<GLuint, 3> names{};
  glGenTextures(3, names.data());
  EXPECT_EQ(names, (std::array<GLuint, 3>{1, 2, 3}));
  EXPECT_FALSE(glIsTexture(2));
  glBindTexture(GL_TEXTURE_3D, 2);
  EXPECT_TRUE(glIsTexture(2));
  EXPECT_FALSE(glIsTexture(0));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_3D), 2);
  glBindTexture(GL_TEXTURE_CUBE_MAP, 77);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_CUBE_MAP), 77);
  EXPECT_GL(GL_INVALID_OPERATION, glBindTexture(GL_TEXTURE_2D, 2));
  EXPECT_GL(GL_INVALID_ENUM, glBindTexture(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 5));
  EXPECT_GL(GL_INVALID_VALUE, glGenTextures(-1, names.data()));
  EXPECT_GL(GL_INVALID_VALUE, glDeleteTextures(-1, names.data()));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
}

TEST(TextureObjects, ADeletedObjectIsUnboundFromEveryUnit) {
  Screen screen;
  for (const GLenum unit : {GL_TEXTURE0, GL_TEXTURE5}) {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, 4);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const std::array<GLuint, 3> names{0, 4, 99};
  EXPECT_GL(GL_NO_ERROR, glDeleteTextures(3, names.data()));
  EXPECT_FALSE(glIsTexture(4));
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
  glActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
  glBindTexture(GL_TEXTURE_2D, 4);
  EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER), GL_LINEAR) << "a new object";
}

TEST(TextureObjects, AreSharedButTheDefaultIsNot) {
  Screen first;
  glBindTexture(GL_TEXTURE_2D, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
  glBindTexture(GL_TEXTURE_2D, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP);
  Screen second(&first.context);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_T), GL_REPEAT);
  glBindTexture(GL_TEXTURE_2D, 1);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP);
  const GLuint name = 1;
  make_current(&first.context);
  glBindTexture(GL_TEXTURE_2D, 1);
  make_current(&second.context);
  glDeleteTextures(1, &name);
  make_current(&first.context);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP) << "lives on where it is bound";
  EXPECT_FALSE(glIsTexture(1));
}

TEST(TextureObjects, PrioritiesAndResidence) {
  Screen screen;
  glBindTexture(GL_TEXTURE_1D, 3);
  const std::array<GLuint, 3> names{3, 0, 8};
  const std::array<GLfloat, 3> priorities{2.0f, 0.5f, 0.5f};
  EXPECT_GL(GL_NO_ERROR, glPrioritizeTextures(3, names.data(), priorities.data()));
  GLfloat priority = 0;
  glGetTexParameterfv(GL_TEXTURE_1D, GL_TEXTURE_PRIORITY, &priority);
  EXPECT_EQ(priority, 1.0f);
  GLboolean residences[3];
  EXPECT_TRUE(glAreTexturesResident(1, names.data(), residences));
  EXPECT_GL(GL_INVALID_VALUE, EXPECT_FALSE(glAreTexturesResident(2, names.data(), residences)));
  EXPECT_GL(GL_INVALID_VALUE, EXPECT_FALSE(glAreTexturesResident(-1, names.data(), residences)));
  EXPECT_EQ(parameter(GL_TEXTURE_RESIDENT, GL_TEXTURE_1D), GL_TRUE);
}

TEST(TextureParameters, HaveTheInitialValuesOfTable6_16) {
  Screen screen;
  for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}) {
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER, target), GL_NEAREST_MIPMAP_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_MAG_FILTER, target), GL_LINEAR);
    EXPECT_EQ(parameter(GL_TEXTURE_WRAP_R, target), GL_REPEAT);
    EXPECT_EQ(parameter(GL_TEXTURE_MAX_LEVEL, target), 1000);
    EXPECT_EQ(parameter(GL_TEXTURE_MIN_LOD, target), -1000);
    EXPECT_EQ(parameter(GL_TEXTURE_COMPARE_FUNC, target), GL_LEQUAL);
    EXPECT_EQ(parameter(GL_DEPTH_TEXTURE_MODE, target), GL_LUMINANCE);
    EXPECT_EQ(parameter(GL_GENERATE_MIPMAP, target), GL_FALSE);
  }
  EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER, GL_TEXTURE_RECTANGLE_ARB), GL_LINEAR);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S, GL_TEXTURE_RECTANGLE_ARB), GL_CLAMP_TO_EDGE);
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TextureParameters, AreSetAndGotInEveryType) {
  Screen screen;
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, static_cast<GLfloat>(GL_LINEAR));
  EXPECT_EQ(parameter(GL_TEXTURE_MIN_FILTER), GL_LINEAR);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_LOD, 2.75f);
  EXPECT_EQ(parameter(GL_TEXTURE_MAX_LOD), 3);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 7);
  EXPECT_EQ(parameter(GL_TEXTURE_BASE_LEVEL), 7);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 100.0f);
  EXPECT_EQ(parameter(GL_TEXTURE_MAX_ANISOTROPY_EXT), 16);
  const std::array<GLfloat, 4> color{-1.0f, 0.5f, 2.0f, 1.0f};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, color.data());
  std::array<GLfloat, 4> got{};
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, got.data());
  EXPECT_EQ(got, (std::array<GLfloat, 4>{0.0f, 0.5f, 1.0f, 1.0f}));
  std::array<GLint, 4> ints{0, 2147483647, 0, 2147483647};
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, ints.data());
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, ints.data());
  EXPECT_EQ(ints[1], 2147483647);
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TextureParameters, RefuseWhatTheyDoNotKnow) {
  Screen screen;
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WIDTH, 1));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_RESIDENT, 1));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_NEAREST));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, -1e38f));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_REPEAT));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_LEQUAL));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_NONE));
  EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, GL_RGB));
  EXPECT_GL(GL_INVALID_VALUE, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1));
  EXPECT_GL(GL_INVALID_VALUE, glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, -1));
  EXPECT_GL(GL_INVALID_VALUE, glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5f));
  for (const GLint mode : {GL_REPEAT, GL_MIRRORED_REPEAT}) {
    EXPECT_GL(GL_INVALID_ENUM, glTexParameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_WRAP_S, mode));
  }
  EXPECT_GL(GL_INVALID_ENUM,
            glTexParameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST));
  EXPECT_GL(GL_INVALID_OPERATION, glTexParameteri(GL_TEXTURE_RECTANGLE_ARB, GL_TEXTURE_BASE_LEVEL, 1));
  GLint value = 0;
  EXPECT_GL(GL_INVALID_ENUM, glGetTexParameteriv(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WRAP_S, &value));
  EXPECT_GL(GL_INVALID_ENUM, glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WIDTH, &value));
  glBegin(GL_POINTS);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
  glEnd();
  expect_error(GL_INVALID_OPERATION, __LINE__);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_REPEAT);
}

GLint environment(GLenum pname, GLenum target = GL_TEXTURE_ENV) {
  GLint value = -1;
  glGetTexEnviv(target, pname, &value);
  return value;
}

TEST(TextureEnvironment, IsOfTheActiveUnit) {
  Screen screen;
  EXPECT_EQ(environment(GL_TEXTURE_ENV_MODE), GL_MODULATE);
  EXPECT_EQ(environment(GL_SRC0_RGB), GL_TEXTURE);
  EXPECT_EQ(environment(GL_SRC1_ALPHA), GL_PREVIOUS);
  EXPECT_EQ(environment(GL_SRC2_RGB), GL_CONSTANT);
  EXPECT_EQ(environment(GL_OPERAND0_RGB), GL_SRC_COLOR);
  EXPECT_EQ(environment(GL_OPERAND2_RGB), GL_SRC_ALPHA);
  EXPECT_EQ(environment(GL_OPERAND0_ALPHA), GL_SRC_ALPHA);
  EXPECT_EQ(environment(GL_RGB_SCALE), 1);
  glActiveTexture(GL_TEXTURE3);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE_EXT);
  EXPECT_EQ(environment(GL_TEXTURE_ENV_MODE), GL_REPLACE) << "EXT_texture";
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB_EXT);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_DOT3_RGB_EXT);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGBA);
  glTexEnvi(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_TEXTURE7);
  glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_ONE_MINUS_SRC_COLOR);
  glTexEnvf(GL_TEXTURE_ENV, GL_ALPHA_SCALE, 4.0f);
  glTexEnvf(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, -2.5f);
  glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, GL_TRUE);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_DOT3_RGBA);
  EXPECT_EQ(environment(GL_SRC1_RGB), GL_TEXTURE7);
  EXPECT_EQ(environment(GL_OPERAND1_RGB), GL_ONE_MINUS_SRC_COLOR);
  EXPECT_EQ(environment(GL_ALPHA_SCALE), 4);
  EXPECT_EQ(environment(GL_COORD_REPLACE_ARB, GL_POINT_SPRITE_ARB), GL_TRUE);
  GLfloat bias = 0;
  glGetTexEnvfv(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS, &bias);
  EXPECT_EQ(bias, -2.5f);
  glActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(environment(GL_TEXTURE_ENV_MODE), GL_MODULATE);
  expect_error(GL_NO_ERROR, __LINE__);
}

TEST(TextureEnvironment, RefusesWhatItDoesNotKnow) {
  Screen screen;
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, GL_REPLACE));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, 1));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_ENV_MODE, GL_REPLACE));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_INTERPOLATE));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_DOT3_RGB));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE0 + 8));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR));
  EXPECT_GL(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1));
  EXPECT_GL(GL_INVALID_VALUE, glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3.0f));
  EXPECT_GL(GL_INVALID_VALUE, glTexEnvi(GL_POINT_SPRITE_ARB, GL_COORD_REPLACE_ARB, 2));
  GLint value = 0;
  EXPECT_GL(GL_INVALID_ENUM, glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_LOD_BIAS, &value));
  EXPECT_GL(GL_INVALID_ENUM, glGetTexEnviv(GL_TEXTURE_2D, GL_TEXTURE_ENV_MODE, &value));
}

TEST(TextureAttributes, SaveBindingsEnvironmentsAndParametersOfBoundObjects) {
  Screen screen;
  glBindTexture(GL_TEXTURE_2D, 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP);
  glPushAttrib(GL_TEXTURE_BIT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL);
  glBindTexture(GL_TEXTURE_2D, 2);
  glActiveTexture(GL_TEXTURE2);
  glPopAttrib();
  EXPECT_EQ(get(GL_ACTIVE_TEXTURE), GL_TEXTURE0);
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 1);
  EXPECT_EQ(parameter(GL_TEXTURE_WRAP_S), GL_CLAMP);
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_2D));
  EXPECT_EQ(environment(GL_TEXTURE_ENV_MODE), GL_MODULATE);
}

TEST(TextureAttributes, ANameDeletedMeanwhileIsNotBoundAgain) {
  Screen screen;
  const GLuint name = 1;
  glBindTexture(GL_TEXTURE_2D, name);
  glPushAttrib(GL_TEXTURE_BIT);
  glDeleteTextures(1, &name);
  glPopAttrib();
  EXPECT_EQ(get(GL_TEXTURE_BINDING_2D), 0);
  EXPECT_FALSE(glIsTexture(name));
}

TEST(TextureAttributes, EnablesOfEveryUnitBelongToEnableBit) {
  Screen screen;
  glActiveTexture(GL_TEXTURE4);
  glEnable(GL_TEXTURE_CUBE_MAP);
  glActiveTexture(GL_TEXTURE0);
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(GL_TEXTURE_1D);
  glActiveTexture(GL_TEXTURE4);
  glDisable(GL_TEXTURE_CUBE_MAP);
  glPopAttrib();
  EXPECT_EQ(get(GL_ACTIVE_TEXTURE), GL_TEXTURE4);
  EXPECT_TRUE(glIsEnabled(GL_TEXTURE_CUBE_MAP));
  glActiveTexture(GL_TEXTURE0);
  EXPECT_FALSE(glIsEnabled(GL_TEXTURE_1D));
}

}  // namespace
}  // namespace gouraud::api
