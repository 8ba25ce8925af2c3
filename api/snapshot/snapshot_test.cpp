// The canonical snapshot as a property: for random states and targets, changing a parameter that the picture cannot
// show leaves the DrawState equal, changing one that it can show makes it differ. `shows` says when, from the
// specification, independently of the snapshot's code.
#include "api/snapshot/snapshot.h"

#include <gtest/gtest.h>

#include <vector>

#include "api/snapshot/test_fragment_parameters.h"
#include "api/snapshot/test_vertex_parameters.h"

namespace gouraud::api {
namespace {

std::vector<Parameter> all_parameters() {
  std::vector<Parameter> list;
  add_transform(list);
  add_lighting(list);
  add_rasterization(list);
  add_points_and_lines(list);
  add_polygons(list);
  add_framebuffer(list);
  add_fog(list);
  add_clip_planes(list);
  add_alpha_test(list);
  add_blending(list);
  add_logic_op(list);
  add_stencil(list);
  add_what_no_draw_reads(list);
  return list;
}

State random_state(Random& r, const std::vector<Parameter>& parameters) {
  State s;
  s.viewport = {3, 4, 50, 40, 0.125, 0.75};
  s.scissor = {coin(r), 5 + pick(r, 9), 6, 20, 21};
  s.lighting.enabled = pick(r, 4) != 0;
  s.depth.test_enabled = coin(r);
  s.stencil.front = {GL_EQUAL, 4, 0xFF, GL_INVERT, GL_KEEP, GL_KEEP, 0xFF};
  s.stencil.separate_back = {GL_EQUAL, 8, 0xFF, GL_INVERT, GL_KEEP, GL_KEEP, 0xFF};
  s.stencil.two_side_back = {GL_EQUAL, 16, 0xFF, GL_INVERT, GL_KEEP, GL_KEEP, 0xFF};
  for (Light& light : s.lighting.lights) {
    light.enabled = coin(r);
    light.ambient = color_or_black(r);
    light.diffuse = color_or_black(r);
    light.specular = color_or_black(r);
    light.position_eye = {number(r), number(r), number(r), coin(r) ? 0.0f : number(r)};
    if (coin(r)) light.spot_cutoff_deg = 90.0f * number(r);
  }
  if (coin(r)) s.lighting.model_ambient = glm::vec4(0);
  s.lighting.color_material_face = other(r, 0, {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK});
  s.lighting.color_material_parameter = other(r, 0, {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION});
  if (coin(r)) s.lighting.color_material_parameter = GL_AMBIENT_AND_DIFFUSE;
  if (pick(r, 4) == 0) s.color_buffer.write_enabled = {false, false, coin(r), false};
  for (const Parameter& parameter : parameters) {
    if (coin(r)) parameter.change(s, r);
  }
  return s;
}

TargetInfo random_target(Random& r) {
  constexpr pipeline::ColorFormat colors[] = {pipeline::ColorFormat::none, pipeline::ColorFormat::rgba8,
                                              pipeline::ColorFormat::rgba8, pipeline::ColorFormat::rgba32f};
  constexpr pipeline::DepthFormat depths[] = {pipeline::DepthFormat::none, pipeline::DepthFormat::z16,
                                              pipeline::DepthFormat::z24s8, pipeline::DepthFormat::z24s8};
  return {100, 80, {colors[pick(r, 4)], depths[pick(r, 4)]}, coin(r) ? 255u : 0u};
}

TEST(Snapshot, DiffersExactlyWhereThePictureCanShowTheParameter) {
  const std::vector<Parameter> parameters = all_parameters();
  Random random(7);
  std::vector<int> shown(parameters.size()), hidden(parameters.size());
  for (int round = 0; round < 3000; ++round) {
    const State state = random_state(random, parameters);
    const TargetInfo target = random_target(random);
    const pipeline::DrawState before = snapshot_of(state, target);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      State changed = state;
      parameters[i].change(changed, random);
      const bool shows = parameters[i].shows({state, target});
      ASSERT_EQ(snapshot_of(changed, target) != before, shows) << parameters[i].name << ", round " << round;
      ++(shows ? shown : hidden)[i];
    }
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) EXPECT_GT(shown[i] + hidden[i], 0) << parameters[i].name;
}

TEST(Snapshot, InSelectionHoldsWhatFindsPrimitivesAndNothingElse) {
  const std::vector<Parameter> parameters = all_parameters();
  Random random(9);
  for (int round = 0; round < 500; ++round) {
    State state = random_state(random, parameters);
    state.render_mode.mode = GL_SELECT;
    const TargetInfo target = random_target(random);
    const pipeline::DrawState before = snapshot_of(state, target);
    EXPECT_TRUE(before.report.enabled);
    EXPECT_FALSE(before.report.colors);
    EXPECT_EQ(before.raster.color_write_mask, 0);
    State changed = state;
    changed.color_buffer.clear_color = color(random);
    changed.lighting.enabled = !changed.lighting.enabled;
    changed.lighting.shade_model = GL_FLAT;
    changed.color_buffer.write_enabled = {true, false, true, false};
    changed.depth.test_enabled = !changed.depth.test_enabled;
    changed.polygon.front_mode = GL_LINE;
    changed.scissor.enabled = !changed.scissor.enabled;
    EXPECT_EQ(snapshot_of(changed, target), before);
    changed.viewport.depth_near = 0.375;
    EXPECT_NE(snapshot_of(changed, target), before);
  }
}

TEST(Snapshot, OfTheInitialStateIsTheInitialDrawState) {
  const TargetInfo target{0, 0, {pipeline::ColorFormat::rgba8, pipeline::DepthFormat::z24s8}, 255};
  EXPECT_EQ(snapshot_of(State(), target), pipeline::DrawState());
}

}  // namespace
}  // namespace gouraud::api
