// Clip control [ARB_clip_control].
#include <GL/gl.h>
#include <gtest/gtest.h>

#include "api/commands/test_samples.h"
#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

TEST(ClipControl, DepthFromZeroToOne) {
  const Screen screen;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  EXPECT_EQ(integer(GL_CLIP_DEPTH_MODE), GL_ZERO_TO_ONE);
  glClear(GL_DEPTH_BUFFER_BIT);
  rectangle(0, 0, 8, 32, 0.25f);
  rectangle(8, 0, 16, 32, -0.25f);
  glDepthRange(1, 0);
  rectangle(16, 0, 24, 32, 0.25f);
  EXPECT_NEAR(depth_at(4, 4), 0.25, 1e-7);
  EXPECT_EQ(depth_at(12, 4), 1.0f) << "clipped";
  EXPECT_NEAR(depth_at(20, 4), 0.75, 1e-7);
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_TRIANGLES);
  glVertex3f(-1, -1, -1);
  glVertex3f(1, -1, -1);
  glVertex3f(0, 1, 1);
  glEnd();
  EXPECT_EQ(red_at(16, 15), 0) << "in front of the near plane, z = 0";
  EXPECT_EQ(red_at(16, 17), 255);
}

TEST(ClipControl, OriginAtTheUpperLeft) {
  const Screen screen;
  glClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  glEnable(GL_CULL_FACE);
  rectangle(0, 0, 32, 8);
  EXPECT_EQ(red_at(5, 31), 255);
  EXPECT_EQ(red_at(5, 24), 255);
  EXPECT_EQ(red_at(5, 23), 0);
  EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_UPPER_LEFT);
}

TEST(ClipControl, ErrorsChangeNothingAndTheTransformGroupKeepsIt) {
  const Screen screen;
  glPushAttrib(GL_TRANSFORM_BIT);
  glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
  glClipControl(GL_LOWER_LEFT, GL_LEQUAL);
  EXPECT_EQ(glGetError(), GL_INVALID_ENUM);
  glClipControl(GL_FRONT, GL_ZERO_TO_ONE);
  EXPECT_EQ(glGetError(), GL_INVALID_ENUM);
  EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_UPPER_LEFT);
  glPopAttrib();
  EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_LOWER_LEFT);
  EXPECT_EQ(integer(GL_CLIP_DEPTH_MODE), GL_NEGATIVE_ONE_TO_ONE);
}

}  // namespace
}  // namespace gouraud::api
