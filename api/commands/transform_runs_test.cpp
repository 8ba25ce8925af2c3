// Primitives under changing matrices, gathered in one batch, look like the same primitives drawn one at a time.
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "api/commands/test_screen.h"

namespace gouraud::api {
namespace {

/// Batches as the renderer gets them, and what onlookers are shown.
struct Counter : pipeline::DrawObserver {
  int draws = 0, runs = 0;
  std::vector<float> scales;  ///< of each draw's matrix
  void target_changed(const pipeline::Framebuffer&) override {}
  void clear(const pipeline::ClearState&) override {}
  void draw(const pipeline::DrawState& state, const pipeline::VertexBatch& batch) override {
    ++draws;
    runs += static_cast<int>(batch.transform_runs.size());
    scales.push_back(state.transform.modelview[0][0]);
  }
};

/// Small primitives of all kinds, each under its own matrix; some with their own material or from an array.
class Scene {
 public:
  explicit Scene(unsigned seed) : random_(seed) {}

  template <class Between>
  void draw(int count, const Between& between) {
    glNormal3f(0, 0, 1);
    material();
    for (int i = 0; i < count; ++i) {
      glPushMatrix();
      glTranslatef(number(), number(), number());
      glRotatef(180 * number(), number(), number(), 1);
      if (random_() % 4 == 0) glScalef(1, 2, 0.5f);
      if (random_() % 2 == 0) material();
      const auto mode = static_cast<GLenum>(random_() % 3 == 0 ? GL_QUADS : random_() % (GL_POLYGON + 1));
      random_() % 4 == 0 ? draw_elements(mode) : draw_vertices(mode);
      glPopMatrix();
      between();
    }
  }

 private:
  float number() { return static_cast<float>(random_() % 2048) / 1024.0f - 1.0f; }
  void material() {
    const std::array<float, 4> color{number(), 0.5f + 0.5f * number(), 0.5f, 1};
    glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, color.data());
  }
  void draw_vertices(GLenum mode) {
    glBegin(mode);
    for (int i = 0, count = 4 * static_cast<int>(1 + random_() % 3); i < count; ++i) {
      glNormal3f(number(), number(), 1);
      glVertex3f(0.5f * number(), 0.5f * number(), 0.5f * number());
    }
    glEnd();
  }
  void draw_elements(GLenum mode) {
    std::array<float, 24> points;
    for (float& coordinate : points) coordinate = 0.5f * number();
    std::array<GLushort, 12> elements;
    for (GLushort& element : elements) element = static_cast<GLushort>(random_() % 8);
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, 0, points.data());
    glDrawElements(mode, static_cast<GLsizei>(elements.size()), GL_UNSIGNED_SHORT, elements.data());
  }

  std::minstd_rand random_;
};

void set_light() {
  const std::array<float, 4> position{0.3f, 0.5f, 1, 0}, near_position{0.5f, -0.5f, 0.5f, 1}, red{1, 0, 0, 1};
  glLightfv(GL_LIGHT0, GL_POSITION, position.data());
  glLightfv(GL_LIGHT1, GL_POSITION, near_position.data());
  glLightfv(GL_LIGHT1, GL_SPECULAR, red.data());
  glEnable(GL_LIGHT0);
  glEnable(GL_LIGHT1);
  glEnable(GL_LIGHTING);
  glEnable(GL_DEPTH_TEST);
}

std::vector<std::uint32_t> picture(Screen& screen, unsigned seed, const auto& between) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  Scene(seed).draw(150, between);
  return screen.pixels();
}

TEST(TransformRuns, LookLikeOneDrawAfterTheOther) {
  for (int variant = 0; variant < 6; ++variant) {
    Screen screen;
    set_light();
    if (variant == 1) glEnable(GL_NORMALIZE);
    if (variant == 2) glEnable(GL_FOG);
    if (variant == 3) glShadeModel(GL_FLAT);
    if (variant == 4) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    if (variant == 5) {
      glEnable(GL_CLIP_PLANE0);
      glEnable(GL_RESCALE_NORMAL);
      glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    }
    const auto seed = static_cast<unsigned>(7 + variant);
    const auto together = picture(screen, seed, [] {});
    const auto apart = picture(screen, seed, [] { glFlush(); });
    EXPECT_EQ(together, apart) << "variant " << variant;
  }
}

TEST(TransformRuns, AreOneBatchUntilAnotherStateChanges) {
  Screen screen;
  set_light();
  Scene scene(1);
  scene.draw(20, [] {});
  const auto& batch = current_context()->immediate.batch;
  EXPECT_EQ(batch.transform_runs.size(), 20u);
  EXPECT_EQ(batch.transform_runs[0].first, 0);
  glDisable(GL_DEPTH_TEST);
  glBegin(GL_POINTS);
  EXPECT_EQ(batch.transform_runs.size(), 0u);
  EXPECT_EQ(batch.count, 0);
  glEnd();
}

TEST(TransformRuns, AreShownToOnlookersOneByOne) {
  Screen screen;
  Counter counter;
  current_context()->renderer().set_observer(&counter);
  for (int i = 1; i <= 5; ++i) {
    glLoadIdentity();
    glScalef(static_cast<float>(i), 1, 1);
    glBegin(GL_TRIANGLES);
    for (int k = 0; k < 3; ++k) glVertex2f(0.1f * static_cast<float>(k), 0.1f * static_cast<float>(k * k));
    glEnd();
  }
  glFlush();
  current_context()->renderer().set_observer(nullptr);
  EXPECT_EQ(counter.draws, 5);
  EXPECT_EQ(counter.runs, 0);
  EXPECT_EQ(counter.scales, (std::vector<float>{1, 2, 3, 4, 5}));
}

}  // namespace
}  // namespace gouraud::api
