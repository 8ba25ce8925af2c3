#include "pipeline/texture/halved_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "pipeline/texture/halved_srgb_rows.h"
#include "pipeline/texture/texel_access.h"

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

/// The byte whose linear value, half a byte around it in the encoding, holds the mean; in double, halves up.
int nearest_srgb(const std::array<int, 4>& bytes) {
  double sum = 0;
  for (const int byte : bytes) sum += linear_of_srgb(byte / 255.0) / 4;
  int byte = 0;
  while (byte < 255 && linear_of_srgb((byte + 0.5) / 255.0) <= sum + 1e-12) ++byte;
  return byte;
}

TEST(HalvedSrgbRows, EachTexelIsTheNearestOfTheLinearMean) {
  std::uint32_t state = 5;
  for (const int channels : {1, 2, 4}) {
    constexpr int width = 600;
    const auto step = static_cast<std::size_t>(channels);
    std::vector<std::byte> lower(2 * width * step), upper(lower.size()), out(width * step + 1, std::byte{123});
    for (auto* row : {&lower, &upper}) {
      for (std::byte& byte : *row) {
        state = state * 1664525u + 1013904223u;
        byte = static_cast<std::byte>(state >> 31 == 0 ? state >> 24 & 15 : state >> 24);  // dark ones lie closest
      }
    }
    halve_rows_srgb8(lower.data(), upper.data(), channels, width, out.data());
    for (std::size_t i = 0; i < width * step; ++i) {
      const std::size_t left = i / step * 2 * step + i % step, right = left + step;
      const auto byte = [](const std::vector<std::byte>& row, std::size_t at) { return std::to_integer<int>(row[at]); };
      const std::array<int, 4> bytes{byte(lower, left), byte(lower, right), byte(upper, left), byte(upper, right)};
      const bool is_alpha = channels > 1 && i % step == step - 1;
      ASSERT_EQ(byte(out, i), is_alpha ? (bytes[0] + bytes[1] + bytes[2] + bytes[3] + 2) / 4 : nearest_srgb(bytes)) << channels << ", " << i;
    }
    EXPECT_EQ(out.back(), std::byte{123});
  }
}

TEST(HalvedSrgbRows, AllPairsOfBytes) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      const std::array<std::byte, 2> row{static_cast<std::byte>(a), static_cast<std::byte>(b)};
      std::byte out;
      halve_rows_srgb8(row.data(), row.data(), 1, 1, &out);
      ASSERT_EQ(std::to_integer<int>(out), nearest_srgb({a, b, a, b})) << a << ", " << b;
    }
  }
}

}  // namespace
}  // namespace gouraud::pipeline
