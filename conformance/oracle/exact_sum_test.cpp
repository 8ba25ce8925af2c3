#include "conformance/oracle/exact_sum.h"

#include <gtest/gtest.h>

namespace gouraud::oracle {
namespace {

TEST(ExactSum, LosesNothingToCancellation) {
  EXPECT_EQ((ExactSum{{1e30, 1.0, -1e30}}.value()), 1.0);
  EXPECT_EQ((ExactSum{{1.0, 1e100, 1.0, -1e100}}.value()), 2.0);
  EXPECT_EQ((ExactSum{{}}.value()), 0.0);
}

TEST(ExactSum, MultipliesExactly) {
  const ExactSum a{{1e17, 1.0}}, b{{1e17, -1.0}};
  EXPECT_EQ((a * b - ExactSum{{1e17}} * ExactSum{{1e17}}).value(), -1.0);
}

}  // namespace
}  // namespace gouraud::oracle
