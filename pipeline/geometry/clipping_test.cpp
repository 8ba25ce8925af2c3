#include "pipeline/geometry/clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "pipeline/geometry/test_support.h"
#include "pipeline/geometry/viewport.h"

namespace gouraud::pipeline {
namespace {

using Clip = std::array<float, 4>;
constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
const ViewportState viewport{0, 0, 640, 480, 0.0, 1.0, 480};

/// Vertices given in clip space, whose front colours are (1, 0, 0, 1), (0, 1, 0, 1), (0, 0, 1, 1).
struct Scene {
  std::unique_ptr<ProcessedVertices> vertices = blank_vertices();
  std::vector<AssembledTriangle> triangles;

  explicit Scene(const std::vector<Clip>& positions) { set(positions); }
  void set(const std::vector<Clip>& positions) {
    triangles.clear();
    vertices->count = static_cast<std::int32_t>(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        vertices->position_clip[k][i] = positions[i][k];
        vertices->position_eye[k][i] = 10 * positions[i][k];
      }
      vertices->color_front[i] = {i == 0 ? 1.0f : 0, i == 1 ? 1.0f : 0, i == 2 ? 1.0f : 0, 1};
    }
    project_to_window(viewport, *vertices);
  }
  void clip(std::uint8_t edges = 7, const ClipAttributes& attributes = {true, true, false, false, 0}) {
    clip_triangle({{0, 1, 2}, 2, edges}, viewport, attributes, *vertices, triangles);
  }
  Clip position(std::uint16_t index) const {
    const auto& p = vertices->position_clip;
    return {p[0][index], p[1][index], p[2][index], p[3][index]};
  }
  std::vector<Clip> corners(const AssembledTriangle& t) const {
    return {position(t.vertex[0]), position(t.vertex[1]), position(t.vertex[2])};
  }

  /// Twice the area in pixels, y down.
  double window_area() const {
    double sum = 0;
    for (const AssembledTriangle& t : triangles) {
      const WindowVertex &a = vertices->window[t.vertex[0]], &b = vertices->window[t.vertex[1]],
                         &c = vertices->window[t.vertex[2]];
      sum += (static_cast<double>(b.x) - a.x) * (static_cast<double>(c.y_raster) - a.y_raster) -
             (static_cast<double>(c.x) - a.x) * (static_cast<double>(b.y_raster) - a.y_raster);
    }
    return sum;
  }
};

TEST(ClipTriangle, CutsACornerOffAtTheRightPlane) {
  Scene scene({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0.5f, 0, 1}});
  scene.clip();
  ASSERT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(scene.vertices->count, 5);
  // The polygon is 0, (1, 0), (1, 1/4), 2; its fan is (1, 2, 0), (2, 3, 0).
  EXPECT_EQ(scene.position(3), (Clip{1, 0, 0, 1}));
  EXPECT_EQ(scene.position(4), (Clip{1, 0.25f, 0, 1}));
  EXPECT_EQ(scene.triangles[0].vertex, (std::array<std::uint16_t, 3>{3, 4, 0}));
  EXPECT_EQ(scene.triangles[1].vertex, (std::array<std::uint16_t, 3>{4, 2, 0}));
}

TEST(ClipTriangle, GivesNewVerticesWindowPositionsAndClearOutcodes) {
  Scene scene({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0.5f, 0, 1}});
  scene.clip();
  EXPECT_EQ(scene.vertices->outcode[3], 0);
  EXPECT_EQ(scene.vertices->window[3].x, 640.0f);
  EXPECT_EQ(scene.vertices->window[4].y_raster, 180.0f);
}

TEST(ClipTriangle, InterpolatesWhatItIsToldTo) {
  Scene scene({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0.5f, 0, 1}});
  scene.vertices->color_front[3].r = scene.vertices->specular_front[3].r = 7;
  scene.clip(7, {true, false, false, false});
  EXPECT_EQ(scene.vertices->position_eye[0][3], 10.0f);
  EXPECT_EQ(scene.vertices->color_front[3].r, 7.0f);
  scene.vertices->count = 3;
  scene.clip(7, {false, true, true, true});
  EXPECT_EQ(scene.vertices->color_front[3].r, 0.5f);
  EXPECT_EQ(scene.vertices->color_front[3].g, 0.5f);
  EXPECT_EQ(scene.vertices->specular_front[3].r, 0.0f);
}

