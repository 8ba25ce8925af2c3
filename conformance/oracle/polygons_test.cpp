#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "conformance/oracle/test_scene.h"

namespace gouraud::oracle {
namespace {

using pipeline::PrimitiveMode;

TEST(PolygonCoverage, RectangleOwnsItsLeftAndBottomEdges) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::quads,
              {at(10.5f, 10.5f), at(20.5f, 10.5f), at(20.5f, 20.5f), at(10.5f, 20.5f)});
  for (int y = 0; y < test_size; ++y) {
    for (int x = 0; x < test_size; ++x) {
      EXPECT_EQ(oracle.fragments(x, y), x >= 10 && x < 20 && y >= 10 && y < 20) << x << ' ' << y;
    }
  }
}

TEST(PolygonCoverage, HalfASquareHoldsTheCentresBelowItsDiagonal) {
  TestOracle oracle;
  // Centres with x + y < 32 in [0, 32]^2: rows of 31, 30, ..., 1 (centres on the slanted right edge are not owned).
  oracle.draw(window_state(), PrimitiveMode::triangles, {at(0, 0), at(32, 0), at(0, 32)});
  EXPECT_EQ(oracle.all_fragments(), 31 * 32 / 2);
  // The upper right half owns the diagonal, which is its left edge.
  oracle.draw(window_state(), PrimitiveMode::triangles, {at(32, 0), at(32, 32), at(0, 32)});
  EXPECT_EQ(oracle.all_fragments(), 32 * 32);
}

TEST(PolygonCoverage, OrientationMakesNoDifference) {
  TestOracle ccw, cw;
  ccw.draw(window_state(), PrimitiveMode::triangles, {at(3.25f, 4.5f), at(50.75f, 9.5f), at(20.125f, 60)});
  cw.draw(window_state(), PrimitiveMode::triangles, {at(3.25f, 4.5f), at(20.125f, 60), at(50.75f, 9.5f)});
  EXPECT_EQ(ccw.picture().fragments_written, cw.picture().fragments_written);
  EXPECT_GT(ccw.all_fragments(), 1000);
}

TEST(PolygonCoverage, PixelsOfARandomMeshAreDrawnExactlyOnce) {
  std::mt19937 random(1);
  for (const float grid : {1024.0f, 2.0f}) {  // at 1/2 pixel, edges and corners meet many centres
    constexpr int n = 12;
    std::array<std::array<TestVertex, n + 1>, n + 1> mesh;
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        const auto inner = [&](int k) {
          const float jitter = k == 0 || k == n ? 0.0f : std::uniform_real_distribution(-0.9f, 0.9f)(random);
          return std::round((4.0f + static_cast<float>(k) * 4.5f + jitter) * grid) / grid;
        };
        mesh[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = at(inner(i), inner(j));
      }
    }
    std::vector<TestVertex> triangles;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = 0; i < n; ++i) {
        const TestVertex &a = mesh[j][i], &b = mesh[j][i + 1], &c = mesh[j + 1][i + 1], &d = mesh[j + 1][i];
        if (random() % 2) {
          triangles.insert(triangles.end(), {a, b, c, c, d, a});
        } else {
          triangles.insert(triangles.end(), {b, c, d, a, b, d});
        }
      }
    }
    TestOracle oracle;
    oracle.draw(window_state(), PrimitiveMode::triangles, triangles);
    for (int y = 0; y < test_size; ++y) {
      for (int x = 0; x < test_size; ++x) {
        EXPECT_EQ(oracle.fragments(x, y), x >= 4 && x < 58 && y >= 4 && y < 58) << x << ' ' << y << " grid " << grid;
      }
    }
  }
}

