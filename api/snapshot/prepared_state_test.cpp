// What the snapshot makes of single groups: scissor, lights, clears, stencil, accumulation, samples.
#include <gtest/gtest.h>

#include <limits>

#include "api/snapshot/blend_snapshot.h"
#include "api/snapshot/test_parameters.h"

namespace gouraud::api {
namespace {

TEST(Snapshot, ScissorBoxIsIntersectedWithTheTarget) {
  const TargetInfo target{64, 32, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::none}, 0};
  State state;
  EXPECT_EQ(snapshot_of(state, target).raster.scissor, (pipeline::PixelRect{0, 0, 64, 32}));
  constexpr GLint most = std::numeric_limits<GLint>::max(), least = std::numeric_limits<GLint>::min();
  state.scissor = {true, -5, -5, most, most};
  EXPECT_EQ(snapshot_of(state, target).raster.scissor, (pipeline::PixelRect{0, 0, 64, 32}));
  state.scissor = {true, 60, 30, most, 1};
  EXPECT_EQ(snapshot_of(state, target).raster.scissor, (pipeline::PixelRect{60, 30, 64, 31}));
  for (const ScissorGroup outside : {ScissorGroup{true, 64, 0, 9, 9}, ScissorGroup{true, most, most, most, most},
                                     ScissorGroup{true, least, least, 9, 9}, ScissorGroup{true, 3, 3, 0, 9}}) {
    state.scissor = outside;
    EXPECT_EQ(snapshot_of(state, target).raster.scissor, pipeline::PixelRect());
  }
}

TEST(PreparedLight, IsInEyeSpaceAndOfUnitDirection) {
  Light light;
  light.position_eye = {0, 3, 4, 0};
  light.diffuse = glm::vec4(1);
  light.linear_attenuation = 5;
  const pipeline::PreparedLight directional = prepare_light(light);
  EXPECT_FALSE(directional.positional);
  EXPECT_EQ(directional.position_eye, glm::vec3(0, 0.6f, 0.8f));
  EXPECT_EQ(directional.attenuation, glm::vec3(1, 0, 0));
  EXPECT_FALSE(directional.spot);

  light.position_eye = {2, 4, 6, 2};
  light.spot_cutoff_deg = 90;
  light.spot_direction_eye = {0, 0, -7};
  const pipeline::PreparedLight spot = prepare_light(light);
  EXPECT_TRUE(spot.positional && spot.spot);
  EXPECT_EQ(spot.position_eye, glm::vec3(1, 2, 3));
  EXPECT_EQ(spot.attenuation, glm::vec3(1, 5, 0));
  EXPECT_EQ(spot.spot_direction_eye, glm::vec3(0, 0, -1));
  EXPECT_EQ(spot.spot_cutoff_cosine, 0.0f);
  light.spot_cutoff_deg = 60;
  EXPECT_EQ(prepare_light(light).spot_cutoff_cosine, 0.5f);
}

TEST(PreparedLight, WithoutADirectionIsZero) {
  Light light;
  const float infinity = std::numeric_limits<float>::infinity();
  for (const glm::vec4 position : {glm::vec4(0, 0, 0, 0), glm::vec4(infinity, 0, 0, 0)}) {
    light.position_eye = position;
    EXPECT_EQ(prepare_light(light).position_eye, glm::vec3(0));
  }
}

TEST(ClearState, LeavesOutWhatIsMaskedOrMissing) {
  State state;
  state.stencil.clear_value = 0x1FF;
  const GLbitfield everything = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  const TargetInfo full{8, 8, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::z24s8}, 255};
  const pipeline::ClearState all = clear_state(state, full, everything);
  EXPECT_TRUE(all.color && all.depth && all.stencil);
  EXPECT_EQ(all.clear_stencil, 255u);

  state.depth.write_enabled = false;
  state.stencil.front.write_mask = 0xF00;
  state.color_buffer.write_enabled = {false, false, false, false};
  const pipeline::ClearState masked = clear_state(state, full, everything);
  EXPECT_FALSE(masked.color || masked.depth || masked.stencil);
  const pipeline::ClearState bare = clear_state(State(), {8, 8, {}, 0}, everything);
  EXPECT_FALSE(bare.color || bare.depth || bare.stencil);
}

constexpr TargetInfo stencil_target{8, 8, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::z24s8}, 255};

TEST(StencilSnapshot, IsAbsentWhereItPassesAllAndChangesNothing) {
  State state;
  state.stencil.test_enabled = true;
  EXPECT_EQ(snapshot_of(state, stencil_target), snapshot_of(State(), stencil_target));
  state.stencil.front.fail = state.stencil.separate_back.fail = GL_INCR;  // nothing fails
  EXPECT_FALSE(snapshot_of(state, stencil_target).raster.stencil.enabled);
  state.stencil.front.depth_pass = GL_ZERO;
  state.stencil.front.write_mask = 0xFF00;
  EXPECT_FALSE(snapshot_of(state, stencil_target).raster.stencil.enabled);
}