TEST(ClipTriangle, KeepsTheProvokingVertexEvenIfItIsCutOff) {
  Scene scene({{0, 0, 0, 1}, {0, 0.5f, 0, 1}, {2, 0, 0, 1}});
  scene.clip();
  ASSERT_EQ(scene.triangles.size(), 2u);
  for (const AssembledTriangle& t : scene.triangles) EXPECT_EQ(t.provoking, 2);
}

/// The boundary edges of the clipped polygon as pairs of vertices, in order around it.
std::vector<std::pair<int, int>> boundary(const Scene& scene) {
  std::vector<std::pair<int, int>> edges;
  for (const AssembledTriangle& t : scene.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if ((t.edges >> k & 1) != 0) edges.emplace_back(t.vertex[k], t.vertex[(k + 1) % 3]);
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

TEST(ClipTriangle, MakesTheCutABoundaryEdge) {
  Scene scene({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0.5f, 0, 1}});
  scene.clip();
  EXPECT_EQ(boundary(scene), (std::vector<std::pair<int, int>>{{0, 3}, {2, 0}, {3, 4}, {4, 2}}));
}

TEST(ClipTriangle, LeavesTheFlagsOfTheOldEdges) {
  Scene scene({{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0.5f, 0, 1}});
  scene.clip(0);
  EXPECT_EQ(boundary(scene), (std::vector<std::pair<int, int>>{{3, 4}}));
}

TEST(ClipTriangle, MeasuresFromTheVertexNearerToThePlane) {
  // d = 0.4 inside, -1 outside: t = 0.4 / (0.4 + 1) from the inside vertex, each step rounded.
  Scene scene({{0.6f, 0.3f, 0, 1}, {2, 0.7f, 0, 1}, {0.6f, 0.9f, 0, 1}});
  scene.clip();
  const volatile float d0 = -0.6f + 1, t = d0 / (d0 - (-2.0f + 1)), rise = 0.7f - 0.3f, step = t * rise;
  EXPECT_EQ(scene.position(3)[1], 0.3f + step);
  // d = 1.4 inside, -1 outside: from the outside vertex.
  scene = Scene({{-0.4f, 0.3f, 0, 1}, {2, 0.7f, 0, 1}, {-0.4f, 0.9f, 0, 1}});
  scene.clip();
  const volatile float far_d = 0.4f + 1, far_t = -1.0f / (-1.0f - far_d), fall = 0.3f - 0.7f, far_step = far_t * fall;
  EXPECT_EQ(scene.position(3)[1], 0.7f + far_step);
}

TEST(ClipTriangle, BehindTheEyeKeepsTheVisiblePart) {
  // w = z at the vertices: two before the eye, one behind it. The volume's slice is -w <= x, y, z <= w.
  Scene scene({{-0.5f, -0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}, {0, 1, 0, -1}});
  scene.clip();
  ASSERT_FALSE(scene.triangles.empty());
  for (const AssembledTriangle& t : scene.triangles) {
    for (const Clip& p : scene.corners(t)) EXPECT_GT(p[3], 0.0f);
  }
  EXPECT_NE(scene.window_area(), 0.0);
}

TEST(ClipTriangle, WithAVertexAtWZeroKeepsTheVisiblePart) {
  Scene scene({{-0.5f, -0.5f, 0, 1}, {0.5f, -0.5f, 0, 1}, {0, 1, 0, 0}});
  scene.clip();
  ASSERT_FALSE(scene.triangles.empty());
  for (const AssembledTriangle& t : scene.triangles) {
    for (const std::uint16_t v : t.vertex) EXPECT_EQ(scene.vertices->outcode[v], 0);
  }
}

TEST(ClipTriangle, WhollyBehindTheEyeIsNothing) {
  Scene scene({{-0.5f, -0.5f, 0, -1}, {0.5f, -0.5f, 0, -1}, {0, 0.5f, 0, -1}});
  scene.clip();
  EXPECT_TRUE(scene.triangles.empty());
  EXPECT_EQ(scene.vertices->count, 3);
}

TEST(ClipTriangle, ThatCoversEverythingBecomesTheViewport) {
  Scene scene({{-10, -10, 0, 1}, {10, -10, 0, 1}, {0, 20, 0, 1}});
  scene.clip();
  EXPECT_DOUBLE_EQ(std::abs(scene.window_area()), 2 * 640 * 480);
}

TEST(ClipTriangle, CanMeetAllSixPlanes) {
  // Through the origin, square to the diagonal of the cube: the section is a regular hexagon.
  Scene scene({{10, -5, -5, 1}, {-5, 10, -5, 1}, {-5, -5, 10, 1}});
  scene.clip();
  EXPECT_EQ(scene.triangles.size(), 4u);
  EXPECT_LE(scene.vertices->count, 3 + max_clip_vertices);
  // Its projection along z: the square of 640 x 480 pixels less two corners of an eighth each.
  EXPECT_NEAR(std::abs(scene.window_area()), 2 * 640 * 480 * 0.75, 0.1);
}

TEST(ClipTriangle, ThatTouchesAPlaneIsNotChanged) {
  Scene scene({{1, 0, 0, 1}, {1, 1, 0, 1}, {-2, 0, 0, 1}});
  scene.clip();
  ASSERT_EQ(scene.triangles.size(), 2u);
  EXPECT_EQ(scene.position(scene.triangles[0].vertex[2]), (Clip{1, 0, 0, 1}));
}

TEST(ClipTriangle, IsDroppedIfACoordinateOrADistanceIsNotFinite) {
  for (const float bad : {nan, inf, -inf}) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::vector<Clip> positions{{0, 0, 0, 1}, {2, 0, 0, 1}, {0, 0.5f, 0, 1}};
      positions[0][k] = bad;
      Scene scene(positions);
      scene.clip();
      EXPECT_TRUE(scene.triangles.empty());
    }
  }
  Scene scene({{0, 0, 0, 1}, {3e38f, 0, 0, -3e38f}, {0, 0.5f, 0, 1}});
  scene.clip();
  EXPECT_TRUE(scene.triangles.empty());
  EXPECT_EQ(scene.vertices->count, 3);
}

