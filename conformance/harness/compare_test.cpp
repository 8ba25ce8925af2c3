#include "conformance/harness/compare.h"

#include <gtest/gtest.h>

#include "conformance/harness/testing.h"

namespace gouraud::conformance {
namespace {

TEST(CompareCoverage, CountsPixelsOfOnePictureOnly) {
  Picture first = covered_row(std::vector<Rgba>(5));
  Picture second = first;
  first.covered = {1, 1, 1, 0, 0};
  second.covered = {0, 1, 1, 1, 0};
  const CoverageDifference difference = compare_coverage(first, second);
  EXPECT_EQ(difference.drawn, 4u);
  EXPECT_EQ(difference.only_first, 1u);
  EXPECT_EQ(difference.only_second, 1u);
  EXPECT_EQ(difference.total(), 2u);
}

TEST(CompareCoverage, OracleDecidesWhereNoDepthTestIsAmbiguous) {
  Picture oracle = exact_row({{10, 0, 0, 255}, {20, 0, 0, 255}, {30, 0, 0, 255}});
  Picture picture = oracle;
  picture.covered = {0, 0, 1};
  oracle.exact->alternatives[1] = {oracle::OraclePixel{}};
  EXPECT_EQ(compare_coverage(picture, *oracle.exact).total(), 1u);
}

TEST(CompareColor, MeasuresOnlyPixelsThatBothCover) {
  Picture first = covered_row({{10, 10, 10, 255}, {10, 10, 10, 255}, {10, 10, 10, 255}, {0, 0, 0, 0}});
  Picture second = covered_row({{10, 10, 10, 255}, {11, 10, 10, 255}, {10, 7, 10, 255}, {99, 99, 99, 99}});
  second.covered[3] = 0;
  const ColorDifference difference = compare_color(first, second);
  EXPECT_EQ(difference.pixels, 3u);
  EXPECT_EQ(difference.identical, 1u);
  EXPECT_EQ(difference.beyond_one, 1u);
  EXPECT_EQ(difference.max, 3);
  EXPECT_DOUBLE_EQ(difference.mean, 4.0 / 12.0);
  EXPECT_DOUBLE_EQ(difference.different_percent(), 200.0 / 3.0);
}

TEST(CompareBackground, SeesWrongClears) {
  Picture first = covered_row(std::vector<Rgba>(4));
  first.covered = {0, 0, 0, 1};
  Picture second = first;
  set_color(second, 1, {0, 0, 0, 1});
  second.depth[2] = 7;
  set_color(second, 3, {9, 9, 9, 9});
  EXPECT_EQ(compare_background(first, second), 2u);
}

TEST(CompareExact, PerfectRoundingHasNoExcess) {
  const Picture oracle = exact_row({{10.25, 20.5, 30.75, 255}, {0.1, 0, 7.4, 255}});
  const ExactError error = compare_exact(oracle, *oracle.exact);
  EXPECT_EQ(error.pixels, 2u);
  EXPECT_DOUBLE_EQ(error.color_max, 0.5);
  EXPECT_DOUBLE_EQ(error.color_mean, (0.25 + 0.5 + 0.25 + 0.1 + 0.4) / 5.0);  // whole numbers do not count
  EXPECT_DOUBLE_EQ(error.color_mean, error.color_mean_of_rounding);
  EXPECT_EQ(error.depth_max, 0.0);
}

TEST(CompareExact, WrongColorsAndDepthsShow) {
  const Picture oracle = exact_row({{10.25, 20.5, 30.75, 255}, {50, 50, 50, 255}});
  Picture picture = oracle;
  picture.rgba[0] = 12;
  picture.rgba[4] = 53;
  picture.depth = {1000, 1004};
  const ExactError error = compare_exact(picture, *oracle.exact);
  EXPECT_DOUBLE_EQ(error.color_max, 3.0);
  EXPECT_NEAR(error.color_mean, (1.75 + 0.5 + 0.25 + 3.0) / 4.0, 1e-9);  // a wrong byte counts for whole numbers as well
  EXPECT_NEAR(error.color_mean_of_rounding, (0.25 + 0.5 + 0.25) / 4.0, 1e-9);
  EXPECT_DOUBLE_EQ(error.depth_max, 4.0);
  EXPECT_DOUBLE_EQ(error.depth_mean, 2.0);
}

TEST(CompareExact, AnAmbiguousPixelMayBeAnyOfItsOutcomes) {
  Picture oracle = exact_row({{10, 10, 10, 255}});
  const Picture other = exact_row({{200, 200, 200, 255}});
  oracle.exact->alternatives[0] = {other.exact->pixels[0]};
  oracle.exact->flags[0] |= oracle::pixel_depth_ambiguous;
  EXPECT_EQ(compare_exact(other, *oracle.exact).color_max, 0.0);
  const Picture neither = exact_row({{100, 100, 100, 255}});
  EXPECT_NEAR(compare_exact(neither, *oracle.exact).color_max, 90.0, 1e-9);
}

}  // namespace
}  // namespace gouraud::conformance
