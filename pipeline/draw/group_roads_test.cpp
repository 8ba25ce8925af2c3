// The roads of groups, small triangles' and the others', find what records, blocks and the depth pass find one by one.
#include "pipeline/draw/group_depth.h"
#include "pipeline/draw/small_triangles.h"

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

#include "pipeline/fragment/depth.h"
#include "pipeline/raster/polygons.h"
#include "pipeline/raster/sample_blocks.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

constexpr int tile_x = 64, tile_y = 128;

enum class Road { small_triangles, group_depth, block_by_block };

/// Triangles of vertices that lie up to `reach` pixels from a place, in a tile and over its borders, and the tile's depths.
struct Tile {
  Tile(CompareFunc func, DepthFormat format, float depth_range, float reach, bool samples = false) {
    if (samples) binding.sample_mask = 0xB;
    binding.samples_apart = samples;
    binding.state.depth = {true, true, func};
    binding.passes.add(depth_test_pass(func, format));
    binding.passes.early = 1;
    binding.passes.small_triangles = small_triangle_tests(func, format);
    binding.passes.group_depth = group_depth_test(func, format);
    state.binding = &binding;
    state.scissor = {0, 0, 512, 512};
    state.target_height_px = 512;
    state.targets = {format == DepthFormat::z16 ? 65535.0 : 16777215.0, false, 255.0f};
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(-4, tile_size + 4), near(-reach, reach), unit(0, 1);
    for (std::size_t i = 0; i < count; ++i) {
      const float x = tile_x + place(random), y = 512 - tile_y - place(random), z = unit(random);
      for (std::size_t k = 0; k < 3; ++k) {
        vertices->window[k] = {x + near(random), y + near(random), std::fmod(z + depth_range * unit(random), 1.0f), 1.0f};
      }
      const AssembledTriangle triangle{{0, 1, 2}, 0, 7};
      waiting.emplace_back();
      const bool selected = select_triangles(state, *vertices, {&triangle, 1}, {}, waiting.back().bytes.data()) == 1;
      const bool wanted = selected && is_here(waiting.back().triangle()) && (reach > 4 || waiting.back().triangle().small());
      if (!wanted) waiting.pop_back();
    }
    std::uniform_int_distribution<std::uint32_t> bits;
    for (auto& plane : depth) {
      for (std::uint32_t& word : plane) word = bits(random);
    }
  }

  static bool is_here(const WaitingTriangle& triangle) {
    return triangle.x0 < tile_x + tile_size && triangle.x1 > tile_x && triangle.y0 < tile_y + tile_size &&
           triangle.y1 > tile_y;
  }

  TileTarget target(std::size_t sample) {
    return {nullptr, reinterpret_cast<std::byte*>(depth[sample].data()), nullptr, static_cast<std::int32_t>(sample)};
  }

  /// Calls visit(group) for groups of 8 and then of fewer.
  template <class Visit>
  void for_each_group(Visit visit) {
    for (std::size_t i = 0, size = group_capacity; i < waiting.size(); i += size, size = size % group_capacity + 1) {
      TriangleGroup group(state, reinterpret_cast<std::byte*>(records.data()));
      for (std::size_t k = i; k < std::min(i + size, waiting.size()); ++k) group.add(waiting[k].triangle());
      visit(group);
    }
  }

  /// The blocks that are seen in all samples. `road`: or one by one.
  std::vector<SampleBlock> draw_samples(bool road) {
    std::vector<SampleBlock> all;
    const SampleTargets targets = place_samples({target(0), target(1), target(2), target(3)}, binding);
    std::array<SampleBlock, 4 * group_capacity + 4> seen;
    for_each_group([&](TriangleGroup& group) {
      std::size_t found = 0;
      if (road) {
        found = binding.passes.small_triangles.all(group, tile_x, tile_y, targets, seen.data());
      } else {
        set_up_depths(group);
        for (std::size_t i = 0; i < group.count; ++i) {
          const WaitingTriangle& triangle = *group.triangle[i];
          std::array<SampleBlock, 4> blocks;
          const std::size_t cut = sample_mask_cutter()(masks_of(triangle, binding, group.vertex_bytes), triangle.x0, triangle.y0, tile_x, tile_y, blocks.data());
          for (std::size_t k = 0; k < cut; ++k) {
            if (!run_early_passes(group.record(i), blocks[k], targets)) continue;
            seen[found] = blocks[k];
            seen[found++].primitive = static_cast<std::int32_t>(i);
          }
        }
      }
      all.insert(all.end(), seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(found));
    });
    return all;
  }

  /// All blocks that are seen, of groups of 8 and then of fewer.
  std::vector<SeenBlock> draw(Road road) {
    std::vector<SeenBlock> all;
    for_each_group([&](TriangleGroup& group) {
      std::vector<SeenBlock> seen(most_seen_blocks);
      seen.resize(draw(group, road, seen.data()));
      all.insert(all.end(), seen.begin(), seen.end());
    });
    return all;
  }

