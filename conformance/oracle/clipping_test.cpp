#include "conformance/oracle/clipping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

ClipVertex<float> clip_vertex(float x, float y, float z, float w, double red = 0) {
  ClipVertex<float> out;
  out.position = {x, y, z, w};
  out.colors.primary[front] = {red, 0, 0, 1};
  return out;
}

TEST(ClipTriangle, InsideStaysAsItIs) {
  const std::array<ClipVertex<float>, 3> triangle{clip_vertex(0, 0, 0, 1), clip_vertex(1, 0, 0, 1),
                                                  clip_vertex(0, 1, 0, 1)};
  const auto polygon = clip_triangle(triangle, 5);
  ASSERT_EQ(polygon.vertices.size(), 3u);
  EXPECT_EQ(polygon.vertices[1].position, triangle[1].position);
  EXPECT_EQ(polygon.boundary, (std::vector<bool>{true, false, true}));
}

TEST(ClipTriangle, CutsOffACornerAndFlagsTheNewEdge) {
  const auto polygon = clip_triangle<float>(
      {clip_vertex(0, -0.5f, 0, 1, 0), clip_vertex(2, -0.5f, 0, 1, 1), clip_vertex(0, 0.5f, 0, 1, 0)}, 0);
  ASSERT_EQ(polygon.vertices.size(), 4u);
  EXPECT_EQ(polygon.vertices[1].position, (std::array<float, 4>{1, -0.5f, 0, 1}));
  EXPECT_EQ(polygon.vertices[2].position, (std::array<float, 4>{1, 0, 0, 1}));
  EXPECT_EQ(polygon.vertices[1].colors.primary[front][0], 0.5);
  EXPECT_EQ(polygon.boundary, (std::vector<bool>{false, true, false, false}));
}

TEST(ClipTriangle, CutsWhatIsBehindTheEye) {
  const auto polygon =
      clip_triangle<float>({clip_vertex(0, 0, 0, 1), clip_vertex(0.5f, 0, 0, 1), clip_vertex(0, 1, 0, -1)}, 7);
  for (const auto& vertex : polygon.vertices) EXPECT_GT(vertex.position[3], 0.0f);
  EXPECT_EQ(polygon.vertices.size(), 4u);
  EXPECT_TRUE(clip_triangle<float>({clip_vertex(0, 0, 0, -1), clip_vertex(1, 0, 0, -1), clip_vertex(0, 1, 0, -1)}, 7)
                  .vertices.empty());
}

TEST(ClipTriangle, DropsWhatIsNotFinite) {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::array<ClipVertex<float>, 3> triangle{clip_vertex(0, 0, 0, 1), clip_vertex(1, 0, 0, 1),
                                                clip_vertex(0, 1, 0, 1)};
      triangle[1].position[k] = bad;
      EXPECT_TRUE(clip_triangle(triangle, 7).vertices.empty());
      EXPECT_FALSE(clip_line<float>({triangle[0], triangle[1]}));
      EXPECT_FALSE(in_view_volume(triangle[1]));
    }
  }
}

TEST(ClipLine, CutsBothEnds) {
  const auto line = clip_line<float>({clip_vertex(-3, 0, 0, 1, 0), clip_vertex(5, 0, 0, 1, 1)});
  ASSERT_TRUE(line);
  EXPECT_EQ((*line)[0].position[0], -1.0f);
  EXPECT_EQ((*line)[1].position[0], 1.0f);
  EXPECT_EQ((*line)[0].colors.primary[front][0], 0.25);
  EXPECT_EQ((*line)[1].colors.primary[front][0], 0.5);
  EXPECT_FALSE(clip_line<float>({clip_vertex(-3, 2, 0, 1), clip_vertex(5, 2, 0, 1)}));
  EXPECT_FALSE(clip_line<float>({clip_vertex(-3, 0, 0, 1), clip_vertex(0, 3, 0, 1)}));
}

TEST(ClipLine, KeepsWhatIsVisibleOfVeryLongLines) {
  const auto line = clip_line<float>({clip_vertex(-0x1p40f, -0x1p38f, 0, 1), clip_vertex(0x1p41f, 0x1p39f, 0, 1)});
  ASSERT_TRUE(line);
  EXPECT_EQ((*line)[0].position, (std::array<float, 4>{-1, -0.25f, 0, 1}));
  EXPECT_EQ((*line)[1].position, (std::array<float, 4>{1, 0.25f, 0, 1}));
}

TEST(ViewVolume, HoldsItsBoundary) {
  EXPECT_TRUE(in_view_volume(clip_vertex(1, -1, 1, 1)));
  EXPECT_FALSE(in_view_volume(clip_vertex(1.001f, 0, 0, 1)));
  EXPECT_FALSE(in_view_volume(clip_vertex(0, 0, 0, -1)));
}

/// What is seen of a clipped triangle is what one sees of it through a viewport that holds it all.
TEST(Clipping, ChangesNoVisiblePixelsColourOrDepth) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> coordinate(-40.0f, 104.0f), unit(0.0f, 1.0f);
  for (int n = 0; n < 100; ++n) {
    std::vector<TestVertex> vertices;
    for (int i = 0; i < 3; ++i) {
      vertices.push_back(
          at(coordinate(random), coordinate(random), unit(random), {unit(random), unit(random), unit(random), 1}));
    }
    pipeline::DrawState state = window_state();
    state.raster.depth = {true, true, pipeline::CompareFunc::always};
    TestOracle clipped({PositionModel::exact, 0.5}), whole({PositionModel::exact, 0.5});
    clipped.draw(state, pipeline::PrimitiveMode::triangles, vertices);

    // The same window positions: the viewport four times as large, about the same middle.
    state.viewport.x = state.viewport.y = -96;
    state.viewport.width_px = state.viewport.height_px = 256;
    glm::mat4& projection = state.transform.projection;
    projection[0][0] = projection[1][1] = 2.0f / 256;
    projection[3][0] = projection[3][1] = -0.25f;
    state.transform.modelview_projection = projection;
    whole.draw(state, pipeline::PrimitiveMode::triangles, vertices);
    EXPECT_EQ(clipped.picture().fragments_written, whole.picture().fragments_written);
    for (std::size_t i = 0; i < clipped.picture().pixels.size(); ++i) {
      const OraclePixel &a = clipped.picture().pixels[i], &b = whole.picture().pixels[i];
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(a.color[k], b.color[k], 1e-6);
      EXPECT_NEAR(a.depth_units, b.depth_units, 0.01);
    }
  }
}

// [ARB_clip_control]: z from 0 on.
TEST(Clipping, TheNearPlaneAtZero) {
  const std::array<ClipVertex<float>, 2> ends{clip_vertex(0, 0, -0.25f, 1), clip_vertex(0.5f, 0, 0.75f, 1)};
  EXPECT_EQ(clip_line<float>(ends)->at(0).position[2], -0.25f);
  const auto cut = clip_line<float>(ends, {}, true);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->at(0).position[2], 0.0f);
  EXPECT_EQ(cut->at(0).position[0], 0.125f);
  EXPECT_TRUE(in_view_volume(ends[0]));
  EXPECT_FALSE(in_view_volume(ends[0], {}, true));
  const auto polygon = clip_triangle<float>({ends[0], ends[1], clip_vertex(0, 0.5f, 0.5f, 1)}, 7, {}, true);
  ASSERT_EQ(polygon.vertices.size(), 4u);
  for (const auto& vertex : polygon.vertices) EXPECT_GE(vertex.position[2], 0.0f);
}

}  // namespace
}  // namespace gouraud::oracle
