#include "pipeline/texture/halved_rows.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <vector>

namespace gouraud::pipeline {
namespace {

TEST(HalvedRows, EachTexelIsTheRoundedMeanOfFourAndNothingElseIsWritten) {
  std::uint32_t state = 1;
  const auto random_byte = [&] {
    state = state * 1664525u + 1013904223u;
    return static_cast<std::byte>(state >> 30 == 0 ? 255 : state >> 24);
  };
  for (const int channels : {1, 2, 4}) {
    for (int width = 1; width <= 140; ++width) {
      const auto step = static_cast<std::size_t>(channels), texels = static_cast<std::size_t>(width);
      std::vector<std::byte> lower(2 * texels * step), upper(lower.size()), out(texels * step + 1, std::byte{123});
      for (auto* row : {&lower, &upper}) {
        for (std::byte& byte : *row) byte = random_byte();
      }
      halve_rows_unorm8(lower.data(), upper.data(), channels, width, out.data());
      for (std::size_t i = 0; i < texels * step; ++i) {
        const std::size_t left = i / step * 2 * step + i % step, right = left + step;
        int sum = 2;
        for (const auto* row : {&lower, &upper}) sum += std::to_integer<int>((*row)[left]) + std::to_integer<int>((*row)[right]);
        ASSERT_EQ(std::to_integer<int>(out[i]), sum / 4) << channels << " channels, width " << width << ", byte " << i;
      }
      EXPECT_EQ(out.back(), std::byte{123});
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
