// Samples random textures at random coordinates through every kernel, and compares with the formulas in double.
#include "pipeline/texture/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"
#include "pipeline/texture/mipmaps.h"
#include "pipeline/texture/texel_access.h"

namespace gouraud::pipeline {
namespace {

using Texel64 = std::array<double, 4>;

int dimensions(TextureTarget target) { return target == TextureTarget::one_d ? 1 : target == TextureTarget::three_d ? 3 : 2; }

/// A primitive whose coordinates do not vary (as far as levels of detail go), with one unit.
struct Fixture {
  struct alignas(64) Record {
    PrimitiveRecord primitive;
    VaryingRecord varyings;
    std::array<VaryingPlane, 4> planes;
  };
  Texture texture;
  TextureUnitState state;
  PreparedUnit unit;
  TexturingState texturing;
  TextureUnits units;
  RasterBinding binding;
  Record record;
  FragmentBlock block;
  std::mt19937 random{7};

  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }

  void make_texture(TextureTarget target, TexelFormat format, BaseFormat base, std::array<int, 3> size, int border, bool tiled) {
    texture = {};
    texture.target = target;
    texture.faces.resize(target == TextureTarget::cube_map ? 6 : 1);
    for (auto& face : texture.faces) {
      Image& image = face[0];
      image.format = format;
      image.base_format = base;
      image.border = border;
      image.width = size[0] + 2 * border;
      image.height = size[1] + (dimensions(target) > 1 ? 2 * border : 0);
      image.depth = size[2] + (dimensions(target) > 2 ? 2 * border : 0);
      if (tiled) image.tiles = std::make_shared<TiledBuffer>(image.width, image.height, bytes_per_texel(format));
      else image.texels = allocate_texels(format, image.width, image.height, image.depth);
      for (int z = 0; z < image.depth; ++z) {
        for (int y = 0; y < image.height; ++y) {
          for (int x = 0; x < image.width; ++x) {
            store_channels(format, {between(0, 1), between(0, 1), between(0, 1), between(0, 1)}, texel_address(image, x, y, z));
          }
        }
      }
    }
    state.target = target;
    state.texture = &texture;
  }

  void prepare() {
    texturing.count = 1;
    texturing.unit[0] = state;
    prepare_texture_units(texturing, 1.0f, units);
    const bool three = state.target == TextureTarget::three_d || state.target == TextureTarget::cube_map || state.sampler.compares;
    binding.varyings = {};
    binding.varyings.texture_coordinates[0] = {0, static_cast<std::int8_t>(three ? 3 : dimensions(state.target)), false};
    binding.varyings.count = binding.varyings.texture_coordinates[0].dimensions;
    record = {};
    record.primitive.binding = &binding;
    record.varyings.constant = ~std::uint64_t{0};
    block.primitive = &record.primitive;
    block.x = block.y = 0;
    block.coverage = ~std::uint64_t{0};
  }

