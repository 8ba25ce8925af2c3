#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/simd/math_test.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/simd/math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Applies `function` to x and y, whose sizes are a multiple of 16.
template <class T, class Function>
HWY_INLINE void for_lanes(const std::vector<T>& x, const std::vector<T>& y, std::vector<T>& out,
                          const Function& function) {
  const hn::CappedTag<T, 16> d;
  for (std::size_t i = 0; i < x.size(); i += hn::Lanes(d)) {
    hn::StoreU(function(d, hn::LoadU(d, x.data() + i), hn::LoadU(d, y.data() + i)), d, out.data() + i);
  }
}

template <class T>
void log2_all(const std::vector<T>& x, const std::vector<T>& y, std::vector<T>& out) {
  for_lanes(x, y, out, [](auto d, auto a, auto) HWY_ATTR { return log2(d, a); });
}
template <class T>
void exp2_all(const std::vector<T>& x, const std::vector<T>& y, std::vector<T>& out) {
  for_lanes(x, y, out, [](auto d, auto a, auto) HWY_ATTR { return exp2(d, a); });
}
void pow_all(const std::vector<double>& x, const std::vector<double>& y, std::vector<double>& out) {
  for_lanes(x, y, out, [](auto d, auto a, auto b) HWY_ATTR { return pow(d, a, b); });
}

void log2_double(const std::vector<double>& x, const std::vector<double>& y, std::vector<double>& out) {
  log2_all(x, y, out);
}
void log2_float(const std::vector<float>& x, const std::vector<float>& y, std::vector<float>& out) {
  log2_all(x, y, out);
}
void exp2_double(const std::vector<double>& x, const std::vector<double>& y, std::vector<double>& out) {
  exp2_all(x, y, out);
}
void exp2_float(const std::vector<float>& x, const std::vector<float>& y, std::vector<float>& out) {
  exp2_all(x, y, out);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
namespace {

template <class T>
using Kernel = void (*)(const std::vector<T>&, const std::vector<T>&, std::vector<T>&);
template <class T>
using Chooser = Kernel<T> (*)();

template <class T>
std::vector<T> apply(Chooser<T> chooser, const std::vector<T>& x, const std::vector<T>& y) {
  std::vector<T> out(x.size());
  chooser()(x, y, out);
  return out;
}

/// The results of the best target, after a check that every other one gives the same bits.
template <class T>
std::vector<T> apply_on_all_targets(Chooser<T> chooser, const std::vector<T>& x, const std::vector<T>& y) {
  const std::vector<T> best = apply(chooser, x, y);
  for (const simd::Target target :
       {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    const std::vector<T> other = apply(chooser, x, y);
    EXPECT_EQ(std::memcmp(other.data(), best.data(), best.size() * sizeof(T)), 0) << simd::target_name(target);
  }
  simd::set_target_for_test(std::nullopt);
  return best;
}

Kernel<double> log2_of_doubles() {
  return GOURAUD_SIMD_PICK(log2_double);
}
Kernel<float> log2_of_floats() {
  return GOURAUD_SIMD_PICK(log2_float);
}
Kernel<double> exp2_of_doubles() {
  return GOURAUD_SIMD_PICK(exp2_double);
}
Kernel<float> exp2_of_floats() {
  return GOURAUD_SIMD_PICK(exp2_float);
}
Kernel<double> pow_of_doubles() {
  return GOURAUD_SIMD_PICK(pow_all);
}

constexpr std::size_t sample_count = 1 << 18;

/// `count` numbers from low to high, evenly spaced.
template <class T>
std::vector<T> evenly(double low, double high, std::size_t count = sample_count) {
  std::vector<T> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = static_cast<T>(low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return out;
}

/// Any bit pattern at all: every number, denormals, infinities, NaNs.
template <class T, class Bits>
std::vector<T> any_bits() {
  std::mt19937_64 random(1);
  std::vector<T> out(sample_count);
  for (T& value : out) {
    const auto bits = static_cast<Bits>(random());
    std::memcpy(&value, &bits, sizeof value);
  }
  return out;
}

TEST(Log2, OfDoublesIsWithinItsBound) {
  for (const double high : {2.0, 1e-3, 1e6, 1e-300, 1e300}) {
    const std::vector<double> x = evenly<double>(high / 1e4, high), got = apply_on_all_targets(log2_of_doubles, x, x);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::abs(got[i] - std::log2(x[i])));
    EXPECT_LT(worst, 2.5e-10) << high;
  }
}

TEST(Log2, OfDoublesNearOneIsRelativelyExact) {
  const std::vector<double> x = evenly<double>(1 - 1e-5, 1 + 1e-5), got = apply_on_all_targets(log2_of_doubles, x, x);
  for (std::size_t i = 0; i < x.size(); ++i)
    ASSERT_LE(std::abs(got[i] - std::log2(x[i])), 2e-8 * std::abs(std::log2(x[i])));
}

TEST(Log2, OfFloatsIsWithinItsBound) {
  for (const double high : {2.0, 1e-3, 1e6, 1e-34, 1e36}) {
    const std::vector<float> x = evenly<float>(high / 1e3, high), got = apply_on_all_targets(log2_of_floats, x, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double exact = std::log2(static_cast<double>(x[i]));
      ASSERT_LE(std::abs(got[i] - exact), std::max(1.2e-7, 0.9e-7 * std::abs(exact))) << x[i];
    }
  }
}

TEST(Log2, OfPowersOfTwoIsExact) {
  std::vector<double> x(2048, 1.0);
  for (int e = -1022; e <= 1023; ++e) x[static_cast<std::size_t>(e + 1022)] = std::ldexp(1.0, e);
  const std::vector<double> got = apply_on_all_targets(log2_of_doubles, x, x);
  for (int e = -1022; e <= 1023; ++e) EXPECT_EQ(got[static_cast<std::size_t>(e + 1022)], e);
}

TEST(Log2, TakesWhatIsNoPositiveNumberForTheSmallest) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  std::vector<double> x{0.0, -0.0, -1.0, -inf, nan, 1e-310};
  x.resize(16, inf);
  const std::vector<double> got = apply_on_all_targets(log2_of_doubles, x, x);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(got[i], -1022.0);
  EXPECT_EQ(got[6], 1024.0);
}

TEST(Exp2, OfDoublesIsWithinItsBound) {
  for (const double high : {1.0, 30.0, 400.0}) {
    const std::vector<double> x = evenly<double>(-2.5 * high, high), got = apply_on_all_targets(exp2_of_doubles, x, x);
    for (std::size_t i = 0; i < x.size(); ++i) ASSERT_LE(std::abs(got[i] / std::exp2(x[i]) - 1), 6e-11) << x[i];
  }
}

TEST(Exp2, OfFloatsIsWithinItsBound) {
  for (const double high : {1.0, 30.0, 126.0}) {
    const std::vector<float> x = evenly<float>(-high, high), got = apply_on_all_targets(exp2_of_floats, x, x);
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_LE(std::abs(got[i] / std::exp2(static_cast<double>(x[i])) - 1), 1.2e-7) << x[i];
    }
  }
}

TEST(Exp2, OfIntegersIsExactAndOutsideTheRangeItIsClamped) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x{-1000, -3, 0, 1, 10, 400, 1e9, -1e9, nan};
  x.resize(16, 0.0);
  const std::vector<double> got = apply_on_all_targets(exp2_of_doubles, x, x);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(got[i], std::exp2(x[i]));
  EXPECT_EQ(got[6], std::exp2(400.0));
  EXPECT_EQ(got[7], std::exp2(-1000.0));
  EXPECT_EQ(got[8], std::exp2(-1000.0));
}

