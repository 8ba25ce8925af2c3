// The stencil pass on single blocks, on every instruction set, against the words of the specification: every function,
// operation, reference and mask at random, all stored values, in both places where stencil values lie [GL1.5 §4.1.5].
#include "pipeline/fragment/stencil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

namespace gouraud::pipeline {
namespace {

class Random {
 public:
  std::uint32_t below(std::uint32_t count) {
    state_ = state_ * 1664525u + 1013904223u;
    return (state_ >> 8) % count;
  }
  std::uint64_t bits() { return std::uint64_t{below(1u << 24)} << 48 ^ std::uint64_t{below(1u << 24)} << 24 ^ below(1u << 24); }
  StencilFace face() {
    const auto byte = [this] { return static_cast<std::uint8_t>(below(256)); };
    const auto op = [this] { return static_cast<StencilOp>(below(8)); };
    StencilFace face;
    face.func = static_cast<CompareFunc>(below(8));
    face.reference = byte();
    face.compare_mask = byte();
    face.write_mask = byte();
    face.fail = op();
    face.depth_fail = op();
    face.depth_pass = op();
    return face;
  }

 private:
  std::uint32_t state_ = 5;
};

bool passes(CompareFunc func, int a, int b) {
  const std::array<bool, 8> verdicts{false, a < b, a == b, a <= b, a > b, a != b, a >= b, true};
  return verdicts[static_cast<std::size_t>(func)];
}

int operated(StencilOp op, int stored, const StencilFace& face) {
  const std::array<int, 8> results{stored, 0, face.reference, std::min(stored + 1, 255), std::max(stored - 1, 0), ~stored,
                                   stored + 1, stored - 1};
  const int result = results[static_cast<std::size_t>(op)];
  return (stored & ~face.write_mask & 0xFF) | (result & face.write_mask);
}

std::uint64_t depth_verdicts;
void depth_test(FragmentBlock& block, const TileTarget&) { block.coverage &= depth_verdicts; }

/// 64 pixels through the pass, and what the specification says of each.
void check(Random& random, DepthFormat format, bool with_depth) {
  RasterBinding binding;
  binding.state.stencil = {true, random.face(), random.face()};
  if (with_depth) binding.passes.inner_depth = depth_test;
  PrimitiveRecord primitive;
  primitive.binding = &binding;
  primitive.back = random.below(2) == 0;
  const StencilFace& face = primitive.back ? binding.state.stencil.back : binding.state.stencil.front;

  FragmentBlock block;
  block.primitive = &primitive;
  const std::uint64_t covered = block.coverage = random.below(3) == 0 ? ~std::uint64_t{0} : random.bits();
  depth_verdicts = random.below(4) == 0 ? 0 : random.bits();
  alignas(64) std::array<std::uint32_t, 64> words;
  alignas(64) std::array<std::uint8_t, 64> bytes;
  std::array<int, 64> old;
  for (std::size_t i = 0; i < 64; ++i) {
    old[i] = static_cast<int>(random.below(3) == 0 ? std::uint32_t{face.reference} : random.below(256));
    words[i] = static_cast<std::uint32_t>(old[i]) << 24 | (0x123456u + static_cast<std::uint32_t>(i));
    bytes[i] = static_cast<std::uint8_t>(old[i]);
  }
  const bool apart = format != DepthFormat::z24s8;
  stencil_pass(format)(block, {nullptr, reinterpret_cast<std::byte*>(words.data()),
                               apart ? reinterpret_cast<std::byte*>(bytes.data()) : nullptr});

  for (std::size_t i = 0; i < 64; ++i) {
    const bool alive = (covered >> i & 1) != 0;
    const bool passed = passes(face.func, face.reference & face.compare_mask, old[i] & face.compare_mask);
    const bool deep = !with_depth || (depth_verdicts >> i & 1) != 0;
    const StencilOp op = !passed ? face.fail : deep ? face.depth_pass : face.depth_fail;
    const int expected = alive ? operated(op, old[i], face) : old[i];
    ASSERT_EQ((block.coverage >> i & 1) != 0, alive && passed && deep) << i;
    ASSERT_EQ(apart ? int{bytes[i]} : static_cast<int>(words[i] >> 24), expected) << i;
    ASSERT_EQ(words[i] & 0xFFFFFFu, 0x123456u + i);
  }
}

TEST(Stencil, IsWhatTheSpecificationSays) {
  for (const simd::Target target : {simd::Target::baseline, simd::Target::sse4, simd::Target::avx2, simd::Target::avx512}) {
    if (!simd::target_supported(target)) continue;
    simd::set_target_for_test(target);
    Random random;
    for (int round = 0; round < 5000; ++round) {
      check(random, round % 2 == 0 ? DepthFormat::z24s8 : DepthFormat::z32f, round % 3 != 0);
    }
  }
  simd::set_target_for_test(std::nullopt);
}

}  // namespace
}  // namespace gouraud::pipeline
