#include "pipeline/simd/float_mode.h"

#include <cfenv>

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

// Kept from the compiler, which would compute it by its own rounding.
float third() {
  volatile float one = 1, three = 3;
  return one / three;
}

TEST(IeeeFloats, RoundsToNearestWhateverTheProgramHasSet) {
  const float nearest = third();
  ASSERT_EQ(std::fesetround(FE_DOWNWARD), 0);
  const float down = third();
  {
    const IeeeFloats floats;
    EXPECT_EQ(third(), nearest);
  }
  EXPECT_EQ(third(), down);
  EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
  std::fesetround(FE_TONEAREST);
  EXPECT_LT(down, nearest);
}

#if defined(__SSE2__)
TEST(IeeeFloats, KeepsDenormals) {
  const auto halved = [] {
    volatile float smallest_normal = 1.17549435e-38f, half = 0.5f;
    return smallest_normal * half;
  };
  const unsigned before = _mm_getcsr();
  _mm_setcsr(before | 0x8040);
  EXPECT_EQ(halved(), 0.0f);
  {
    const IeeeFloats floats;
    EXPECT_GT(halved(), 0.0f);
  }
  EXPECT_EQ(halved(), 0.0f);
  _mm_setcsr(before);
}
#endif

}  // namespace
}  // namespace gouraud::pipeline
