// Where rectangles, discs and small triangles have samples, against the plain formula in double.
#include "pipeline/raster/sample_blocks.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "pipeline/raster/rectangle_edges.h"
#include "pipeline/raster/sample_positions.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

constexpr int tile_x = 128, tile_y = 64;
/// What can be decided without knowing how edges are rounded.
constexpr double unsure_px = 1.0 / 4096;

/// The samples of a tile that are covered.
using Covered = std::array<std::array<std::uint64_t, tile_size * tile_size / 64>, max_samples>;

/// Bit `x` of row `y` of the tile.
bool is_covered(const Covered& covered, std::size_t sample, int x, int y) { return (covered[sample][static_cast<std::size_t>(y)] >> x & 1) != 0; }

void add_block(const SampleBlock& block, Covered& out) {
  for (std::size_t k = 0; k < max_samples; ++k) {
    for (int row = 0; row < block_size; ++row) {
      const std::uint64_t bits = block.coverage[k] >> (row * block_size) & 0xFF;
      out[k][static_cast<std::size_t>(block.y - tile_y + row)] |= bits << (block.x - tile_x);
    }
  }
}

Covered cover(const PrimitiveRecord& record) {
  Covered covered{};
  const auto blocks = std::make_unique<std::array<SampleBlock, most_sample_blocks>>();
  const std::size_t count = sample_block_finder()(record, tile_x, tile_y, blocks->data());
  for (std::size_t i = 0; i < count; ++i) add_block((*blocks)[i], covered);
  return covered;
}

struct Fixture {
  Fixture() {
    binding.sample_mask = 0xF;
    binding.samples_apart = true;
    record.binding = &binding;
    record.x1 = record.y1 = 512;
  }
  RasterBinding binding;
  PrimitiveRecord record;
};

/// Calls check(sample, x, y, place) for all samples of the tile.
template <class Check>
void for_each_sample(Check check) {
  for (std::size_t k = 0; k < max_samples; ++k) {
    for (int y = 0; y < tile_size; ++y) {
      for (int x = 0; x < tile_size; ++x) {
        check(k, x, y, Point2{tile_x + x + double{sample_positions[k][0]}, tile_y + y + double{sample_positions[k][1]}});
      }
    }
  }
}

template <class Test>
void for_each_instruction_set(Test test) {
  for (const auto set : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(set)) continue;
    simd::set_target_for_test(set);
    test();
  }
  simd::set_target_for_test(std::nullopt);
}

TEST(SampleBlocks, ARectangleHasTheSamplesInsideIt) {
  for_each_instruction_set([] {
    Fixture fixture;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(tile_x - 40, tile_x + 104), y(tile_y - 40, tile_y + 104), wide(0.3, 12);
    int sure = 0, inside = 0;
    for (int i = 0; i < 40; ++i) {
      const Point2 from{x(random), y(random)}, to{x(random), y(random)};
      const double width = wide(random), length = std::hypot(to.x - from.x, to.y - from.y);
      new (&fixture.record.rectangle) RectangleEdges(edges_of_rectangle(from, to, width));
      fixture.record.is_rectangle = true;
      const Covered covered = cover(fixture.record);
      for_each_sample([&](std::size_t k, int column, int row, Point2 p) {
        const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length, dx = p.x - from.x, dy = p.y - from.y;
        const double along = dx * ux + dy * uy, across = std::abs(dx * uy - dy * ux);
        const double depth = std::min({along, length - along, 0.5 * width - across});
        if (std::abs(depth) < unsure_px) return;
        ++sure;
        inside += depth > 0 ? 1 : 0;
        ASSERT_EQ(is_covered(covered, k, column, row), depth > 0) << depth;
      });
    }
    EXPECT_GT(sure, 600000);
    EXPECT_GT(inside, 10000);
  });
}

