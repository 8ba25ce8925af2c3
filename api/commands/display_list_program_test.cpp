// Random programs do the same directly and through display lists: state, error and pixels [GL1.5 §5.4].
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <utility>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

// Issues one random command after another, valid or not; the same for the same seed. `calls` are lists to call.
class RandomProgram {
 public:
  explicit RandomProgram(std::uint32_t seed) : random_(seed) {}
  void run(int commands) {
    for (int i = 0; i < commands; ++i) command();
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
  GLfloat number() { return static_cast<GLfloat>(below(2001)) / 1000.0f - 1.0f; }
  GLenum capability() {
    constexpr GLenum all[] = {GL_LIGHTING, GL_LIGHT0, GL_LIGHT1, GL_DEPTH_TEST, GL_COLOR_MATERIAL, GL_NORMALIZE};
    return all[below(6)];
  }
  void vertex_value() {
    switch (below(9)) {
      case 0:
        return glNormal3b(static_cast<GLbyte>(below(256) - 128), 5, 120);
      case 1:
        return glNormal3f(number(), number(), 1);
      case 2:
        return glColor4ub(static_cast<GLubyte>(below(256)), static_cast<GLubyte>(below(256)), 40, 255);
      case 3:
        return glColor3f(number(), number(), number());
      case 4:
        return glTexCoord2f(number(), number());
      case 5:
        return glVertex2s(static_cast<GLshort>(below(3) - 1), static_cast<GLshort>(below(3) - 1));
      case 6:
        return glVertex4f(number(), number(), number(), 1.5f);
      default:
        return glVertex3f(number(), number(), number());
    }
  }
  void material() {
    const GLfloat value[] = {number(), number(), number(), 1};
    glMaterialfv(below(2) ? GL_FRONT : GL_FRONT_AND_BACK, below(2) ? GL_DIFFUSE : GL_EMISSION, value);
  }
  void primitive() {
    const auto mode = static_cast<GLenum>(below(11));
    glBegin(mode == GL_QUADS ? GL_QUAD_STRIP : mode);  // lists split quads along the other diagonal (MESA-RULES 2.5)
    for (int n = below(below(8) == 0 ? 3000 : 30); n > 0; --n) vertex_value();
    if (below(4) == 0) material();
    if (below(8) == 0) glDepthFunc(GL_ALWAYS);  // an error, unless there is no Begin
    for (int n = below(12); n > 0; --n) vertex_value();
    if (below(16) != 0) glEnd();
  }
  void command() {
    switch (below(10)) {
      case 0:
        return glEnable(capability());
      case 1:
        return glDisable(capability());
      case 2:
        return glRotatef(30 * number(), number(), number(), 1);
      case 3:
        return below(2) ? glPushMatrix() : glPopMatrix();
      case 4:
        return glDepthFunc(GL_NEVER + static_cast<GLenum>(below(9)));
      case 5:
        return material();
      case 6:
        return vertex_value();
      case 7:
        return glShadeModel(below(2) ? GL_FLAT : GL_SMOOTH);
      default:
        return primitive();
    }
  }
  std::mt19937 random_;
};

TEST(DisplayListProgram, DoesTheSameDirectlyAndThroughLists) {
  std::ptrdiff_t drawn = 0;
  for (std::uint32_t seed = 0; seed < 150; ++seed) {
    const auto finish = [](Screen& screen) {
      const GLenum error = glGetError();
      if (screen.context.inside_begin_end()) glEnd();
      return std::pair(error, screen.pixels());
    };
    Screen direct;
    RandomProgram(seed).run(40);
    const auto expected = finish(direct);
    drawn += std::count_if(expected.second.begin(), expected.second.end(), [](auto pixel) { return pixel != 0; });
    const auto same = [&](Screen& screen, const char* way) {
      EXPECT_TRUE(finish(screen) == expected) << way << ", seed " << seed;
      EXPECT_TRUE(screen.context.state == direct.context.state) << way << ", seed " << seed;
    };
    {
      Screen screen;
      glNewList(1, GL_COMPILE);
      RandomProgram(seed).run(40);
      glEndList();
      EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
      EXPECT_TRUE(screen.context.state == Screen().context.state);
      make_current(&screen.context);
      glCallList(1);
      same(screen, "compiled");
    }
    {
      Screen screen;
      glNewList(1, GL_COMPILE_AND_EXECUTE);
      RandomProgram(seed).run(40);
      if (screen.context.inside_begin_end()) continue;  // EndList has to wait
      glEndList();
      same(screen, "compiled and executed");
    }
    make_current(&direct.context);
  }
  EXPECT_GT(drawn, 150 * side_px * side_px / 4);
}

}  // namespace
}  // namespace gouraud::api
