// The watch over a GL of four pixels that can clear and be written to.
#include "conformance/harness/coverage_watch.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include <gtest/gtest.h>

namespace gouraud::conformance {
namespace {

constexpr int width = 4;
constexpr std::uint32_t far_depth = 0xFFFFFF;

/// State of the one fake context.
struct FakeGl {
  std::uint8_t* color = nullptr;
  std::array<std::uint32_t, width> depth{};
  std::array<float, 4> clear_color{};
  std::array<bool, 4> color_mask{true, true, true, true};
  int scissor_end = width;
};
FakeGl fake;

void write(int pixel, const std::array<float, 4>& color) {
  for (std::size_t i = 0; i < 4; ++i) {
    const float byte = std::clamp(color[i], 0.0f, 1.0f) * 255.0f;
    if (fake.color_mask[i]) fake.color[4 * pixel + static_cast<int>(i)] = static_cast<std::uint8_t>(byte);
  }
}

void APIENTRY fake_clear(GLbitfield mask) {
  for (int pixel = 0; pixel < fake.scissor_end; ++pixel) {
    if ((mask & GL_COLOR_BUFFER_BIT) != 0) write(pixel, fake.clear_color);
    if ((mask & GL_DEPTH_BUFFER_BIT) != 0) fake.depth[static_cast<std::size_t>(pixel)] = far_depth;
  }
}
void APIENTRY fake_clear_color(GLfloat r, GLfloat g, GLfloat b, GLfloat a) { fake.clear_color = {r, g, b, a}; }
void APIENTRY fake_get_floatv(GLenum, GLfloat* values) { std::ranges::copy(fake.clear_color, values); }
void APIENTRY do_nothing() {}

void* find_function(const char* name) {
  const auto pointer = [](auto* function) {
    void* result;
    std::memcpy(&result, &function, sizeof(result));
    return result;
  };
  if (name == std::string_view("glClear")) return pointer(&fake_clear);
  if (name == std::string_view("glClearColor")) return pointer(&fake_clear_color);
  if (name == std::string_view("glGetFloatv")) return pointer(&fake_get_floatv);
  return pointer(&do_nothing);
}

const OsmesaFunctions fake_osmesa{
    .CreateContextExt = [](GLenum, GLint, GLint, GLint, void*) -> void* { return &fake; },
    .DestroyContext = [](void*) {},
    .MakeCurrent =
        [](void* context, void* buffer, GLenum, GLsizei, GLsizei) -> GLboolean {
          if (context == nullptr) return GL_TRUE;
          fake = FakeGl{};
          fake.color = static_cast<std::uint8_t*>(buffer);
          return GL_TRUE;
        },
    .GetDepthBuffer = [](void*, GLint* w, GLint* h, GLint* bytes, void** buffer) -> GLboolean {
      *w = width;
      *h = 1;
      *bytes = 4;
      *buffer = fake.depth.data();
      return GL_TRUE;
    },
    .GetProcAddress = &find_function};

/// What the watch finds of a scene that is drawn plainly first.
std::vector<std::uint8_t> coverage_of(void (*draw)(const GlTable& gl)) {
  Picture plain;
  {
    OffscreenContext context(fake_osmesa, width, 1, 24);
    draw(context.gl());
    plain = context.read();
  }
  OffscreenContext context(fake_osmesa, width, 1, 24);
  CoverageWatch watch(context);
  draw(watch.gl());
  return watch.covered(plain);
}

using Covered = std::vector<std::uint8_t>;

TEST(CoverageWatch, AClearCoversNothing) {
  EXPECT_EQ(coverage_of([](const GlTable& gl) { gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }),
            (Covered{0, 0, 0, 0}));
}

TEST(CoverageWatch, WithoutAClearTheBackgroundIsZero) {
  EXPECT_EQ(coverage_of([](const GlTable&) { write(2, {1, 1, 1, 1}); }), (Covered{0, 0, 1, 0}));
}

TEST(CoverageWatch, AFragmentMayHaveTheClearColor) {
  EXPECT_EQ(coverage_of([](const GlTable& gl) {
              gl.ClearColor(0.2f, 0.4f, 0.6f, 1.0f);
              gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              write(0, {0.2f, 0.4f, 0.6f, 1.0f});
              write(3, {0.7f, 0.9f, 0.1f, 0.5f});  // what the watch clears to instead
            }),
            (Covered{1, 0, 0, 1}));
}

TEST(CoverageWatch, DepthAloneCovers) {
  EXPECT_EQ(coverage_of([](const GlTable& gl) {
              gl.Clear(GL_DEPTH_BUFFER_BIT);
              fake.depth[1] = 5;
            }),
            (Covered{0, 1, 0, 0}));
}

TEST(CoverageWatch, ADepthClearBetweenPassesForgetsNothing) {
  EXPECT_EQ(coverage_of([](const GlTable& gl) {
              gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              fake.depth[0] = 5;
              write(1, {1, 0, 0, 1});
              gl.Clear(GL_DEPTH_BUFFER_BIT);
              fake.depth[3] = 5;
            }),
            (Covered{1, 1, 0, 1}));
}

TEST(CoverageWatch, AColorClearWipesWhatWasDrawn) {
  EXPECT_EQ(coverage_of([](const GlTable& gl) {
              gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              write(0, {1, 0, 0, 1});
              gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              write(1, {1, 0, 0, 1});
            }),
            (Covered{0, 1, 0, 0}));
}

TEST(CoverageWatch, ClearsUnderScissorAndMask) {
  EXPECT_EQ(coverage_of([](const GlTable& gl) {
              gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
              gl.ClearColor(1, 1, 1, 1);
              fake.scissor_end = 2;
              fake.color_mask = {true, false, false, true};
              gl.Clear(GL_COLOR_BUFFER_BIT);
              write(1, {1, 1, 1, 1});  // red and alpha of the clear colour
            }),
            (Covered{0, 1, 0, 0}));
}

}  // namespace
}  // namespace gouraud::conformance
