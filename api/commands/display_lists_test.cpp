// Display lists through the entry points, sentence by sentence of [GL1.5 §5.4].
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

class DisplayListsTest : public testing::Test {
 protected:
  static void compile(GLuint name, const std::function<void()>& commands, GLenum mode = GL_COMPILE) {
    glNewList(name, mode);
    commands();
    glEndList();
  }
  static GLint integer(GLenum pname) {
    GLint value = -1;
    glGetIntegerv(pname, &value);
    return value;
  }
  static std::array<GLfloat, 4> color() {
    std::array<GLfloat, 4> value{};
    glGetFloatv(GL_CURRENT_COLOR, value.data());
    return value;
  }
  // A list that says it was called: adds its digit to the number in the colour's red.
  void make_digits(GLuint first, int count) {
    for (int i = 0; i < count; ++i) {
      compile(first + static_cast<GLuint>(i), [i] {
        glTranslatef(static_cast<GLfloat>(i), 0, 0);
        glScalef(10, 1, 1);
      });
    }
  }
  // Runs `calls` with the matrix 1: x of the result tells which digit lists ran, in order.
  static double digits_of(const std::function<void()>& calls) {
    glLoadIdentity();
    calls();
    GLfloat m[16];
    glGetFloatv(GL_MODELVIEW_MATRIX, m);
    return m[12];
  }

  Screen screen_;
};

TEST_F(DisplayListsTest, NewListRefusesBadArguments) {
  glNewList(0, GL_COMPILE);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  glNewList(1, GL_FILL);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  glEndList();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  glNewList(1, GL_COMPILE);
  glNewList(2, GL_COMPILE);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_EQ(integer(GL_LIST_INDEX), 1);
  glEndList();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_FALSE(glIsList(2));
}

