// Fog, clip planes and texture coordinate generation: state, errors, and that a picture shows them.
#include <gtest/gtest.h>

#include "api/commands/clip_planes.h"
#include "api/commands/fog.h"
#include "api/commands/test_screen.h"
#include "api/commands/texture_generation.h"

namespace gouraud::api {
namespace {

TEST(Fog, ValuesAreKeptAndReadBack) {
  const Screen screen;
  GLfloat v[4];
  glGetFloatv(GL_FOG_DENSITY, v);
  EXPECT_EQ(v[0], 1.0f);
  const GLfloat color[] = {0.5f, 2, -1, 0.25f};
  glFogfv(GL_FOG_COLOR, color);
  glGetFloatv(GL_FOG_COLOR, v);
  EXPECT_EQ(v[0], 0.5f);
  EXPECT_EQ(v[1], 1.0f);
  EXPECT_EQ(v[2], 0.0f);
  glFogi(GL_FOG_MODE, GL_EXP2);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  GLint i = 0;
  glGetIntegerv(GL_FOG_MODE, &i);
  EXPECT_EQ(i, GL_EXP2);
  glGetIntegerv(GL_FOG_COORD_SRC, &i);
  EXPECT_EQ(i, GL_FOG_COORD);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(Fog, RefusesWhatIsNoModeAndNegativeDensities) {
  const Screen screen;
  glFogi(GL_FOG_MODE, GL_NEAREST);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  glFogf(GL_FOG_DENSITY, -0.5f);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  glFogf(GL_FOG_COLOR, 1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  glFogi(GL_FOG_COORD_SRC, GL_FOG);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  EXPECT_EQ(screen.context.state.fog, FogGroup());
}

TEST(Fog, IsOfItsOwnGroupAndOfEnable) {
  const Screen screen;
  glPushAttrib(GL_FOG_BIT);
  glEnable(GL_FOG);
  glEnable(GL_COLOR_SUM);
  glFogf(GL_FOG_END, 5);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(GL_FOG);
  glPopAttrib();
  EXPECT_TRUE(glIsEnabled(GL_FOG));
  glPopAttrib();
  EXPECT_EQ(screen.context.state.fog, FogGroup());
}

TEST(Fog, CoversAPicture) {
  Screen screen;
  const GLfloat color[] = {0, 1, 0, 0};
  glFogfv(GL_FOG_COLOR, color);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glEnable(GL_FOG);
  glColor4f(1, 0, 0, 1);
  glFogCoordf(0.5f);
  glBegin(GL_TRIANGLES);
  glVertex2f(-3, -1);
  glVertex2f(3, -1);
  glVertex2f(0, 5);
  glEnd();
  EXPECT_EQ(screen.pixels()[side_px * 16 + 16], 0xFF008080u);
}

TEST(ColorSum, AddsTheSecondaryColorOfVerticesFromListsAndArrays) {
  Screen screen;
  glEnable(GL_COLOR_SUM);
  glColor4f(0.2f, 0, 0, 1);
  glSecondaryColor3f(0.2f, 0.4f, 0);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_TRIANGLE_FAN);
  for (int i = 0; i < 9; ++i) {
    glSecondaryColor3f(0.2f, i == 8 ? 0.4f : 0.4f, 0);
    const float x[] = {-9, 9, 9, 8, 7, 6, 5, 4, -9}, y[] = {-9, -9, 8, 9, 9, 9, 9, 9, 9};
    glVertex2f(x[i], y[i]);
  }
  glEnd();
  glEndList();
  glSecondaryColor3f(0, 0, 0);
  glCallList(list);
  EXPECT_EQ(screen.pixels()[0], 0xFF006666u);
  const GLfloat position[] = {-9, -9, 9, -9, 0, 9}, secondary[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, position);
  glSecondaryColorPointer(3, GL_FLOAT, 0, secondary);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  EXPECT_EQ(screen.pixels()[16 * side_px + 16], 0xFFFF0033u);
}

TEST(ClipPlane, IsTransformedWhenItIsGiven) {
  Context c({}, nullptr);
  c.state.matrices.modelview.top() = glm::mat4(2.0f);
  c.state.matrices.modelview.top()[3] = glm::vec4(1, 0, 0, 1);
  const GLdouble equation[] = {1, 0, 0, 0};  // x_object = (x_eye - w_eye) / 2
  ClipPlane(c, GL_CLIP_PLANE0 + 3, equation);
  GLdouble got[4];
  GetClipPlane(c, GL_CLIP_PLANE0 + 3, got);
  EXPECT_DOUBLE_EQ(got[0], 0.5);
  EXPECT_DOUBLE_EQ(got[3], -0.5);
  ClipPlane(c, GL_CLIP_PLANE0 + 8, equation);
  EXPECT_EQ(c.take_error(), static_cast<GLenum>(GL_INVALID_ENUM));
  GetClipPlane(c, GL_CLIP_PLANE0 - 1, got);
  EXPECT_EQ(c.take_error(), static_cast<GLenum>(GL_INVALID_ENUM));
}

TEST(ClipPlane, UnderASingularMatrixStaysFinite) {
  Context c({}, nullptr);
  c.state.matrices.modelview.top() = glm::mat4(0.0f);
  const GLdouble equation[] = {1, 2, 3, 4};
  ClipPlane(c, GL_CLIP_PLANE0, equation);
  EXPECT_EQ(c.state.transform.clip_planes[0].plane_eye, glm::dvec4(0.0));
}

TEST(TexGen, KeepsAModeAndPlanesForEachUnitAndCoordinate) {
  Context c({}, nullptr);
  c.state.texture.active_unit = 2;
  c.state.matrices.modelview.top() = glm::mat4(2.0f);
  c.state.matrices.modelview.top()[3][3] = 1.0f;
  const GLfloat plane[] = {1, 2, 3, 4}, sphere[] = {GL_SPHERE_MAP};
  TexGenfv(c, GL_T, GL_EYE_PLANE, plane);
  TexGenfv(c, GL_T, GL_OBJECT_PLANE, plane);
  TexGenfv(c, GL_T, GL_TEXTURE_GEN_MODE, sphere);
  GLfloat v[4];
  GetTexGenfv(c, GL_T, GL_EYE_PLANE, v);
  EXPECT_EQ(v[1], 1.0f);
  EXPECT_EQ(v[3], 4.0f);
  GLint i[4];
  GetTexGeniv(c, GL_T, GL_OBJECT_PLANE, i);
  EXPECT_EQ(i[2], 3);
  GetTexGeniv(c, GL_T, GL_TEXTURE_GEN_MODE, i);
  EXPECT_EQ(i[0], GL_SPHERE_MAP);
  c.state.texture.active_unit = 0;
  GLdouble d[4];
  GetTexGendv(c, GL_T, GL_EYE_PLANE, d);
  EXPECT_EQ(d[1], 1.0);
  EXPECT_EQ(d[3], 0.0);
}

TEST(TexGen, RefusesModesThatACoordinateDoesNotHave) {
  Context c({}, nullptr);
  const auto error_of = [&](GLenum coord, GLenum pname, GLenum mode) {
    const GLfloat value[4] = {static_cast<GLfloat>(mode)};
    TexGenfv(c, coord, pname, value);
    return c.take_error();
  };
  constexpr GLenum mode = GL_TEXTURE_GEN_MODE, invalid = GL_INVALID_ENUM, none = GL_NO_ERROR;
  EXPECT_EQ(error_of(GL_S, mode, GL_SPHERE_MAP), none);
  EXPECT_EQ(error_of(GL_R, mode, GL_SPHERE_MAP), invalid);
  EXPECT_EQ(error_of(GL_R, mode, GL_REFLECTION_MAP), none);
  EXPECT_EQ(error_of(GL_Q, mode, GL_NORMAL_MAP), invalid);
  EXPECT_EQ(error_of(GL_S, mode, GL_LINEAR), invalid);
  EXPECT_EQ(error_of(GL_S, GL_FOG, GL_LINEAR), invalid);
  EXPECT_EQ(error_of(GL_S + 4, mode, GL_EYE_LINEAR), invalid);
}

}  // namespace
}  // namespace gouraud::api
