#include "pipeline/geometry/clip_planes.h"

#include <gtest/gtest.h>

#include "pipeline/geometry/clipping.h"
#include "pipeline/geometry/test_support.h"
#include "pipeline/geometry/viewport.h"

namespace gouraud::pipeline {
namespace {

/// A triangle in eye space, which is clip space here.
struct Cut {
  Cut() {
    viewport.width_px = viewport.height_px = 100;
    viewport.target_height_px = 100;
    constexpr float corner[3][2] = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {-0.5f, 0.5f}};
    vertices->count = 3;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        vertices->position_eye[k][i] = vertices->position_clip[k][i] = k < 2 ? corner[i][k] : k == 3 ? 1.0f : 0.0f;
      }
      vertices->varying[0][i] = corner[i][0];
    }
  }
  void test() {
    project_to_window(viewport, *vertices);
    test_clip_planes(planes, *vertices);
  }
  ClipAttributes attributes() const { return {true, false, false, false, 1, &planes}; }

  ViewportState viewport;
  ClipPlaneState planes;
  std::unique_ptr<ProcessedVertices> vertices = blank_vertices();
};

TEST(ClipPlanes, SetABitEachOfVerticesBehindThem) {
  for_each_target([] {
    Cut cut;
    cut.planes.count = 8;
    cut.planes.plane_eye[0] = {1, 0, 0, 0.5f};  // touches two vertices
    cut.planes.plane_eye[7] = {-1, 0, 0, 0};
    cut.test();
    EXPECT_EQ(cut.vertices->outcode[0], 0);
    EXPECT_EQ(cut.vertices->outcode[1], outside_clip_plane_0 << 7);
    EXPECT_EQ(cut.vertices->outcode[2], 0);
  });
}

TEST(ClipPlanes, CutTrianglesWithTheirVaryings) {
  Cut cut;
  cut.planes.count = 1;
  cut.planes.plane_eye[0] = {-1, 0, 0, 0.25f};  // x <= 0.25
  cut.test();
  std::vector<AssembledTriangle> out;
  clip_triangle({{0, 1, 2}, 2, 7}, cut.viewport, cut.attributes(), *cut.vertices, out);
  ASSERT_EQ(out.size(), 2u);
  for (const AssembledTriangle& triangle : out) {
    for (const std::uint16_t index : triangle.vertex) {
      EXPECT_LE(cut.vertices->position_eye[0][index], 0.25f);
      EXPECT_EQ(cut.vertices->varying[0][index], cut.vertices->position_eye[0][index]);
      EXPECT_EQ(cut.vertices->outcode[index], 0);
    }
  }
}

TEST(ClipPlanes, CutLinesAndRemoveThem) {
  Cut cut;
  cut.planes.count = 2;
  cut.planes.plane_eye[0] = {-1, 0, 0, 0.25f};
  cut.planes.plane_eye[1] = {1, 0, 0, 0.25f};
  cut.test();
  AssembledLine line{{0, 1}, 1, false};
  ASSERT_TRUE(clip_line(line, cut.viewport, cut.attributes(), *cut.vertices));
  EXPECT_EQ(cut.vertices->varying[0][line.vertex[0]], -0.25f);
  EXPECT_EQ(cut.vertices->varying[0][line.vertex[1]], 0.25f);
  AssembledLine outside{{0, 2}, 2, false};
  EXPECT_FALSE(clip_line(outside, cut.viewport, cut.attributes(), *cut.vertices));
}

TEST(ClipPlanes, TakeWhatIsNotANumberForOutside) {
  Cut cut;
  cut.planes.count = 1;
  cut.planes.plane_eye[0] = {std::numeric_limits<float>::quiet_NaN(), 0, 0, 1};
  cut.test();
  EXPECT_EQ(cut.vertices->outcode[0], outside_clip_plane_0);
}

}  // namespace
}  // namespace gouraud::pipeline