TEST_F(DisplayListsTest, NewListAndEndListAreRefusedBetweenBeginAndEnd) {
  glBegin(GL_POINTS);
  glNewList(1, GL_COMPILE);
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_EQ(integer(GL_LIST_INDEX), 0);
  glNewList(1, GL_COMPILE_AND_EXECUTE);
  glBegin(GL_POINTS);
  glEndList();
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_EQ(integer(GL_LIST_INDEX), 1);
  glEndList();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(DisplayListsTest, CompileDoesNotExecute) {
  compile(3, [] { glColor3f(0.5f, 0, 0); });
  EXPECT_EQ(color()[0], 1.0f);
  glCallList(3);
  EXPECT_EQ(color()[0], 0.5f);
}

TEST_F(DisplayListsTest, CompileAndExecuteDoesBoth) {
  compile(
      3,
      [] {
        glColor3f(0.5f, 0, 0);
        glShadeModel(GL_FLAT);
      },
      GL_COMPILE_AND_EXECUTE);
  EXPECT_EQ(color()[0], 0.5f);
  EXPECT_EQ(integer(GL_SHADE_MODEL), GL_FLAT);
  glShadeModel(GL_SMOOTH);
  glCallList(3);
  EXPECT_EQ(integer(GL_SHADE_MODEL), GL_FLAT);
}

TEST_F(DisplayListsTest, StateOfCompilationCanBeQueried) {
  EXPECT_EQ(integer(GL_LIST_INDEX), 0);
  EXPECT_EQ(integer(GL_LIST_MODE), 0);
  EXPECT_EQ(integer(GL_LIST_BASE), 0);
  EXPECT_GE(integer(GL_MAX_LIST_NESTING), 64);
  glNewList(7, GL_COMPILE_AND_EXECUTE);
  glListBase(5);
  EXPECT_EQ(integer(GL_LIST_INDEX), 7);
  EXPECT_EQ(integer(GL_LIST_MODE), GL_COMPILE_AND_EXECUTE);
  EXPECT_EQ(integer(GL_LIST_BASE), 5);
  glEndList();
  EXPECT_EQ(integer(GL_LIST_MODE), 0);
}

TEST_F(DisplayListsTest, OnlyEndListGivesTheNameItsList) {
  compile(1, [] { glColor3f(0.25f, 0, 0); });
  glNewList(1, GL_COMPILE_AND_EXECUTE);
  glColor3f(0.75f, 0, 0);
  glCallList(1);
  EXPECT_EQ(color()[0], 0.25f);  // still the old one
  EXPECT_FALSE(glIsList(2));
  glEndList();
  glDeleteLists(1, 1);
  glNewList(2, GL_COMPILE);
  EXPECT_FALSE(glIsList(2));
  glEndList();
  EXPECT_TRUE(glIsList(2));
}

TEST_F(DisplayListsTest, MayBeDeletedWhileItIsBeingCompiled) {
  compile(1, [] { glColor3f(0.25f, 0, 0); });
  glNewList(1, GL_COMPILE);
  glColor3f(0.75f, 0, 0);
  glDeleteLists(1, 1);
  EXPECT_FALSE(glIsList(1));
  glEndList();
  glCallList(1);
  EXPECT_EQ(color()[0], 0.75f);
}

TEST_F(DisplayListsTest, NamesAreGeneratedSideBySide) {
  EXPECT_EQ(glGenLists(0), 0u);
  EXPECT_EQ(glGenLists(-1), 0u);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  const GLuint first = glGenLists(3);
  ASSERT_NE(first, 0u);
  for (GLuint i = 0; i < 3; ++i) EXPECT_TRUE(glIsList(first + i));
  const GLuint second = glGenLists(2);
  EXPECT_TRUE(second >= first + 3 || second + 2 <= first);
  EXPECT_FALSE(glIsList(0));
  glCallList(first);  // empty
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(DisplayListsTest, AllNamesMayBeTaken) {
  constexpr GLsizei most = std::numeric_limits<GLsizei>::max();
  EXPECT_EQ(glGenLists(most), 1u);
  EXPECT_EQ(glGenLists(most), 1u + most);
  EXPECT_EQ(glGenLists(2), 0u);  // 4294967295 alone is left
  EXPECT_EQ(glGenLists(1), 4294967295u);
  EXPECT_EQ(glGenLists(1), 0u);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glDeleteLists(1000, 10);
  EXPECT_EQ(glGenLists(11), 0u);
  EXPECT_EQ(glGenLists(10), 1000u);
  glDeleteLists(4294967290u, most);  // beyond the last name
  EXPECT_FALSE(glIsList(4294967295u));
  EXPECT_TRUE(glIsList(4294967289u));
}

TEST_F(DisplayListsTest, DeleteIgnoresWhatIsNoList) {
  compile(5, [] {});
  compile(8, [] { glColor3f(0.5f, 0, 0); });
  glDeleteLists(5, -1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  glDeleteLists(5, 0);
  EXPECT_TRUE(glIsList(5));
  glDeleteLists(0, 8);
  EXPECT_FALSE(glIsList(5));
  EXPECT_TRUE(glIsList(8));
  glDeleteLists(6, 1000);
  EXPECT_FALSE(glIsList(8));
  glCallList(8);
  EXPECT_EQ(color()[0], 1.0f);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(DisplayListsTest, CallListOfZeroIsAnErrorAndOfNoListIsNot) {
  glCallList(77);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glCallList(0);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
}

TEST_F(DisplayListsTest, CallListsConvertsEveryType) {
  make_digits(0x1000, 10);
  glListBase(0x1000);
  // x = d1 + 10 d2 + 100 d3
  const GLbyte bytes[] = {1, 2, 3};
  const GLubyte ubytes[] = {4, 5, 6};
  const GLshort shorts[] = {7, 8, 9};
  const GLushort ushorts[] = {1, 3, 5};
  const GLint ints[] = {2, 4, 6};
  const GLuint uints[] = {3, 5, 7};
  const GLfloat floats[] = {4.0f, 6.99f, 8.5f};
  const GLubyte twos[] = {0, 5, 0, 7, 0, 9}, threes[] = {0, 0, 1, 0, 0, 4, 0, 0, 7},
                fours[] = {0, 0, 0, 2, 0, 0, 0, 5, 0, 0, 0, 8};
  const auto calls = [](GLenum type, const void* lists) { return digits_of([=] { glCallLists(3, type, lists); }); };
  EXPECT_EQ(calls(GL_BYTE, bytes), 321);
  EXPECT_EQ(calls(GL_UNSIGNED_BYTE, ubytes), 654);
  EXPECT_EQ(calls(GL_SHORT, shorts), 987);
  EXPECT_EQ(calls(GL_UNSIGNED_SHORT, ushorts), 531);
  EXPECT_EQ(calls(GL_INT, ints), 642);
  EXPECT_EQ(calls(GL_UNSIGNED_INT, uints), 753);
  EXPECT_EQ(calls(GL_FLOAT, floats), 864);
  EXPECT_EQ(calls(GL_2_BYTES, twos), 975);
  EXPECT_EQ(calls(GL_3_BYTES, threes), 741);
  EXPECT_EQ(calls(GL_4_BYTES, fours), 852);
  glListBase(0x1005);
  const GLbyte down[] = {-1, -2, -3};
  EXPECT_EQ(calls(GL_BYTE, down), 234);
  glListBase(0);
  const GLubyte high[] = {0x10, 5, 0x10, 6, 0x10, 7};
  EXPECT_EQ(calls(GL_2_BYTES, high), 765);
}

TEST_F(DisplayListsTest, CallListsRefusesBadArguments) {
  const GLubyte lists[] = {1};
  glCallLists(1, GL_DOUBLE, lists);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  glCallLists(-1, GL_BYTE, lists);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_VALUE));
  glCallLists(0, GL_BYTE, nullptr);
  const GLfloat absurd[] = {1e38f, -1e38f, std::numeric_limits<GLfloat>::quiet_NaN()};
  glCallLists(3, GL_FLOAT, absurd);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(DisplayListsTest, ClientMemoryIsTakenWhenTheCommandIsIssued) {
  make_digits(1, 9);
  GLubyte names[] = {3, 2};
  GLfloat matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 0, 0, 1};
  compile(50, [&] {
    glLoadMatrixf(matrix);
    glCallLists(2, GL_UNSIGNED_BYTE, names);
  });
  names[0] = names[1] = 9;
  matrix[12] = 1;
  EXPECT_EQ(digits_of([] { glCallList(50); }), 7 + 2 + 10 * 1);  // digit lists 3 and 2 add 2 and 1
}

TEST_F(DisplayListsTest, NestedListsAreCalledByName) {
  compile(1, [] { glColor3f(0.25f, 0, 0); });
  compile(2, [] { glCallList(1); });
  compile(1, [] { glColor3f(0.75f, 0, 0); });
  glCallList(2);
  EXPECT_EQ(color()[0], 0.75f);
  glDeleteLists(1, 1);
  glColor3f(0.5f, 0, 0);
  glCallList(2);
  EXPECT_EQ(color()[0], 0.5f);
}

TEST_F(DisplayListsTest, SixtyFourLevelsNestAndRecursionEnds) {
  for (GLuint i = 1; i < 64; ++i) compile(i, [i] { glCallList(i + 1); });
  compile(64, [] { glColor3f(0.5f, 0, 0); });
  glCallList(1);
  EXPECT_EQ(color()[0], 0.5f);
  compile(100, [] {
    glTranslatef(1, 0, 0);
    glCallList(100);
  });
  EXPECT_EQ(digits_of([] { glCallList(100); }), 64);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

TEST_F(DisplayListsTest, WhatIsNeverCompiledIsExecutedAtOnce) {
  compile(1, [] {
    EXPECT_NE(glGenLists(1), 0u);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
    EXPECT_EQ(integer(GL_UNPACK_ALIGNMENT), 2);
    EXPECT_FALSE(glIsEnabled(GL_LIGHTING));
    glFlush();
    glFinish();
    std::uint32_t pixel = 1;
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
    EXPECT_EQ(pixel, 0u);
  });
  glPixelStorei(GL_UNPACK_ALIGNMENT, 8);
  glCallList(1);
  EXPECT_EQ(integer(GL_UNPACK_ALIGNMENT), 8);
}

TEST_F(DisplayListsTest, ErrorsOfItsCommandsAreRaisedByItsExecution) {
  compile(1, [] {
    glDepthFunc(GL_POLYGON);
    glCallList(0);
    glCallLists(1, GL_DOUBLE, nullptr);
  });
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  glCallList(1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
  compile(1, [] { glPopMatrix(); });
  glCallList(1);
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_STACK_UNDERFLOW));
  glBegin(GL_POINTS);
  glCallList(1);  // allowed here, its command is not
  glEnd();
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
}

TEST_F(DisplayListsTest, ContextsThatShareHaveTheSameLists) {
  compile(9, [] { glColor3f(0.5f, 0, 0); });
  {
    Screen other(&screen_.context);
    EXPECT_TRUE(glIsList(9));
    glCallList(9);
    EXPECT_EQ(color()[0], 0.5f);
    glDeleteLists(9, 1);
    compile(10, [] { glColor3f(0.75f, 0, 0); });
  }
  make_current(&screen_.context);
  EXPECT_FALSE(glIsList(9));
  glCallList(10);
  EXPECT_EQ(color()[0], 0.75f);
  Screen stranger;
  EXPECT_FALSE(glIsList(10));
  make_current(&screen_.context);
}

TEST_F(DisplayListsTest, ListInUseOutlivesItsName) {
  compile(9, [] { glColor3f(0.5f, 0, 0); });
  const auto list = screen_.context.display_lists->find(9);
  glDeleteLists(9, 1);
  EXPECT_EQ(screen_.context.display_lists->find(9), nullptr);
  EXPECT_GT(list->size(), 0u);
  EXPECT_EQ(list.use_count(), 1);
}

// A strip of twelve vertices, so that the list keeps it as a run.
void strip(GLfloat left, bool colors) {
  for (int i = 0; i < 12; ++i) {
    if (colors && i % 3 == 0) glColor3f(0.1f * static_cast<GLfloat>(i), 0.5f, 0.25f);
    glVertex2f(left + 0.1f * static_cast<GLfloat>(i / 2), i % 2 ? 0.5f : -0.5f);
  }
}

TEST_F(DisplayListsTest, BeginAndEndMayStandInDifferentLists) {
  glBegin(GL_TRIANGLE_STRIP);
  strip(-0.5f, true);
  glEnd();
  const auto expected = screen_.pixels();
  compile(1, [] { glBegin(GL_TRIANGLE_STRIP); });
  compile(2, [] { strip(-0.5f, true); });
  compile(3, [] { glEnd(); });
  const std::array<void (*)(), 3> ways = {[] {
                                            glCallList(1);
                                            glCallList(2);
                                            glCallList(3);
                                          },
                                          [] {
                                            glBegin(GL_TRIANGLE_STRIP);
                                            glCallList(2);
                                            glEnd();
                                          },
                                          [] {
                                            glCallList(1);
                                            strip(-0.5f, true);
                                            glCallList(3);
                                          }};
  for (const auto way : ways) {
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 1, 1);
    way();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(screen_.pixels(), expected);
  }
}

TEST_F(DisplayListsTest, WholePrimitiveCalledInsideAnotherGivesItItsVertices) {
  const auto draw = [](auto inner) {
    glColor3f(1, 0, 1);
    glBegin(GL_TRIANGLE_STRIP);
    glVertex2f(-0.9f, -0.5f);
    glVertex2f(-0.9f, 0.5f);
    inner();
    glVertex2f(0.9f, 0.9f);  // the list's End was ours: ignored
    glEnd();
  };
  draw([] {
    strip(-0.5f, true);
    glEnd();
  });
  glGetError();
  const auto expected = screen_.pixels();
  const auto expected_color = color();
  compile(1, [] {
    glBegin(GL_QUADS);
    strip(-0.5f, true);
    glEnd();
  });
  glClear(GL_COLOR_BUFFER_BIT);
  draw([] { glCallList(1); });
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  EXPECT_EQ(screen_.pixels(), expected);
  EXPECT_EQ(color(), expected_color);
}

TEST_F(DisplayListsTest, RunWithoutColoursTakesTheCurrentOneUpToItsFirst) {
  compile(1, [] {
    glBegin(GL_TRIANGLE_STRIP);
    strip(-0.5f, false);
    glColor3f(0, 0, 0.5f);
    strip(0.1f, false);
    glColor3f(0.5f, 0.5f, 0.5f);
    glEnd();
  });
  for (const GLfloat green : {0.25f, 0.75f}) {
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(0, green, 0);
    glBegin(GL_TRIANGLE_STRIP);
    strip(-0.5f, false);
    glColor3f(0, 0, 0.5f);
    strip(0.1f, false);
    glEnd();
    const auto expected = screen_.pixels();
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(0, green, 0);
    glCallList(1);
    EXPECT_EQ(screen_.pixels(), expected);
    EXPECT_EQ(color()[0], 0.5f);
  }
}

TEST_F(DisplayListsTest, VertexArraysAreReadWhenTheyAreCompiled) {
  std::vector<GLfloat> positions{-1, -1, 1, -1, 1, 1, -1, 1};
  std::vector<GLubyte> colors{255, 0, 0, 255, 255, 0, 255, 255, 0, 0, 255, 255, 0, 0, 0, 255};  // planar: of any diagonal
  std::vector<GLushort> indices{0, 1, 2, 0, 2, 3};
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, positions.data());
  glColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
  const std::vector<std::function<void()>> draws{
      [] { glDrawArrays(GL_QUADS, 0, 4); },
      [&] { glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, indices.data()); },
      [] {
        glBegin(GL_QUADS);
        for (GLint i = 0; i < 4; ++i) glArrayElement(i);
        glEnd();
      }};
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    for (const auto& draw : draws) {
      glClear(GL_COLOR_BUFFER_BIT);
      draw();
      const auto expected = screen_.pixels();
      EXPECT_NE(expected, std::vector<std::uint32_t>(expected.size(), 0));
      glClear(GL_COLOR_BUFFER_BIT);
      compile(1, draw, mode);
      EXPECT_EQ(screen_.pixels() == expected, mode == GL_COMPILE_AND_EXECUTE);
      const auto kept = positions;
      positions.assign(positions.size(), 9.0f);
      glClear(GL_COLOR_BUFFER_BIT);
      glCallList(1);
      EXPECT_EQ(screen_.pixels(), expected);
      std::copy(kept.begin(), kept.end(), positions.begin());
    }
  }
}

