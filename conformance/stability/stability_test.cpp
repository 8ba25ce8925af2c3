// Every sweep keeps its promises: the default holds as far as it says, and the weak methods fail where theory says so.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "conformance/stability/sweeps.h"

namespace gouraud::stability {
namespace {

class Sweeps : public ::testing::TestWithParam<std::size_t> {};

/// The contestants that something is expected of.
std::vector<Contestant> contestants_of(const Sweep& sweep) {
  std::vector<Contestant> all = probes::all_contestants(conformance::Paths::of_this_build());
  std::erase_if(all, [&](const Contestant& contestant) {
    return std::ranges::none_of(sweep.expectations, [&](const Expectation& e) { return e.contestant == contestant.name; });
  });
  return all;
}

TEST_P(Sweeps, AllIsAsExpected) {
  const Sweep& sweep = all_sweeps()[GetParam()];
  const std::vector<Contestant> contestants = contestants_of(sweep);
  ASSERT_FALSE(contestants.empty());
  for (const std::string& complaint : complaints(sweep, run_sweep(sweep, contestants))) ADD_FAILURE() << complaint;
}

INSTANTIATE_TEST_SUITE_P(All, Sweeps, ::testing::Range(std::size_t{0}, all_sweeps().size()),
                         [](const auto& sweep) { return std::string(all_sweeps()[sweep.param].probe.name); });

// The judge itself, over values made by hand.
const Sweep judged{{"made_up", "", 1, 1, nullptr},
                   "knob",
                   {1, 2, 3},
                   {{"error", "", nullptr}},
                   {{"default", "error", 1, 2, 0.5}, {"weak", "error", 2, 3, {}, 5.0, "it must"}}};

TEST(Complaints, AreNoneWhereAllHolds) {
  EXPECT_TRUE(complaints(judged, {{"default", {{1, {0.1}}, {2, {0.5}}, {3, {9}}}, {}}, {"weak", {{2, {0}}, {3, {6}}}, {}}}).empty());
}

TEST(Complaints, NameTheKnobWhereABoundIsPassed) {
  const auto sentences = complaints(judged, {{"default", {{1, {0.1}}, {2, {0.6}}}, {}}});
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_NE(sentences[0].find("0.6 at 2"), std::string::npos);
}

TEST(Complaints, AWeakMethodThatDoesNotFailIsOne) {
  EXPECT_EQ(complaints(judged, {{"weak", {{2, {1}}, {3, {2}}}, {}}}).size(), 1u);
}

TEST(Complaints, NotANumberKeepsNoBound) {
  EXPECT_EQ(complaints(judged, {{"default", {{1, {std::numeric_limits<double>::quiet_NaN()}}}, {}}}).size(), 1u);
}

TEST(Complaints, ADefaultThatDoesNotDrawIsOne) {
  EXPECT_EQ(complaints(judged, {{"default", {{1, {0}}, {2, {0}}}, {"at 3: the process ended"}}}).size(), 1u);
}

}  // namespace
}  // namespace gouraud::stability
