// The depth test of many blocks at once, for kernels: included inside a kernel file, once per instruction set.
//
// Which row pairs of a block hold pixels is a coin toss that a processor guesses wrong, block after block. So one loop runs over
// the row pairs of all blocks, those that hold pixels and no others: a vector (or two, or four) each.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_DEPTH_PAIRS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_DEPTH_PAIRS_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_DEPTH_PAIRS_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_DEPTH_PAIRS_INL_H_
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "pipeline/fragment/block_depth-inl.h"
#include "pipeline/fragment/depth_formats-inl.h"
#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Depths of a row pair whose first pixel is (x, y), each from the plane in double.
HWY_INLINE void exact_pair(const DepthPlane& plane, double x, double y, std::int32_t* depth) {
  for (std::int32_t lane = 0; lane < static_cast<std::int32_t>(pair_lanes); ++lane) {
    const double z = plane_at(plane, x + lane % 8, y + lane / 8);
    depth[lane] = static_cast<std::int32_t>(std::nearbyint(std::clamp<double>(z, plane.minimum, plane.maximum)));
  }
}

/// Whether a depth test that is all of the early passes writes depth, or rejects hidden fragments and no more.
HWY_INLINE bool writes_early(const RasterBinding& binding) { return binding.state.depth.write_enabled && !binding.passes.rejects_early; }

/// Tests the row pairs of `bits`, in order, and writes the depths of what passes. Of block n, `blocks` tells
///   depth(n), first_pixel(n), coverage(n); steep(n): exact(n, pair, out) gives the depths of a row pair in place of depth(n).
/// `passed` has a word of 16 bits for each row pair, in the order of the bits.
template <class Format, class Func, class Blocks>
HWY_INLINE void test_pairs(const Blocks& blocks, std::uint64_t bits, bool write, std::byte* pixels, std::uint16_t* passed) {
  const IntTag di;
  const FloatTag df;
  auto* const words = reinterpret_cast<typename Format::Word*>(pixels);
  for (std::uint64_t left = bits; left != 0; left &= left - 1) {
    const auto at = static_cast<std::size_t>(__builtin_ctzll(left));
    const std::size_t pair = at % row_pairs, n = at / row_pairs;
    const bool steep = blocks.steep(n);
    alignas(64) std::int32_t exact[pair_lanes];
    if (HWY_UNLIKELY(steep)) blocks.exact(n, pair, exact);
    const BlockDepth& depth = blocks.depth(n);
    const std::uint64_t covered = blocks.coverage(n) >> (pair * pair_lanes);
    auto* const first = words + blocks.first_pixel(n) + pair * pair_lanes;
    // What a step adds for pairs behind the first, and nothing before.
    const float steps[2] = {0.0f, depth.step};
    std::uint64_t found = 0;
    for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(di)) {
      FloatVector part = first_pair(depth.part, offset);
      for (std::size_t p = 0; p + 1 < row_pairs; ++p) part = hn::Add(part, hn::Set(df, steps[pair > p ? 1 : 0]));
      IntVector z = depth_at(depth, part);
      if (HWY_UNLIKELY(steep)) z = hn::Load(di, exact + offset);
      const auto stored = Format::load(first + offset);
      const auto passes = hn::And(Func::test(z, Format::depth(stored)), mask_of(di, lane_bits(covered, offset)));
      if (write) Format::store(hn::IfThenElse(passes, Format::merge(stored, z), stored), first + offset);
      found |= bits_of(di, passes) << offset;
    }
    passed[at] = static_cast<std::uint16_t>(found);
  }
}

/// Road::of<Format, Func>() for this depth test on a buffer of this format; none for formats that have no integer in 24 bits.
template <class Road, class Format>
auto road_of(CompareFunc func) -> decltype(Road::template of<Format, Always>()) {
  switch (func) {
    case CompareFunc::less: return Road::template of<Format, Less>();
    case CompareFunc::lequal: return Road::template of<Format, Lequal>();
    case CompareFunc::greater: return Road::template of<Format, Greater>();
    case CompareFunc::gequal: return Road::template of<Format, Gequal>();
    case CompareFunc::equal: return Road::template of<Format, Equal>();
    case CompareFunc::notequal: return Road::template of<Format, Notequal>();
    case CompareFunc::never: return {};
    case CompareFunc::always: break;
  }
  return Road::template of<Format, Always>();
}
template <class Road>
auto road_for(CompareFunc func, DepthFormat format) -> decltype(road_of<Road, Z16>(func)) {
  switch (format) {
    case DepthFormat::z16: return road_of<Road, Z16>(func);
    case DepthFormat::z24s8: return road_of<Road, Z24S8>(func);
    case DepthFormat::z32:
    case DepthFormat::z32f:
    case DepthFormat::none: break;
  }
  return {};
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