TEST(PolygonCoverage, EdgesSnapToTheNearest256thSeenFromTheTop) {
  // A bottom edge at 10.5 + 1/512: from the top 53.5 - 1/512, less the half pixel 53 - 1/512, a tie between 53 * 256 -
  // 1 and 53 * 256: the even one, so the edge lies on the centres of row 10 and owns them.
  TestOracle oracle;
  const float edge = 10.5f + 1.0f / 512;
  oracle.draw(window_state(), PrimitiveMode::quads, {at(8, edge), at(12, edge), at(12, 12), at(8, 12)});
  EXPECT_EQ(oracle.fragments(9, 10), 1);
  // The true picture does not hold them.
  TestOracle exact({PositionModel::exact, 0.5});
  exact.draw(window_state(), PrimitiveMode::quads, {at(8, edge), at(12, edge), at(12, 12), at(8, 12)});
  EXPECT_EQ(exact.fragments(9, 10), 0);
  EXPECT_EQ(exact.fragments(9, 11), 1);
}

TEST(PolygonCoverage, ScissorAndTargetCutIt) {
  TestOracle oracle;
  pipeline::DrawState state = window_state();
  state.raster.scissor = {5, 6, 9, 8};
  oracle.draw(state, PrimitiveMode::quads, {at(0, 0), at(64, 0), at(64, 64), at(0, 64)});
  EXPECT_EQ(oracle.all_fragments(), 4 * 2);
  EXPECT_EQ(oracle.fragments(5, 6), 1);
  EXPECT_EQ(oracle.fragments(8, 7), 1);
}

TEST(Culling, FollowsTheSignOfTheArea) {
  const std::vector<TestVertex> ccw{at(8, 8), at(40, 8), at(8, 40)};
  for (const auto front_face : {pipeline::FrontFace::ccw, pipeline::FrontFace::cw}) {
    for (const auto cull : {pipeline::CullMode::none, pipeline::CullMode::front, pipeline::CullMode::back,
                            pipeline::CullMode::front_and_back}) {
      pipeline::DrawState state = window_state();
      state.assembly.front_face = front_face;
      state.assembly.cull = cull;
      const bool is_front = front_face == pipeline::FrontFace::ccw;
      const bool drawn =
          cull == pipeline::CullMode::none || cull == (is_front ? pipeline::CullMode::back : pipeline::CullMode::front);
      TestOracle oracle;
      oracle.draw(state, PrimitiveMode::triangles, ccw);
      EXPECT_EQ(oracle.all_fragments() > 0, drawn);
    }
  }
}

TEST(Interpolation, IsAffineInTheWindowForEqualW) {
  TestOracle oracle;
  oracle.draw(window_state(), PrimitiveMode::triangles,
              {at(0, 0, 0.25f, {0, 0, 1, 1}), at(64, 0, 0.5f, {1, 0, 1, 1}), at(0, 64, 0.75f, {0, 1, 1, 1})});
  const double x = 10.5 / 64, y = 20.5 / 64;
  EXPECT_NEAR(oracle.pixel(10, 20).color[0], x, 1e-12);
  EXPECT_NEAR(oracle.pixel(10, 20).color[1], y, 1e-12);
  EXPECT_EQ(oracle.pixel(10, 20).color[2], 1.0);
  EXPECT_EQ(oracle.picture().count(pixel_extrapolated), 0u);
}

TEST(Interpolation, DepthIsAPlaneInTheWindow) {
  TestOracle oracle;
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, true, pipeline::CompareFunc::less};
  oracle.draw(state, PrimitiveMode::triangles, {at(0, 0, 0.25f), at(64, 0, 0.5f), at(0, 64, 0.75f)});
  const double z = 0.25 + 0.25 * 10.5 / 64 + 0.5 * 20.5 / 64;
  EXPECT_NEAR(oracle.pixel(10, 20).depth_units, z * 16777215, 1e-6);
  EXPECT_EQ(oracle.pixel(10, 20).depth_stored, static_cast<std::uint32_t>(std::nearbyint(z * 16777215)));
}

