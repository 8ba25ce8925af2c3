// The road of the varyings: setup's planes and the pass that interpolates them, against the formula in double.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/draw/varying_layout.h"
#include "pipeline/fragment/varyings.h"
#include "pipeline/geometry/test_support.h"
#include "pipeline/geometry/texture_coordinates.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/texture/image.h"

namespace gouraud::pipeline {
namespace {

constexpr int height = 256;

/// One triangle with `count` varyings, set up on the instruction set in use.
struct Road {
  explicit Road(int count) {
    binding.varyings.count = static_cast<std::int8_t>(count);
    state.binding = &binding;
    state.scissor = {0, 0, 256, height};
    state.target_height_px = height;
    state.targets = {0xFFFFFF, false, 255.0f};
  }

  bool set_up() {
    alignas(64) std::array<std::byte, 1024> waiting;
    const AssembledTriangle triangle{{0, 1, 2}, 2, 7};
    if (select_triangles(state, *vertices, {&triangle, 1}, {}, waiting.data()) == 0) return false;
    set_up_triangle(state, *reinterpret_cast<const WaitingTriangle*>(waiting.data()), memory.data());
    return true;
  }
  const PrimitiveRecord& record() const { return *reinterpret_cast<const PrimitiveRecord*>(memory.data()); }
  std::unique_ptr<FragmentBlock> block(int x, int y) const {
    auto result = std::make_unique<FragmentBlock>();
    result->primitive = &record();
    result->coverage = ~std::uint64_t{0};
    result->x = x;
    result->y = y;
    varying_interpolation_pass()(*result, {});
    return result;
  }
  /// Inside the snapped triangle.
  bool covers(int x, int y) const {
    for (const EdgeFunction& edge : record().edges) {
      if (edge.c + static_cast<std::int64_t>(edge.a) * x + static_cast<std::int64_t>(edge.b) * y < 0) return false;
    }
    return true;
  }

  /// [GL1.5 §3.5.1 eq 3.6] at the pixel's centre, kept in the range of the vertices.
  double exact(std::size_t k, int x, int y) const {
    std::array<double, 3> px, py, weight, value;
    for (std::size_t i = 0; i < 3; ++i) {
      const WindowVertex& v = vertices->window[i];
      px[i] = v.x - (x + 0.5);
      py[i] = height - static_cast<double>(v.y_raster) - (y + 0.5);
      value[i] = vertices->varying[k][i];
    }
    double sum = 0, total = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
      weight[i] = (px[a] * py[b] - px[b] * py[a]) * vertices->window[i].w_inverse;
      sum += weight[i] * value[i];
      total += weight[i];
    }
    return std::clamp(sum / total, std::min({value[0], value[1], value[2]}), std::max({value[0], value[1], value[2]}));
  }

  RasterBinding binding;
  SetupState state;
  /// How much a varying changes inside a block at most, seen from the pixel.
  double change_in_block(std::size_t k, int x, int y, double largest) const {
    const VaryingRecord& r = varyings_of(record());
    const VaryingPlane& p = planes_of(r)[k];
    const double flat = std::abs(p.dx) + std::abs(p.dy);
    if (!r.perspective) return 7 * flat;
    const double inverse_w = std::max<double>(r.inverse_w_origin + r.inverse_w_dx * x + r.inverse_w_dy * y, r.inverse_w_minimum);
    return 7 * (flat + 2 * largest * (std::abs(r.inverse_w_dx) + std::abs(r.inverse_w_dy))) / inverse_w;
  }