TEST(SampleBlocks, RectanglesSideBySideShareNoSample) {
  Fixture fixture;
  fixture.record.is_rectangle = true;
  const auto rectangle = [&](double left, double right) {
    new (&fixture.record.rectangle) RectangleEdges(edges_of_rectangle({left, tile_y + 8.125}, {right, tile_y + 8.125}, 4.5));
    return cover(fixture.record);
  };
  // Edges through samples: left and bottom ones own theirs.
  const Covered a = rectangle(tile_x + 3.125, tile_x + 17.625), b = rectangle(tile_x + 17.625, tile_x + 40.375);
  for_each_sample([&](std::size_t k, int column, int row, Point2 p) {
    const bool in_rows = p.y >= tile_y + 5.875 && p.y < tile_y + 10.375;
    EXPECT_EQ(is_covered(a, k, column, row), in_rows && p.x >= tile_x + 3.125 && p.x < tile_x + 17.625);
    EXPECT_EQ(is_covered(b, k, column, row), in_rows && p.x >= tile_x + 17.625 && p.x < tile_x + 40.375);
  });
}

TEST(SampleBlocks, ADiscHasTheSamplesInsideIt) {
  for_each_instruction_set([] {
    Fixture fixture;
    SmoothShape disc;
    fixture.record.shape = &disc;
    for (const double radius : {0.2, 0.5, 3.3, 24.0}) {
      disc.corner[0] = {tile_x + 20.3 + radius, tile_y + 33.7};
      disc.radius = radius;
      const Covered covered = cover(fixture.record);
      for_each_sample([&](std::size_t k, int column, int row, Point2 p) {
        const double dx = p.x - disc.corner[0].x, dy = p.y - disc.corner[0].y;
        EXPECT_EQ(is_covered(covered, k, column, row), dx * dx + dy * dy < radius * radius);
      });
    }
  });
}

/// Small triangles: masks of the selection, cut into blocks, are what the edges find.
TEST(SampleBlocks, SmallTrianglesHaveTheSamplesInsideTheirEdges) {
  for_each_instruction_set([] {
    RasterBinding binding;
    binding.sample_mask = 0xD;
    binding.samples_apart = true;
    SetupState state;
    state.binding = &binding;
    state.scissor = {0, 0, 512, 512};
    state.target_height_px = 512;
    const auto vertices = std::make_unique<ProcessedVertices>();
    std::mt19937 random(8);
    std::uniform_real_distribution<float> place(-3, tile_size + 3), near(-3.6f, 3.6f);
    int small = 0;
    for (int i = 0; i < 2000; ++i) {
      const float x = tile_x + place(random), y = 512 - tile_y - place(random);
      for (std::size_t k = 0; k < 3; ++k) vertices->window[k] = {x + near(random), y + near(random), 0.5f, 1.0f};
      alignas(32) std::array<std::byte, largest_waiting> memory;
      const AssembledTriangle assembled{{0, 1, 2}, 0, 7};
      if (select_triangles(state, *vertices, {&assembled, 1}, {}, memory.data()) == 0) continue;
      const auto& triangle = *reinterpret_cast<const WaitingTriangle*>(memory.data());
      if (!triangle.small()) continue;
      ++small;
      alignas(64) std::array<std::byte, sizeof(ColoredPrimitive)> record;
      set_up_triangle(state, triangle, record.data());
      Covered cut{};
      std::array<SampleBlock, 4> blocks;
      const std::size_t count = sample_mask_cutter()(masks_of(triangle, binding, kept_vertex_size(state)), triangle.x0, triangle.y0, tile_x, tile_y, blocks.data());
      for (std::size_t k = 0; k < count; ++k) add_block(blocks[k], cut);
      ASSERT_EQ(cut, cover(*reinterpret_cast<const PrimitiveRecord*>(record.data())));
      EXPECT_EQ(cut[1], (Covered{}[1])) << "this sample is masked";
    }
    EXPECT_GT(small, 1500);
  });
}

}  // namespace
}  // namespace gouraud::pipeline
