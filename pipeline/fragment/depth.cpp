// Takes a block and its primitive's depth plane, gives the block without the fragments that fail [GL1.5 §4.1.6].
//
// Depth is an integer at the block's first pixel plus a small float offset, rounded once: float steps alone could not
// hold 24 bits. Primitives steeper than 65536 units a pixel, slivers mostly, are evaluated in double.
#include "pipeline/fragment/depth.h"

#include <algorithm>
#include <cmath>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/depth.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE double plane_at(const DepthPlane& plane, std::int32_t x, std::int32_t y) {
  return (plane.origin + plane.dx * x) + plane.dy * y;
}

/// Depths of a block in buffer units.
class FixedPointDepth {
 public:
  using Tag = IntTag;
  FixedPointDepth(const DepthPlane& plane, const FragmentBlock& block) : steep_(plane.steep) {
    if (steep_) {
      for (std::int32_t lane = 0; lane < 64; ++lane) {
        const double z = plane_at(plane, block.x + lane % 8, block.y + lane / 8);
        exact_[lane] = static_cast<std::int32_t>(
            std::nearbyint(std::clamp<double>(z, plane.minimum, plane.maximum)));
      }
      return;
    }
    const double base = plane_at(plane, block.x, block.y);
    const double whole = std::nearbyint(base);
    // Inside the block no covered lane is more than 14 * 65536 units from `whole`: within reach of the magic.
    whole_ = static_cast<std::int32_t>(whole) - rounding_bits;
    plane_ = {static_cast<float>(base - whole), static_cast<float>(plane.dx), static_cast<float>(plane.dy)};
    minimum_ = static_cast<float>(plane.minimum - whole);
    maximum_ = static_cast<float>(plane.maximum - whole);
  }
  HWY_INLINE FloatVector pattern(std::size_t offset) const { return pair_pattern(plane_, offset); }
  HWY_INLINE IntVector at(FloatVector pattern, std::size_t pair, std::size_t offset) const {
    const FloatTag d;
    const IntTag di;
    if (steep_) return hn::Load(di, exact_ + pair * pair_lanes + offset);
    const FloatVector part = clamp_lanes(at_pair(plane_, pattern, pair), hn::Set(d, minimum_), hn::Set(d, maximum_));
    return hn::Add(bits_after_adding(rounding_magic, part), hn::Set(di, whole_));
  }

 private:
  bool steep_;
  std::int32_t whole_ = 0;  ///< less rounding_bits
  BlockPlane plane_{};
  float minimum_ = 0, maximum_ = 0;
  alignas(64) std::int32_t exact_[64];
};

/// Depths of a block in [0, 1].
class FloatDepth {
 public:
  using Tag = FloatTag;
  FloatDepth(const DepthPlane& plane, const FragmentBlock& block) {
    for (std::int32_t lane = 0; lane < 64; ++lane) {
      const double z = plane_at(plane, block.x + lane % 8, block.y + lane / 8);
      exact_[lane] = static_cast<float>(std::clamp<double>(z, plane.minimum, plane.maximum));
    }
  }
  HWY_INLINE FloatVector pattern(std::size_t) const { return hn::Zero(FloatTag()); }
  HWY_INLINE FloatVector at(FloatVector, std::size_t pair, std::size_t offset) const {
    return hn::Load(FloatTag(), exact_ + pair * pair_lanes + offset);
  }

 private:
  alignas(64) float exact_[64];
};