TEST(DisplayLists, DrawsFromArraysLeaveTheCurrentValues) {
  Screen screen;
  const GLfloat colored[] = {1, 0, 0, -1, -1, 0, 0, 1, 0, 1, -1, 0, 0, 0, 1, 1, 1, 0};
  const GLubyte indices[] = {0, 1, 2};
  glInterleavedArrays(GL_C3F_V3F, 0, colored);
  glNewList(1, GL_COMPILE);
  glColor3f(0.25f, 0.5f, 0.75f);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, indices);
  glEndList();
  glCallList(1);
  std::array<GLfloat, 4> color{};
  glGetFloatv(GL_CURRENT_COLOR, color.data());
  EXPECT_EQ(color, (std::array{0.25f, 0.5f, 0.75f, 1.0f}));
  EXPECT_NE(screen.pixels()[0], 0u);
}

TEST(DisplayLists, DrawsFromArraysBetweenBeginAndEndFailAsAWhole) {
  Screen screen;
  const GLfloat corners[] = {-1, -1, 1, -1, 1, 1, -1, 1};
  glVertexPointer(2, GL_FLOAT, 0, corners);
  for (const bool has_vertices : {true, false}) {
    has_vertices ? glEnableClientState(GL_VERTEX_ARRAY) : glDisableClientState(GL_VERTEX_ARRAY);
    glNewList(1, GL_COMPILE);
    glDrawArrays(GL_QUADS, 0, 4);
    glEndList();
    glClear(GL_COLOR_BUFFER_BIT);
    glBegin(GL_QUADS);
    glCallList(1);
    EXPECT_TRUE(screen.context.inside_begin_end());
    glEnd();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    EXPECT_EQ(screen.pixels()[100], 0u);

    glNewList(2, GL_COMPILE_AND_EXECUTE);
    glBegin(GL_QUADS);
    glDrawArrays(GL_QUADS, 0, 4);
    glEnd();
    glEndList();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
    glCallList(2);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_OPERATION)) << "each time that it is called";
  }
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

}  // namespace
}  // namespace gouraud::api
