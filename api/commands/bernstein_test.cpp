// Bernstein weights against their definition [GL1.5 §5.1 eq 5.1].
#include "api/commands/bernstein.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace gouraud::api {
namespace {

using Real = long double;
constexpr int most = 30;

Real power(Real base, int exponent) {
  Real result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

// choose(n, i) t^i (1 - t)^(n - i)
Real definition(int n, int i, Real t) {
  if (i < 0 || i > n) return 0;
  Real choose = 1;
  for (int k = 1; k <= i; ++k) choose = choose * static_cast<Real>(n - i + k) / static_cast<Real>(k);
  return choose * power(t, i) * power(1 - t, n - i);
}

TEST(Bernstein, MeetsItsDefinitionToAFewUnitsInTheLastPlace) {
  Real worst = 0;
  for (int order = 1; order <= most; ++order) {
    for (int step = 0; step <= 64; ++step) {
      const double t = step / 64.0;
      std::array<double, most> weights;
      bernstein(order, t, weights.data(), nullptr);
      for (int i = 0; i < order; ++i) {
        const Real want = definition(order - 1, i, t);
        const Real error = std::abs(static_cast<Real>(weights[static_cast<std::size_t>(i)]) - want);
        EXPECT_LE(error, want * 3 * order * 0x1p-53L) << order << ' ' << i << ' ' << t;
        if (want > 0) worst = std::max(worst, error / want);
      }
    }
  }
  RecordProperty("worst_error_in_units_of_the_last_place", std::to_string(static_cast<double>(worst * 0x1p53L)));
  EXPECT_LT(worst, 8e-15L);
}

TEST(Bernstein, SlopesAreTheDerivatives) {
  for (int order = 1; order <= most; ++order) {
    for (int step = 0; step <= 64; ++step) {
      const double t = step / 64.0;
      std::array<double, most> weights, slopes, alone;
      bernstein(order, t, weights.data(), slopes.data());
      bernstein(order, t, alone.data(), nullptr);
      const int n = order - 1;
      for (int i = 0; i < order; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Real left = definition(n - 1, i - 1, t), right = definition(n - 1, i, t);
        EXPECT_NEAR(slopes[k], static_cast<double>(n * (left - right)), n * 1e-14 * static_cast<double>(left + right) + 0.0);
        EXPECT_EQ(weights[k], alone[k]);
      }
    }
  }
}

TEST(Bernstein, TakesTheEndsExactlyAndOtherNumbersAsTheyCome) {
  std::array<double, most> weights, slopes;
  bernstein(most, 0.0, weights.data(), slopes.data());
  for (std::size_t i = 0; i < most; ++i) EXPECT_EQ(weights[i], i == 0 ? 1.0 : 0.0);
  bernstein(most, 1.0, weights.data(), slopes.data());
  for (std::size_t i = 0; i < most; ++i) EXPECT_EQ(weights[i], i == most - 1 ? 1.0 : 0.0);
  bernstein(3, -1.0, weights.data(), nullptr);
  EXPECT_EQ((std::array{weights[0], weights[1], weights[2]}), (std::array{4.0, -4.0, 1.0}));
  bernstein(1, NAN, weights.data(), slopes.data());
  EXPECT_EQ(weights[0], 1.0);
  EXPECT_EQ(slopes[0], 0.0);
}

}  // namespace
}  // namespace gouraud::api
