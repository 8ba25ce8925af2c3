// Blending, logical operation and alpha test of single blocks, on every instruction set: against the formulas, over all
// bytes [GL1.5 §4.1.4, §4.1.8, §4.1.10].
#include "pipeline/fragment/blend.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "pipeline/fragment/alpha.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

using Bytes = std::array<int, 4>;

/// 64 pixels through one pass.
struct BlockRun {
  RasterBinding binding;
  PrimitiveRecord primitive;
  FragmentBlock block;
  alignas(64) std::array<std::array<std::uint8_t, 4>, 64> pixels{};

  explicit BlockRun(const RasterState& state) {
    binding.state = state;
    primitive.binding = &binding;
    block.primitive = &primitive;
    block.coverage = ~std::uint64_t{0};
  }
  void set(std::size_t lane, const Bytes& source, const Bytes& destination) {
    for (std::size_t k = 0; k < 4; ++k) {
      block.color[k][lane] = static_cast<float>(source[k]);
      pixels[lane][k] = static_cast<std::uint8_t>(destination[k]);
    }
  }
  void blend() {
    const TileTarget target{reinterpret_cast<std::byte*>(pixels.data()), nullptr};
    blend_pass(binding.state, ColorFormat::rgba8)(block, target);
  }
};

int product(int a, int b) { return static_cast<int>(std::nearbyint(a * b / 255.0)); }

int factor(BlendFactor f, std::size_t k, const Bytes& s, const Bytes& d, const Bytes& c) {
  const std::array<int, 15> values{0,    255,        s[k], 255 - s[k], d[k], 255 - d[k], s[3], 255 - s[3],
                                   d[3], 255 - d[3], c[k], 255 - c[k], c[3], 255 - c[3], std::min(s[3], 255 - d[3])};
  return values[static_cast<std::size_t>(f)];
}

int expected(const BlendTerms& terms, std::size_t k, const Bytes& s, const Bytes& d, const Bytes& c) {
  const int a = product(s[k], factor(terms.source, k, s, d, c)), b = product(d[k], factor(terms.destination, k, s, d, c));
  const std::array<int, 5> values{std::min(a + b, 255), std::max(a - b, 0), std::max(b - a, 0), std::min(s[k], d[k]),
                                  std::max(s[k], d[k])};
  return values[static_cast<std::size_t>(terms.equation)];
}

class Random {
 public:
  int below(int count) {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<int>((state_ >> 8) % static_cast<std::uint32_t>(count));
  }
  Bytes color() { return {below(256), below(256), below(256), below(256)}; }

 private:
  std::uint32_t state_ = 1;
};

template <class Test>
void on_every_target(const Test& test) {
  for (const simd::Target target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    SCOPED_TRACE(simd::target_name(target));
    test();
  }
  simd::set_target_for_test(std::nullopt);
}

TEST(Blending, ProductsOfAllBytesAreRoundedExactly) {
  on_every_target([] {
    RasterState state;
    state.blend = {true, {BlendEquation::add, BlendFactor::source_alpha, BlendFactor::zero},
                   {BlendEquation::add, BlendFactor::source_alpha, BlendFactor::zero}, {}};
    for (int a = 0; a < 256; ++a) {
      for (int first = 0; first < 256; first += 64) {
        BlockRun run(state);
        for (int i = 0; i < 64; ++i) run.set(static_cast<std::size_t>(i), {first + i, 255 - first - i, 0, a}, {});
        run.blend();
        for (int i = 0; i < 64; ++i) {
          const auto& pixel = run.pixels[static_cast<std::size_t>(i)];
          ASSERT_EQ(pixel[0], product(first + i, a));
          ASSERT_EQ(pixel[1], product(255 - first - i, a));
          ASSERT_EQ(pixel[3], product(a, a));
        }
      }
    }
  });
}

TEST(Blending, OfEveryEquationAndFactorIsTheFormula) {
  on_every_target([] {
    Random random;
    for (int round = 0; round < 5 * 15 * 15 * 2; ++round) {
      const auto equation = static_cast<BlendEquation>(round % 5);
      const auto source = static_cast<BlendFactor>(round / 5 % 15), destination = static_cast<BlendFactor>(round / 75 % 15);
      RasterState state;
      state.blend.enabled = true;
      state.blend.rgb = {equation, source, destination};
      // Alpha's terms never hold saturation (BlendState).
      state.blend.alpha = round % 2 == 0 && source != BlendFactor::source_alpha_saturate &&
                                  destination != BlendFactor::source_alpha_saturate
                              ? state.blend.rgb
                              : BlendTerms{static_cast<BlendEquation>(random.below(5)),
                                           static_cast<BlendFactor>(random.below(14)),
                                           static_cast<BlendFactor>(random.below(14))};
      state.color_write_mask = static_cast<std::uint8_t>(round % 3 == 0 ? 15 : 1 + random.below(15));
      const Bytes constant = random.color();
      for (std::size_t k = 0; k < 4; ++k) {
        state.blend.constant[static_cast<int>(k)] = static_cast<float>(constant[k]) / 255.0f;
      }
      BlockRun run(state);
      std::array<Bytes, 64> s, d;
      for (std::size_t lane = 0; lane < 64; ++lane) run.set(lane, s[lane] = random.color(), d[lane] = random.color());
      run.block.coverage = 0xFFFF'0F0F'FFFF'1234u;
      run.blend();
      for (std::size_t lane = 0; lane < 64; ++lane) {
        for (std::size_t k = 0; k < 4; ++k) {
          const bool written = (run.block.coverage >> lane & 1) != 0 && (state.color_write_mask >> k & 1) != 0;
          const BlendTerms& terms = k == 3 ? state.blend.alpha : state.blend.rgb;
          ASSERT_EQ(run.pixels[lane][k], written ? expected(terms, k, s[lane], d[lane], constant) : d[lane][k])
              << "round " << round << ", lane " << lane << ", channel " << k;
        }
      }
    }
  });
}

