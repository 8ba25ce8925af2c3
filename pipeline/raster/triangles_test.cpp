// Triangles between a batch and their tile: which are selected, the pixels of small ones, shared vertices, both steps of setup.
#include "pipeline/raster/triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

constexpr int size_px = 256;

template <class Body>
void on_every_target(Body body) {
  for (const auto target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    body();
  }
  simd::set_target_for_test(std::nullopt);
}

/// Vertices in window space and what is made of them.
struct Bench {
  Bench() {
    binding.colors = true;
    state.binding = &binding;
    state.colors = true;
    state.scissor = {0, 0, size_px, size_px};
    state.target_height_px = size_px;
    state.targets = {0xFFFFFF, false, 255.0f};
  }

  /// `count` triangles with corners within `reach` pixels around a random place; every coordinate is a multiple of `step`.
  void random_triangles(std::size_t count, float reach, float step, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(12, size_px - 12), near(-reach, reach), unit(0, 1);
    const auto rounded = [step](float value) { return std::round(value / step) * step; };
    triangles.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const float x = place(random), y = place(random);
      for (std::size_t k = 0; k < 3; ++k) {
        vertices->window[3 * i + k] = {rounded(x + near(random)), rounded(y + near(random)), unit(random), 0.1f + unit(random)};
        vertices->color_front[3 * i + k] = {unit(random), unit(random), unit(random), unit(random)};
        vertices->color_back[3 * i + k] = {unit(random), unit(random), unit(random), unit(random)};
      }
      const auto first = static_cast<std::uint16_t>(3 * i);
      triangles.push_back({{first, static_cast<std::uint16_t>(first + 1), static_cast<std::uint16_t>(first + 2)}, first, 7});
    }
  }

  /// Selected one by one, so that it is known which are left out.
  const WaitingTriangle* select(std::size_t i) {
    const std::size_t count = select_triangles(state, *vertices, {&triangles[i], 1}, {}, waiting.data());
    return count == 1 ? reinterpret_cast<const WaitingTriangle*>(waiting.data()) : nullptr;
  }

  RasterBinding binding;
  SetupState state;
  std::unique_ptr<ProcessedVertices> vertices = std::make_unique<ProcessedVertices>();
  std::vector<AssembledTriangle> triangles;
  alignas(64) std::array<std::byte, largest_waiting> waiting;
};

bool is_inside(const PrimitiveRecord& record, int x, int y) {
  for (const EdgeFunction& edge : record.edges) {
    if (edge.c + std::int64_t{edge.a} * x + std::int64_t{edge.b} * y < 0) return false;
  }
  return true;
}

TEST(SmallTriangles, HaveTheMaskThatTheirEdgesGive) {
  on_every_target([] {
    for (const float step : {0.5f, 1.0f / 256, 1.0f / 1024}) {  // many samples on edges and corners; few; none
      Bench bench;
      bench.random_triangles(500, 4.4f, step, 17);
      std::size_t small = 0;
      for (std::size_t i = 0; i < bench.triangles.size(); ++i) {
        const WaitingTriangle* const triangle = bench.select(i);
        if (triangle == nullptr || !triangle->small()) continue;
        ++small;
        alignas(64) std::array<std::byte, sizeof(ColoredPrimitive)> memory;
        set_up_triangle(bench.state, *triangle, memory.data());
        const auto& record = *reinterpret_cast<const PrimitiveRecord*>(memory.data());
        for (int lane = 0; lane < 64; ++lane) {
          EXPECT_EQ(triangle->mask >> lane & 1, is_inside(record, triangle->x0 + lane % 8, triangle->y0 + lane / 8) ? 1u : 0u);
        }
      }
      EXPECT_GT(small, 300u);
    }
  });
}

TEST(SmallTriangles, BetweenTheSamplesAreLeftOut) {
  Bench bench;
  bench.random_triangles(1, 1, 1, 1);
  const auto place = [&](float x, float y) {
    bench.vertices->window[0] = {x, y, 0, 1};
    bench.vertices->window[1] = {x, y + 0.75f, 0, 1};
    bench.vertices->window[2] = {x + 0.75f, y, 0, 1};
    return bench.select(0);
  };
  EXPECT_EQ(place(20.6f, 30.6f), nullptr);   // its box holds no sample
  EXPECT_EQ(place(19.96f, 29.96f), nullptr);  // its box does, itself does not
  ASSERT_NE(place(20.4f, 30.4f), nullptr);
  EXPECT_EQ(bench.select(0)->mask, 1u);
}

