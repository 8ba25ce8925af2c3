// Occlusion queries count every fragment that passes the depth test, once, whatever becomes of it then [GL1.5 §4.1.7].
#include "api/commands/occlusion_queries.h"

#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

constexpr GLuint all_pixels = side_px * side_px;

void draw_square(float z = 0, float size = 1) {
  glBegin(GL_QUADS);
  glVertex3f(-size, -size, z);
  glVertex3f(size, -size, z);
  glVertex3f(size, size, z);
  glVertex3f(-size, size, z);
  glEnd();
}

GLuint result(GLuint id) {
  GLuint count = 77;
  glGetQueryObjectuiv(id, GL_QUERY_RESULT, &count);
  return count;
}

TEST(OcclusionQuery, CountsWhatPassesTheDepthTest) {
  Screen screen;
  GLuint ids[4];
  glGenQueries(4, ids);
  EXPECT_FALSE(glIsQuery(ids[0]));
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glBeginQuery(GL_SAMPLES_PASSED, ids[0]);
  draw_square(0, 0.5f);
  glEndQuery(GL_SAMPLES_PASSED);
  glBeginQuery(GL_SAMPLES_PASSED, ids[1]);
  draw_square(0.5f);
  glEndQuery(GL_SAMPLES_PASSED);
  glBeginQuery(GL_SAMPLES_PASSED, ids[2]);
  draw_square(0.9f);
  glEndQuery(GL_SAMPLES_PASSED);
  draw_square(-0.9f);
  EXPECT_TRUE(glIsQuery(ids[0]));
  EXPECT_EQ(result(ids[0]), all_pixels / 4);
  EXPECT_EQ(result(ids[1]), all_pixels * 3 / 4);
  EXPECT_EQ(result(ids[2]), 0u);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(OcclusionQuery, CountsWhatNoMaskLetsBeSeen) {
  Screen screen;
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glBeginQuery(GL_SAMPLES_PASSED, 9);
  draw_square();
  glFlush();
  draw_square(0, 0.5f);
  glEndQuery(GL_SAMPLES_PASSED);
  EXPECT_EQ(result(9), all_pixels + all_pixels / 4);
}

TEST(OcclusionQuery, CountsNothingThatEarlierTestsRejected) {
  Screen screen;
  glEnable(GL_STENCIL_TEST);
  glClear(GL_STENCIL_BUFFER_BIT);
  glStencilFunc(GL_ALWAYS, 1, 1);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  draw_square(0, 0.5f);
  glStencilFunc(GL_EQUAL, 1, 1);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, side_px / 2, side_px);
  glBeginQuery(GL_SAMPLES_PASSED, 1);
  draw_square();
  glEndQuery(GL_SAMPLES_PASSED);
  EXPECT_EQ(result(1), all_pixels / 8);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_LESS, 0.5f);
  glBeginQuery(GL_SAMPLES_PASSED, 1);
  draw_square();
  glEndQuery(GL_SAMPLES_PASSED);
  EXPECT_EQ(result(1), 0u);
}

TEST(OcclusionQuery, OutlivesItsDeletionWhileDrawsArePending) {
  Screen screen;
  glBeginQuery(GL_SAMPLES_PASSED, 5);
  draw_square();
  glEndQuery(GL_SAMPLES_PASSED);
  const GLuint id = 5;
  glDeleteQueries(1, &id);
  EXPECT_FALSE(glIsQuery(5));
  glFinish();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(OcclusionQuery, RefusesWhatTheSpecificationSays) {
  Screen screen;
  const auto error = [](GLenum expected) { EXPECT_EQ(glGetError(), expected); };
  GLuint id = 3;
  GLint value = 7;
  glBeginQuery(GL_SAMPLES_PASSED, 0);
  error(GL_INVALID_OPERATION);
  glBeginQuery(GL_TEXTURE_2D, 3);
  error(GL_INVALID_ENUM);
  glEndQuery(GL_SAMPLES_PASSED);
  error(GL_INVALID_OPERATION);
  glGetQueryObjectiv(3, GL_QUERY_RESULT, &value);
  error(GL_INVALID_OPERATION);
  glGenQueries(-1, &id);
  error(GL_INVALID_VALUE);
  glBeginQuery(GL_SAMPLES_PASSED, 3);
  glBeginQuery(GL_SAMPLES_PASSED, 4);
  error(GL_INVALID_OPERATION);
  glGenQueries(1, &id);
  error(GL_INVALID_OPERATION);
  glDeleteQueries(1, &id);
  error(GL_INVALID_OPERATION);
  glGetQueryObjectiv(3, GL_QUERY_RESULT, &value);
  error(GL_INVALID_OPERATION);
  EXPECT_EQ(value, 7);
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &value);
  EXPECT_EQ(value, 3);
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryiv(GL_SAMPLES_PASSED, GL_CURRENT_QUERY, &value);
  EXPECT_EQ(value, 0);
  glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_COUNTER_BITS, &value);
  EXPECT_EQ(value, query_counter_bits);
  glGetQueryiv(GL_SAMPLES_PASSED, GL_QUERY_RESULT, &value);
  error(GL_INVALID_ENUM);
  glGetQueryObjectiv(3, GL_CURRENT_QUERY, &value);
  error(GL_INVALID_ENUM);
  glGetQueryObjectiv(3, GL_QUERY_RESULT_AVAILABLE, &value);
  EXPECT_EQ(value, GL_TRUE);
}

}  // namespace
}  // namespace gouraud::api