TEST(Blending, QuantizesTheSourceFirst) {
  RasterState state;
  state.blend = {true, {BlendEquation::add, BlendFactor::one, BlendFactor::one},
                 {BlendEquation::add, BlendFactor::one, BlendFactor::one}, {}};
  BlockRun run(state);
  for (std::size_t lane = 0; lane < 64; ++lane) {
    run.set(lane, {}, {10, 10, 10, 10});
    run.block.color[0][lane] = 0.5f;
    run.block.color[1][lane] = 1.5f;
    run.block.color[2][lane] = 1.49f;
  }
  run.blend();
  EXPECT_EQ(run.pixels[63], (std::array<std::uint8_t, 4>{10, 12, 11, 10}));
}

TEST(Blending, OfWiderTargetsIsTheFormulaInTheirPrecision) {
  RasterState state;
  const BlendTerms over{BlendEquation::add, BlendFactor::source_alpha, BlendFactor::one_minus_source_alpha};
  state.blend = {true, over, {BlendEquation::reverse_subtract, BlendFactor::one, BlendFactor::one}, {}};
  BlockRun run(state);
  run.block.coverage = 1;
  for (std::size_t k = 0; k < 4; ++k) run.block.color[k][0] = k == 3 ? 16384.4f : 65535.0f;
  std::array<std::uint16_t, 4> words{0, 1000, 65535, 20000};
  blend_pass(state, ColorFormat::rgba16)(run.block, {reinterpret_cast<std::byte*>(words.data()), nullptr});
  // 16384 + round(1000 * (65535 - 16384) / 65535) = 16384 + 750.
  EXPECT_EQ(words, (std::array<std::uint16_t, 4>{16384, 17134, 65535, 3616}));

  for (std::size_t k = 0; k < 4; ++k) run.block.color[k][0] = k == 3 ? 0.25f : 0.5f;
  std::array<float, 4> floats{0.0f, 1.0f, 0.5f, 0.125f};
  blend_pass(state, ColorFormat::rgba32f)(run.block, {reinterpret_cast<std::byte*>(floats.data()), nullptr});
  EXPECT_EQ(floats, (std::array<float, 4>{0.125f, 0.875f, 0.5f, 0.0f}));

  state.logic_op = LogicOp::xor_;
  run.binding.state = state;
  for (std::size_t k = 0; k < 4; ++k) run.block.color[k][0] = 65535.0f;
  words = {0, 0xF0F0, 0xFFFF, 0x1234};
  blend_pass(state, ColorFormat::rgba16)(run.block, {reinterpret_cast<std::byte*>(words.data()), nullptr});
  EXPECT_EQ(words, (std::array<std::uint16_t, 4>{0xFFFF, 0x0F0F, 0, 0xEDCB}));
}

TEST(LogicOp, OfEveryKindIsTheTable) {
  // [GL1.5 Table 4.2]: the result for the bits (s, d) = (1, 1), (1, 0), (0, 1), (0, 0), from the lowest.
  constexpr std::array<int, 16> truth{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  on_every_target([&] {
    Random random;
    for (std::size_t op = 0; op < 16; ++op) {
      RasterState state;
      state.logic_op = static_cast<LogicOp>(op);
      state.color_write_mask = static_cast<std::uint8_t>(op % 2 == 0 ? 15 : 11);
      BlockRun run(state);
      std::array<Bytes, 64> s, d;
      for (std::size_t lane = 0; lane < 64; ++lane) run.set(lane, s[lane] = random.color(), d[lane] = random.color());
      run.blend();
      for (std::size_t lane = 0; lane < 64; ++lane) {
        for (std::size_t k = 0; k < 4; ++k) {
          int result = 0;
          for (int bit = 0; bit < 8; ++bit) {
            const int source = s[lane][k] >> bit & 1, destination = d[lane][k] >> bit & 1;
            result |= (truth[op] >> (3 - 2 * source - destination) & 1) << bit;
          }
          const bool written = (state.color_write_mask >> k & 1) != 0;
          ASSERT_EQ(run.pixels[lane][k], written ? result : d[lane][k]) << "operation " << op;
        }
      }
    }
  });
}

TEST(AlphaTest, OfEveryFunctionComparesRoundedBytes) {
  on_every_target([] {
    for (int func = 1; func < 7; ++func) {
      for (const int reference : {0, 1, 127, 128, 255}) {
        for (int first = 0; first < 256; first += 64) {
          RasterState state;
          state.alpha_test = {true, static_cast<CompareFunc>(func), (static_cast<float>(reference) + 0.3f) / 255.0f};
          if (reference == 255) state.alpha_test.reference = 1.0f;
          BlockRun run(state);
          for (int i = 0; i < 64; ++i) run.block.color[3][static_cast<std::size_t>(i)] = static_cast<float>(first + i) - 0.4f;
          alpha_test_pass(ColorFormat::rgba8)(run.block, {});
          for (int i = 0; i < 64; ++i) {
            const int alpha = first + i;
            const std::array<bool, 8> passes{false,              alpha < reference,  alpha == reference, alpha <= reference,
                                             alpha > reference,  alpha != reference, alpha >= reference, true};
            ASSERT_EQ((run.block.coverage >> i & 1) != 0, passes[static_cast<std::size_t>(func)])
                << "function " << func << ", alpha " << alpha << ", reference " << reference;
          }
        }
      }
    }
  });
}

}  // namespace
}  // namespace gouraud::pipeline