  std::size_t draw(TriangleGroup& group, Road road, SeenBlock* seen) {
    if (road == Road::small_triangles) return binding.passes.small_triangles.one(group, tile_x, tile_y, target(0), seen);
    set_up_depths(group);
    const std::size_t found = group_rasterizer()(group, tile_x, tile_y, seen);
    if (road == Road::group_depth) return binding.passes.group_depth(group, seen, found, target(0));
    std::size_t left = 0;
    for (std::size_t i = 0; i < found; ++i) {
      FragmentBlock block;
      block.coverage = seen[i].coverage;
      block.x = seen[i].x;
      block.y = seen[i].y;
      block.first_pixel = seen[i].first_pixel;
      block.primitive = &group.record(static_cast<std::size_t>(seen[i].primitive));
      run_passes(binding.passes, block, target(0));
      seen[left] = seen[i];
      seen[left].coverage = block.coverage;
      left += block.coverage != 0 ? 1 : 0;
    }
    return left;
  }

  static constexpr std::size_t count = 1000;
  struct alignas(64) Waiting {
    std::array<std::byte, largest_waiting> bytes;
    const WaitingTriangle& triangle() const { return *reinterpret_cast<const WaitingTriangle*>(bytes.data()); }
  };
  RasterBinding binding;
  SetupState state;
  std::unique_ptr<ProcessedVertices> vertices = std::make_unique<ProcessedVertices>();
  std::vector<Waiting> waiting;
  alignas(64) std::array<std::array<std::uint32_t, tile_size * tile_size>, max_samples> depth;
  alignas(64) std::array<ColoredPrimitive, group_capacity> records;
};

void expect_the_same(Road wanted, CompareFunc func, DepthFormat format, float depth_range, float reach) {
  const auto road = std::make_unique<Tile>(func, format, depth_range, reach), one_by_one = std::make_unique<Tile>(func, format, depth_range, reach);
  const FragmentPasses& passes = road->binding.passes;
  if (passes.small_triangles.one == nullptr || passes.group_depth == nullptr) return;
  ASSERT_GT(road->waiting.size(), 600u);
  const std::vector<SeenBlock> a = road->draw(wanted), b = one_by_one->draw(Road::block_by_block);
  EXPECT_GT(a.size(), 0u);
  EXPECT_TRUE(a == b);
  EXPECT_TRUE(road->depth == one_by_one->depth);
}

void expect_the_same_in_samples(CompareFunc func, DepthFormat format, float depth_range) {
  const auto road = std::make_unique<Tile>(func, format, depth_range, 4, true), one_by_one = std::make_unique<Tile>(func, format, depth_range, 4, true);
  if (road->binding.passes.small_triangles.all == nullptr) return;
  ASSERT_GT(road->waiting.size(), 500u);
  const std::vector<SampleBlock> a = road->draw_samples(true), b = one_by_one->draw_samples(false);
  EXPECT_GT(a.size(), 0u);
  EXPECT_TRUE(std::ranges::equal(a, b, [](const SampleBlock& p, const SampleBlock& q) {
    return p.coverage == q.coverage && p.x == q.x && p.y == q.y && p.first_pixel == q.first_pixel && p.primitive == q.primitive;
  }));
  EXPECT_TRUE(road->depth == one_by_one->depth);
}

void expect_the_same_on_all_sets(Road road, float reach) {
  for (const auto set : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(set)) continue;
    simd::set_target_for_test(set);
    for (const DepthFormat format : {DepthFormat::z16, DepthFormat::z24s8}) {
      for (const CompareFunc func : {CompareFunc::less, CompareFunc::gequal, CompareFunc::notequal, CompareFunc::always}) {
        expect_the_same(road, func, format, 0.001f, reach);  // flat
        expect_the_same(road, func, format, 1.0f, reach);    // many are too steep for steps in float
        if (road != Road::small_triangles) continue;
        expect_the_same_in_samples(func, format, 0.001f);
        expect_the_same_in_samples(func, format, 1.0f);
      }
    }
  }
  simd::set_target_for_test(std::nullopt);
}

TEST(SmallTriangleRoad, SeesTheSameAsRecordsAndPasses) { expect_the_same_on_all_sets(Road::small_triangles, 4); }

TEST(GroupDepthRoad, SeesTheSameAsThePass) {
  for (const float reach : {4.0f, 12.0f, 60.0f}) expect_the_same_on_all_sets(Road::group_depth, reach);
}

TEST(GroupRoads, AreClosedToFloatingPointDepths) {
  EXPECT_EQ(small_triangle_tests(CompareFunc::less, DepthFormat::z32f), SmallTriangleTests{});
  EXPECT_EQ(group_depth_test(CompareFunc::less, DepthFormat::z32f), nullptr);
}

}  // namespace
}  // namespace gouraud::pipeline