  std::unique_ptr<ProcessedVertices> vertices = blank_vertices();
  alignas(64) std::array<std::byte, 4096> memory;
};

void random_triangle(Numbers& number, bool perspective, float repeats, Road& road) {
  for (std::size_t i = 0; i < 3; ++i) {
    const float w = perspective ? std::pow(10.0f, number()) : 1.0f;
    road.vertices->window[i] = {128 + 100 * number(), 128 + 100 * number(), 0.5f, 1 / w};
    for (auto& array : road.vertices->varying) array[i] = repeats * number();
  }
}

TEST(Varyings, FollowTheFormulaToAFewBitsOfAFloatEvenOverThousandsOfRepeats) {
  constexpr int count = 5;
  for (const bool perspective : {false, true}) {
    for (const float repeats : {1.0f, 4096.0f}) {
      Numbers number(7);
      double worst = 0;
      int compared = 0;
      for (int round = 0; round < 60; ++round) {
        Road road(count);
        random_triangle(number, perspective, repeats, road);
        if (!road.set_up()) continue;
        for (int by = 0; by < height; by += 8) {
          for (int bx = 0; bx < 256; bx += 8) {
            const auto block = road.block(bx, by);
            for (int lane = 0; lane < 64; ++lane) {
              const int x = bx + lane % 8, y = by + lane / 8;
              if (!road.covers(x, y)) continue;
              for (std::size_t k = 0; k < count; ++k) {
                const double error = block->varying[k][static_cast<std::size_t>(lane)] - road.exact(k, x, y);
                worst = std::max(worst, std::abs(error) / (repeats + road.change_in_block(k, x, y, repeats)));
                ++compared;
              }
            }
          }
        }
      }
      EXPECT_GT(compared, 100000);
      // A float has 2^-24: relative to the largest coordinate, or to what a sliver's coordinate does inside a block.
      EXPECT_LT(worst, 0x1p-22) << (perspective ? "perspective" : "affine") << ", " << repeats << " repeats";
    }
  }
}

TEST(Varyings, HaveTheSameBitsOnEveryInstructionSet) {
  constexpr int count = 3;
  std::vector<float> reference;
  for_each_target([&] {
    std::vector<float> values;
    Numbers number(11);
    for (int round = 0; round < 40; ++round) {
      Road road(count);
      random_triangle(number, round % 2 == 0, 10, road);
      if (!road.set_up()) continue;
      for (int at = 0; at < 256; at += 24) {
        const auto block = road.block(at, at);
        for (std::size_t lane = 0; lane < 64; ++lane) {
          if (!road.covers(at + static_cast<int>(lane % 8), at + static_cast<int>(lane / 8))) continue;
          for (std::size_t k = 0; k < count; ++k) values.push_back(block->varying[k][lane]);
        }
      }
    }
    if (reference.empty()) reference = values;
    ASSERT_EQ(values.size(), reference.size());
    EXPECT_EQ(std::memcmp(values.data(), reference.data(), values.size() * sizeof(float)), 0);
  });
}

TEST(Varyings, ThatDoNotVaryStayExactlyWhatTheyAre) {
  Road road(2);
  Numbers number(3);
  random_triangle(number, true, 1, road);
  for (std::size_t i = 0; i < 3; ++i) road.vertices->varying[1][i] = 0.1f;
  ASSERT_TRUE(road.set_up());
  EXPECT_EQ(varyings_of(road.record()).constant, 2u);
  const auto block = road.block(128, 128);
  for (const float value : block->varying[1]) EXPECT_EQ(value, 0.1f);
}

TEST(Varyings, AreFiniteWhateverTheVerticesBring) {
  Numbers number(5, true);
  for (int round = 0; round < 200; ++round) {
    Road road(4);
    random_triangle(number, false, 1, road);
    for (std::size_t i = 0; i < 3; ++i) road.vertices->window[i] = {10.0f + 90 * static_cast<float>(i % 2), i == 2 ? 90.0f : 20.0f, 0, 1};
    ASSERT_TRUE(road.set_up());
    const auto block = road.block(48, 200);
    for (int lane = 0; lane < 64; ++lane) {
      for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(std::isfinite(block->varying[k][static_cast<std::size_t>(lane)]));
    }
  }
}

TEST(Varyings, OfLinesRunAlongTheLineAndBeyond) {
  Road road(1);
  std::vector<PixelPosition> pixels;
  road.vertices->window[0] = {10.5f, height - 20.5f, 0, 1};
  road.vertices->window[1] = {30.5f, height - 20.5f, 0, 1};
  road.vertices->varying[0][0] = 2;
  road.vertices->varying[0][1] = 4;
  StippleCount count = 0;
  ASSERT_NE(setup_line(road.state, *road.vertices, {{0, 1}, 1, false}, count, road.memory.data(), pixels), LinePixels::none);
  const auto block = road.block(8, 16);
  EXPECT_NEAR(block->varying[0][4 * 8 + 2], 2.0, 1e-6);
  EXPECT_NEAR(block->varying[0][4 * 8 + 7], 2.5, 1e-6);
  EXPECT_NEAR(block->varying[0][4 * 8 + 0], 1.8, 1e-6);
}

TEST(Varyings, OfPointsAreTheVertex) {
  Road road(2);
  road.vertices->window[0] = {10.5f, 20.5f, 0, 1};
  road.vertices->varying[0][0] = 3;
  road.vertices->varying[1][0] = -1;
  ASSERT_TRUE(setup_point(road.state, *road.vertices, {0, 0, false}, 1.0f, road.memory.data(), nullptr));
  const auto block = road.block(8, 16);
  EXPECT_EQ(block->varying[0][17], 3.0f);
  EXPECT_EQ(block->varying[1][63], -1.0f);
}

Texture any_texture() {
  Texture texture;
  texture.faces.resize(1);
  return texture;
}

TEST(VaryingLayout, LeavesQOutIfItIsOneAtEveryVertex) {
  auto state = std::make_unique<DrawState>();
  state->raster.scissor = {0, 0, 8, 8};
  state->texturing.count = 1;
  const Texture texture = any_texture();
  state->texturing.unit[0].texture = &texture;
  state->texturing.unit[0].unit = 2;
  state->texture_coordinates.units = 4;
  auto batch = random_batch(1, 20);
  for (std::size_t c = 0; c < 4; ++c) batch->texture_coordinates[2][c].fill(c == 3 ? 1.0f : 0.5f);
  const Plan plan = make_plan(*state, {ColorFormat::rgba8, DepthFormat::none});
  EXPECT_EQ(plan.vertex_demand, attribute_color | attribute_texture_coordinates(2));
  VaryingLayout layout = make_varying_layout(*state, plan, *batch);
  EXPECT_EQ(layout.count, 2);
  EXPECT_FALSE(layout.texture_coordinates[2].has_q);
  EXPECT_EQ(layout.texture_coordinates[0].first, -1);

  batch->texture_coordinates[2][3][19] = 0.5f;
  layout = make_varying_layout(*state, plan, *batch);
  EXPECT_EQ(layout.count, 3);
  EXPECT_TRUE(layout.texture_coordinates[2].has_q);
}

TEST(TexturePlan, DemandsWhatTexgenReadsAndNothingElse) {
  auto state = std::make_unique<DrawState>();
  state->raster.scissor = {0, 0, 8, 8};
  state->texturing.count = 1;
  const Texture texture = any_texture();
  state->texturing.unit[0].texture = &texture;
  state->texture_coordinates.units = 1;
  TextureCoordinateSource& source = state->texture_coordinates.unit[0];
  source.mode = {TexgenMode::sphere_map, TexgenMode::sphere_map, TexgenMode::given, TexgenMode::object_linear};
  const TargetFormat target{ColorFormat::rgba8, DepthFormat::none};
  Plan plan = make_plan(*state, target);
  EXPECT_TRUE(plan.eye_positions && plan.normals);
  EXPECT_EQ(plan.vertex_demand, attribute_color | attribute_normal);
  source.mode = {TexgenMode::eye_linear, TexgenMode::object_linear, TexgenMode::given, TexgenMode::given};
  plan = make_plan(*state, target);
  EXPECT_TRUE(plan.eye_positions && !plan.normals);
  EXPECT_EQ(plan.vertex_demand, attribute_color | attribute_texture_coordinates_0);
  state->raster.color_write_mask = 0;
  EXPECT_FALSE(make_plan(*state, target).textured);
}

}  // namespace
}  // namespace gouraud::pipeline