TEST(ClipTriangle, OfASliverStaysInsideTheVolume) {
  Numbers number(1);
  Scene scene({});
  for (int round = 0; round < 2000; ++round) {
    const Clip a{3 * number(), 3 * number(), 3 * number(), 1};
    Clip b = a, c{3 * number(), 3 * number(), 3 * number(), 1};
    for (std::size_t k = 0; k < 3; ++k) b[k] = a[k] + 1e-6f * number();
    scene.set({a, b, c});
    if ((scene.vertices->outcode[0] | scene.vertices->outcode[1] | scene.vertices->outcode[2]) == 0) continue;
    scene.clip();
    for (const AssembledTriangle& t : scene.triangles) {
      for (const Clip& p : scene.corners(t)) {
        for (std::size_t k = 0; k < 3; ++k) ASSERT_LE(std::abs(p[k]), p[3] * 1.00001f);
      }
    }
  }
}

// The area of what is left, against clipping in double.

using Exact = std::array<double, 4>;

double exact_window_area(const std::vector<Clip>& triangle) {
  std::vector<Exact> polygon;
  for (const Clip& p : triangle) polygon.push_back({p[0], p[1], p[2], p[3]});
  for (std::size_t plane = 0; plane < 6; ++plane) {
    const auto distance = [plane](const Exact& p) { return p[3] + (plane % 2 == 0 ? -p[plane / 2] : p[plane / 2]); };
    std::vector<Exact> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Exact &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = distance(a), db = distance(b);
      if (da >= 0) kept.push_back(a);
      if ((da >= 0) == (db >= 0)) continue;
      Exact p;
      for (std::size_t k = 0; k < 4; ++k) p[k] = (da * b[k] - db * a[k]) / (da - db);
      kept.push_back(p);
    }
    polygon = kept;
  }
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Exact &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += (a[0] / a[3]) * (b[1] / b[3]) - (b[0] / b[3]) * (a[1] / a[3]);
  }
  return -sum * 320 * 240;
}

