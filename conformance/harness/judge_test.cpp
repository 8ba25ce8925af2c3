#include "conformance/harness/judge.h"

#include <gtest/gtest.h>

#include "conformance/harness/testing.h"

namespace gouraud::conformance {
namespace {

/// 2000 pixels of one colour that is not a whole number of 1/255.
Picture exact_picture() { return exact_row(std::vector<std::array<double, 4>>(2000, {100.25, 50.25, 0, 255})); }

SceneRenderings all_equal() {
  const Rendering oracle{exact_picture(), ""};
  Rendering driver = oracle;
  driver.picture->exact.reset();
  return {driver, driver, driver, oracle};
}

Verdict judge_as(Judge judge_kind, const SceneRenderings& renderings, const AcceptedExceptions* accepted = nullptr) {
  Scene scene;
  scene.name = "test";
  scene.judge = judge_kind;
  return judge(scene, renderings, accepted);
}

bool complains(const Verdict& verdict, std::string_view about) {
  for (const std::string& complaint : verdict.complaints) {
    if (complaint.find(about) != std::string::npos) return true;
  }
  return false;
}

TEST(Judge, EqualPicturesPass) {
  for (const Judge kind : {Judge::polygons, Judge::lines_and_points, Judge::oracle_only}) {
    const Verdict verdict = judge_as(kind, all_equal());
    EXPECT_TRUE(verdict.passed()) << verdict.complaints.front();
    EXPECT_EQ(verdict.value("drawn"), 2000.0);
    EXPECT_EQ(verdict.value("color_max_oracle"), 0.25);
  }
}

TEST(Judge, OnePixelOfCoverageFailsPolygonsOnly) {
  SceneRenderings renderings = all_equal();
  renderings.llvmpipe->picture->covered[7] = 0;
  EXPECT_TRUE(complains(judge_as(Judge::polygons, renderings), "coverage_llvmpipe"));
  EXPECT_TRUE(judge_as(Judge::lines_and_points, renderings).passed());  // 1 of 2000 is less than 0.5 %
  EXPECT_TRUE(judge_as(Judge::oracle_only, renderings).passed());
}

TEST(Judge, CoverageOfTheOracleBindsAll) {
  SceneRenderings renderings = all_equal();
  renderings.ours->picture->covered[7] = 0;
  EXPECT_TRUE(complains(judge_as(Judge::oracle_only, renderings), "coverage_oracle"));
}

TEST(Judge, ThreePixelsOffByOneIn2000AreTooMany) {
  SceneRenderings renderings = all_equal();
  for (const std::size_t pixel : {1, 2}) ++renderings.llvmpipe->picture->rgba[4 * pixel];
  EXPECT_TRUE(judge_as(Judge::polygons, renderings).passed());
  ++renderings.llvmpipe->picture->rgba[4 * 3];
  EXPECT_TRUE(complains(judge_as(Judge::polygons, renderings), "different_llvmpipe"));
}

TEST(Judge, DepthIsTheOraclesBusiness) {
  SceneRenderings renderings = all_equal();
  renderings.llvmpipe->picture->depth[5] = 90000;
  EXPECT_TRUE(judge_as(Judge::polygons, renderings).passed());
  renderings.ours->picture->depth[5] = 1002;
  EXPECT_TRUE(complains(judge_as(Judge::polygons, renderings), "depth_max_oracle"));
}

TEST(Judge, SystematicRoundingDownShowsInTheMean) {
  SceneRenderings renderings = all_equal();
  renderings.oracle->picture = exact_row(std::vector<std::array<double, 4>>(2000, {100.52, 50.52, 0, 255}));
  EXPECT_TRUE(complains(judge_as(Judge::oracle_only, renderings), "color_excess_oracle"));
}

TEST(Judge, ACrashedDriverFailsTheScene) {
  SceneRenderings renderings = all_equal();
  renderings.llvmpipe = Rendering{std::nullopt, "signal 11"};
  const Verdict verdict = judge_as(Judge::polygons, renderings);
  EXPECT_TRUE(complains(verdict, "llvmpipe: signal 11"));
  EXPECT_TRUE(verdict.value("coverage_oracle").has_value());  // the rest is measured all the same
  renderings.ours = Rendering{std::nullopt, "signal 6"};
  EXPECT_TRUE(complains(judge_as(Judge::polygons, renderings), "ours: signal 6"));
}

TEST(Judge, GlErrorsMustBeMesas) {
  SceneRenderings renderings = all_equal();
  renderings.ours->picture->gl_errors = {0x0502};
  EXPECT_TRUE(complains(judge_as(Judge::oracle_only, renderings), "glGetError gives 0x0502, llvmpipe none"));
}

TEST(Judge, ReadPixelsMustAgreeWithTheMemory) {
  SceneRenderings renderings = all_equal();
  renderings.ours->picture->read_differences = 3;
  EXPECT_TRUE(complains(judge_as(Judge::oracle_only, renderings), "glReadPixels"));
}

TEST(Judge, AnEmptyPictureShowsNothing) {
  SceneRenderings renderings = all_equal();
  for (auto* rendering : {&renderings.ours, &renderings.llvmpipe, &renderings.softpipe}) {
    (*rendering)->picture->covered.assign(2000, 0);
  }
  EXPECT_TRUE(complains(judge_as(Judge::oracle_only, renderings), "the picture is empty"));
  renderings.ours->picture->rgba[8] = 7;  // cleared in two colours, say
  EXPECT_FALSE(complains(judge_as(Judge::oracle_only, renderings), "the picture is empty"));
}

TEST(Judge, AnExceptionRaisesTheBoundAndNoFurther) {
  SceneRenderings renderings = all_equal();
  renderings.llvmpipe->picture->covered[7] = 0;
  const AcceptedExceptions one{{{"coverage_llvmpipe", 1.0}}, "§3.5.1"};
  EXPECT_TRUE(judge_as(Judge::polygons, renderings, &one).passed());
  renderings.llvmpipe->picture->covered[8] = 0;
  EXPECT_TRUE(complains(judge_as(Judge::polygons, renderings, &one), "coverage_llvmpipe"));
}

TEST(Judge, AnExceptionThatIsNotNeededFails) {
  const AcceptedExceptions idle{{{"coverage_llvmpipe", 1.0}}, "§3.5.1"};
  EXPECT_TRUE(complains(judge_as(Judge::polygons, all_equal(), &idle), "needs no exception"));
  EXPECT_TRUE(complains(judge_as(Judge::oracle_only, all_equal(), &idle), "not judged here"));
}

TEST(Accepted, ReadsBoundsAndReason) {
  const AcceptedExceptions accepted =
      parse_accepted("coverage_llvmpipe <= 3\ncolor_max_llvmpipe <= 2.5\n\nMesa is wrong here [GL1.5 §2.12].\nx <= 1\n");
  EXPECT_EQ(accepted.bounds.size(), 2u);
  EXPECT_EQ(accepted.bounds.at("color_max_llvmpipe"), 2.5);
  EXPECT_EQ(accepted.reason, "Mesa is wrong here [GL1.5 §2.12].\nx <= 1\n");
}

TEST(Accepted, RefusesWhatExcusesNothing) {
  EXPECT_THROW(parse_accepted("because of §2.12\n"), std::runtime_error);
  EXPECT_THROW(parse_accepted("coverage_llvmpipe <= 3\n"), std::runtime_error);
  EXPECT_THROW(parse_accepted("coverage_llvmpipe <= some\n§2.12\n"), std::runtime_error);
  EXPECT_THROW(parse_accepted("no_such_measure <= 3\n§2.12\n"), std::runtime_error);
}

}  // namespace
}  // namespace gouraud::conformance
