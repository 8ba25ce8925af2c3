// Hit records, number by number [GL1.5 §5.2].
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

constexpr GLenum no_error = GL_NO_ERROR, invalid_value = GL_INVALID_VALUE, invalid_enum = GL_INVALID_ENUM,
                 invalid_operation = GL_INVALID_OPERATION;
constexpr GLuint most = 0xFFFFFFFFu;
using Records = std::vector<GLuint>;

// Window depth 0 .. 1 of a z in [-1, 1], as a record has it.
GLuint depth(double z) {
  return static_cast<GLuint>(std::floor((z + 1) / 2 * 4294967295.0 + 0.5));
}

void triangle(GLfloat z0, GLfloat z1, GLfloat z2, GLfloat x = 0) {
  glBegin(GL_TRIANGLES);
  glVertex3f(x - 0.5f, -0.5f, z0), glVertex3f(x + 0.5f, -0.5f, z1), glVertex3f(x, 0.5f, z2);
  glEnd();
}

/// What `commands` in selection mode leave in a buffer of `size`; `result` is what RenderMode says.
Records select(const std::function<void()>& commands, GLint& result, GLsizei size = 64) {
  constexpr GLuint untouched = 0xDEADBEEF;
  Records buffer(96, untouched);
  glSelectBuffer(size, buffer.data());
  EXPECT_EQ(glRenderMode(GL_SELECT), 0);
  commands();
  result = glRenderMode(GL_RENDER);
  EXPECT_TRUE(std::all_of(buffer.begin() + size, buffer.end(), [](GLuint value) { return value == untouched; }));
  buffer.resize(static_cast<std::size_t>(std::find(buffer.begin(), buffer.end(), untouched) - buffer.begin()));
  return buffer;
}
Records select(const std::function<void()>& commands) {
  GLint result = 0;
  return select(commands, result);
}

TEST(Selection, ARecordHasTheNamesAndTheDepthsSinceTheLast) {
  Screen screen;
  GLint result = 0;
  const Records records = select(
      [] {
        glInitNames();
        glPushName(7);
        triangle(-0.5f, 0, 0.25f);
        triangle(0, 0, 0.5f);
        glPushName(8);
        glLoadName(9);  // no hit since
        triangle(1, 1, 1);
        glPopName();
        glLoadName(10);
        triangle(5, 5, 5);  // outside
        glPopName();
        triangle(-1, -1, -1);  // no names
      },
      result);
  EXPECT_EQ(result, 3);
  EXPECT_EQ(records, (Records{1, depth(-0.5), depth(0.5), 7, 2, most, most, 7, 9, 0, 0, 0}));
  EXPECT_EQ(glGetError(), no_error);
}

TEST(Selection, DepthsAreThoseOfClippedVertices) {
  Screen screen;
  // The triangle leaves the clip volume at z = 1, half-way to its tip.
  EXPECT_EQ(select([] { triangle(0.5f, 0.5f, 1.5f); }), (Records{0, depth(0.5), most}));
  // A line that comes in at x = -1, z = -0.25.
  EXPECT_EQ(select([] {
              glBegin(GL_LINES);
              glVertex3f(-2, 0, -0.5f), glVertex3f(0, 0, 0);
              glEnd();
            }),
            (Records{0, depth(-0.25), depth(0)}));
  EXPECT_EQ(select([] {
              glBegin(GL_POINTS);
              glVertex3f(2, 0, 0), glVertex3f(1, 1, 0.5f);
              glEnd();
            }),
            (Records{0, depth(0.5), depth(0.5)}));
}

TEST(Selection, DepthRangeApplies) {
  Screen screen;
  glDepthRange(0.75, 0.25);
  EXPECT_EQ(select([] { triangle(-1, 0, 1); }), (Records{0, 0x40000000, 0xBFFFFFFF}));
}

