// Setup, bins, coverage, depth and colour together, on triangles given in window space.
#include "pipeline/draw/tiles.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "pipeline/fragment/color_write.h"
#include "pipeline/fragment/depth.h"
#include "pipeline/framebuffer/read.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

struct Vertex {
  float x, y, z = 0.5f, inverse_w = 1;  ///< y up
  Rgba color{1, 1, 1, 1};
};

/// A target, its bins and a scratch ProcessedVertices: draws window-space triangles.
class Canvas {
 public:
  Canvas(int width, int height, int threads = 1)
      : target(width, height, ColorFormat::rgba8, DepthFormat::z24s8, 8), bins(threads), vertices(new ProcessedVertices) {
    bins.set_target(&target);
    state.scissor = {0, 0, width, height};
    setup.target_height_px = height;
    setup.colors = true;
    setup.targets = {0xFFFFFF, false, 255.0f};
  }

  void draw(const std::vector<Vertex>& triangles) {
    FragmentPasses passes;
    if (state.depth.test_enabled) passes.add(depth_test_pass(state.depth.func, DepthFormat::z24s8));
    passes.add(color_write_pass(ColorFormat::rgba8, state.color_write_mask));
    setup.scissor = state.scissor;
    const SetupState* shared = bins.intern(setup, {state, passes, {}, setup.colors});
    std::vector<AssembledTriangle> assembled;
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex& v = triangles[i + k];
        vertices->window[k] = {v.x, static_cast<float>(setup.target_height_px) - v.y, v.z, v.inverse_w};
        vertices->color_front[k] = v.color;
      }
      const AssembledTriangle triangle{{0, 1, 2}, 2, 7};
      alignas(64) std::array<std::byte, largest_waiting> waiting;
      const std::size_t count = select_triangles(*shared, *vertices, {&triangle, 1}, {}, waiting.data());
      bins.add_triangles(*shared, waiting.data(), count, false);
    }
    bins.run();
  }

  std::uint32_t pixel(int x, int y) const {
    std::uint32_t value;
    std::memcpy(&value, target.color.pixel(x, y), 4);
    return value;
  }
  std::uint32_t depth(int x, int y) const {
    std::uint32_t value;
    std::memcpy(&value, target.depth.pixel(x, y), 4);
    return value & 0xFFFFFF;
  }
  int covered() const {
    int count = 0;
    for (int y = 0; y < target.height_px; ++y) {
      for (int x = 0; x < target.width_px; ++x) count += pixel(x, y) != 0 ? 1 : 0;
    }
    return count;
  }

  Framebuffer target;
  TileBins bins;
  std::unique_ptr<ProcessedVertices> vertices;
  RasterState state;
  SetupState setup;
};

std::vector<Vertex> rectangle(float x0, float y0, float x1, float y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Vertex> random_mesh(int size, int cells, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> jitter(-0.2f, 0.2f);
  const float step = static_cast<float>(size) / static_cast<float>(cells);
  std::vector<std::vector<Vertex>> grid;
  for (int j = 0; j <= cells; ++j) {
    grid.emplace_back();
    for (int i = 0; i <= cells; ++i) {
      const bool inner = i > 0 && j > 0 && i < cells && j < cells;
      grid.back().push_back({(static_cast<float>(i) + (inner ? jitter(random) : 0)) * step,
                             (static_cast<float>(j) + (inner ? jitter(random) : 0)) * step, 0.5f, 1,
                             {0.5f + jitter(random), 0.5f + jitter(random), 0.5f, 1}});
    }
  }
  std::vector<Vertex> mesh;
  for (std::size_t j = 0; j + 1 < grid.size(); ++j) {
    for (std::size_t i = 0; i + 1 < grid.size(); ++i) {
      for (const Vertex& v : {grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j][i], grid[j + 1][i + 1], grid[j + 1][i]}) {
        mesh.push_back(v);
      }
    }
  }
  return mesh;
}

TEST(PolygonCoverage, LeftAndBottomEdgesOwnTheirSamples) {
  Canvas canvas(100, 100);
  canvas.draw(rectangle(10.5f, 20.5f, 30.5f, 40.5f));
  EXPECT_EQ(canvas.covered(), 20 * 20);
  EXPECT_NE(canvas.pixel(10, 20), 0u);
  EXPECT_NE(canvas.pixel(29, 39), 0u);
  EXPECT_EQ(canvas.pixel(30, 39), 0u);
  EXPECT_EQ(canvas.pixel(29, 40), 0u);
}

TEST(PolygonCoverage, SharedEdgesOfAMeshCoverEachPixelOnce) {
  constexpr int size = 192;
  std::vector<int> hits(size * size);
  const std::vector<Vertex> mesh = random_mesh(size, 40, 7);
  for (std::size_t i = 0; i < mesh.size(); i += 3) {
    static Canvas canvas(size, size);
    canvas.bins.add_clear({.color = true, .scissor = {0, 0, size, size}});
    canvas.draw({mesh[i], mesh[i + 1], mesh[i + 2]});
    const int x0 = static_cast<int>(std::min({mesh[i].x, mesh[i + 1].x, mesh[i + 2].x})) - 1;
    const int y0 = static_cast<int>(std::min({mesh[i].y, mesh[i + 1].y, mesh[i + 2].y})) - 1;
    for (int y = std::max(y0, 0); y < std::min(y0 + 16, size); ++y) {
      for (int x = std::max(x0, 0); x < std::min(x0 + 16, size); ++x) {
        hits[static_cast<std::size_t>(y * size + x)] += canvas.pixel(x, y) != 0 ? 1 : 0;
      }
    }
  }
  for (const int count : hits) ASSERT_EQ(count, 1);
}

