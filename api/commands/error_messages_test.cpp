// What GOURAUD_TRACE=errors and =calls print: the command that the program called, and what inside it failed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

struct TracedScreen {
  explicit TracedScreen(const char* topics) {
    setenv("GOURAUD_TRACE", topics, 1);
    screen.emplace();
    unsetenv("GOURAUD_TRACE");
  }
  std::optional<Screen> screen;
};

template <class Calls>
std::string printed_by(const Calls& calls) {
  testing::internal::CaptureStderr();
  calls();
  return testing::internal::GetCapturedStderr();
}

void bind_incomplete_framebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
}

const std::string incomplete = "GL_INVALID_FRAMEBUFFER_OPERATION: ";
const std::string because = "the draw framebuffer is incomplete\n";

TEST(ErrorMessages, NameTheFormOfTheCommandThatWasCalled) {
  const TracedScreen traced("errors");
  EXPECT_EQ(printed_by([] { glLightf(GL_LIGHT0, GL_SPOT_CUTOFF, 100); }).substr(0, 35),
            "gouraud: glLightf: GL_INVALID_VALUE");
  static const GLint color[4] = {};
  EXPECT_EQ(printed_by([] { glMaterialiv(GL_LEFT, GL_AMBIENT, color); }).substr(0, 38),
            "gouraud: glMaterialiv: GL_INVALID_ENUM");
}

TEST(ErrorMessages, NameTheDrawThatTheProgramCalled) {
  const TracedScreen traced("errors");
  bind_incomplete_framebuffer();
  const GLfloat vertices[6] = {};
  const GLubyte indices[3] = {0, 1, 2};
  glVertexPointer(2, GL_FLOAT, 0, vertices);
  glEnableClientState(GL_VERTEX_ARRAY);
  glNewList(1, GL_COMPILE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEndList();
  glNewList(2, GL_COMPILE);
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 30; ++i) glVertex2fv(vertices);
  glEnd();
  glEndList();
  const struct {
    void (*call)(const GLubyte* indices);
    std::string command, inside;
  } draws[] = {
      {[](const GLubyte*) { glDrawArrays(GL_TRIANGLES, 0, 3); }, "glDrawArrays", ""},
      {[](const GLubyte* i) { glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, i); }, "glDrawElements", ""},
      {[](const GLubyte* i) { glDrawRangeElements(GL_TRIANGLES, 0, 2, 3, GL_UNSIGNED_BYTE, i); },
       "glDrawRangeElements",
       ""},
      {[](const GLubyte*) { glRecti(0, 0, 1, 1); }, "glRecti", ""},
      {[](const GLubyte*) { glEvalMesh1(GL_LINE, 0, 1); }, "glEvalMesh1", ""},
      {[](const GLubyte*) { glCallList(1); }, "glCallList", "a draw from vertex arrays: "},
      {[](const GLubyte*) { glCallList(2); }, "glCallList", "glBegin: "},
  };
  for (const auto& draw : draws) {
    EXPECT_EQ(printed_by([&] { draw.call(indices); }), "gouraud: " + draw.command + ": " + incomplete + draw.inside + because);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_FRAMEBUFFER_OPERATION));
  }
}

TEST(CallTraces, ShowNoCallThatTheProgramDidNotMake) {
  const TracedScreen traced("calls");
  const GLfloat vertices[6] = {};
  glVertexPointer(2, GL_FLOAT, 0, vertices);
  glEnableClientState(GL_VERTEX_ARRAY);
  glNewList(1, GL_COMPILE);
  EXPECT_EQ(printed_by([] { glDrawArrays(GL_TRIANGLES, 0, 3); }), "glDrawArrays(GL_TRIANGLES, 0, 3)\n");
  glEndList();
}

TEST(CallTraces, ShowOneValueOfCommandsThatHaveOne) {
  const TracedScreen traced("calls");
  EXPECT_EQ(printed_by([] { glLightModelf(GL_LIGHT_MODEL_AMBIENT, 0.5f); }), "glLightModelf(GL_LIGHT_MODEL_AMBIENT, 0.5)\n");
  EXPECT_EQ(printed_by([] { glMateriali(GL_FRONT, GL_SHININESS, 7); }), "glMateriali(GL_FRONT, GL_SHININESS, 7)\n");
  EXPECT_EQ(printed_by([] { glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP); }),
            "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP)\n");
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM));
}

}  // namespace
}  // namespace gouraud::api