  void sample(TexelBlock& out) { units.unit[0].sample(block, units.unit[0], out); }
};

/// Index along an axis, -1 and n for beyond the border [GL1.5 §3.8.7].
double wrapped(WrapMode mode, double s, double n, bool normalized, bool linear) {
  const double scale = normalized ? n : 1.0;
  double u = s * scale;
  switch (mode) {
    case WrapMode::repeat: return (s - std::floor(s)) * scale;
    case WrapMode::clamp: return std::clamp(u, 0.0, n);
    case WrapMode::clamp_to_edge: return std::clamp(u, 0.5, n - 0.5);
    case WrapMode::clamp_to_border: return std::clamp(u, linear ? -0.5 : -0.5, n + 0.5);
    case WrapMode::mirrored_repeat: break;
  }
  const double floor = std::floor(s), fraction = s - floor;
  u = std::fmod(floor, 2.0) == 0 ? fraction : 1 - fraction;
  return std::clamp(u * scale, 0.5, n - 0.5);
}

Texel64 reference(const Fixture& f, int face, std::array<double, 3> s, bool linear, double r) {
  const Image& image = f.texture.faces[static_cast<std::size_t>(face)][0];
  const int count = dimensions(f.state.target), border = image.border;
  const std::array<int, 3> size{image.width - 2 * border, count > 1 ? image.height - 2 * border : 1, count > 2 ? image.depth - 2 * border : 1};
  std::array<int, 3> first{};
  std::array<double, 3> weight{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const WrapMode mode = f.state.sampler.wrap[k];
    const double n = size[k];
    double u = wrapped(mode, s[k], n, f.state.target != TextureTarget::rectangle, linear);
    if (linear) u -= 0.5;
    const double floor = std::floor(u);
    first[k] = static_cast<int>(floor);
    weight[k] = linear ? u - floor : 0;
    if (!linear && u >= n && mode != WrapMode::clamp_to_border) first[k] = size[k] - 1;
  }
  Texel64 sum{};
  for (int corner = 0; corner < (linear ? 1 << count : 1); ++corner) {
    std::array<int, 3> at{};
    double share = 1;
    bool outside = false;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
      const bool second = (corner >> k & 1) != 0;
      at[k] = first[k] + (second ? 1 : 0);
      share *= second ? weight[k] : 1 - weight[k];
      if (f.state.sampler.wrap[k] == WrapMode::repeat) at[k] = (at[k] % size[k] + size[k]) % size[k];
      if (f.state.sampler.wrap[k] == WrapMode::clamp_to_edge || f.state.sampler.wrap[k] == WrapMode::mirrored_repeat) at[k] = std::clamp(at[k], 0, size[k] - 1);
      outside |= at[k] < -border || at[k] >= size[k] + border;
      at[k] += border;
    }
    if (share == 0) continue;
    Texel64 texel{};
    const std::array<float, 4>& b = f.units.unit[0].border;
    if (outside) {
      texel = {b[0], b[1], b[2], b[3]};
    } else {
      const Texel t = expand_channels(image, stored_channels(image.format, texel_address(image, at[0], at[1], at[2])));
      texel = {t[0], t[1], t[2], t[3]};
    }
    if (f.state.sampler.compares) {
      const double depth = texel[0];
      const int func = f.state.sampler.compare_func;
      texel.fill((func & (r < depth ? 1 : r == depth ? 2 : 4)) != 0 ? 1.0 : 0.0);
    }
    for (std::size_t k = 0; k < 4; ++k) sum[k] += share * texel[k];
  }
  return sum;
}

/// Random coordinates that are not on a tie of the nearest filter.
void fill_coordinates(Fixture& f) {
  for (std::size_t lane = 0; lane < 64; ++lane) {
    for (std::size_t k = 0; k < 3; ++k) f.block.varying[k][lane] = f.between(-1.6f, 2.6f);
    if (f.state.target != TextureTarget::rectangle) continue;
    f.block.varying[0][lane] *= static_cast<float>(f.texture.faces[0][0].width);
    f.block.varying[1][lane] *= static_cast<float>(f.texture.faces[0][0].height);
  }
  if (!f.state.sampler.compares) return;
  for (std::size_t lane = 0; lane < 64; ++lane) f.block.varying[2][lane] = f.between(0, 1);
}

void expect_reference(Fixture& f, const std::string& what) {
  f.prepare();
  fill_coordinates(f);
  const bool linear = f.state.sampler.minify == TexelFilter::linear;
  std::array<std::unique_ptr<TexelBlock>, 2> results;
  const auto first = std::make_unique<TexelBlock>();
  f.sample(*first);
  for (std::size_t lane = 0; lane < 64; ++lane) {
    const double r = f.block.varying[2][lane];
    const Texel64 expected = reference(f, 0, {f.block.varying[0][lane], f.block.varying[1][lane], f.block.varying[2][lane]}, linear, r);
    for (std::size_t k = 0; k < 4; ++k) {
      ASSERT_NEAR(first->channel[k][lane], expected[k], 0.05 / 255) << what << " lane " << lane << " channel " << k;
    }
  }
  for (const simd::Target target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    f.prepare();
    TexelBlock other;
    f.sample(other);
    EXPECT_EQ(first->channel, other.channel) << what << " on " << simd::target_name(target);
  }
  simd::set_target_for_test(std::nullopt);
}

