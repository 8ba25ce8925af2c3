#include "api/commands/lighting.h"

#include <gtest/gtest.h>

#include "api/commands/current_values.h"
#include "api/commands/enables.h"
#include "api/commands/matrices.h"

namespace gouraud::api {
namespace {

glm::vec4 get_material(Context& c, GLenum face, GLenum pname) {
  GLfloat v[4] = {};
  GetMaterialfv(c, face, pname, v);
  return {v[0], v[1], v[2], v[3]};
}

void set_material(Context& c, GLenum face, GLenum pname, const glm::vec4& color) {
  const GLfloat v[4] = {color.x, color.y, color.z, color.w};
  Materialfv(c, face, pname, v);
}

TEST(Lights, PositionsAndDirectionsAreTransformedWhenTheyAreGiven) {
  Context c({}, nullptr);
  Translatef(c, 1, 2, 3);
  Scalef(c, 2, 2, 2);
  const GLfloat position[] = {1, 1, 1, 1}, direction[] = {0, 1, -1};
  Lightfv(c, GL_LIGHT2, GL_POSITION, position);
  Lightfv(c, GL_LIGHT2, GL_SPOT_DIRECTION, direction);
  LoadIdentity(c);
  EXPECT_EQ(c.state.lighting.lights[2].position_eye, glm::vec4(3, 4, 5, 1));
  EXPECT_EQ(c.state.lighting.lights[2].spot_direction_eye, glm::vec3(0, 2, -2));
}

TEST(Lights, InitialValuesAreThoseOfTheTable) {
  Context c({}, nullptr);
  GLfloat v[4];
  GetLightfv(c, GL_LIGHT0, GL_DIFFUSE, v);
  EXPECT_EQ(v[0], 1.0f);
  GetLightfv(c, GL_LIGHT1, GL_DIFFUSE, v);
  EXPECT_EQ(v[0], 0.0f);
  GetLightfv(c, GL_LIGHT1, GL_SPOT_DIRECTION, v);
  EXPECT_EQ(v[2], -1.0f);
  GLint i[4];
  GetLightiv(c, GL_LIGHT0, GL_SPECULAR, i);
  EXPECT_EQ(i[3], 2147483647);
  GetLightiv(c, GL_LIGHT0, GL_SPOT_CUTOFF, i);
  EXPECT_EQ(i[0], 180);
}

TEST(Materials, AreSetPerFace) {
  Context c({}, nullptr);
  set_material(c, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, glm::vec4(2));
  set_material(c, GL_BACK, GL_DIFFUSE, glm::vec4(3));
  EXPECT_EQ(get_material(c, GL_FRONT, GL_AMBIENT), glm::vec4(2));
  EXPECT_EQ(get_material(c, GL_FRONT, GL_DIFFUSE), glm::vec4(2));
  EXPECT_EQ(get_material(c, GL_BACK, GL_AMBIENT), glm::vec4(2));
  EXPECT_EQ(get_material(c, GL_BACK, GL_DIFFUSE), glm::vec4(3));
}

TEST(ColorMaterial, FollowsTheCurrentColorFromTheMomentItIsEnabled) {
  Context c({}, nullptr);
  ColorMaterial(c, GL_FRONT, GL_SPECULAR);
  Color4f(c, 1, 2, 3, 4);
  Enable(c, GL_COLOR_MATERIAL);
  EXPECT_EQ(get_material(c, GL_FRONT, GL_SPECULAR), glm::vec4(1, 2, 3, 4));
  EXPECT_EQ(get_material(c, GL_BACK, GL_SPECULAR), glm::vec4(0, 0, 0, 1));
  Color4f(c, 5, 6, 7, 8);
  EXPECT_EQ(get_material(c, GL_FRONT, GL_SPECULAR), glm::vec4(5, 6, 7, 8));
}

TEST(ColorMaterial, ReplacementsStayAfterItIsDisabledOrPointedElsewhere) {
  Context c({}, nullptr);
  ColorMaterial(c, GL_FRONT_AND_BACK, GL_EMISSION);
  Enable(c, GL_COLOR_MATERIAL);
  Color4f(c, 1, 1, 1, 1);
  ColorMaterial(c, GL_BACK, GL_DIFFUSE);
  Color4f(c, 2, 2, 2, 2);
  Disable(c, GL_COLOR_MATERIAL);
  Color4f(c, 3, 3, 3, 3);
  EXPECT_EQ(get_material(c, GL_FRONT, GL_EMISSION), glm::vec4(1));
  EXPECT_EQ(get_material(c, GL_BACK, GL_EMISSION), glm::vec4(1));
  EXPECT_EQ(get_material(c, GL_BACK, GL_DIFFUSE), glm::vec4(2));
  EXPECT_EQ(get_material(c, GL_FRONT, GL_DIFFUSE), glm::vec4(0.8f, 0.8f, 0.8f, 1));
}

TEST(ColorMaterial, MaterialCannotOverrideWhatFollows) {
  Context c({}, nullptr);
  Color4f(c, 1, 1, 1, 1);
  Enable(c, GL_COLOR_MATERIAL);
  set_material(c, GL_FRONT, GL_DIFFUSE, glm::vec4(9));
  set_material(c, GL_FRONT, GL_EMISSION, glm::vec4(7));
  Disable(c, GL_COLOR_MATERIAL);
  EXPECT_EQ(get_material(c, GL_FRONT, GL_DIFFUSE), glm::vec4(1));
  EXPECT_EQ(get_material(c, GL_FRONT, GL_EMISSION), glm::vec4(7));
}

}  // namespace
}  // namespace gouraud::api
