#include "conformance/chart/pareto.h"

#include <gtest/gtest.h>

namespace gouraud::chart {
namespace {

const std::vector<Point> three{{"fast", 0.5, 10}, {"right", 2, 0}, {"neither", 3, 20}};

TEST(Pareto, TheFrontHoldsWhatNothingBeats) { EXPECT_EQ(front(three), (std::vector{true, true, false})); }

TEST(Pareto, EqualErrorIsBeatenByLessTime) {
  EXPECT_EQ(front({{"a", 1, 5}, {"b", 2, 5}}), (std::vector{true, false}));
}

TEST(Pareto, EqualPointsAreBothOnTheFront) { EXPECT_EQ(front({{"a", 1, 5}, {"b", 1, 5}}), (std::vector{true, true})); }

TEST(Pareto, DifferencesBelowTheResolutionDecideNothing) {
  EXPECT_FALSE(beats({"a", 0.99, 0}, {"b", 1, 1}));
  EXPECT_FALSE(beats({"a", 0.5, 1}, {"b", 1, 1 + 1e-6}));
  EXPECT_TRUE(beats({"a", 0.5, 0.9}, {"b", 1, 1}));
  EXPECT_TRUE(is_faster_and_as_accurate({"a", 0.5, 1}, {"b", 1, 1}));
}

TEST(Pareto, NamesWhoBeatsAPoint) {
  EXPECT_EQ(beaten_by(three[2], three), (std::vector<std::string>{"fast", "right"}));
  EXPECT_TRUE(beaten_by(three[0], three).empty());
}

}  // namespace
}  // namespace gouraud::chart
