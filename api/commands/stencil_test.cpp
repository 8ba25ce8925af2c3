// State, queries and errors of the stencil test [GL1.5 §4.1.5], and of its two extensions for back faces.
#include "api/commands/stencil.h"

#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

GLint integer(GLenum pname) {
  GLint value = -1;
  glGetIntegerv(pname, &value);
  return value;
}

void expect_error(GLenum error) {
  EXPECT_EQ(glGetError(), error);
}

TEST(StencilState, IsAtFirstWhatTheTablesSay) {
  Screen screen;
  EXPECT_EQ(glIsEnabled(GL_STENCIL_TEST), GL_FALSE);
  EXPECT_EQ(integer(GL_STENCIL_FUNC), GL_ALWAYS);
  EXPECT_EQ(integer(GL_STENCIL_REF), 0);
  EXPECT_EQ(integer(GL_STENCIL_FAIL), GL_KEEP);
  EXPECT_EQ(integer(GL_STENCIL_PASS_DEPTH_FAIL), GL_KEEP);
  EXPECT_EQ(integer(GL_STENCIL_PASS_DEPTH_PASS), GL_KEEP);
  EXPECT_EQ(integer(GL_STENCIL_BACK_FUNC_ATI), GL_ALWAYS);
  EXPECT_EQ(integer(GL_ACTIVE_STENCIL_FACE_EXT), GL_FRONT);
}

TEST(StencilState, GivesTheReferenceAsTheBufferCanHoldIt) {
  Screen screen;
  glStencilFunc(GL_LESS, 300, 0xFF);
  EXPECT_EQ(integer(GL_STENCIL_REF), 255);
  glStencilFunc(GL_LESS, -300, 0xFF);
  EXPECT_EQ(integer(GL_STENCIL_REF), 0);
}

TEST(StencilState, OfTheFrontIsFollowedByTheSeparateBackAndNotByTheOther) {
  Screen screen;
  glActiveStencilFaceEXT(GL_BACK);
  glStencilFunc(GL_GREATER, 9, 1);
  glActiveStencilFaceEXT(GL_FRONT);
  glStencilOpSeparateATI(GL_BACK, GL_ZERO, GL_INCR, GL_DECR_WRAP);
  EXPECT_EQ(integer(GL_STENCIL_FAIL), GL_KEEP);
  EXPECT_EQ(integer(GL_STENCIL_BACK_PASS_DEPTH_PASS_ATI), GL_DECR_WRAP);
  glStencilFunc(GL_LESS, 2, 3);
  glStencilOp(GL_INVERT, GL_KEEP, GL_REPLACE);
  EXPECT_EQ(integer(GL_STENCIL_BACK_FUNC_ATI), GL_LESS);
  EXPECT_EQ(integer(GL_STENCIL_BACK_FAIL_ATI), GL_INVERT);
  glActiveStencilFaceEXT(GL_BACK);
  EXPECT_EQ(integer(GL_STENCIL_FUNC), GL_GREATER);
  EXPECT_EQ(integer(GL_STENCIL_VALUE_MASK), 1);
  expect_error(GL_NO_ERROR);
}

TEST(StencilCommands, RefuseWhatTheyDoNotKnowAndChangeNothing) {
  Screen screen;
  const State before = screen.context.state;
  glStencilFunc(GL_KEEP, 1, 1);
  expect_error(GL_INVALID_ENUM);
  glStencilOp(GL_KEEP, GL_ALWAYS, GL_KEEP);
  expect_error(GL_INVALID_ENUM);
  glActiveStencilFaceEXT(GL_FRONT_AND_BACK);
  expect_error(GL_INVALID_ENUM);
  glStencilFuncSeparateATI(GL_LESS, GL_ZERO, 1, 1);
  expect_error(GL_INVALID_ENUM);
  glStencilOpSeparateATI(GL_LEFT, GL_ZERO, GL_ZERO, GL_ZERO);
  expect_error(GL_INVALID_ENUM);
  glStencilOpSeparateATI(GL_FRONT, GL_ZERO, GL_ZERO, GL_ONE);
  expect_error(GL_INVALID_ENUM);
  EXPECT_TRUE(screen.context.state == before);
}

}  // namespace
}  // namespace gouraud::api
