// The canonical texturing state as a property: what no filter, wrap mode or combiner reads makes no difference, and what
// one reads does.
#include "api/snapshot/texture_snapshot.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace gouraud::api {
namespace {

using pipeline::BaseFormat;
using pipeline::TexelFormat;

TextureBinding object_of(TextureTarget target, BaseFormat base, GLsizei side = 4, GLint border = 0) {
  auto object = std::make_shared<TextureObject>(target);
  for (auto& face : object->texture->faces) {
    GLsizei size = side;
    for (auto& image : face) {
      image.format = base == BaseFormat::depth ? TexelFormat::z16 : TexelFormat::rgba8;
      image.base_format = base;
      image.border = border;
      image.width = size + 2 * border;
      image.height = target == TextureTarget::one_d ? 1 : image.width;
      image.depth = target == TextureTarget::three_d ? image.width : 1;
      if (size == 1) break;
      size /= 2;
    }
  }
  return object;
}

/// Unit 1 with a complete texture.
struct Scene {
  explicit Scene(TextureTarget its_target = TextureTarget::two_d, BaseFormat base = BaseFormat::rgba, GLint border = 0)
      : target(its_target), object(object_of(target, base, 4, border)) {
    unit().enabled[index_of(target)] = true;
    unit().binding[index_of(target)] = object;
  }
  TextureUnit& unit() { return state.texture.units[1]; }
  TextureEnvironmentParameters& environment() { return unit().environment; }
  TextureParameters& parameters() { return object->parameters; }
  pipeline::TexturingState snapshot() const { return texturing_state(state); }