/// A floor seen in perspective: the colour along it is linear in eye space, so at a fraction s of the window between
/// vertices of depths w0 and w1 it is s w0 / (s w0 + (1 - s) w1).
TEST(Interpolation, IsPerspectiveCorrect) {
  TestOracle oracle;
  const float w0 = 1.0f, w1 = 4.0f;
  const auto vertex = [](float x, float y, float w, float red) {
    return TestVertex{{x * w, y * w, 0.5f * w, w}, {red, 0, 0, 1}, {0, 0, 1}};
  };
  oracle.draw(window_state(), PrimitiveMode::quads,
              {vertex(0, 0, w0, 0), vertex(64, 0, w0, 0), vertex(64, 64, w1, 1), vertex(0, 64, w1, 1)});
  for (const int y : {0, 7, 31, 63}) {
    const double s = (y + 0.5) / 64;
    EXPECT_NEAR(oracle.pixel(30, y).color[0], s * w0 / (s * w0 + (1 - s) * w1), 1e-12) << y;
  }
}

TEST(Interpolation, StaysInsideTheVerticesRangeWhereSnappingCoversForeignSamples) {
  TestOracle oracle;
  pipeline::DrawState state = window_state();
  state.raster.depth = {true, true, pipeline::CompareFunc::less};
  // A sliver of a thousandth of a pixel, beside the centres of column 10 but snapped onto them and beyond.
  const float left = 10.5f + 0.0021f, right = 10.5f + 0.0031f;
  oracle.draw(state, PrimitiveMode::quads,
              {at(left, 2, 0.2f, {0.2f, 0, 0, 1}), at(right, 2, 0.6f, {0.6f, 0, 0, 1}),
               at(right, 60, 0.6f, {0.6f, 0, 0, 1}), at(left, 60, 0.2f, {0.2f, 0, 0, 1})});
  ASSERT_EQ(oracle.fragments(10, 30), 0);  // snapped to 10.5 + 1/256
  const float on_centre = 10.5f + 0.0011f;
  oracle.draw(state, PrimitiveMode::quads,
              {at(on_centre, 2, 0.2f, {0.2f, 0, 0, 1}), at(right, 2, 0.6f, {0.6f, 0, 0, 1}),
               at(right, 60, 0.6f, {0.6f, 0, 0, 1}), at(on_centre, 60, 0.2f, {0.2f, 0, 0, 1})});
  ASSERT_EQ(oracle.fragments(10, 30), 1);
  EXPECT_EQ(oracle.picture().flags[oracle.picture().index(10, 30)] & pixel_extrapolated, pixel_extrapolated);
  const OraclePixel& pixel = oracle.pixel(10, 30);
  EXPECT_GE(pixel.color[0], 0.2f);
  EXPECT_LE(pixel.color[0], 0.6f);
  EXPECT_LE(pixel.color_lowest[0], pixel.color[0]);
  EXPECT_GT(pixel.color_highest[0], pixel.color_lowest[0] + 0.1f);  // any value within half a sub-pixel is legal
  EXPECT_GT(pixel.depth_highest, pixel.depth_lowest + 1000000);
}

TEST(FlatShading, TakesTheProvokingVertex) {
  pipeline::DrawState state = window_state();
  state.assembly.shade_model = pipeline::ShadeModel::flat;
  const std::vector<TestVertex> quad{at(0, 0, 0, {0.1f, 0, 0, 1}), at(64, 0, 0, {0.2f, 0, 0, 1}),
                                     at(64, 64, 0, {0.3f, 0, 0, 1}), at(0, 64, 0, {0.4f, 0, 0, 1})};
  const std::vector<std::pair<PrimitiveMode, float>> expected{{PrimitiveMode::quads, 0.4f},
                                                              {PrimitiveMode::polygon, 0.1f},
                                                              {PrimitiveMode::triangles, 0.3f},
                                                              {PrimitiveMode::triangle_fan, 0.3f}};
  for (const auto& [mode, red] : expected) {
    TestOracle oracle;
    oracle.draw(state, mode, quad);
    EXPECT_EQ(oracle.pixel(50, 20).color[0], static_cast<double>(red));
  }
}

}  // namespace
}  // namespace gouraud::oracle