constexpr std::array all_wraps{WrapMode::repeat, WrapMode::clamp, WrapMode::clamp_to_edge, WrapMode::clamp_to_border,
                               WrapMode::mirrored_repeat};

struct Kind {
  TexelFormat format;
  BaseFormat base;
};
constexpr std::array all_kinds{
    Kind{TexelFormat::r8, BaseFormat::alpha},       Kind{TexelFormat::r8, BaseFormat::luminance}, Kind{TexelFormat::r8, BaseFormat::intensity},
    Kind{TexelFormat::rg8, BaseFormat::luminance_alpha}, Kind{TexelFormat::rgba8, BaseFormat::rgb}, Kind{TexelFormat::rgba8, BaseFormat::rgba},
    Kind{TexelFormat::r16, BaseFormat::luminance},  Kind{TexelFormat::rg16, BaseFormat::luminance_alpha},
    Kind{TexelFormat::rgba16, BaseFormat::rgba},    Kind{TexelFormat::rgba32f, BaseFormat::rgba}, Kind{TexelFormat::z16, BaseFormat::depth},
    Kind{TexelFormat::z24s8, BaseFormat::depth},    Kind{TexelFormat::z32f, BaseFormat::depth},
    Kind{TexelFormat::rgba8, BaseFormat::alpha},    Kind{TexelFormat::rgba8, BaseFormat::luminance}, Kind{TexelFormat::rgba8, BaseFormat::intensity},
    Kind{TexelFormat::rgba8, BaseFormat::luminance_alpha}, Kind{TexelFormat::rgba16, BaseFormat::alpha},
    Kind{TexelFormat::rgba16, BaseFormat::luminance}, Kind{TexelFormat::rgba16, BaseFormat::luminance_alpha}};

