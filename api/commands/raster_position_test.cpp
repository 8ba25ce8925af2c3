// The raster position against the formulas of its vertex [GL1.5 §2.13].
#include <array>
#include <cmath>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

using Vector = std::array<GLfloat, 4>;

Vector position() {
  Vector result{};
  glGetFloatv(GL_CURRENT_RASTER_POSITION, result.data());
  return result;
}
Vector color() {
  Vector result{};
  glGetFloatv(GL_CURRENT_RASTER_COLOR, result.data());
  return result;
}
bool valid() {
  GLboolean result = GL_FALSE;
  glGetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &result);
  return result != GL_FALSE;
}
GLfloat distance() {
  GLfloat result = -1;
  glGetFloatv(GL_CURRENT_RASTER_DISTANCE, &result);
  return result;
}
// Window units as object coordinates.
void pixel_space() {
  glMatrixMode(GL_PROJECTION);
  glOrtho(0, side_px, 0, side_px, -1, 1);
  glMatrixMode(GL_MODELVIEW);
}

TEST(RasterPosition, IsInitiallyTheOriginAndValid) {
  Screen screen;
  EXPECT_EQ(position(), (Vector{0, 0, 0, 1}));
  EXPECT_EQ(color(), (Vector{1, 1, 1, 1}));
  EXPECT_TRUE(valid());
  EXPECT_EQ(distance(), 0.0f);
  GLint index = 0;
  glGetIntegerv(GL_CURRENT_RASTER_INDEX, &index);
  EXPECT_EQ(index, 1);
}

TEST(RasterPosition, IsTransformedLikeAVertex) {
  Screen screen;
  pixel_space();
  glTranslatef(3, 4, 0);
  glColor4f(0.25f, 2.0f, -1.0f, 0.5f);
  glRasterPos2i(10, 20);
  EXPECT_EQ(position(), (Vector{13, 24, 0.5f, 1}));
  EXPECT_EQ(color(), (Vector{0.25f, 1, 0, 0.5f}));
  EXPECT_EQ(distance(), std::sqrt(13.0f * 13.0f + 24.0f * 24.0f));
}

TEST(RasterPosition, KeepsTheClipCoordinateW) {
  Screen screen;
  glRasterPos4f(1, -1, 2, 4);
  EXPECT_EQ(position(), (Vector{20, 12, 0.75f, 4}));
  glDepthRange(1, 0);
  glRasterPos4f(1, -1, 2, 4);
  EXPECT_EQ(position(), (Vector{20, 12, 0.25f, 4}));
}

TEST(RasterPosition, OutsideTheClipVolumeIsInvalidAndKeepsItsData) {
  Screen screen;
  glColor3f(0, 1, 0);
  glRasterPos2f(0.5f, 0.5f);
  glColor3f(1, 0, 0);
  for (const Vector& outside : {Vector{1.5f, 0, 0, 1}, Vector{0, -1.001f, 0, 1}, Vector{0, 0, 1.5f, 1}, Vector{0, 0, 0, -1},
                                Vector{0, 0, 0, 0}, Vector{NAN, 0, 0, 1}, Vector{0, INFINITY, 0, 1},
                                Vector{1e38f, 1e38f, 1e38f, 1e38f * 10}}) {
    glRasterPos2f(0.5f, 0.5f);
    glRasterPos4fv(outside.data());
    EXPECT_FALSE(valid()) << outside[0] << ' ' << outside[1];
    EXPECT_EQ(position(), (Vector{24, 24, 0.5f, 1}));
  }
  glRasterPos2f(1, 1);  // the boundary belongs to the clip volume
  EXPECT_TRUE(valid());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST(RasterPosition, IsLitAsAFrontFace) {
  Screen screen;
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);  // what is drawn does not matter
  glNormal3f(0, 0.6f, 0.8f);
  glRasterPos2f(0, 0);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color()[static_cast<std::size_t>(i)], 0.2f * 0.2f + 0.8f * 0.8f, 1e-6f);
  EXPECT_EQ(color()[3], 1.0f);
}