TEST(Selection, CulledPolygonsDoNotHitAndModesDoNotMatter) {
  Screen screen;
  glEnable(GL_CULL_FACE);
  EXPECT_EQ(select([] { triangle(0, 0, 0); }).size(), 3u);
  glCullFace(GL_FRONT);
  EXPECT_EQ(select([] { triangle(0, 0, 0); }).size(), 0u);
  glFrontFace(GL_CW);
  EXPECT_EQ(select([] { triangle(0, 0, 0); }).size(), 3u);
  glCullFace(GL_FRONT_AND_BACK);
  EXPECT_EQ(select([] { triangle(0, 0, 0); }).size(), 0u);
  glDisable(GL_CULL_FACE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  // All vertices lie outside, the polygon does not.
  EXPECT_EQ(select([] {
              glBegin(GL_QUADS);
              glVertex2f(-3, -3), glVertex2f(3, -3), glVertex2f(3, 3), glVertex2f(-3, 3);
              glEnd();
            }),
            (Records{0, depth(0), depth(0)}));
}

TEST(Selection, EveryPrimitiveHits) {
  Screen screen;
  for (const GLenum mode : {GL_POINTS, GL_LINES, GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES, GL_TRIANGLE_STRIP,
                            GL_TRIANGLE_FAN, GL_QUADS, GL_QUAD_STRIP, GL_POLYGON}) {
    EXPECT_EQ(select([mode] {
                glBegin(mode);
                glVertex3f(-0.5f, -0.5f, 0.5f), glVertex3f(0.5f, -0.5f, 0.5f), glVertex3f(0.5f, 0.5f, -0.5f),
                    glVertex3f(-0.5f, 0.5f, -0.5f);
                glEnd();
              }),
              (Records{0, depth(-0.5), depth(0.5)}))
        << mode;
  }
}

TEST(Selection, ValidRasterPositionsHit) {
  Screen screen;
  EXPECT_EQ(select([] { glRasterPos3f(0, 0, -0.5f); }), (Records{0, depth(-0.5), depth(-0.5)}));
  EXPECT_EQ(select([] { glRasterPos3f(2, 0, 0); }).size(), 0u);
  EXPECT_EQ(select([] { glWindowPos3f(-70, 0, 1); }), (Records{0, most, most}));
}

TEST(Selection, OverflowWritesWhatFitsAndSaysSo) {
  Screen screen;
  GLint result = 0;
  const auto hits = [] {
    glInitNames();
    glPushName(5);
    triangle(0, 0, 0);
    glLoadName(6);
    triangle(0, 0, 0);
  };
  EXPECT_EQ(select(hits, result, 8), (Records{1, depth(0), depth(0), 5, 1, depth(0), depth(0), 6}));
  EXPECT_EQ(result, 2);
  EXPECT_EQ(select(hits, result, 7), (Records{1, depth(0), depth(0), 5, 1, depth(0), depth(0)}));
  EXPECT_EQ(result, -1);
  EXPECT_EQ(select(hits, result, 0).size(), 0u);
  EXPECT_EQ(result, -1);
  EXPECT_EQ(select([] {}, result, 0).size(), 0u);
  EXPECT_EQ(result, 0);
}

TEST(Selection, RenderModeAgainStartsAgain) {
  Screen screen;
  std::array<GLuint, 16> buffer{};
  glSelectBuffer(16, buffer.data());
  glRenderMode(GL_SELECT);
  glPushName(3);
  triangle(0, 0, 0);
  EXPECT_EQ(glRenderMode(GL_SELECT), 1);
  EXPECT_EQ(buffer[3], 3u);
  GLint names = -1;
  glGetIntegerv(GL_NAME_STACK_DEPTH, &names);
  EXPECT_EQ(names, 0);
  triangle(1, 1, 1);
  EXPECT_EQ(glRenderMode(GL_RENDER), 1);
  EXPECT_EQ(buffer[0], 0u);
  EXPECT_EQ(buffer[1], most);
}

TEST(Selection, NameStackHas64Names) {
  Screen screen;
  glPushName(1);  // not in this mode
  glPopName();
  glLoadName(1);
  EXPECT_EQ(glGetError(), no_error);
  select([] {
    glLoadName(1);
    EXPECT_EQ(glGetError(), invalid_operation);
    glPopName();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_STACK_UNDERFLOW));
    for (GLuint i = 0; i < 64; ++i) glPushName(i);
    EXPECT_EQ(glGetError(), no_error);
    glPushName(64);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_STACK_OVERFLOW));
    GLint names = 0;
    glGetIntegerv(GL_NAME_STACK_DEPTH, &names);
    EXPECT_EQ(names, 64);
    glBegin(GL_POINTS);
    glPushName(3);
    glEnd();
    EXPECT_EQ(glGetError(), invalid_operation);
  });
}

TEST(Selection, NothingReachesTheFramebuffer) {
  Screen screen;
  glClearColor(0.25f, 0.5f, 0.75f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const auto before = screen.pixels();
  select([] {
    glClear(GL_COLOR_BUFFER_BIT);
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    triangle(0, 0, 0);
    glFinish();
  });
  EXPECT_EQ(screen.pixels(), before);
  triangle(0, 0, 0);
  EXPECT_NE(screen.pixels(), before);
}

TEST(Selection, NamesGoIntoDisplayLists) {
  Screen screen;
  glNewList(1, GL_COMPILE);
  glPushName(4);
  triangle(0, 0, 0);
  glPopName();
  glEndList();
  EXPECT_EQ(select([] { glCallList(1); }), (Records{1, depth(0), depth(0), 4}));
}

TEST(Selection, ErrorsAndQueries) {
  Screen screen;
  EXPECT_EQ(glRenderMode(GL_SELECT), 0);
  EXPECT_EQ(glGetError(), invalid_operation);
  EXPECT_EQ(glRenderMode(GL_POINTS), 0);
  EXPECT_EQ(glGetError(), invalid_enum);
  std::array<GLuint, 8> buffer{};
  glSelectBuffer(-1, buffer.data());
  EXPECT_EQ(glGetError(), invalid_value);
  glSelectBuffer(8, buffer.data());
  GLint value = 0;
  glGetIntegerv(GL_SELECTION_BUFFER_SIZE, &value);
  EXPECT_EQ(value, 8);
  void* pointer = nullptr;
  glGetPointerv(GL_SELECTION_BUFFER_POINTER, &pointer);
  EXPECT_EQ(pointer, buffer.data());
  glRenderMode(GL_SELECT);
  glGetIntegerv(GL_RENDER_MODE, &value);
  EXPECT_EQ(value, GL_SELECT);
  glSelectBuffer(4, buffer.data());
  EXPECT_EQ(glGetError(), invalid_operation);
  glRenderMode(0);
  EXPECT_EQ(glGetError(), invalid_enum);
  glGetIntegerv(GL_RENDER_MODE, &value);
  EXPECT_EQ(value, GL_SELECT);
  glRenderMode(GL_RENDER);
  glSelectBuffer(8, nullptr);  // nowhere to write to
  glRenderMode(GL_SELECT);
  triangle(0, 0, 0);
  EXPECT_EQ(glRenderMode(GL_RENDER), -1);
  EXPECT_EQ(glGetError(), no_error);
}

}  // namespace
}  // namespace gouraud::api
