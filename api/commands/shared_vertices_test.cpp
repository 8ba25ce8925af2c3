#include "api/commands/shared_vertices.h"

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

/// Vertices and draws that reach the renderer.
struct Counter : pipeline::DrawObserver {
  std::int32_t vertices = 0, named = 0, batches = 0;
  void target_changed(const pipeline::Framebuffer&) override {}
  void clear(const pipeline::ClearState&) override {}
  void draw(const pipeline::DrawState&, const pipeline::VertexBatch& batch) override {
    vertices += batch.count;
    ++batches;
    pipeline::for_each_named_vertex(batch, [this](std::int32_t) { ++named; });
  }
};

struct ColoredPoint {
  std::array<float, 3> color, position;
};

std::vector<ColoredPoint> random_points(std::size_t count, std::minstd_rand& random) {
  const auto between = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 4096) / 4096.0f;
  };
  std::vector<ColoredPoint> points(count);
  for (ColoredPoint& point : points) {
    for (float& channel : point.color) channel = between(0, 1);
    for (float& coordinate : point.position) coordinate = between(-1.3f, 1.3f);
  }
  return points;
}

void use(const std::vector<ColoredPoint>& points) {
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
  glVertexPointer(3, GL_FLOAT, sizeof(ColoredPoint), points[0].position.data());
  glColorPointer(3, GL_FLOAT, sizeof(ColoredPoint), points[0].color.data());
  glEnable(GL_DEPTH_TEST);
}

std::vector<std::uint32_t> picture(Screen& screen, const auto& draw) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw();
  return screen.pixels();
}

TEST(SharedVertices, DrawsWhatTheSameVerticesDrawOneByOne) {
  Screen screen;
  std::minstd_rand random(11);
  const std::vector<ColoredPoint> points = random_points(3000, random);
  use(points);
  for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
    for (const GLuint range : {5u, 400u, 3000u}) {  // few, many and too many distinct ones for one batch
      SCOPED_TRACE("mode " + std::to_string(mode) + ", " + std::to_string(range) + " elements");
      std::vector<GLuint> indices(6007);
      for (GLuint& index : indices) index = static_cast<GLuint>(random() % range);
      const auto together = picture(screen, [&] {
        glDrawElements(mode, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, indices.data());
      });
      const auto one_by_one = picture(screen, [&] {
        glBegin(mode);
        for (const GLuint index : indices) glArrayElement(static_cast<GLint>(index));
        glEnd();
      });
      EXPECT_TRUE(together == one_by_one);
    }
  }
}

TEST(SharedVertices, ReachTheRendererOnce) {
  Screen screen;
  std::minstd_rand random(12);
  const std::vector<ColoredPoint> points = random_points(900, random);
  use(points);
  std::vector<GLushort> indices(6000);
  for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<GLushort>(i * 7 % points.size());
  Counter counter;
  screen.context.renderer().set_observer(&counter);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_SHORT, indices.data());
  screen.context.flush_vertices();
  EXPECT_EQ(counter.vertices, 900);
  EXPECT_EQ(counter.named, 6000);
  EXPECT_EQ(counter.batches, 1);
}

/// A grid of quads, each corner given for each quad.
void grid(int side) {
  glBegin(GL_QUADS);
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      for (const auto& [x, y] : {std::array{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
        const float u = static_cast<float>(column + x) / static_cast<float>(side);
        const float v = static_cast<float>(row + y) / static_cast<float>(side);
        glColor3f(u, v, 1 - u);
        glVertex3f(2.2f * u - 1.1f, 2.2f * v - 1.1f, u * v);
      }
    }
  }
  glEnd();
}

TEST(SharedVertices, OfAListAreFoundWhenItIsMade) {
  Screen screen;
  Counter counter;
  const auto at_once = picture(screen, [] { grid(40); });
  glNewList(1, GL_COMPILE);
  grid(40);
  glEndList();
  screen.context.renderer().set_observer(&counter);
  const auto from_list = picture(screen, [] { glCallList(1); });
  EXPECT_TRUE(at_once == from_list);
  EXPECT_EQ(counter.named, 40 * 40 * 4);
  EXPECT_LT(counter.vertices, 41 * 41 * 11 / 10) << "1681 are distinct; few stand in two batches";
}

TEST(SharedVertices, OfAListKeepTheCurrentValuesThatItLeavesAlone) {
  Screen screen;
  glNewList(1, GL_COMPILE);
  glBegin(GL_QUADS);
  for (int i = 0; i < 4; ++i) {
    for (const auto& [x, y] : {std::array{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) glVertex2i(x, y);
  }
  glEnd();
  glEndList();
  for (const float red : {0.2f, 0.8f}) {
    glColor3f(red, 0, 0);
    glCallList(1);
    EXPECT_EQ(screen.pixels()[100] & 0xFF, red < 0.5f ? 51u : 204u);
  }
}

}  // namespace
}  // namespace gouraud::api