TEST(RasterPosition, TakesTheColorThatAMaterialFollows) {
  Screen screen;
  glEnable(GL_LIGHTING);
  glEnable(GL_COLOR_MATERIAL);
  glColorMaterial(GL_FRONT, GL_EMISSION);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 3);
  const GLfloat black[4] = {0, 0, 0, 1};
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, black);
  glColor3f(0.25f, 0.5f, 0.75f);
  glRasterPos2f(0, 0);
  EXPECT_EQ(color(), (Vector{0.25f, 0.5f, 0.75f, 1}));
}

TEST(RasterPosition, TakesTheTextureCoordinatesOfEveryUnit) {
  Screen screen;
  const auto coordinates = [](GLenum unit) {
    Vector result{};
    glActiveTexture(unit);
    glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, result.data());
    return result;
  };
  glMultiTexCoord4f(GL_TEXTURE1, 1, 2, 3, 4);
  glMultiTexCoord2f(GL_TEXTURE0, 5, 6);
  glActiveTexture(GL_TEXTURE1);
  glMatrixMode(GL_TEXTURE);
  glTranslatef(1, 0, 0);
  glRasterPos2f(0, 0);
  EXPECT_EQ(coordinates(GL_TEXTURE0), (Vector{5, 6, 0, 1}));
  EXPECT_EQ(coordinates(GL_TEXTURE1), (Vector{5, 2, 3, 4}));
  EXPECT_EQ(coordinates(GL_TEXTURE7), (Vector{0, 0, 0, 1}));
  glWindowPos2f(0, 0);
  EXPECT_EQ(coordinates(GL_TEXTURE1), (Vector{1, 2, 3, 4}));  // as they are
}

TEST(RasterPosition, LeavesPendingVerticesAlone) {
  Screen screen, expected;
  const auto draw = [](bool between) {
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1), glVertex2f(1, -1), glVertex2f(0, 1);
    glEnd();
    if (between) glRasterPos2f(0, 0);
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, 1), glVertex2f(1, 1), glVertex2f(0, 0);
    glEnd();
  };
  draw(false);
  const auto want = expected.pixels();
  make_current(&screen.context);
  draw(true);
  EXPECT_EQ(screen.pixels(), want);
}

TEST(WindowPosition, SetsTheCoordinatesAndIsAlwaysValid) {
  Screen screen;
  glEnable(GL_LIGHTING);
  glColor4f(0.5f, 0.25f, 7, 0);
  glDepthRange(0.25, 0.75);
  glRasterPos2f(7, 7);
  glWindowPos3f(-300, 2.5f, 0.5f);
  EXPECT_TRUE(valid());
  EXPECT_EQ(position(), (Vector{-300, 2.5f, 0.5f, 1}));
  EXPECT_EQ(color(), (Vector{0.5f, 0.25f, 1, 0}));
  EXPECT_EQ(distance(), 0.0f);
  glWindowPos3f(0, 0, 9);
  EXPECT_EQ(position()[2], 0.75f);
  glWindowPos3f(0, 0, -9);
  EXPECT_EQ(position()[2], 0.25f);
  glWindowPos2s(3, 4);
  EXPECT_EQ(position(), (Vector{3, 4, 0.25f, 1}));
}

TEST(RasterPosition, IsOfTheCurrentGroupAndOfDisplayLists) {
  Screen screen;
  glPushAttrib(GL_CURRENT_BIT);
  glNewList(1, GL_COMPILE);
  glWindowPos2i(5, 6);
  glEndList();
  EXPECT_EQ(position(), (Vector{0, 0, 0, 1}));
  glCallList(1);
  EXPECT_EQ(position(), (Vector{5, 6, 0, 1}));
  glPopAttrib();
  EXPECT_EQ(position(), (Vector{0, 0, 0, 1}));
}

TEST(RasterPosition, IsRefusedBetweenBeginAndEnd) {
  Screen screen;
  glBegin(GL_POINTS);
  glRasterPos2f(0.5f, 0.5f);
  glWindowPos2f(1, 1);
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_EQ(position(), (Vector{0, 0, 0, 1}));
}

}  // namespace
}  // namespace gouraud::api