TEST(StencilSnapshot, ComparesNothingUnderAnEmptyMaskAndClampsTheReference) {
  State state;
  state.stencil.test_enabled = true;
  state.stencil.front = {GL_LESS, 3, 0, GL_REPLACE, GL_KEEP, GL_KEEP, 0xFF};
  EXPECT_EQ(snapshot_of(state, stencil_target).raster.stencil.front.func, pipeline::CompareFunc::never);
  state.stencil.front = {GL_EQUAL, 3, 0x100, GL_REPLACE, GL_KEEP, GL_KEEP, 0xFF};
  EXPECT_EQ(snapshot_of(state, stencil_target).raster.stencil.front, pipeline::StencilFace());
  for (const auto& [reference, clamped] : {std::pair{300, 255}, std::pair{-7, 0}, std::pair{77, 77}}) {
    state.stencil.front = {GL_GEQUAL, reference, ~0u, GL_KEEP, GL_KEEP, GL_KEEP, 0xFF};
    EXPECT_EQ(snapshot_of(state, stencil_target).raster.stencil.front.reference, clamped);
  }
}

TEST(BlendSnapshot, OfTheEquationLogicOpIsThatOfTheLogicalOperation) {
  State as_equation, as_operation;
  as_equation.color_buffer.blend.equation_rgb = as_equation.color_buffer.blend.equation_alpha = GL_LOGIC_OP;
  for (const GLenum op : {GL_XOR, GL_COPY, GL_NOOP}) {
    as_equation.color_buffer.logic_op = as_operation.color_buffer.logic_op = op;
    for (const bool enabled : {true, false}) {
      as_equation.color_buffer.blend.enabled = as_operation.color_buffer.logic_op_enabled = enabled;
      const ColorBufferGroup &a = as_equation.color_buffer, &b = as_operation.color_buffer;
      for (const pipeline::ColorFormat format : {pipeline::ColorFormat::rgba8, pipeline::ColorFormat::rgba32f}) {
        EXPECT_EQ(logic_op_state(a, 15, format), logic_op_state(b, 15, format));
      }
      EXPECT_EQ(blend_state(a, 15), pipeline::BlendState());
    }
  }
}

TEST(AccumSnapshot, BoundsTheValue) {
  const float infinity = std::numeric_limits<float>::infinity();
  const State state;
  EXPECT_EQ(accum_state(state, stencil_target, GL_ADD, 3.0f).value, 1.0f);
  EXPECT_EQ(accum_state(state, stencil_target, GL_MULT, -infinity).value, -1.0f);
  EXPECT_EQ(accum_state(state, stencil_target, GL_LOAD, 3.0f).value, 3.0f);
  EXPECT_EQ(accum_state(state, stencil_target, GL_RETURN, infinity).value, std::numeric_limits<float>::max());
  EXPECT_EQ(accum_state(state, stencil_target, GL_ACCUM, std::numeric_limits<float>::quiet_NaN()).value, 0.0f);
}

/// Of a target with four samples, or without.
bool changes(int samples, void (*change)(State&)) {
  State state;
  TargetInfo target;
  target.width_px = target.height_px = 8;
  target.format = {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::none};
  target.samples = samples;
  const pipeline::DrawState before = snapshot_of(state, target);
  change(state);
  return snapshot_of(state, target) != before;
}

TEST(Multisample, ItsStateIsThatOfTargetsWithSamples) {
  const auto expect = [](void (*change)(State&), bool of_many, bool of_one) {
    EXPECT_EQ(changes(4, change), of_many);
    EXPECT_EQ(changes(0, change), of_one);
  };
  expect([](State& s) { s.multisample.alpha_to_coverage_enabled = true; }, true, false);
  expect([](State& s) { s.multisample.alpha_to_one_enabled = true; }, true, false);
  expect([](State& s) { s.multisample.enabled = false; }, true, false);
  expect([](State& s) { s.multisample.coverage_enabled = true, s.multisample.coverage_value = 0.5f; }, true, false);
  expect([](State& s) { s.point.fade_threshold_px = 3.0f; }, true, false);
  expect([](State& s) { s.point.fade_threshold_px = 0.5f; }, false, false);
  expect([](State& s) { s.point.smooth_enabled = true; }, false, true);
  expect([](State& s) { s.line.smooth_enabled = true; }, false, true);
  expect([](State& s) { s.polygon.smooth_enabled = true; }, false, true);
  expect([](State& s) { s.line.width_px = 1.25f; }, true, false);
}

}  // namespace
}  // namespace gouraud::api
