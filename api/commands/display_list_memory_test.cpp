// What happens where there is no memory for a display list [GL1.5 §5.4].
#include <GL/gl.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "api/context/context.h"

static thread_local bool allocations_fail = false;

// The test program's own: out of memory on demand.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  void* const memory = allocations_fail ? nullptr : std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace gouraud::api {
namespace {

TEST(DisplayListMemory, ThatRunsOutIsSaidByEndListAndKeepsTheOldList) {
  Context context({}, nullptr);
  make_current(&context);
  const auto red = [] {
    GLfloat value[4];
    glGetFloatv(GL_CURRENT_COLOR, value);
    return value[0];
  };
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    glNewList(1, GL_COMPILE);
    glColor3f(0.25f, 0, 0);
    glEndList();
    glNewList(1, mode);
    glColor3f(0.75f, 0, 0);
    allocations_fail = true;
    for (int i = 0; i < 100; ++i) glTranslatef(1, 0, 0);
    allocations_fail = false;
    glRotatef(1, 0, 0, 1);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(red(), mode == GL_COMPILE ? 1.0f : 0.75f);
    glEndList();
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_OUT_OF_MEMORY));
    EXPECT_FALSE(context.compiling());
    EXPECT_TRUE(glIsList(1));
    glCallList(1);
    EXPECT_EQ(red(), 0.25f);
    glColor3f(1, 1, 1);
  }
  glNewList(2, GL_COMPILE);
  glColor3f(0.5f, 0, 0);
  allocations_fail = true;
  glEndList();
  allocations_fail = false;
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_OUT_OF_MEMORY));
  EXPECT_FALSE(glIsList(2));

  // A run that cannot be made stays a list of single commands, or the whole list is lost: never half of it.
  for (int vertices = 0; vertices < 200; vertices += 7) {
    glColor3f(1, 1, 1);
    glNewList(3, GL_COMPILE);
    glBegin(GL_POINTS);
    for (int i = 0; i < vertices; ++i) glVertex2i(i, i);
    allocations_fail = true;
    glEnd();
    allocations_fail = false;
    glColor3f(0.5f, 0, 0);
    glEndList();
    glCallList(3);
    EXPECT_EQ(red(), glGetError() == GL_OUT_OF_MEMORY ? 1.0f : 0.5f) << vertices;
    EXPECT_FALSE(context.inside_begin_end());
    glDeleteLists(3, 1);
  }
}

}  // namespace
}  // namespace gouraud::api