/// How depth lies in memory: load and store of one vector of stored values, beside whatever shares their words.
struct Z24S8 {
  using Depth = FixedPointDepth;
  static constexpr std::int32_t depth_bits = 0xFFFFFF;
  using Word = std::int32_t;
  static HWY_INLINE IntVector load(const Word* p) { return hn::Load(IntTag(), p); }
  static HWY_INLINE IntVector depth(IntVector stored) { return hn::And(stored, hn::Set(IntTag(), depth_bits)); }
  static HWY_INLINE IntVector merge(IntVector stored, IntVector z) {
    return hn::Or(hn::AndNot(hn::Set(IntTag(), depth_bits), stored), z);
  }
  static HWY_INLINE void store(IntVector v, Word* p) { hn::Store(v, IntTag(), p); }
};
struct Z16 {
  using Depth = FixedPointDepth;
  using Word = std::uint16_t;
  using Tag16 = hn::Rebind<std::uint16_t, IntTag>;
  static HWY_INLINE IntVector load(const Word* p) { return hn::PromoteTo(IntTag(), hn::Load(Tag16(), p)); }
  static HWY_INLINE IntVector depth(IntVector stored) { return stored; }
  static HWY_INLINE IntVector merge(IntVector, IntVector z) { return z; }
  static HWY_INLINE void store(IntVector v, Word* p) { hn::Store(hn::DemoteTo(Tag16(), v), Tag16(), p); }
};
struct Z32F {
  using Depth = FloatDepth;
  using Word = float;
  static HWY_INLINE FloatVector load(const Word* p) { return hn::Load(FloatTag(), p); }
  static HWY_INLINE FloatVector depth(FloatVector stored) { return stored; }
  static HWY_INLINE FloatVector merge(FloatVector, FloatVector z) { return z; }
  static HWY_INLINE void store(FloatVector v, Word* p) { hn::Store(v, FloatTag(), p); }
};

/// The incoming depth z against the stored one [GL1.5 §4.1.6].
struct Less { template <class V> static HWY_INLINE auto test(V z, V stored) { return hn::Lt(z, stored); } };
struct Lequal { template <class V> static HWY_INLINE auto test(V z, V stored) { return hn::Not(hn::Lt(stored, z)); } };
struct Greater { template <class V> static HWY_INLINE auto test(V z, V stored) { return hn::Gt(z, stored); } };
struct Gequal { template <class V> static HWY_INLINE auto test(V z, V stored) { return hn::Not(hn::Lt(z, stored)); } };
struct Equal { template <class V> static HWY_INLINE auto test(V z, V stored) { return hn::Eq(z, stored); } };
struct Notequal { template <class V> static HWY_INLINE auto test(V z, V stored) { return hn::Ne(z, stored); } };
struct Always { template <class V> static HWY_INLINE auto test(V z, V) { return hn::Eq(z, z); } };

template <class Format, class Func, bool whole_block>
HWY_INLINE std::uint64_t test_block(const FragmentBlock& block, const TileTarget& target) {
  const typename Format::Depth::Tag d;
  const typename Format::Depth depth(block.primitive->depth, block);
  const bool write = block.primitive->binding->state.depth.write_enabled;
  auto* words = reinterpret_cast<typename Format::Word*>(target.depth) + block.first_pixel;
  std::uint64_t passed_all = 0;
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    const FloatVector pattern = depth.pattern(offset);
    for (std::size_t pair = 0; pair < row_pairs; ++pair) {
      const std::size_t first_lane = pair * pair_lanes + offset;
      const std::uint64_t covered = lane_bits(block.coverage, first_lane);
      if (!whole_block && covered == 0) continue;
      const auto z = depth.at(pattern, pair, offset);
      const auto stored = Format::load(words + first_lane);
      auto passed = Func::test(z, Format::depth(stored));
      if constexpr (!whole_block) passed = hn::And(passed, mask_of(d, covered));
      if (write) Format::store(hn::IfThenElse(passed, Format::merge(stored, z), stored), words + first_lane);
      passed_all |= bits_of(d, passed) << first_lane;
    }
  }
  return passed_all;
}

template <class Format, class Func>
void depth_test(FragmentBlock& block, const TileTarget& target) {
  block.coverage = block.coverage == ~std::uint64_t{0} ? test_block<Format, Func, true>(block, target)
                                                       : test_block<Format, Func, false>(block, target);
}

template <class Format>
FragmentPass pass_for(CompareFunc func) {
  switch (func) {
    case CompareFunc::less: return depth_test<Format, Less>;
    case CompareFunc::lequal: return depth_test<Format, Lequal>;
    case CompareFunc::greater: return depth_test<Format, Greater>;
    case CompareFunc::gequal: return depth_test<Format, Gequal>;
    case CompareFunc::equal: return depth_test<Format, Equal>;
    case CompareFunc::notequal: return depth_test<Format, Notequal>;
    case CompareFunc::always:
    case CompareFunc::never: break;
  }
  return depth_test<Format, Always>;
}

FragmentPass select(CompareFunc func, DepthFormat format) {
  switch (format) {
    case DepthFormat::z16: return pass_for<Z16>(func);
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
}  // namespace gouraud::pipeline
#endif