TEST(ClipTriangle, LeavesTheExactArea) {
  Numbers number(2);
  Scene scene({});
  for (int round = 0; round < 5000; ++round) {
    std::vector<Clip> positions(3);
    for (Clip& p : positions) p = {3 * number(), 3 * number(), 3 * number(), round % 2 == 0 ? 1.0f : 0.3f + number()};
    scene.set(positions);
    if ((scene.vertices->outcode[0] | scene.vertices->outcode[1] | scene.vertices->outcode[2]) == 0) continue;
    scene.clip();
    // Float's rounding, magnified where w is small: no more than 1/100000 of the viewport.
    ASSERT_NEAR(scene.window_area(), exact_window_area(positions), 2e-5 * 640 * 480) << "round " << round;
  }
}

TEST(ClipTriangle, NeverLeavesItsRoomForAnyInput) {
  Numbers number(3, true);
  Scene scene({});
  for (int round = 0; round < 20000; ++round) {
    std::vector<Clip> positions(3);
    for (Clip& p : positions) p = {number(), number(), number(), number()};
    scene.set(positions);
    if (round % 50 == 0) scene.vertices->count = processed_stride - max_clip_vertices;
    const std::int32_t count = scene.vertices->count;
    scene.clip();
    ASSERT_LE(scene.vertices->count, count + max_clip_vertices);
    for (const AssembledTriangle& t : scene.triangles) {
      for (const std::uint16_t v : t.vertex) {
        const WindowVertex& w = scene.vertices->window[v];
        ASSERT_EQ(scene.vertices->outcode[v], 0);
        ASSERT_TRUE(std::isfinite(w.x) && std::isfinite(w.y_raster) && std::isfinite(w.z) &&
                    std::isfinite(w.w_inverse));
      }
    }
  }
}

// Lines.

/// The end points after clipping, as (x, y, z, w); empty if nothing is left.
std::vector<Clip> clipped(const Clip& a, const Clip& b) {
  static Scene scene({});
  scene.set({a, b});
  AssembledLine line{{0, 1}, 1, false};
  if (!clip_line(line, viewport, {true, true, false, false}, *scene.vertices)) return {};
  EXPECT_EQ(line.provoking, 1);
  for (const std::uint16_t v : line.vertex) EXPECT_EQ(scene.vertices->outcode[v], 0);
  return {scene.position(line.vertex[0]), scene.position(line.vertex[1])};
}

TEST(ClipLine, CutsEitherEnd) {
  EXPECT_EQ(clipped({0, 0, 0, 1}, {2, 0.5f, 0, 1}), (std::vector<Clip>{{0, 0, 0, 1}, {1, 0.25f, 0, 1}}));
  EXPECT_EQ(clipped({2, 0.5f, 0, 1}, {0, 0, 0, 1}), (std::vector<Clip>{{1, 0.25f, 0, 1}, {0, 0, 0, 1}}));
}

TEST(ClipLine, CutsBothEndsAtWhicheverPlaneComesLast) {
  EXPECT_EQ(clipped({-2, -4, 0, 1}, {2, 4, 0, 1}), (std::vector<Clip>{{-0.5f, -1, 0, 1}, {0.5f, 1, 0, 1}}));
  EXPECT_EQ(clipped({-4, -2, 0, 1}, {4, 2, 0, 1}), (std::vector<Clip>{{-1, -0.5f, 0, 1}, {1, 0.5f, 0, 1}}));
}

