#include "pipeline/geometry/viewport.h"

#include <cmath>

#include "pipeline/geometry/test_support.h"

namespace gouraud::pipeline {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

struct Projected {
  unsigned outcode;
  WindowVertex window;
};

Projected project(const ViewportState& state, const std::array<float, 4>& clip) {
  const auto vertices = blank_vertices();
  vertices->count = 1;
  for (std::size_t k = 0; k < 4; ++k) vertices->position_clip[k][0] = clip[k];
  project_to_window(state, *vertices);
  return {vertices->outcode[0], vertices->window[0]};
}

const ViewportState whole{0, 0, 640, 480, 0.0, 1.0, 480};

TEST(Viewport, PutsTheCentreOfTheClipVolumeInTheMiddleOfTheViewport) {
  const Projected p = project({100, 50, 640, 480, 0.25, 0.75, 1000}, {0, 0, 0, 2});
  EXPECT_EQ(p.outcode, 0u);
  EXPECT_EQ(p.window.x, 100 + 320);
  EXPECT_EQ(p.window.y_raster, 1000 - (50 + 240));
  EXPECT_EQ(p.window.z, 0.5f);
  EXPECT_EQ(p.window.w_inverse, 0.5f);
}

TEST(Viewport, CountsYFromTheTop) {
  EXPECT_EQ(project(whole, {0, 1, 0, 1}).window.y_raster, 0.0f);
  EXPECT_EQ(project(whole, {0, -1, 0, 1}).window.y_raster, 480.0f);
}

TEST(Viewport, MapsNearAndFarToTheDepthRangeEvenIfReversed) {
  EXPECT_EQ(project(whole, {0, 0, -1, 1}).window.z, 0.0f);
  EXPECT_EQ(project(whole, {0, 0, 1, 1}).window.z, 1.0f);
  const ViewportState reversed{0, 0, 640, 480, 1.0, 0.25, 480};
  EXPECT_EQ(project(reversed, {0, 0, -1, 1}).window.z, 1.0f);
  EXPECT_EQ(project(reversed, {0, 0, 1, 1}).window.z, 0.25f);
}

TEST(Outcode, HasOneBitForEachPlane) {
  EXPECT_EQ(project(whole, {1.5f, 0, 0, 1}).outcode, outside_right);
  EXPECT_EQ(project(whole, {-1.5f, 0, 0, 1}).outcode, outside_left);
  EXPECT_EQ(project(whole, {0, 1.5f, 0, 1}).outcode, outside_top);
  EXPECT_EQ(project(whole, {0, -1.5f, 0, 1}).outcode, outside_bottom);
  EXPECT_EQ(project(whole, {0, 0, -1.5f, 1}).outcode, outside_near);
  EXPECT_EQ(project(whole, {0, 0, 1.5f, 1}).outcode, outside_far);
  EXPECT_EQ(project(whole, {2, -2, 2, 1}).outcode, unsigned{outside_right | outside_bottom | outside_far});
}

TEST(Outcode, IsClearOnThePlanesThemselves) {
  EXPECT_EQ(project(whole, {1, 1, 1, 1}).outcode, 0u);
  EXPECT_EQ(project(whole, {-1, -1, -1, 1}).outcode, 0u);
}

TEST(Outcode, BehindTheEyeIsOutsideOfBothPlanesOfAnAxis) {
  EXPECT_EQ(project(whole, {0, 0, 0, -1}).outcode,
            unsigned{outside_right | outside_left | outside_top | outside_bottom | outside_near | outside_far});
}

TEST(Outcode, IsInvalidWithoutFiniteCoordinates) {
  for (const float bad : {nan, inf, -inf}) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<float, 4> clip{0, 0, 0, 1};
      clip[k] = bad;
      EXPECT_NE(project(whole, clip).outcode & outside_invalid, 0u);
    }
  }
}

TEST(Outcode, IsInvalidWhereTheVolumeHasNoWindowPosition) {
  EXPECT_EQ(project(whole, {0, 0, 0, 0}).outcode, outside_invalid);
  EXPECT_EQ(project(whole, {0, 0, 0, 1e-40f}).outcode, outside_invalid);
  EXPECT_EQ(project(whole, {0.5f, 0, 0, 0}).outcode, outside_right);  // to be clipped
}

TEST(Viewport, OfOneVertexHasTheBitsOfTheWholeBatch) {
  const auto vertices = blank_vertices();
  Numbers number(1);
  vertices->count = 1000;
  for (std::size_t i = 0; i < 1000; ++i) {
    for (std::size_t k = 0; k < 4; ++k) vertices->position_clip[k][i] = k == 3 ? 1.5f + number() : 0.5f * number();
  }
  const ViewportState odd{3, -7, 333, 217, 0.1, 0.9, 501};
  for_each_target([&] {
    project_to_window(odd, *vertices);
    for (std::int32_t i = 0; i < 1000; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (vertices->outcode[k] != 0) continue;
      const WindowVertex batch = vertices->window[k];
      ASSERT_TRUE(project_vertex(odd, *vertices, i));
      ASSERT_EQ(std::memcmp(&batch, &vertices->window[k], sizeof batch), 0);
    }
  });
}

TEST(Viewport, OfOneVertexReportsWhatHasNoPosition) {
  const auto vertices = blank_vertices();
  EXPECT_FALSE(project_vertex(whole, *vertices, 0));
  EXPECT_EQ(vertices->outcode[0], outside_invalid);
}

TEST(Viewport, GivesTheSameBitsOnEveryTargetForAnyInput) {
  const auto first = blank_vertices(), out = blank_vertices();
  Numbers number(2, true);
  first->count = out->count = 1001;
  for (std::size_t i = 0; i < 1001; ++i) {
    for (std::size_t k = 0; k < 4; ++k) first->position_clip[k][i] = out->position_clip[k][i] = number();
  }
  project_to_window(whole, *first);
  for_each_target([&] {
    project_to_window(whole, *out);
    EXPECT_TRUE(same_bits(out->outcode, first->outcode, 1001));
    for (std::size_t i = 0; i < 1001; ++i) {
      if (first->outcode[i] == 0) {
        ASSERT_EQ(std::memcmp(&out->window[i], &first->window[i], sizeof(WindowVertex)), 0);
      }
    }
  });
}

TEST(Viewport, IsFiniteWhereverTheOutcodeIsClear) {
  const auto vertices = blank_vertices();
  Numbers number(3, true);
  vertices->count = batch_capacity;
  for (int round = 0; round < 100; ++round) {
    for (std::size_t i = 0; i < batch_capacity; ++i) {
      for (std::size_t k = 0; k < 4; ++k) vertices->position_clip[k][i] = number();
    }
    project_to_window(whole, *vertices);
    for (std::size_t i = 0; i < batch_capacity; ++i) {
      const WindowVertex& w = vertices->window[i];
      if (vertices->outcode[i] != 0) continue;
      ASSERT_TRUE(std::isfinite(w.x) && std::isfinite(w.y_raster) && std::isfinite(w.z) && std::isfinite(w.w_inverse));
      ASSERT_TRUE(w.x >= -0.001f && w.x <= 640.001f && w.y_raster >= -0.001f && w.y_raster <= 480.001f);
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
