#include "pipeline/draw/methods.h"

#include <gtest/gtest.h>

#include <string>

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/plan.h"

namespace gouraud::pipeline {
namespace {

TEST(Methods, AreTheDefaultsWhereNothingIsSaid) {
  std::string error;
  EXPECT_EQ(parse_methods("", error), Methods{});
  EXPECT_EQ(parse_methods(",", error), Methods{});
  EXPECT_EQ(describe(Methods{}), "");
}

TEST(Methods, AreDescribedAsTheyAreParsed) {
  std::string error;
  for (const MethodRow& row : method_rows()) {
    const std::string text = std::string(row.step) + "=" + std::string(row.name);
    const auto methods = parse_methods(text, error);
    ASSERT_TRUE(methods) << text;
    EXPECT_EQ(describe(*methods), *methods == Methods{} ? "" : text);
  }
}

TEST(Methods, HaveOneDefaultAStepAndItIsTheFirst) {
  std::string error, last;
  for (const MethodRow& row : method_rows()) {
    const auto methods = parse_methods(std::string(row.step) + "=" + std::string(row.name), error);
    EXPECT_EQ(*methods == Methods{}, row.step != last) << row.step << ' ' << row.name;
    EXPECT_FALSE(row.line.empty() || row.source.empty()) << row.name;
    last = row.step;
  }
}

TEST(Methods, ThatAreUnknownAreNamedWithWhatTheyMayBe) {
  std::string error;
  EXPECT_FALSE(parse_methods("colors=affine,shading=rough", error));
  EXPECT_EQ(error.find("method shading='rough' is not known; it may be gouraud"), 0u) << error;
  EXPECT_FALSE(parse_methods("smell=strong", error));
  EXPECT_NE(error.find("step 'smell' is not known; it may be coverage, epsilon, ownership, "), std::string::npos) << error;
  EXPECT_FALSE(parse_methods("colors", error));
  EXPECT_EQ(error, "method 'colors' is not of the form step=name");
}

TEST(Methods, ArePrintedWithThePlan) {
  DrawState state;
  state.raster.scissor = {0, 0, 64, 64};
  TargetFormat target{ColorFormat::rgba8, DepthFormat::z24s8};
  EXPECT_EQ(describe(make_plan(state, target), state, target).find("methods"), std::string::npos);
  target.methods.colors = InterpolationMethod::affine;
  EXPECT_NE(describe(make_plan(state, target), state, target).find("\n  methods: colors=affine\n"), std::string::npos);
}

}  // namespace
}  // namespace gouraud::pipeline
