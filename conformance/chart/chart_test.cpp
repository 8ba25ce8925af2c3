// The whole program in a tiny form: it measures, says who is on the front, and writes its files.
#include <algorithm>

#include <gtest/gtest.h>

#include "conformance/chart/chart_files.h"

namespace gouraud::chart {
namespace {

class ChartTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    contestants_ = all_contestants(conformance::Paths::of_this_build());
    std::erase_if(contestants_, [](const Contestant& c) { return c.owner == Owner::ours_method; });
    ChartOptions options;
    options.rounds = 1;
    options.area_grid = 2;
    options.least_sample_s = 0;
    options.only = {"color_floor", "edges"};
    charts_ = measure_chart(contestants_, options);
  }
  static std::vector<Contestant> contestants_;
  static std::vector<SceneChart> charts_;
};

std::vector<Contestant> ChartTest::contestants_;
std::vector<SceneChart> ChartTest::charts_;

TEST_F(ChartTest, EveryContestantDrawsEveryScene) {
  ASSERT_EQ(charts_.size(), 2u);
  for (const SceneChart& chart : charts_) {
    EXPECT_EQ(chart.entries.size(), 3u);
    for (const Entry& entry : chart.entries) {
      EXPECT_EQ(entry.failure, "") << entry.contestant->name;
      EXPECT_GT(entry.frame_s, 0);
    }
  }
}

TEST_F(ChartTest, TheDefaultIsExactWhereTheReferenceIs) {
  const Entry& own = charts_[0].entries[0];
  ASSERT_EQ(own.contestant->owner, Owner::ours_default);
  EXPECT_EQ(own.error.coverage_percent, 0);
  EXPECT_LT(own.error.color_beyond_rounding, 0.001);
  EXPECT_EQ(charts_[1].entries[0].error.has_coverage, false);
}

TEST_F(ChartTest, TheFilesHoldWhatWasMeasured) {
  const std::string json = chart_json(charts_);
  for (const char* const word : {"\"color_floor\"", "\"edges\"", "\"llvmpipe\"", "\"softpipe\"", "\"default\"", "\"overall\""}) {
    EXPECT_NE(json.find(word), std::string::npos) << word;
  }
  const std::string page = chart_html(charts_);
  EXPECT_NE(page.find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);  // nothing from elsewhere
}

// So the default is on the front of these scenes, whatever the times are.
TEST(ChartFront, NobodyIsMoreAccurateThanTheDefaultWhereTheReferenceIsExact) {
  const std::vector<Contestant> contestants = all_contestants(conformance::Paths::of_this_build());
  ChartOptions options;
  options.rounds = 1;
  options.least_sample_s = 0;
  for (const ChartScene& scene : chart_scenes()) {
    if (scene.reference == ReferenceKind::exact) options.only.emplace_back(scene.probe.name);
  }
  for (const SceneChart& chart : measure_chart(contestants, options)) {
    for (const Axis axis : all_axes) {
      const std::vector<Point> points = points_of(chart, axis);
      const auto own = std::ranges::find(points, "default", &Point::name);
      if (own == points.end()) continue;
      for (const Point& other : points) {
        EXPECT_GE(other.error, own->error - Resolution{}.error) << chart.scene->probe.name << ", " << name_of(axis) << ": " << other.name;
      }
    }
  }
}

TEST(ChartScenes, AreAtLeastTwelveWithNamesOfTheirOwn) {
  std::vector<std::string_view> names;
  for (const Probe& probe : all_probes()) names.push_back(probe.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  EXPECT_GE(chart_scenes().size(), 12u);
}

}  // namespace
}  // namespace gouraud::chart