TEST(Selection, KnowsLargeAndScissoredTrianglesByTheirBoxAlone) {
  Bench bench;
  bench.random_triangles(1, 1, 1, 1);
  bench.vertices->window[0] = {10, 10, 0, 1};
  bench.vertices->window[1] = {10, 18.5f, 0, 1};
  bench.vertices->window[2] = {16, 10, 0, 1};
  ASSERT_NE(bench.select(0), nullptr);
  EXPECT_FALSE(bench.select(0)->small());  // nine rows
  bench.vertices->window[1].y_raster = 17;
  EXPECT_TRUE(bench.select(0)->small());
  bench.state.scissor.x1 = 12;
  ASSERT_NE(bench.select(0), nullptr);
  EXPECT_FALSE(bench.select(0)->small());
  EXPECT_TRUE(bench.select(0)->scissored);
  EXPECT_EQ(bench.select(0)->x1, 12);
}

/// Waiting triangles of a bench, all selected at once.
struct Waiting {
  Waiting(Bench& bench, SharedVertices shared) : memory(bench.triangles.size() * largest_waiting / 64 + 1) {
    auto* const out = memory.data()->data();
    const std::size_t bytes = waiting_size(bench.state, shared.front != nullptr);
    for (std::size_t i = 0; i < bench.triangles.size(); i += selection_batch) {
      const auto some = std::span(bench.triangles).subspan(i, std::min(selection_batch, bench.triangles.size() - i));
      const std::size_t before = triangles.size();
      const std::size_t count = select_triangles(bench.state, *bench.vertices, some, shared, out + before * bytes);
      for (std::size_t k = before; k < before + count; ++k) {
        triangles.push_back(reinterpret_cast<const WaitingTriangle*>(out + k * bytes));
      }
    }
  }
  struct alignas(64) Line : std::array<std::byte, 64> {};
  std::vector<Line> memory;
  std::vector<const WaitingTriangle*> triangles;
};

void expect_shared_as_own(bool two_sided) {
  Bench bench;
  bench.state.two_sided = two_sided;
  bench.random_triangles(100, 9, 1.0f / 256, 5);
  std::vector<std::byte> kept(shared_vertices_size(bench.state, 300) + 64);
  auto* const memory = kept.data() + (64 - reinterpret_cast<std::uintptr_t>(kept.data()) % 64) % 64;
  // The first vertices of the batch belong to others.
  bench.triangles.erase(bench.triangles.begin(), bench.triangles.begin() + 20);
  const SharedVertices shared = keep_vertices(bench.state, *bench.vertices, 60, 240, memory);
  const Waiting own(bench, {}), sharing(bench, shared);
  ASSERT_EQ(own.triangles.size(), sharing.triangles.size());
  ASSERT_GT(own.triangles.size(), 50u);
  const std::size_t bytes = kept_vertex_size(bench.state);
  for (std::size_t i = 0; i < own.triangles.size(); ++i) {
    const WaitingTriangle &a = *own.triangles[i], &b = *sharing.triangles[i];
    EXPECT_EQ(a.mask, b.mask);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(std::memcmp(&vertex_of(a, k, bytes), &vertex_of(b, k, bytes), sizeof(KeptVertex)), 0);
    }
  }
}

TEST(SharedVertices, GiveTheTrianglesThatOwnOnesGive) {
  expect_shared_as_own(false);
  expect_shared_as_own(true);
}

TEST(Setup, OfAGroupGivesTheRecordsOfEachAlone) {
  on_every_target([] {
    Bench bench;
    bench.random_triangles(60, 12, 1.0f / 256, 9);
    const Waiting waiting(bench, {});
    for (std::size_t first = 0; first + group_capacity <= waiting.triangles.size(); first += group_capacity - 3) {
      alignas(64) std::array<ColoredPrimitive, group_capacity> together;
      alignas(64) ColoredPrimitive alone;
      TriangleGroup group(bench.state, reinterpret_cast<std::byte*>(together.data()));
      for (std::size_t i = 0; i < group_capacity - first % 3; ++i) group.add(*waiting.triangles[first + i]);
      constexpr std::uint32_t wanted = 0xB5;
      set_up_depths(group);
      set_up_colors(group, wanted);
      for (std::size_t i = 0; i < group.count; ++i) {
        set_up_triangle(bench.state, *group.triangle[i], reinterpret_cast<std::byte*>(&alone));
        EXPECT_EQ(std::memcmp(&together[i].record.depth, &alone.record.depth, offsetof(DepthPlane, steep)), 0);
        if (!group.triangle[i]->small()) {
          EXPECT_EQ(std::memcmp(&together[i].record.edges, &alone.record.edges, sizeof alone.record.edges), 0);
        }
        if ((wanted >> i & 1) == 0) continue;
        EXPECT_EQ(together[i].color.origin, alone.color.origin);
        EXPECT_EQ(together[i].color.dx, alone.color.dx);
        EXPECT_EQ(together[i].color.dy, alone.color.dy);
        EXPECT_EQ(together[i].color.inverse_w_dx, alone.color.inverse_w_dx);
        EXPECT_EQ(together[i].color.minimum, alone.color.minimum);
        EXPECT_EQ(together[i].color.base, alone.color.base);
      }
    }
  });
}

}  // namespace
}  // namespace gouraud::pipeline
