// A plan holds what the picture needs, and nothing else: asserted on the printed lines.
#include "pipeline/draw/plan.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "pipeline/draw/small_triangles.h"

namespace gouraud::pipeline {
namespace {

constexpr TargetFormat window{ColorFormat::rgba8, DepthFormat::z24s8};

DrawState unlit() {
  DrawState state;
  state.raster.scissor = {0, 0, 64, 64};
  return state;
}

DrawState lit() {
  DrawState state = unlit();
  state.lighting.enabled = true;
  state.lighting.light_count = 1;
  state.lighting.lights[0].diffuse = glm::vec4(1);
  state.lighting.lights[0].position_eye = {0, 0, 1};
  return state;
}

/// The stages' names: each printed line up to its detail or section.
std::vector<std::string> stages(const DrawState& state, TargetFormat target = window) {
  std::istringstream text(describe(make_plan(state, target), state, target));
  std::vector<std::string> names;
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) names.push_back(line.substr(2, line.find_first_of(":[") - 2));
  for (std::string& name : names) {
    while (!name.empty() && name.back() == ' ') name.pop_back();
  }
  return names;
}

using Stages = std::vector<std::string>;

TEST(Plan, OfUnlitUntestedTrianglesIsShort) {
  EXPECT_EQ(stages(unlit()), (Stages{"transform to clip space", "clamp vertex colors", "clip and project", "rasterize", "write color"}));
}

TEST(Plan, OfADirectionalLightNeedsNoEyePositions) {
  EXPECT_EQ(stages(lit()),
            (Stages{"transform to clip space", "transform normals", "light", "clip and project", "rasterize", "write color"}));
}

TEST(Plan, OfAPositionalLightOrALocalViewerNeedsEyePositions) {
  DrawState positional = lit();
  positional.lighting.lights[0].positional = true;
  EXPECT_TRUE(make_plan(positional, window).eye_positions);
  DrawState viewer = lit();
  viewer.lighting.local_viewer = true;
  EXPECT_TRUE(make_plan(viewer, window).eye_positions);
}

TEST(Plan, WithoutLightsAsksForNoNormals) {
  DrawState state = lit();
  state.lighting.light_count = 0;
  const Plan plan = make_plan(state, window);
  EXPECT_FALSE(plan.normals);
  EXPECT_EQ(plan.vertex_demand, 0u);
}

TEST(Plan, OfMaskedColorsLightsNothing) {
  DrawState state = lit();
  state.raster.color_write_mask = 0;
  state.raster.depth = {true, true, CompareFunc::less};
  EXPECT_EQ(stages(state), (Stages{"transform to clip space", "clip and project", "rasterize", "depth test"}));
  EXPECT_EQ(make_plan(state, window).vertex_demand, 0u);
}

TEST(Plan, ThatCannotReachTheTargetDrawsNothing) {
  DrawState masked = unlit();
  masked.raster.color_write_mask = 0;
  EXPECT_FALSE(make_plan(masked, window).draws);
  DrawState never = unlit();
  never.raster.depth = {true, true, CompareFunc::never};
  EXPECT_FALSE(make_plan(never, window).draws);
  DrawState scissored = unlit();
  scissored.raster.scissor = {};
  EXPECT_FALSE(make_plan(scissored, window).draws);
}

TEST(Plan, ADepthTestThatAlwaysPassesAndWritesNothingIsAbsent) {
  DrawState state = unlit();
  state.raster.depth = {true, false, CompareFunc::always};
  EXPECT_EQ(stages(state), stages(unlit()));
}

TEST(Plan, RunsThePassesThatNeedNoColorsEarly) {
  DrawState state = unlit();
  EXPECT_EQ(make_plan(state, window).fragment.early, 0);
  state.raster.depth = {true, true, CompareFunc::less};
  EXPECT_EQ(make_plan(state, window).fragment.early, 1);
  state.raster.polygon_stipple.enabled = true;
  state.raster.counts_samples = true;
  EXPECT_EQ(make_plan(state, window).fragment.early, 3);
  // The alpha test comes before the depth test [GL1.5 §4.1.4] and needs colours: what is hidden goes before.
  state.raster.alpha_test = {true, CompareFunc::greater, 0.5f};
  EXPECT_EQ(make_plan(state, window).fragment.early, 2);
  state.raster.depth.func = CompareFunc::notequal;
  EXPECT_EQ(make_plan(state, window).fragment.early, 1);
  state.raster.depth.func = CompareFunc::less;
  state.raster.color_write_mask = 0;
  state.raster.alpha_test.enabled = false;
  const FragmentPasses passes = make_plan(state, window).fragment;
  EXPECT_EQ(passes.early, passes.count);
}

TEST(Plan, OpensTheRoadOfSmallTrianglesToADepthTestAlone) {
  DrawState state = unlit();
  const auto road = [&] { return make_plan(state, window).fragment.small_triangles; };
  EXPECT_EQ(road(), SmallTriangleTests{});
  state.raster.depth = {true, true, CompareFunc::less};
  EXPECT_EQ(road(), small_triangle_tests(CompareFunc::less, window.depth));
  state.polygons.offset_fill = true;
  EXPECT_EQ(road(), SmallTriangleTests{});
  state.polygons.offset_fill = false;
  state.raster.counts_samples = true;
  EXPECT_EQ(road(), SmallTriangleTests{});
}

TEST(Plan, BlendsBetweenInterpolationAndWrite) {
  DrawState state = unlit();
  state.raster.blend = {true, {BlendEquation::add, BlendFactor::source_alpha, BlendFactor::one_minus_source_alpha},
                        {BlendEquation::add, BlendFactor::source_alpha, BlendFactor::one_minus_source_alpha}, {}};
  Stages expected = stages(unlit());
  expected.insert(expected.end() - 1, "blend");
  EXPECT_EQ(stages(state), expected);
  EXPECT_NE(describe(make_plan(state, window), state, window)
                .find("blend: add (source alpha, 1 - source alpha)  [GL1.5 §4.1.8]"),
            std::string::npos);
}

TEST(Plan, TestsAlphaBeforeDepth) {
  DrawState state = unlit();
  state.raster.depth = {true, true, CompareFunc::less};
  state.raster.alpha_test = {true, CompareFunc::greater, 0.5f};
  const Stages all = stages(state);
  EXPECT_EQ(Stages(all.end() - 3, all.end()), (Stages{"alpha test", "depth test", "write color"}));

  state.raster.color_write_mask = 0;
  const Stages masked = stages(state);
  EXPECT_EQ(Stages(masked.end() - 2, masked.end()), (Stages{"alpha test", "depth test"}));
  EXPECT_EQ(make_plan(state, window).vertex_demand, attribute_color);

  state.raster.alpha_test = {true, CompareFunc::never, 0.0f};
  EXPECT_FALSE(make_plan(state, window).draws);
}

TEST(Plan, ALogicOpThatChangesNothingWritesNothing) {
  DrawState state = unlit();
  state.raster.logic_op = LogicOp::xor_;
  EXPECT_EQ(stages(state).end()[-2], "logical operation");
  state.raster.logic_op = LogicOp::noop;
  EXPECT_FALSE(make_plan(state, window).draws);
}

TEST(Plan, WithoutADepthBufferTestsNoDepth) {
  DrawState state = unlit();
  state.raster.depth = {true, true, CompareFunc::less};
  EXPECT_EQ(stages(state, {ColorFormat::rgba8, DepthFormat::none}), stages(unlit()));
}

TEST(Plan, ThatReportsEndsBehindClipping) {
  DrawState state = lit();
  state.raster = {};
  state.report.enabled = true;
  EXPECT_EQ(stages(state), (Stages{"transform to clip space", "clip and project", "report"}));
  state.report.colors = true;
  EXPECT_EQ(stages(state), (Stages{"transform to clip space", "transform normals", "light", "clip and project", "report"}));
  state.report.texture_units = 1;
  EXPECT_EQ(make_plan(state, window).vertex_demand, attribute_normal | attribute_texture_coordinates(0));
  EXPECT_EQ(make_plan(state, window).fragment.count, 0);
}

TEST(Plan, ColorMaterialAsksForColors) {
  DrawState state = lit();
  EXPECT_EQ(make_plan(state, window).vertex_demand, attribute_normal);
  state.lighting.color_material_front = material_diffuse;
  EXPECT_EQ(make_plan(state, window).vertex_demand, attribute_normal | attribute_color);
}

/// What the gears demo sets up: one directional light, flat or smooth, back faces culled, depth tested.
TEST(Plan, OfGearsHoldsNothingThatTheSceneDoesNotNeed) {
  DrawState state = lit();
  state.transform.normal_scaling = NormalScaling::normalize;
  state.assembly.cull = CullMode::back;
  state.assembly.shade_model = ShadeModel::flat;
  state.raster.depth = {true, true, CompareFunc::less};
  EXPECT_EQ(describe(make_plan(state, window), state, window),
            "plan:\n"
            "  transform to clip space  [GL1.5 §2.11.2]\n"
            "  transform normals: normalized  [GL1.5 §2.11.3]\n"
            "  light: 1 light  [GL1.5 §2.14.1]\n"
            "  clip and project  [GL1.5 §2.12, §2.11.1]\n"
            "  cull  [GL1.5 §3.5.1]\n"
            "  rasterize: flat  [GL1.5 §3.5.1]\n"
            "  depth test: less, write  [GL1.5 §4.1.6]\n"
            "  write color: 8 bits  [GL1.5 §4.2.2]\n");
}

TEST(Plan, OfSmoothLinesMultipliesAlphaByCoverage) {
  DrawState state = unlit();
  state.lines.smooth = true;
  state.lines.width_px = 1.5f;
  EXPECT_EQ(stages(state), (Stages{"transform to clip space", "clamp vertex colors", "clip and project", "rasterize", "smooth lines",
                                   "coverage", "write color"}));
  EXPECT_NE(describe(make_plan(state, window), state, window).find("smooth lines: width 1.5"), std::string::npos);
}

TEST(Plan, OfFilledPolygonsHasNoCoverageOfSmoothLines) {
  DrawState state = unlit();
  const Plan plain = make_plan(state, window);
  state.lines.smooth = state.points.smooth = true;
  const Plan plan = make_plan(state, window);
  EXPECT_EQ(plan.filled, plain.fragment);
  EXPECT_NE(plan.fragment, plain.fragment);
  const DrawnKinds filled{.points = false, .lines = false};
  EXPECT_EQ(describe(plan, state, window, filled), describe(plain, unlit(), window));
  state.polygons.smooth = true;
  EXPECT_EQ(make_plan(state, window).filled, plan.fragment);
}

TEST(Plan, OfAStippledPolygonMasksFirst) {
  DrawState state = unlit();
  state.raster.polygon_stipple.enabled = true;
  const Plan plan = make_plan(state, window);
  EXPECT_TRUE(plan.polygon_stipple);
  EXPECT_EQ(plan.fragment.count, 2);
}

TEST(Plan, OfAttenuatedPointsNeedsEyePositions) {
  DrawState state = unlit();
  state.points.attenuated = true;
  EXPECT_TRUE(make_plan(state, window).eye_positions);
}

TEST(Plan, OfPolygonsThatAreNotFilledNeedsEdgeFlags) {
  DrawState state = unlit();
  EXPECT_EQ(make_plan(state, window).vertex_demand & attribute_edge_flag, 0u);
  state.assembly.polygon_mode_back = PolygonMode::line;
  EXPECT_NE(make_plan(state, window).vertex_demand & attribute_edge_flag, 0u);
}

TEST(Plan, RunsTheDepthTestInsideTheStencilTest) {
  DrawState state = unlit();
  state.raster.color_write_mask = 0;
  state.raster.depth = {true, false, CompareFunc::less};
  state.raster.stencil.enabled = true;
  state.raster.stencil.front = state.raster.stencil.back = {.func = CompareFunc::equal, .depth_fail = StencilOp::increment};
  EXPECT_EQ(stages(state), (Stages{"transform to clip space", "clip and project", "rasterize", "stencil test", "depth test"}));
  const Plan plan = make_plan(state, window);
  EXPECT_EQ(plan.fragment.count, 1);
  EXPECT_NE(plan.fragment.inner_depth, nullptr);
  EXPECT_NE(describe(plan, state, window).find("equal (keep, increment, keep)"), std::string::npos);
}

TEST(Plan, OfDepthsThatAllFailDrawsForTheStencilBufferAlone) {
  DrawState state = unlit();
  state.raster.depth = {true, false, CompareFunc::never};
  EXPECT_FALSE(make_plan(state, window).draws);
  state.raster.stencil.enabled = true;
  state.raster.stencil.front = state.raster.stencil.back = {.depth_fail = StencilOp::zero};
  const Plan plan = make_plan(state, window);
  EXPECT_TRUE(plan.draws && plan.writes_stencil);
  EXPECT_FALSE(plan.writes_color || plan.colors);
}

TEST(Plan, CountsSamplesThatNobodySees) {
  DrawState state = unlit();
  state.raster.color_write_mask = 0;
  EXPECT_FALSE(make_plan(state, window).draws);
  state.raster.counts_samples = true;
  EXPECT_EQ(stages(state), (Stages{"transform to clip space", "clip and project", "rasterize", "count samples"}));
}

}  // namespace
}  // namespace gouraud::pipeline