TEST(ClipLine, ThatPassesACornerIsNothing) {
  EXPECT_TRUE(clipped({-3, 0, 0, 1}, {0, 3, 0, 1}).empty());
  EXPECT_FALSE(clipped({-1.5f, 0, 0, 1}, {0, 1.5f, 0, 1}).empty());
  EXPECT_TRUE(clipped({-2, 0, 0, 1}, {0, 2, 0, 1}).empty());  // it touches the corner
}

TEST(ClipLine, BehindTheEyeKeepsTheVisiblePart) {
  // w falls from 1 to -1; the near plane z = -w cuts at w = -z.
  const std::vector<Clip> line = clipped({0, 0, -0.5f, 1}, {0, 0, -0.5f, -1});
  ASSERT_EQ(line.size(), 2u);
  EXPECT_EQ(line[1], (Clip{0, 0, -0.5f, 0.5f}));
  EXPECT_TRUE(clipped({0, 0, 0, -1}, {0.5f, 0, 0, -1}).empty());
}

TEST(ClipLine, WithHugeEndsIsDrawnWhereItShould) {
  for (const float huge : {1e3f, 1e10f, 1e20f, 3e38f}) {
    EXPECT_EQ(clipped({-huge, 0.5f, 0, 1}, {huge, 0.5f, 0, 1}), (std::vector<Clip>{{-1, 0.5f, 0, 1}, {1, 0.5f, 0, 1}}));
    EXPECT_EQ(clipped({-huge, -huge, 0.25f, 1}, {huge, huge, 0.25f, 1}),
              (std::vector<Clip>{{-1, -1, 0.25f, 1}, {1, 1, 0.25f, 1}}));
    EXPECT_EQ(clipped({-huge, huge, huge, 1}, {huge, -huge, -huge, 1}),
              (std::vector<Clip>{{-1, 1, 1, 1}, {1, -1, -1, 1}}));
  }
}

TEST(ClipLine, InterpolatesColors) {
  Scene scene({{0, 0, 0, 1}, {4, 0, 0, 1}});
  AssembledLine line{{0, 1}, 1, false};
  ASSERT_TRUE(clip_line(line, viewport, {false, true, false, false}, *scene.vertices));
  const Rgba& color = scene.vertices->color_front[line.vertex[1]];
  EXPECT_EQ(color.r, 0.75f);
  EXPECT_EQ(color.g, 0.25f);
  EXPECT_EQ(color.a, 1.0f);
}

TEST(ClipLine, IsDroppedIfACoordinateIsNotFinite) {
  for (const float bad : {nan, inf, -inf}) EXPECT_TRUE(clipped({0, 0, 0, 1}, {bad, 0, 0, 1}).empty());
}

TEST(ClipLine, StaysOnTheLineAndInTheVolume) {
  Numbers number(4);
  for (int round = 0; round < 5000; ++round) {
    const Clip a{3 * number(), 3 * number(), 3 * number(), 1.2f + number()},
        b{3 * number(), 3 * number(), 3 * number(), 1.2f + number()};
    for (const Clip& p : clipped(a, b)) {
      for (std::size_t k = 0; k < 3; ++k) ASSERT_LE(std::abs(p[k]), p[3] * 1.000001f);
      // p = a + t (b - a) with the same t in every coordinate.
      double t = 0, longest = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        const double side = static_cast<double>(b[k]) - a[k];
        if (std::abs(side) > std::abs(longest)) longest = side, t = (static_cast<double>(p[k]) - a[k]) / side;
      }
      for (std::size_t k = 0; k < 4; ++k) ASSERT_NEAR(a[k] + t * (static_cast<double>(b[k]) - a[k]), p[k], 1e-6);
    }
  }
}

TEST(ClipLine, NeverLeavesItsRoomForAnyInput) {
  Numbers number(5, true);
  for (int round = 0; round < 20000; ++round) {
    for (const Clip& p : clipped({number(), number(), number(), number()}, {number(), number(), number(), number()})) {
      for (const float coordinate : p) ASSERT_TRUE(std::isfinite(coordinate));
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