TEST(Pow, OfSpecularFactorsIsWithinItsBound) {
  for (const double y : {0.3, 1.0, 2.0, 7.25, 32.0, 99.9, 128.0}) {
    const std::vector<double> x = evenly<double>(0.01, 1), exponent(x.size(), y);
    const std::vector<double> got = apply_on_all_targets(pow_of_doubles, x, exponent);
    for (std::size_t i = 0; i < x.size(); ++i) {
      ASSERT_LE(std::abs(got[i] / std::pow(x[i], y) - 1), 2e-10 * (1 + y)) << x[i] << " ^ " << y;
    }
  }
}

TEST(Pow, OfOneAndToTheZeroIsOneAndOfNothingIsNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x{1, 1, 0, 0.5, nan, 0, -1, nan, 0};
  std::vector<double> y{3, 128, 0, 0, 0, 1, 2, 3, 1e-3};
  x.resize(16, 1.0);
  y.resize(16, 1.0);
  const std::vector<double> got = apply_on_all_targets(pow_of_doubles, x, y);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(got[i], 1.0) << i;
  for (std::size_t i = 5; i < 9; ++i) EXPECT_EQ(got[i], 0.0) << i;
}

TEST(EveryTarget, GivesTheSameBitsForAnyInput) {
  const std::vector<double> x = any_bits<double, std::uint64_t>();
  std::vector<double> y = x;
  std::reverse(y.begin(), y.end());
  apply_on_all_targets(log2_of_doubles, x, y);
  apply_on_all_targets(exp2_of_doubles, x, y);
  const std::vector<double> powers = apply_on_all_targets(pow_of_doubles, x, y);
  EXPECT_TRUE(std::none_of(powers.begin(), powers.end(), [](double v) { return std::isnan(v); }));
  const std::vector<float> a = any_bits<float, std::uint32_t>();
  apply_on_all_targets(log2_of_floats, a, a);
  apply_on_all_targets(exp2_of_floats, a, a);
}

}  // namespace
}  // namespace gouraud::pipeline
#endif
