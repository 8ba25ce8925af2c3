#include "api/commands/matrices.h"

#include <gtest/gtest.h>

#include "api/commands/queries.h"
#include "api/state/matrix.h"

namespace gouraud::api {
namespace {

glm::mat4 modelview(const Context& context) {
  return context.state.matrices.modelview.top();
}

TEST(Matrices, MultiplyFromTheRight) {
  Context c({}, nullptr);
  Translatef(c, 1, 2, 3);
  Scalef(c, 2, 3, 4);
  EXPECT_EQ(modelview(c) * glm::vec4(1, 1, 1, 1), glm::vec4(3, 5, 7, 1));
  LoadIdentity(c);
  const GLfloat m[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  LoadMatrixf(c, m);
  EXPECT_EQ(modelview(c)[3][1], 14.0f);
  MultMatrixf(c, m);
  EXPECT_EQ(modelview(c)[0], glm::vec4(90, 100, 110, 120));
}

TEST(Matrices, ShortcutsGiveTheBitsOfAFullProduct) {
  Context c({}, nullptr);
  Rotatef(c, 37, 1, 2, 3);
  Frustum(c, -1, 1.5, -0.7, 1, 0.3, 7);
  const glm::mat4 before = modelview(c);
  Translatef(c, 0.1f, -0.7f, 13.3f);
  glm::mat4 translation(1.0f);
  translation[3] = glm::vec4(0.1f, -0.7f, 13.3f, 1.0f);
  EXPECT_EQ(modelview(c), product(before, translation));
}

TEST(Matrices, GoToTheStackOfTheModeAndUnit) {
  Context c({}, nullptr);
  MatrixMode(c, GL_TEXTURE);
  ActiveTexture(c, GL_TEXTURE3);
  PushMatrix(c);
  Scalef(c, 2, 2, 2);
  EXPECT_EQ(c.state.matrices.texture[3].depth, 2);
  EXPECT_EQ(c.state.matrices.texture[3].top()[0][0], 2.0f);
  EXPECT_EQ(c.state.matrices.texture[0].depth, 1);
  GLint depth = 0;
  GetIntegerv(c, GL_TEXTURE_STACK_DEPTH, &depth);
  EXPECT_EQ(depth, 2);
  PopMatrix(c);
  EXPECT_EQ(c.state.matrices.texture[3].top(), glm::mat4(1.0f));
  EXPECT_EQ(modelview(c), glm::mat4(1.0f));
  MatrixMode(c, GL_PROJECTION);
  Ortho(c, 0, 4, 0, 2, -1, 1);
  EXPECT_EQ(c.state.matrices.projection.top(), orthographic(0, 4, 0, 2, -1, 1));
}

TEST(Matrices, PopRestoresWhatPushKept) {
  Context c({}, nullptr);
  Rotatef(c, 10, 0, 1, 0);
  const glm::mat4 kept = modelview(c);
  PushMatrix(c);
  EXPECT_EQ(modelview(c), kept);
  LoadIdentity(c);
  PopMatrix(c);
  EXPECT_EQ(modelview(c), kept);
}

}  // namespace
}  // namespace gouraud::api
