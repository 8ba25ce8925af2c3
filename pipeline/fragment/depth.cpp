// Takes a block and its primitive's depth plane, gives the block without the fragments that fail [GL1.5 §4.1.6].
//
// Depth is an integer and a small float offset (block_depth-inl.h). Primitives steeper than 65536 units a pixel, slivers mostly, are evaluated in double.
#include "pipeline/fragment/depth.h"

#include <algorithm>
#include <cmath>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/depth.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/block_depth-inl.h"
#include "pipeline/fragment/depth_formats-inl.h"
#include "pipeline/fragment/image_colors-inl.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Depths of a block in buffer units, row pair by row pair.
class SteppedDepth {
 public:
  HWY_INLINE SteppedDepth(const DepthPlane& plane, const FragmentBlock& block, const TileTarget& target)
      : depth_(depth_of_block(plane, block.x + double{target.sample_x}, block.y + double{target.sample_y})) {}
  HWY_INLINE FloatVector first(std::size_t offset) const { return first_pair(depth_.part, offset); }
  HWY_INLINE FloatVector next(FloatVector part) const { return hn::Add(part, hn::Set(FloatTag(), depth_.step)); }
  HWY_INLINE IntVector at(FloatVector part, std::size_t) const { return depth_at(depth_, part); }

 private:
  BlockDepth depth_;
};

/// Depths of a block, each lane from the plane in double: for steep planes and float buffers; or from an image.
template <class Value, class Tag, bool is_unsigned32 = false>
class ExactDepth {
 public:
  HWY_INLINE ExactDepth(const DepthPlane& plane, const FragmentBlock& block, const TileTarget& target) {
    const PlacedImage* const image = block.primitive->binding->image;
    if (image != nullptr && image->format == PixelImageFormat::depth) {
      for (Value& value : value_) value = 0;
      for_image_pixels(*image, block, [&](std::int32_t lane, const std::byte* pixel) {
        float units;
        std::memcpy(&units, pixel, sizeof units);
        value_[lane] = stored(is_unsigned32 ? static_cast<double>(units) * 0xFFFFFFFF : static_cast<double>(units));
      });
      return;
    }
    for (std::int32_t lane = 0; lane < 64; ++lane) {
      const double x = block.x + lane % 8 + double{target.sample_x}, y = block.y + lane / 8 + double{target.sample_y};
      value_[lane] = stored(std::clamp<double>(plane_at(plane, x, y), plane.minimum, plane.maximum));
    }
  }
  HWY_INLINE FloatVector first(std::size_t) const { return hn::Zero(FloatTag()); }
  HWY_INLINE FloatVector next(FloatVector part) const { return part; }
  HWY_INLINE hn::Vec<Tag> at(FloatVector, std::size_t first_lane) const { return hn::Load(Tag(), value_ + first_lane); }

 private:
  static HWY_INLINE Value stored(double z) {
    if constexpr (is_unsigned32) return static_cast<Value>(std::nearbyint(std::min(z, 4294967295.0)) - 2147483648.0);
    return static_cast<Value>(std::is_integral_v<Value> ? std::nearbyint(z) : z);
  }

  alignas(64) Value value_[64];
};

/// Where a plane is too steep for float steps, or depths come from an image.
template <class Format>
using ExactDepthOf = ExactDepth<typename Format::Depth, typename Format::Tag, std::is_same_v<Format, Z32>>;

template <class Format, class Func, class Depth, bool whole_block>
HWY_INLINE std::uint64_t test_lanes(const FragmentBlock& block, const TileTarget& target) {
  const typename Format::Tag d;
  const Depth depth(block.primitive->depth, block, target);
  const bool write = block.primitive->binding->state.depth.write_enabled && !target.keeps_depth;
  auto* words = reinterpret_cast<typename Format::Word*>(target.depth) + block.first_pixel;
  const PairRange pairs = whole_block ? PairRange{0, row_pairs} : covered_pairs(block.coverage);
  std::uint64_t passed_all = 0;
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    FloatVector part = depth.first(offset);
    for (std::size_t pair = 0; pair < pairs.first; ++pair) part = depth.next(part);
    for (std::size_t pair = pairs.first; pair < pairs.end; ++pair, part = depth.next(part)) {
      const std::size_t first_lane = pair * pair_lanes + offset;
      const std::uint64_t covered = lane_bits(block.coverage, first_lane);
      const auto z = depth.at(part, first_lane);
      const auto stored = Format::load(words + first_lane);
      auto passed = Func::test(z, Format::depth(stored));
      if constexpr (!whole_block) passed = hn::And(passed, mask_of(d, covered));
      if (write) Format::store(hn::IfThenElse(passed, Format::merge(stored, z), stored), words + first_lane);
      passed_all |= bits_of(d, passed) << first_lane;
    }
  }
  return passed_all;
}

template <class Format, class Func, class Depth>
HWY_INLINE std::uint64_t test_block(const FragmentBlock& block, const TileTarget& target) {
  return block.coverage == ~std::uint64_t{0} ? test_lanes<Format, Func, Depth, true>(block, target)
                                             : test_lanes<Format, Func, Depth, false>(block, target);
}

template <class Format, class Func>
void depth_test(FragmentBlock& block, const TileTarget& target) {
  if constexpr (!std::is_same_v<Format, Z32F> && !std::is_same_v<Format, Z32>) {
    if (!block.primitive->depth.steep) {
      block.coverage = test_block<Format, Func, SteppedDepth>(block, target);
      return;
    }
  }
  block.coverage = test_lanes<Format, Func, ExactDepthOf<Format>, false>(block, target);
}

/// `never`: where the stencil buffer learns of it.
void reject_all(FragmentBlock& block, const TileTarget&) { block.coverage = 0; }

template <class Format>
FragmentPass pass_for(CompareFunc func) {
  switch (func) {
    case CompareFunc::less: return depth_test<Format, Less>;
    case CompareFunc::lequal: return depth_test<Format, Lequal>;
    case CompareFunc::greater: return depth_test<Format, Greater>;
    case CompareFunc::gequal: return depth_test<Format, Gequal>;
    case CompareFunc::equal: return depth_test<Format, Equal>;
    case CompareFunc::notequal: return depth_test<Format, Notequal>;
    case CompareFunc::never: return reject_all;
    case CompareFunc::always: break;
  }
  return depth_test<Format, Always>;
}

FragmentPass select(CompareFunc func, DepthFormat format) {
  switch (format) {
    case DepthFormat::z16: return pass_for<Z16>(func);
    case DepthFormat::z32: return pass_for<Z32>(func);
    case DepthFormat::z32f: return pass_for<Z32F>(func);
    case DepthFormat::z24s8:
    case DepthFormat::none: break;
  }
  return pass_for<Z24S8>(func);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass depth_test_pass(CompareFunc func, DepthFormat format) { return GOURAUD_SIMD_PICK(select)(func, format); }

FragmentPass hidden_fragments_pass() {
  return [](FragmentBlock& block, const TileTarget& target) {
    TileTarget kept = target;
    kept.keeps_depth = true;
    block.primitive->binding->passes.inner_depth(block, kept);
  };
}
}  // namespace gouraud::pipeline
#endif
