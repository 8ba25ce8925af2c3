#include "conformance/probes/methods.h"

#include <gtest/gtest.h>

#include "conformance/harness/drivers.h"

namespace gouraud::probes {
namespace {

TEST(ChartMethods, TheFirstRowOfAStepIsItsDefault) {
  const std::vector<Method> methods = methods_of_table(
      "coverage\tblocks8\twhat\twho\ncoverage\tscanline\tspans\tWylie 1967\nantialiasing\tnone\t\t\nantialiasing\t4x4\t\t\n");
  ASSERT_EQ(methods.size(), 3u);
  EXPECT_EQ(methods[0].setting, "");
  EXPECT_EQ(methods[1].setting, "coverage=scanline");
  EXPECT_EQ(methods[1].source, "Wylie 1967");
  EXPECT_FALSE(methods[1].antialiases);
  EXPECT_EQ(methods[2].setting, "antialiasing=4x4");
  EXPECT_TRUE(methods[2].antialiases);
}

TEST(ChartMethods, AreThoseOfTheLibrary) { EXPECT_GT(all_methods(conformance::Paths::of_this_build().our_library).size(), 1u); }

}  // namespace
}  // namespace gouraud::probes
