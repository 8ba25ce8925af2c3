#include "pipeline/texture/mipmaps.h"

#include <gtest/gtest.h>

#include "pipeline/texture/completeness.h"
#include "pipeline/texture/texel_access.h"

namespace gouraud::pipeline {
namespace {

Image make_image(TexelFormat format, BaseFormat base, int width, int height, int depth, int border = 0) {
  Image image;
  image.format = format;
  image.base_format = base;
  image.width = width;
  image.height = height;
  image.depth = depth;
  image.border = border;
  image.texels = allocate_texels(format, width, height, depth);
  return image;
}

void fill(const Image& image, float (*value)(int x, int y, int z)) {
  for (int z = 0; z < image.depth; ++z) {
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const float v = value(x, y, z);
        store_channels(image.format, {v, v, v, v}, texel_address(image, x, y, z));
      }
    }
  }
}

float texel(const Image& image, int x, int y, int z) { return stored_channels(image.format, texel_address(image, x, y, z))[0]; }

TEST(Srgb, BytesSurviveDecodingAndEncoding) {
  for (int i = 0; i < 256; ++i) EXPECT_EQ(encode_srgb(decode_srgb(static_cast<std::uint8_t>(i))), i);
  EXPECT_NEAR(decode_srgb(188), 0.502886, 1e-6);
  EXPECT_EQ(encode_srgb(-1.0f), 0);
  EXPECT_EQ(encode_srgb(2.0f), 255);
}

TEST(Mipmaps, FourBytesAreAveragedAndRoundedToNearest) {
  const Image image = make_image(TexelFormat::rgba8, BaseFormat::rgba, 2, 2, 1);
  const std::array<int, 4> values{10, 11, 11, 11};  // 10.75
  for (int i = 0; i < 4; ++i) {
    const float v = static_cast<float>(values[static_cast<std::size_t>(i)]) / 255.0f;
    store_channels(image.format, {v, v, v, v}, texel_address(image, i % 2, i / 2, 0));
  }
  const Image half = half_size(TextureTarget::two_d, image);
  EXPECT_EQ(half.width, 1);
  EXPECT_EQ(half.height, 1);
  EXPECT_FLOAT_EQ(texel(half, 0, 0, 0), 11.0f / 255.0f);
}

TEST(Mipmaps, EveryFormatKeepsAConstantImage) {
  for (const TexelFormat format : {TexelFormat::r8, TexelFormat::rg8, TexelFormat::rgba8, TexelFormat::r16, TexelFormat::rg16,
                                   TexelFormat::rgba16, TexelFormat::rgba32f, TexelFormat::z16, TexelFormat::z24s8, TexelFormat::z32f}) {
    for (const bool srgb : {false, true}) {
      if (srgb && bytes_per_texel(format) > 1 && format != TexelFormat::rgba8) continue;
      Image image = make_image(format, BaseFormat::rgba, 7, 6, 5);
      image.srgb = srgb;
      fill(image, [](int, int, int) { return 0.2f; });
      const Image half = half_size(TextureTarget::three_d, image);
      for (int i = 0; i < 3 * 3 * 2; ++i) EXPECT_EQ(texel(half, i % 3, i / 3 % 3, i / 9), texel(image, 0, 0, 0));
    }
  }
}

TEST(Mipmaps, OddSizesAreWeightedByArea) {
  const Image image = make_image(TexelFormat::rgba32f, BaseFormat::rgba, 5, 1, 1);
  fill(image, [](int x, int, int) { return static_cast<float>(x * x); });
  const Image half = half_size(TextureTarget::one_d, image);
  ASSERT_EQ(half.width, 2);
  EXPECT_FLOAT_EQ(texel(half, 0, 0, 0), (0.0f + 1.0f + 0.5f * 4.0f) / 2.5f);
  EXPECT_FLOAT_EQ(texel(half, 1, 0, 0), (0.5f * 4.0f + 9.0f + 16.0f) / 2.5f);
}

TEST(Mipmaps, SrgbIsAveragedInLinearLight) {
  Image image = make_image(TexelFormat::rgba8, BaseFormat::rgba, 2, 1, 1);
  image.srgb = true;
  fill(image, [](int x, int, int) { return static_cast<float>(x); });
  const Image half = half_size(TextureTarget::two_d, image);
  const Texel out = stored_channels(half.format, texel_address(half, 0, 0, 0));
  EXPECT_FLOAT_EQ(out[0], 188.0f / 255.0f);
  EXPECT_FLOAT_EQ(out[3], 128.0f / 255.0f);
}

TEST(Mipmaps, BordersAreFilteredAlongThemselves) {
  const Image image = make_image(TexelFormat::rgba32f, BaseFormat::rgba, 6, 6, 1, 1);
  fill(image, [](int x, int y, int) { return static_cast<float>(10 * x + y); });
  const Image half = half_size(TextureTarget::two_d, image);
  ASSERT_EQ(half.width, 4);
  EXPECT_FLOAT_EQ(texel(half, 0, 0, 0), 0.0f);
  EXPECT_FLOAT_EQ(texel(half, 3, 3, 0), 55.0f);
  EXPECT_FLOAT_EQ(texel(half, 0, 1, 0), 1.5f);
  EXPECT_FLOAT_EQ(texel(half, 1, 1, 0), 16.5f);
}

TEST(Mipmaps, AGeneratedTextureIsComplete) {
  for (const TextureTarget target : {TextureTarget::one_d, TextureTarget::two_d, TextureTarget::three_d, TextureTarget::cube_map}) {
    Texture texture;
    texture.target = target;
    texture.faces.resize(target == TextureTarget::cube_map ? 6 : 1);
    const int height = target == TextureTarget::one_d ? 1 : 21, depth = target == TextureTarget::three_d ? 9 : 1;
    for (auto& face : texture.faces) {
      face[1] = make_image(TexelFormat::rg8, BaseFormat::luminance_alpha, 21, height, depth);
      fill(face[1], [](int x, int y, int) { return static_cast<float>(x + y) / 64.0f; });
    }
    generate_mipmaps(texture, 1);
    const auto levels = usable_levels(texture, 1, 1000, true);
    ASSERT_TRUE(levels.has_value());
    EXPECT_EQ(levels->last, 5);
  }
}

TEST(Mipmaps, TiledImagesAreReadFromTheirTiles) {
  Image image;
  image.format = TexelFormat::rgba8;
  image.width = image.height = 96;
  image.depth = 1;
  image.tiles = std::make_shared<TiledBuffer>(96, 96, 4);
  fill(image, [](int x, int y, int) { return static_cast<float>((x / 2 + y / 2) % 256) / 255.0f; });
  const Image half = half_size(TextureTarget::two_d, image);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) EXPECT_FLOAT_EQ(texel(half, x, y, 0), static_cast<float>(x + y) / 255.0f);
  }
}

}  // namespace
}  // namespace gouraud::pipeline
