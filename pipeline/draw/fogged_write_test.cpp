// Interpolation, fog and write in one pass give what the passes apart give.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/fragment/color_write.h"
#include "pipeline/fragment/fog.h"
#include "pipeline/fragment/varyings.h"
#include "pipeline/geometry/test_support.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

constexpr int height = 256;

/// What varies over a triangle.
struct Kind {
  bool perspective, colors, alpha, coordinate;
};

/// A triangle in fog.
class Triangle {
 public:
  Triangle(FogMode mode, const Kind& kind, Numbers& number) {
    binding_.colors = true;
    binding_.varyings.count = 1;
    binding_.varyings.fog_coordinate = 0;
    binding_.state.fog = {mode, true, 0.4f, 1, 6, {0.25f, 0.5f, 1}};
    state_.binding = &binding_;
    state_.colors = true;
    state_.scissor = {0, 0, 256, height};
    state_.target_height_px = height;
    state_.targets = {0xFFFFFF, false, 255.0f};
    for (std::size_t i = 0; i < 3; ++i) {
      const float w = kind.perspective ? 1.5f + number() : 1.0f;
      vertices_->window[i] = {128 + 40 * number(), 128 + 40 * number(), 0.5f, 1 / w};
      const auto unit = [&] { return 0.5f + 0.5f * number(); };
      vertices_->color_front[i] = kind.colors ? Rgba{unit(), unit(), unit(), kind.alpha ? unit() : 1.0f} : Rgba{0.2f, 0.4f, 0.6f, 1.0f};
      vertices_->color_back[i] = vertices_->color_front[i];
      vertices_->varying[0][i] = kind.coordinate ? 3 + 3 * number() : 2.5f;
    }
  }

  bool set_up() {
    alignas(64) std::array<std::byte, 1024> waiting;
    const AssembledTriangle triangle{{0, 1, 2}, 2, 7};
    if (select_triangles(state_, *vertices_, {&triangle, 1}, {}, waiting.data()) == 0) return false;
    set_up_triangle(state_, *reinterpret_cast<const WaitingTriangle*>(waiting.data()), memory_.data());
    return true;
  }

  /// The block whose first pixel is (x, y), with what the triangle covers of it.
  std::unique_ptr<FragmentBlock> block(int x, int y) const {
    auto result = std::make_unique<FragmentBlock>();
    result->primitive = reinterpret_cast<const PrimitiveRecord*>(memory_.data());
    result->x = x;
    result->y = y;
    for (int lane = 0; lane < 64; ++lane) {
      bool inside = true;
      for (const EdgeFunction& e : result->primitive->edges) inside = inside && e.c + std::int64_t{e.a} * (x + lane % 8) + std::int64_t{e.b} * (y + lane / 8) >= 0;
      result->coverage |= static_cast<std::uint64_t>(inside) << lane;
    }
    return result;
  }
  FogMode mode() const { return binding_.state.fog.mode; }

 private:
  RasterBinding binding_;
  SetupState state_;
  std::unique_ptr<ProcessedVertices> vertices_ = blank_vertices();
  alignas(64) std::array<std::byte, 4096> memory_;
};

using Pixels = std::array<std::uint8_t, 256>;

Pixels in_one_pass(const Triangle& triangle, int x, int y) {
  alignas(64) Pixels pixels{};
  const auto block = triangle.block(x, y);
  fogged_color_write_pass(triangle.mode())(*block, {reinterpret_cast<std::byte*>(pixels.data())});
  return pixels;
}

Pixels pass_by_pass(const Triangle& triangle, int x, int y) {
  Pixels pixels{};
  const auto block = triangle.block(x, y);
  color_interpolation_pass()(*block, {});
  varying_interpolation_pass()(*block, {});
  fog_pass(triangle.mode(), ColorFormat::rgba8)(*block, {});
  for (std::size_t lane = 0; lane < 64; ++lane) {
    if ((block->coverage >> lane & 1) == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) pixels[4 * lane + k] = static_cast<std::uint8_t>(std::nearbyint(block->color[k][lane]));
  }
  return pixels;
}

TEST(FoggedWrite, GivesWhatThePassesApartGive) {
  for (const auto set : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(set)) continue;
    simd::set_target_for_test(set);
    for (const FogMode mode : {FogMode::linear, FogMode::exp, FogMode::exp2}) {
      for (int bits = 0; bits < 16; ++bits) {
        const Kind kind{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
        Numbers number(3);
        int compared = 0, different = 0;
        for (int round = 0; round < 20; ++round) {
          Triangle triangle(mode, kind, number);
          if (!triangle.set_up()) continue;
          for (int block = 0; block < 100; ++block) {
            const int x = 88 + block % 10 * 8, y = 88 + block / 10 * 8;
            const Pixels a = in_one_pass(triangle, x, y), b = pass_by_pass(triangle, x, y);
            for (std::size_t i = 0; i < a.size(); ++i) {
              ASSERT_LE(std::abs(a[i] - b[i]), 1);  // rounded up and down
              ++compared;
              different += a[i] != b[i] ? 1 : 0;
            }
          }
        }
        EXPECT_LE(different * 10'000, compared) << bits;
      }
    }
  }
  simd::set_target_for_test(std::nullopt);
}

TEST(FoggedWrite, HidesAllButTheEyeBehindAnInfiniteDensity) {
  for (const float density : {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e38f}) {
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      RasterBinding binding;
      binding.varyings.count = 1;
      binding.varyings.fog_coordinate = 0;
      binding.state.fog = {mode, true, density, 1, 6, {0.25f, 0.5f, 1}};
      PrimitiveRecord primitive;
      primitive.binding = &binding;
      const auto block = std::make_unique<FragmentBlock>();
      block->primitive = &primitive;
      for (std::size_t lane = 0; lane < 64; ++lane) {
        block->varying[0][lane] = lane == 0 ? 0.0f : 0.01f * static_cast<float>(lane);
        for (std::size_t k = 0; k < 4; ++k) block->color[k][lane] = 255;
      }
      fog_pass(mode, ColorFormat::rgba8)(*block, {});
      EXPECT_EQ(block->color[0][0], 255);
      EXPECT_EQ(block->color[0][1], 0.25f * 255);
      EXPECT_EQ(block->color[0][63], 0.25f * 255);
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
