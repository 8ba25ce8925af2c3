#include "pipeline/texture/completeness.h"

#include <gtest/gtest.h>

namespace gouraud::pipeline {
namespace {

Image image_of(int width, int height, int depth = 1, int border = 0) {
  Image image;
  image.format = TexelFormat::rgba8;
  image.width = width;
  image.height = height;
  image.depth = depth;
  image.border = border;
  return image;
}

Texture mipmap(TextureTarget target, int width, int height, int depth = 1, int border = 0) {
  Texture texture{target, {}};
  texture.faces.resize(target == TextureTarget::cube_map ? 6 : 1);
  for (auto& face : texture.faces) {
    face[0] = image_of(width, height, depth, border);
    for (std::size_t level = 0; !is_last_level(target, face[level]); ++level) {
      const LevelSize size = next_level_size(target, face[level]);
      face[level + 1] = image_of(size.width, size.height, size.depth, border);
    }
  }
  return texture;
}

TEST(Completeness, NothingIsIncomplete) {
  EXPECT_FALSE(usable_levels({}, 0, 1000, false));
  Texture texture{TextureTarget::two_d, {{}}};
  EXPECT_FALSE(usable_levels(texture, 0, 1000, false));
  EXPECT_FALSE(usable_levels(texture, 1000, 1000, true));
}

TEST(Completeness, WithoutMipmapOnlyTheBaseLevelCounts) {
  Texture texture{TextureTarget::two_d, {{}}};
  texture.faces[0][3] = image_of(5, 7);
  EXPECT_EQ(usable_levels(texture, 3, 0, false), (LevelRange{3, 3}));
  EXPECT_FALSE(usable_levels(texture, 3, 1000, true));
  EXPECT_FALSE(usable_levels(texture, 0, 1000, false));
}

TEST(Completeness, MipmapsOfAnySizeEndAtOneTexel) {
  EXPECT_EQ(usable_levels(mipmap(TextureTarget::one_d, 37, 1), 0, 1000, true), (LevelRange{0, 5}));
  EXPECT_EQ(usable_levels(mipmap(TextureTarget::two_d, 37, 300), 0, 1000, true), (LevelRange{0, 8}));
  EXPECT_EQ(usable_levels(mipmap(TextureTarget::two_d, 16384, 1), 0, 1000, true), (LevelRange{0, 14}));
  EXPECT_EQ(usable_levels(mipmap(TextureTarget::three_d, 4, 8, 32), 0, 1000, true), (LevelRange{0, 5}));
  EXPECT_EQ(usable_levels(mipmap(TextureTarget::two_d, 10, 18, 1, 1), 0, 1000, true), (LevelRange{0, 4}));
  EXPECT_EQ(usable_levels(mipmap(TextureTarget::cube_map, 8, 8), 1, 2, true), (LevelRange{1, 2}));
}

TEST(Completeness, OneWrongLevelUpToTheMaximumIsEnough) {
  Texture texture = mipmap(TextureTarget::two_d, 16, 16);
  texture.faces[0][2].width = 5;
  EXPECT_FALSE(usable_levels(texture, 0, 1000, true));
  EXPECT_EQ(usable_levels(texture, 0, 1, true), (LevelRange{0, 1}));
  texture = mipmap(TextureTarget::two_d, 16, 16);
  texture.faces[0][2].base_format = BaseFormat::rgb;
  EXPECT_FALSE(usable_levels(texture, 0, 1000, true));
  EXPECT_FALSE(usable_levels(texture, 3, 2, true)) << "base above maximum";
}

TEST(Completeness, CubeFacesMustAgree) {
  Texture cube = mipmap(TextureTarget::cube_map, 8, 8);
  cube.faces[4][0] = image_of(4, 4);
  EXPECT_FALSE(usable_levels(cube, 0, 1000, false));
  cube = mipmap(TextureTarget::cube_map, 8, 8);
  cube.faces[5][1] = {};
  EXPECT_EQ(usable_levels(cube, 0, 1000, false), (LevelRange{0, 0}));
  EXPECT_FALSE(usable_levels(cube, 0, 1000, true));
  cube = mipmap(TextureTarget::cube_map, 8, 4);
  EXPECT_FALSE(usable_levels(cube, 0, 1000, false)) << "not square";
}

}  // namespace
}  // namespace gouraud::pipeline
