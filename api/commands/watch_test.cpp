// A vertex through its spaces and a pixel's fragments through their tests, as GOURAUD_TRACE=vertex:N and =pixel:X,Y tell.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

std::unique_ptr<Screen> watched_screen(const char* topics) {
  setenv("GOURAUD_TRACE", topics, 1);
  auto screen = std::make_unique<Screen>();
  unsetenv("GOURAUD_TRACE");
  return screen;
}

void draw_scene() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  glBegin(GL_TRIANGLES);
  for (const float z : {-0.5f, 0.5f, 0.0f}) {  // the middle one is hidden
    z == 0.0f ? glColor4f(0, 0, 1, 0.25f) : glColor4f(1, 0, 0, 1);
    if (z == 0.0f) {
      glEnd();
      glEnable(GL_BLEND);
      glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
      glDepthFunc(GL_GREATER);
      glBegin(GL_TRIANGLES);
    }
    glVertex3f(-1, -1, z);
    glVertex3f(3, -1, z);
    glVertex3f(-1, 3, z);
  }
  glEnd();
  glDisable(GL_BLEND);
  glDepthFunc(GL_LESS);
  glFinish();
}

template <class Calls>
std::string told_by(const Calls& calls) {
  testing::internal::CaptureStderr();
  calls();
  return testing::internal::GetCapturedStderr();
}

TEST(Watch, TellsWhatEachPassDidToEachFragmentOfAPixel) {
  const auto screen = watched_screen("pixel:20,4");
  EXPECT_EQ(told_by(draw_scene),
            "gouraud: pixel 20,4: draw 0, a fragment of a polygon, depth 0.2500000\n"
            "  depth test: passes, depth 1.0000000 -> 0.2500000\n"
            "  write color, color (0 0 0 0) -> (255 0 0 255)\n"
            "gouraud: pixel 20,4: draw 0, a fragment of a polygon, depth 0.7500000\n"
            "  depth test: fails against 0.2500000\n"
            "gouraud: pixel 20,4: draw 1, a fragment of a polygon, depth 0.5000000\n"
            "  depth test: passes, depth 0.2500000 -> 0.5000000\n"
            "  interpolate colors: (0.0000 0.0000 1.0000 0.2500)\n"
            "  blend and write color, color (255 0 0 255) -> (191 0 64 207)\n");
}

TEST(Watch, TellsOfAVertexInEverySpaceThatThePlanNeeds) {
  const auto screen = watched_screen("vertex:4");
  EXPECT_EQ(told_by([] {
              glMatrixMode(GL_PROJECTION);
              glScalef(0.5f, 0.5f, 1);
              glMatrixMode(GL_MODELVIEW);
              draw_scene();
            }),
            "gouraud: vertex 4: draw 0\n"
            "  object space (3 -1 0.5 1)\n"
            "  clip space (1.5 -0.5 0.5 1)\n"
            "  outside: right\n"
            "  color (1 0 0 1)\n");
}

TEST(Watch, ChangesNoPixel) {
  Screen plain;
  draw_scene();
  const std::vector<std::uint32_t> expected = plain.pixels();
  const auto screen = watched_screen("pixel:20,4,vertex:1");
  told_by(draw_scene);
  EXPECT_EQ(screen->pixels(), expected);
}

}  // namespace
}  // namespace gouraud::api