TEST(Sampling, EveryWrapModeFilterAndTarget) {
  auto f = std::make_unique<Fixture>();
  f->state.sampler.border_color = {0.25f, 0.5f, 0.75f, 1.0f};
  for (const TextureTarget target : {TextureTarget::one_d, TextureTarget::two_d, TextureTarget::three_d, TextureTarget::rectangle}) {
    for (const WrapMode wrap : all_wraps) {
      if (target == TextureTarget::rectangle && (wrap == WrapMode::repeat || wrap == WrapMode::mirrored_repeat)) continue;
      for (int variant = 0; variant < 12; ++variant) {
        const bool linear = variant % 2 != 0, tiled = variant / 2 % 2 != 0;
        const int border = tiled ? 0 : variant / 4 % 2;
        if (tiled && dimensions(target) != 2) continue;
        const bool power_of_two = variant >= 6;
        const std::array<int, 3> size = power_of_two ? std::array{16, dimensions(target) > 1 ? 8 : 1, dimensions(target) > 2 ? 4 : 1}
                                                     : std::array{tiled ? 150 : 13, dimensions(target) > 1 ? (tiled ? 70 : 7) : 1, dimensions(target) > 2 ? 5 : 1};
        f->make_texture(target, TexelFormat::rgba8, BaseFormat::rgba, size, border, tiled);
        f->state.sampler.wrap = {wrap, wrap, wrap};
        f->state.sampler.minify = f->state.sampler.magnify = linear ? TexelFilter::linear : TexelFilter::nearest;
        expect_reference(*f, "target " + std::to_string(static_cast<int>(target)) + " wrap " + std::to_string(static_cast<int>(wrap)) +
                                 " variant " + std::to_string(variant));
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(Sampling, EveryFormat) {
  auto f = std::make_unique<Fixture>();
  f->state.sampler.border_color = {0.25f, 0.5f, 0.75f, 1.0f};
  f->state.sampler.wrap = {WrapMode::repeat, WrapMode::clamp, WrapMode::repeat};
  for (const Kind& kind : all_kinds) {
    for (const TextureTarget target : {TextureTarget::one_d, TextureTarget::two_d, TextureTarget::three_d}) {
      for (const bool linear : {false, true}) {
        for (const bool srgb : {false, true}) {
          if (srgb && bytes_per_texel(kind.format) > 1 && kind.format != TexelFormat::rgba8 && kind.format != TexelFormat::rg8) continue;
          if (srgb && (kind.base == BaseFormat::alpha || kind.base == BaseFormat::intensity || kind.base == BaseFormat::depth)) continue;
          const int height = target == TextureTarget::one_d ? 1 : 9, depth = target == TextureTarget::three_d ? 6 : 1;
          f->state.sampler.depth_mode = DepthTextureMode::intensity;
          f->make_texture(target, kind.format, kind.base, {14, height, depth}, 0, false);
          f->texture.faces[0][0].srgb = srgb;
          f->state.sampler.minify = f->state.sampler.magnify = linear ? TexelFilter::linear : TexelFilter::nearest;
          expect_reference(*f, "format " + std::to_string(static_cast<int>(kind.format)) + " base " + std::to_string(static_cast<int>(kind.base)) +
                                   " linear " + std::to_string(linear) + " srgb " + std::to_string(srgb));
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST(Sampling, BordersOfDepthsAreOfTheFirstComponent) {
  auto f = std::make_unique<Fixture>();
  f->state.sampler.border_color = {0.25f, 0.5f, 0.75f, 1.0f};
  f->make_texture(TextureTarget::two_d, TexelFormat::z24s8, BaseFormat::depth, {8, 8, 1}, 0, false);
  const auto border_as = [&](DepthTextureMode mode) {
    f->state.sampler.depth_mode = mode;
    f->prepare();
    return f->units.unit[0].border;
  };
  EXPECT_EQ(border_as(DepthTextureMode::alpha), (std::array{0.0f, 0.0f, 0.0f, 0.25f}));
  EXPECT_EQ(border_as(DepthTextureMode::luminance), (std::array{0.25f, 0.25f, 0.25f, 1.0f}));
  EXPECT_EQ(border_as(DepthTextureMode::intensity), (std::array{0.25f, 0.25f, 0.25f, 0.25f}));
}

TEST(Sampling, EveryComparison) {
  auto f = std::make_unique<Fixture>();
  f->state.sampler.compares = true;
  f->state.sampler.depth_mode = DepthTextureMode::intensity;
  for (const TexelFormat format : {TexelFormat::z16, TexelFormat::z24s8, TexelFormat::z32f}) {
    for (int func = 0; func < 8; ++func) {
      for (const bool linear : {false, true}) {
        f->make_texture(TextureTarget::two_d, format, BaseFormat::depth, {100, 90, 1}, 0, func % 2 != 0);
        f->state.sampler.compare_func = static_cast<std::uint8_t>(func);
        f->state.sampler.minify = f->state.sampler.magnify = linear ? TexelFilter::linear : TexelFilter::nearest;
        expect_reference(*f, "format " + std::to_string(static_cast<int>(format)) + " func " + std::to_string(func));
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(Sampling, SurvivesEveryFloat) {
  auto f = std::make_unique<Fixture>();
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const std::array bad{inf, -inf, nan, 3e38f, -3e38f, 1e-40f, -0.0f, 8388609.0f};
  for (const TextureTarget target : {TextureTarget::one_d, TextureTarget::two_d, TextureTarget::three_d, TextureTarget::cube_map, TextureTarget::rectangle}) {
    for (const WrapMode wrap : all_wraps) {
      for (const bool linear : {false, true}) {
        f->make_texture(target, TexelFormat::rgba8, BaseFormat::rgba, {8, dimensions(target) > 1 ? 8 : 1, dimensions(target) > 2 ? 8 : 1}, 0, false);
        f->state.sampler.seamless = linear;
        f->state.sampler.wrap = {wrap, wrap, wrap};
        f->state.sampler.minify = TexelFilter::linear;
        f->state.sampler.magnify = linear ? TexelFilter::linear : TexelFilter::nearest;
        f->prepare();
        for (std::size_t lane = 0; lane < 64; ++lane) {
          for (std::size_t k = 0; k < 3; ++k) f->block.varying[k][lane] = bad[(lane / (k == 0 ? 1 : k == 1 ? 8 : 3)) % 8];
        }
        TexelBlock out;
        f->sample(out);
        for (std::size_t lane = 0; lane < 64; ++lane) {
          EXPECT_GE(out.channel[0][lane], 0.0f);
          EXPECT_LE(out.channel[0][lane], 1.0f);
        }
      }
    }
  }
}

/// Levels of one colour each: level i of the texture holds i / 8.
void make_level_texture(Fixture& f) {
  f.make_texture(TextureTarget::two_d, TexelFormat::rgba32f, BaseFormat::rgba, {64, 64, 1}, 0, false);
  generate_mipmaps(f.texture, 0);
  for (int level = 0; level < 7; ++level) {
    const Image& image = f.texture.faces[0][static_cast<std::size_t>(level)];
    const float v = static_cast<float>(level) / 8.0f;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) store_channels(image.format, {v, v, v, v}, texel_address(image, x, y, 0));
    }
  }
  f.state.sampler.last_level = 6;
  f.state.sampler.min_lod = -1000;
  f.state.sampler.max_lod = 1000;
  f.state.sampler.minify = f.state.sampler.magnify = TexelFilter::linear;
}

/// A tilted plane: s = (1 + 0.5 x) / q, t = 0.3 y / q, q = 1 - 0.04 x - 0.02 y.
double exact_lod(double x, double y) {
  const double q = 1 - 0.04 * x - 0.02 * y, s = 0.1 + 0.05 * x, t = 0.03 * y;
  const double sx = (0.05 * q + s * 0.04) / (q * q), sy = (s * 0.02) / (q * q), tx = t * 0.04 / (q * q), ty = (0.03 * q + t * 0.02) / (q * q);
  return std::log2(64 * std::sqrt(std::max(sx * sx + tx * tx, sy * sy + ty * ty)));
}

TEST(LevelOfDetail, IsThatOfEachPixel) {
  auto f = std::make_unique<Fixture>();
  make_level_texture(*f);
  for (const MipFilter mip : {MipFilter::nearest, MipFilter::linear}) {
    for (const float bias : {0.0f, 1.3f, -2.0f}) {
      f->state.sampler.mip = mip;
      f->state.sampler.lod_bias = bias;
      f->prepare();
      f->record.varyings = {1, -0.04, -0.02, 0.1f, 1, 0, true, false};
      f->record.planes[0] = {0.1, 0.05, 0, 0, 0, 1};
      f->record.planes[1] = {0, 0, 0.03, 0, 0, 1};
      f->block.x = 3;
      f->block.y = 2;
      for (std::size_t lane = 0; lane < 64; ++lane) {
        const double x = 3 + static_cast<double>(lane % 8), y = 2 + static_cast<double>(lane / 8), q = 1 - 0.04 * x - 0.02 * y;
        f->block.varying[0][lane] = static_cast<float>((0.1 + 0.05 * x) / q);
        f->block.varying[1][lane] = static_cast<float>(0.03 * y / q);
      }
      TexelBlock out;
      f->sample(out);
      for (std::size_t lane = 0; lane < 64; ++lane) {
        const double lod = exact_lod(3 + static_cast<double>(lane % 8), 2 + static_cast<double>(lane / 8)) + static_cast<double>(bias);
        const double expected = std::clamp(mip == MipFilter::nearest ? std::ceil(lod + 0.5) - 1 : lod, 0.0, 6.0) / 8;
        EXPECT_NEAR(out.channel[0][lane], expected, 1e-5) << lane;
      }
    }
  }
}

TEST(CubeMap, DirectionsFindTheirFaces) {
  auto f = std::make_unique<Fixture>();
  f->make_texture(TextureTarget::cube_map, TexelFormat::rgba8, BaseFormat::rgba, {4, 4, 1}, 0, false);
  for (std::size_t face = 0; face < 6; ++face) {
    for (int i = 0; i < 16; ++i) {
      const float v = static_cast<float>(40 * face + static_cast<std::size_t>(i)) / 255.0f;
      store_channels(TexelFormat::rgba8, {v, v, v, v}, texel_address(f->texture.faces[face][0], i % 4, i / 4, 0));
    }
  }
  f->prepare();
  // (r_x, r_y, r_z) and the texel that [GL1.5 Table 3.20] gives.
  struct Case {
    float x, y, z;
    int face, s, t;
  };
  const std::array cases{Case{1, 0.6f, -0.2f, 0, 2, 0},   Case{-1, 0.6f, -0.2f, 1, 1, 0}, Case{0.3f, 1, -0.7f, 2, 2, 0},
                         Case{0.3f, -1, -0.7f, 3, 2, 3},  Case{0.3f, -0.7f, 1, 4, 2, 3},  Case{0.3f, -0.7f, -1, 5, 1, 3}};
  f->block.coverage = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    f->block.coverage |= std::uint64_t{1} << (9 * i);
    const float scale = 0.1f + static_cast<float>(i);
    f->block.varying[0][9 * i] = cases[i].x * scale;
    f->block.varying[1][9 * i] = cases[i].y * scale;
    f->block.varying[2][9 * i] = cases[i].z * scale;
  }
  TexelBlock out;
  f->sample(out);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(std::lround(out.channel[0][9 * i] * 255), 40 * cases[i].face + 4 * cases[i].t + cases[i].s) << i;
  }
}

TEST(CubeMap, SeamsAreContinuous) {
  auto f = std::make_unique<Fixture>();
  f->make_texture(TextureTarget::cube_map, TexelFormat::rgba8, BaseFormat::rgba, {4, 4, 1}, 0, false);
  f->state.sampler.minify = f->state.sampler.magnify = TexelFilter::linear;
  f->state.sampler.wrap = {WrapMode::clamp_to_edge, WrapMode::clamp_to_edge, WrapMode::clamp_to_edge};
  f->state.sampler.seamless = true;
  f->prepare();
  // Pairs of directions on both sides of an edge.
  for (std::size_t lane = 0; lane < 64; ++lane) {
    const std::size_t edge = lane / 2 % 12, a = edge / 4, b = (a + 1) % 3, c = (a + 2) % 3;
    const float tiny = lane % 2 != 0 ? 1e-6f : -1e-6f;
    f->block.varying[a][lane] = (edge & 1) != 0 ? 1 : -1;
    f->block.varying[b][lane] = ((edge & 2) != 0 ? 1.0f : -1.0f) * (1 + tiny);
    f->block.varying[c][lane] = -0.8f + 0.3f * static_cast<float>(lane / 12);
  }
  TexelBlock out;
  f->sample(out);
  for (std::size_t lane = 0; lane < 64; lane += 2) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(out.channel[k][lane], out.channel[k][lane + 1], 1e-3) << lane;
  }
}

}  // namespace
}  // namespace gouraud::pipeline