  TextureTarget target;
  TextureBinding object;
  State state;
};

using Change = std::function<void(Scene&)>;

bool shows(Scene& scene, const Change& change) {
  const pipeline::TexturingState before = scene.snapshot();
  EXPECT_EQ(before.count, 1);
  change(scene);
  return scene.snapshot() != before;
}

const Change border_color = [](Scene& s) { s.parameters().border_color = {0.1f, 0.2f, 0.3f, 0.4f}; };
const Change environment_color = [](Scene& s) { s.environment().color.x = 0.5f; };
const Change environment_alpha = [](Scene& s) { s.environment().color.w = 0.5f; };

TEST(TextureSnapshot, UnitsWithoutACompleteTextureAreAbsent) {
  Scene scene;
  EXPECT_EQ(scene.snapshot().count, 1);
  EXPECT_EQ(scene.snapshot().unit[0].unit, 1);
  EXPECT_EQ(scene.snapshot().unit[0].texture, scene.object->texture.get());
  scene.object->texture->faces[0][1].width = 3;
  EXPECT_EQ(scene.snapshot(), pipeline::TexturingState()) << "a mipmap is asked for";
  scene.parameters().min_filter = GL_LINEAR;
  EXPECT_EQ(scene.snapshot().count, 1);
  scene.parameters().base_level = 9;
  EXPECT_EQ(scene.snapshot(), pipeline::TexturingState());
  scene.parameters().base_level = 0;
  scene.unit().enabled = {};
  EXPECT_EQ(scene.snapshot(), pipeline::TexturingState());
  EXPECT_EQ(texturing_state(State()), pipeline::TexturingState());
}

TEST(TextureSnapshot, TheHighestTargetThatIsEnabledIsUsed) {
  Scene scene;
  scene.unit().enabled.fill(true);
  for (const TextureTarget target : {TextureTarget::one_d, TextureTarget::rectangle, TextureTarget::three_d, TextureTarget::cube_map}) {
    scene.unit().binding[index_of(target)] = object_of(target, BaseFormat::rgb);
  }
  for (const TextureTarget target : {TextureTarget::cube_map, TextureTarget::three_d, TextureTarget::rectangle, TextureTarget::two_d, TextureTarget::one_d}) {
    EXPECT_EQ(scene.snapshot().unit[0].target, target);
    scene.unit().enabled[index_of(target)] = false;
  }
}

TEST(TextureSnapshot, OnlyLevelsUpToTheMaximumCount) {
  Scene scene;
  EXPECT_EQ(scene.snapshot().unit[0].sampler.last_level, 2);
  EXPECT_FALSE(shows(scene, [](Scene& s) { s.parameters().max_level = 5; }));
  EXPECT_TRUE(shows(scene, [](Scene& s) { s.parameters().max_level = 1; }));
  scene.parameters().min_filter = GL_LINEAR;
  EXPECT_EQ(scene.snapshot().unit[0].sampler.last_level, 0);
}

TEST(TextureSnapshot, WrapModesAreThoseOfTheTargetsDimensions) {
  const Change s = [](Scene& x) { x.parameters().wrap[0] = GL_CLAMP_TO_EDGE; };
  const Change t = [](Scene& x) { x.parameters().wrap[1] = GL_CLAMP_TO_EDGE; };
  const Change r = [](Scene& x) { x.parameters().wrap[2] = GL_CLAMP_TO_EDGE; };
  for (const TextureTarget target : {TextureTarget::one_d, TextureTarget::two_d, TextureTarget::three_d, TextureTarget::cube_map}) {
    Scene scene(target);
    const int dimensions = target == TextureTarget::one_d ? 1 : target == TextureTarget::three_d ? 3 : 2;
    EXPECT_TRUE(shows(scene, s));
    EXPECT_EQ(shows(scene, t), dimensions > 1);
    EXPECT_EQ(shows(scene, r), dimensions > 2);
  }
}

TEST(TextureSnapshot, TheBorderColorMattersWhereItIsReached) {
  struct Case {
    GLenum wrap, filter;
    GLint border;
    bool reached;
  };
  for (const Case& c : {Case{GL_REPEAT, GL_LINEAR, 0, false}, Case{GL_CLAMP, GL_NEAREST, 0, false},
                        Case{GL_CLAMP, GL_LINEAR, 0, true}, Case{GL_CLAMP_TO_BORDER, GL_NEAREST, 0, true},
                        Case{GL_CLAMP_TO_BORDER, GL_NEAREST, 1, false}, Case{GL_CLAMP_TO_EDGE, GL_LINEAR, 0, false}}) {
    Scene scene(TextureTarget::two_d, BaseFormat::rgba, c.border);
    scene.parameters().wrap[1] = c.wrap;
    scene.parameters().min_filter = scene.parameters().mag_filter = c.filter;
    EXPECT_EQ(shows(scene, border_color), c.reached) << c.wrap << " " << c.filter;
  }
  Scene luminance(TextureTarget::two_d, BaseFormat::luminance);
  luminance.parameters().wrap[0] = GL_CLAMP_TO_BORDER;
  EXPECT_FALSE(shows(luminance, [](Scene& s) { s.parameters().border_color = {0, 1, 1, 1}; }));
  EXPECT_TRUE(shows(luminance, border_color));
}

TEST(TextureSnapshot, TheLevelOfDetailMattersWhereSomethingDependsOnIt) {
  const Change changes[] = {[](Scene& s) { s.parameters().lod_bias += 0.5f; }, [](Scene& s) { s.parameters().min_lod += 1.0f; },
                            [](Scene& s) { s.parameters().max_lod -= 1.0f; }, [](Scene& s) { s.environment().lod_bias += 0.25f; }};
  for (const Change& change : changes) {
    Scene mipmapped, two_filters, one_filter;
    two_filters.parameters().min_filter = GL_NEAREST;
    one_filter.parameters().min_filter = GL_LINEAR;
    EXPECT_TRUE(shows(mipmapped, change));
    EXPECT_TRUE(shows(two_filters, change));
    EXPECT_FALSE(shows(one_filter, change));
  }
  Scene scene;
  scene.parameters().lod_bias = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(scene.snapshot(), scene.snapshot()) << "no NaN gets in";
  scene.parameters().lod_bias = 1e30f;
  EXPECT_EQ(scene.snapshot().unit[0].sampler.lod_bias, max_texture_lod_bias);
}

TEST(TextureSnapshot, AnisotropyIsOfFiltersThatAverage) {
  const Change change = [](Scene& s) { s.parameters().max_anisotropy = 4.0f; };
  Scene mipmapped, linear, nearest, cube(TextureTarget::cube_map);
  linear.parameters().min_filter = GL_LINEAR;
  nearest.parameters().min_filter = GL_NEAREST;
  EXPECT_TRUE(shows(mipmapped, change));
  EXPECT_TRUE(shows(linear, change));
  EXPECT_FALSE(shows(nearest, change));
  EXPECT_FALSE(shows(cube, change));
  EXPECT_FALSE(shows(mipmapped, [](Scene& s) { s.parameters().max_anisotropy = 4.9f; }));
}

// [GL1.5 §3.8.13]: RGB and alpha results are scaled each by its own, wherever alpha comes from.
TEST(TextureSnapshot, TheScalarOfDot3IsScaledInAlphaAsAlphaIs) {
  const Change scale = [](Scene& s) { s.environment().alpha.scale = 4.0f; };
  const Change function = [](Scene& s) { s.environment().alpha.function = GL_ADD; };
  Scene core, extension;
  for (Scene* scene : {&core, &extension}) {
    scene->environment().mode = GL_COMBINE;
    scene->environment().rgb.function = scene == &core ? GL_DOT3_RGBA : GL_DOT3_RGBA_EXT;
    EXPECT_FALSE(shows(*scene, function));
  }
  EXPECT_TRUE(shows(core, scale));
  EXPECT_FALSE(shows(extension, scale)) << "EXT_texture_env_dot3 has no scale";
}

TEST(TextureSnapshot, OnlySpritesReplaceCoordinates) {
  const Change replace = [](Scene& s) { s.state.point.coord_replace ^= 2; };
  const Change replace_of_a_unit_without_texture = [](Scene& s) { s.state.point.coord_replace ^= 5; };
  Scene points, sprites;
  sprites.state.point.sprite_enabled = true;
  EXPECT_FALSE(shows(points, replace));
  EXPECT_TRUE(shows(sprites, replace));
  EXPECT_FALSE(shows(sprites, replace_of_a_unit_without_texture));
}

TEST(TextureSnapshot, DepthParametersAreThoseOfDepthTextures) {
  const Change mode = [](Scene& s) { s.parameters().depth_mode = GL_ALPHA; };
  const Change func = [](Scene& s) { s.parameters().compare_func = GL_GREATER; };
  const Change compare = [](Scene& s) { s.parameters().compare_mode = GL_COMPARE_R_TO_TEXTURE; };
  Scene color, depth(TextureTarget::two_d, BaseFormat::depth);
  EXPECT_FALSE(shows(color, mode) || shows(color, compare) || shows(color, func));
  EXPECT_TRUE(shows(depth, mode));
  EXPECT_FALSE(shows(depth, func));
  EXPECT_TRUE(shows(depth, compare));
  EXPECT_TRUE(shows(depth, [](Scene& s) { s.parameters().compare_func = GL_LESS; }));
}

TEST(TextureSnapshot, WhatIsOnlyForProgramsNeverShows) {
  Scene scene;
  EXPECT_FALSE(shows(scene, [](Scene& s) { s.parameters().priority = 0.0f; }));
  EXPECT_FALSE(shows(scene, [](Scene& s) { s.parameters().generate_mipmap = true; }));
  EXPECT_FALSE(shows(scene, [](Scene& s) { s.state.texture.seamless_enabled = true; }));
  EXPECT_FALSE(shows(scene, [](Scene& s) { s.state.texture.active_unit = 5; }));
  Scene cube(TextureTarget::cube_map);
  EXPECT_TRUE(shows(cube, [](Scene& s) { s.state.texture.seamless_enabled = true; }));
}

TEST(TextureSnapshot, TheEnvironmentColorMattersToThoseThatReadIt) {
  Scene modulate;
  EXPECT_FALSE(shows(modulate, environment_color) || shows(modulate, environment_alpha));
  Scene blend;
  blend.environment().mode = GL_BLEND;
  EXPECT_TRUE(shows(blend, environment_color));
  EXPECT_FALSE(shows(blend, environment_alpha));
  Scene intensity(TextureTarget::two_d, BaseFormat::intensity);
  intensity.environment().mode = GL_BLEND;
  EXPECT_TRUE(shows(intensity, environment_alpha));
  Scene combine;
  combine.environment().mode = GL_COMBINE;
  EXPECT_FALSE(shows(combine, environment_color)) << "MODULATE takes two arguments";
  combine.environment().rgb.function = GL_INTERPOLATE;
  EXPECT_FALSE(shows(combine, environment_color)) << "its alpha is taken";
  combine.environment().rgb.operand[2] = GL_SRC_COLOR;
  combine.environment().color = {};
  EXPECT_TRUE(shows(combine, environment_color));
}

TEST(TextureSnapshot, CombinersAreThoseOfCombine) {
  Scene modulate;
  EXPECT_FALSE(shows(modulate, [](Scene& s) { s.environment().rgb.function = GL_ADD; }));
  Scene combine;
  combine.environment().mode = GL_COMBINE;
  EXPECT_TRUE(shows(combine, [](Scene& s) { s.environment().rgb.function = GL_ADD; }));
  EXPECT_TRUE(shows(combine, [](Scene& s) { s.environment().alpha.scale = 4.0f; }));
  EXPECT_FALSE(shows(combine, [](Scene& s) { s.environment().rgb.source[2] = GL_PRIMARY_COLOR; }));
  EXPECT_TRUE(shows(combine, [](Scene& s) { s.environment().rgb.function = GL_DOT3_RGBA; }));
  EXPECT_FALSE(shows(combine, [](Scene& s) { s.environment().alpha.function = GL_REPLACE; })) << "alpha is the dot product";
}

TEST(TextureSnapshot, AUnitThatReadsAUnitWithoutATextureDoesNothing) {
  Scene scene;
  scene.environment().mode = GL_COMBINE;
  scene.environment().rgb.source[0] = GL_TEXTURE1;
  EXPECT_EQ(scene.snapshot().unit[0].environment.rgb.argument[0].source, pipeline::CombineSource::texture) << "its own";
  scene.environment().rgb.source[0] = GL_TEXTURE3;
  EXPECT_EQ(scene.snapshot().count, 0);
  scene.state.texture.units[3] = scene.state.texture.units[1];
  scene.state.texture.units[3].environment = {};
  EXPECT_EQ(scene.snapshot().count, 2);
}

}  // namespace
}  // namespace gouraud::api