TEST(PolygonCoverage, TheScissorCutsExactly) {
  Canvas canvas(100, 100);
  canvas.state.scissor = {13, 17, 71, 90};
  canvas.draw(rectangle(0, 0, 100, 100));
  EXPECT_EQ(canvas.covered(), (71 - 13) * (90 - 17));
  EXPECT_NE(canvas.pixel(13, 17), 0u);
  EXPECT_EQ(canvas.pixel(12, 17), 0u);
}

TEST(PolygonCoverage, CullingGoesByTheSnappedArea) {
  Canvas canvas(64, 64);
  canvas.setup.cull = CullMode::back;
  canvas.draw({{10, 10}, {10, 30}, {30, 10}});  // clockwise
  EXPECT_EQ(canvas.covered(), 0);
  canvas.draw({{10, 10}, {30, 10}, {10, 30}});
  EXPECT_GT(canvas.covered(), 0);
}

TEST(PolygonColor, AConstantColorStaysExact) {
  Canvas canvas(64, 64);
  std::vector<Vertex> triangles = rectangle(0, 0, 64, 64);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    triangles[i].color = {0.5f, 0.25f, 1, 1};
    triangles[i].inverse_w = 0.1f + 0.3f * static_cast<float>(i);
  }
  canvas.draw(triangles);
  for (int i = 0; i < 64; ++i) ASSERT_EQ(canvas.pixel(i, 63 - i), 0xFFFF4080u);
}

TEST(PolygonColor, PerspectiveFollowsTheFormula) {
  Canvas canvas(100, 4);
  std::vector<Vertex> triangles = rectangle(0, 0, 100, 4);
  for (Vertex& v : triangles) {
    v.inverse_w = v.x > 50 ? 0.1f : 1.0f;
    v.color = v.x > 50 ? Rgba{1, 0, 0, 1} : Rgba{0, 0, 1, 1};
  }
  canvas.draw(triangles);
  for (int x = 0; x < 100; ++x) {
    const double t = (x + 0.5) / 100, far_share = t * 0.1 / ((1 - t) * 1.0 + t * 0.1);
    EXPECT_NEAR(canvas.pixel(x, 2) & 0xFF, far_share * 255, 0.51) << x;
  }
}

TEST(PolygonDepth, IsWithinOneUnitOnASteepPlane) {
  Canvas canvas(64, 64);
  canvas.state.depth = {true, true, CompareFunc::always};
  const auto exact = [](double x, double y) { return (0.1 + 0.005 * x + 0.007 * y) * 0xFFFFFF; };
  std::vector<Vertex> triangles = rectangle(0, 0, 64, 64);
  for (Vertex& v : triangles) v.z = static_cast<float>(0.1 + 0.005 * v.x + 0.007 * v.y);
  canvas.draw(triangles);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) ASSERT_NEAR(canvas.depth(x, y), exact(x + 0.5, y + 0.5), 2.0);
  }
}

TEST(PolygonDepth, OfAConstantPlaneRoundsToNearest) {
  Canvas canvas(8, 8);
  canvas.state.depth = {true, true, CompareFunc::always};
  canvas.draw(rectangle(0, 0, 8, 8));
  EXPECT_EQ(canvas.depth(3, 3), 8388608u);
}

TEST(Slivers, StayInTheRangeOfTheirVertices) {
  Canvas canvas(256, 256);
  canvas.state.depth = {true, true, CompareFunc::always};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(1, 255), thickness(-0.01f, 0.01f);
  for (int i = 0; i < 500; ++i) {
    const float x = place(random), y = place(random);
    const Rgba low{0.4f, 0.4f, 0.4f, 1}, high{0.6f, 0.6f, 0.6f, 1};
    canvas.draw({{x, y, 0.3f, 1, low}, {place(random), place(random), 0.6f, 0.01f, high},
                 {x + thickness(random), y + thickness(random), 0.5f, 0.5f, low}});
  }
  EXPECT_GT(canvas.covered(), 100);
  for (int y = 0; y < 256; ++y) {
    for (int x = 0; x < 256; ++x) {
      if (canvas.pixel(x, y) == 0) continue;
      ASSERT_GE(canvas.pixel(x, y) & 0xFF, 102u);
      ASSERT_LE(canvas.pixel(x, y) & 0xFF, 153u);
      ASSERT_GE(canvas.depth(x, y), static_cast<std::uint32_t>(0.3f * 0xFFFFFF) - 1);
      ASSERT_LE(canvas.depth(x, y), static_cast<std::uint32_t>(0.6f * 0xFFFFFF) + 1);
    }
  }
}

TEST(TileBins, EveryTargetAndThreadCountGivesTheSameBits) {
  constexpr int size = 200;
  std::vector<Vertex> mesh = random_mesh(size, 23, 11);
  std::mt19937 random(5);
  std::uniform_real_distribution<float> unit(0.01f, 1);
  for (Vertex& v : mesh) {
    v.z = unit(random);
    v.inverse_w = unit(random);
  }
  std::vector<std::vector<std::byte>> pictures;
  for (const auto target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    for (const int threads : {1, 3}) {
      Canvas canvas(size, size, threads);
      canvas.state.depth = {true, true, CompareFunc::gequal};
      canvas.draw(mesh);
      std::vector<std::byte>& picture = pictures.emplace_back();
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          picture.insert(picture.end(), canvas.target.color.pixel(x, y), canvas.target.color.pixel(x, y) + 4);
          picture.insert(picture.end(), canvas.target.depth.pixel(x, y), canvas.target.depth.pixel(x, y) + 4);
        }
      }
    }
  }
  simd::set_target_for_test(std::nullopt);
  for (const auto& picture : pictures) EXPECT_EQ(picture, pictures.front());
}

}  // namespace
}  // namespace gouraud::pipeline
