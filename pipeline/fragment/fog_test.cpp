#include "pipeline/fragment/fog.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/fragment/color_sum.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

/// A block of one colour whose lanes have fog coordinates from -1 on, a quarter apart.
struct Fogged {
  Fogged() {
    binding.varyings.count = 4;
    binding.varyings.fog_coordinate = 0;
    binding.varyings.secondary_color = 1;
    binding.state.fog = {FogMode::linear, true, 0.3f, 2, 7, {0.25f, 0.5f, 1}};
    primitive.binding = &binding;
    block->primitive = &primitive;
    for (std::size_t lane = 0; lane < 64; ++lane) {
      block->varying[0][lane] = -1 + 0.25f * static_cast<float>(lane);
      for (std::size_t k = 0; k < 4; ++k) block->color[k][lane] = 0.8f * 255;
      for (std::size_t k = 1; k < 4; ++k) block->varying[k][lane] = 0.1f * static_cast<float>(k);
    }
  }
  void run(FogMode mode) {
    binding.state.fog.mode = mode;
    fog_pass(mode, ColorFormat::rgba8)(*block, {});
  }
  double coordinate(std::size_t lane) const { return block->varying[0][lane]; }
  void expect(std::size_t lane, double f) const {
    const glm::vec3 color = binding.state.fog.color;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(block->color[static_cast<std::size_t>(k)][lane], 255 * (f * 0.8f + (1 - f) * color[k]), 1e-3) << lane;
    }
    EXPECT_EQ(block->color[3][lane], 0.8f * 255);
  }
  RasterBinding binding;
  PrimitiveRecord primitive;
  std::unique_ptr<FragmentBlock> block = std::make_unique<FragmentBlock>();
};

TEST(Fog, FollowsTheFormulaOfEachMode) {
  for (const FogMode mode : {FogMode::linear, FogMode::exp, FogMode::exp2}) {
    Fogged fogged;
    fogged.run(mode);
    for (std::size_t lane = 0; lane < 64; ++lane) {
      const double c = fogged.coordinate(lane), d = 0.3f;
      const double f = mode == FogMode::linear ? (7 - c) / 5 : mode == FogMode::exp ? std::exp(-d * c) : std::exp(-d * c * d * c);
      fogged.expect(lane, std::clamp(f, 0.0, 1.0));
    }
  }
}

TEST(Fog, HasTheSameBitsOnEveryInstructionSet) {
  std::optional<std::vector<float>> reference;
  for (const simd::Target target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    Fogged fogged;
    fogged.run(FogMode::exp2);
    const std::vector<float> red(fogged.block->color[0].begin(), fogged.block->color[0].end());
    if (!reference) reference = red;
    EXPECT_EQ(red, *reference);
  }
  simd::set_target_for_test(std::nullopt);
}

TEST(Fog, OfAnEmptyRangeIsAllOrNothing) {
  Fogged fogged;
  fogged.binding.state.fog.start = fogged.binding.state.fog.end = 2;
  fogged.block->varying[0][63] = std::numeric_limits<float>::quiet_NaN();
  fogged.run(FogMode::linear);
  fogged.expect(0, 1);
  fogged.expect(62, 0);
  fogged.expect(63, 0);
}

TEST(ColorSum, IsClampedAndLeavesAlphaAlone) {
  Fogged fogged;
  color_sum_pass(ColorFormat::rgba8)(*fogged.block, {});
  EXPECT_NEAR(fogged.block->color[0][5], 255 * 0.9, 1e-3);
  EXPECT_EQ(fogged.block->color[2][5], 255.0f);
  EXPECT_EQ(fogged.block->color[3][5], 0.8f * 255);
}

}  // namespace
}  // namespace gouraud::pipeline
