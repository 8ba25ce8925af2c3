// Takes a block and the facing of its primitive, gives the block without the fragments that fail stencil or depth test,
// and the stencil values that follow [GL1.5 §4.1.5].
//
// The depth test runs inside this pass, because the stencil values depend on its outcome even where no fragment is left.
// What to compare and how to update is decided once a block; each of it is a loop over whole vectors.
#include "pipeline/fragment/stencil.h"

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/stencil.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Where the stencil values of a block lie: load and store of one vector of them, beside what shares their words.
struct InDepthWords {
  using Word = std::int32_t;
  static HWY_INLINE Word* words(const TileTarget& target, std::int32_t first_pixel) {
    return reinterpret_cast<Word*>(target.depth) + first_pixel;
  }
  static HWY_INLINE IntVector load(const Word* p) { return hn::Load(IntTag(), p); }
  static HWY_INLINE IntVector stencil(IntVector stored) {
    const hn::RebindToUnsigned<IntTag> u;
    return hn::BitCast(IntTag(), hn::ShiftRight<24>(hn::BitCast(u, stored)));
  }
  static HWY_INLINE IntVector merge(IntVector stored, IntVector stencil) {
    return hn::Or(hn::And(stored, hn::Set(IntTag(), 0xFFFFFF)), hn::ShiftLeft<24>(stencil));
  }
  static HWY_INLINE void store(IntVector v, Word* p) { hn::Store(v, IntTag(), p); }
};
struct Apart {
  using Word = std::uint8_t;
  using ByteTag = hn::Rebind<std::uint8_t, IntTag>;
  static HWY_INLINE Word* words(const TileTarget& target, std::int32_t first_pixel) {
    return reinterpret_cast<Word*>(target.stencil) + first_pixel;
  }
  static HWY_INLINE IntVector load(const Word* p) { return hn::PromoteTo(IntTag(), hn::Load(ByteTag(), p)); }
  static HWY_INLINE IntVector stencil(IntVector stored) { return stored; }
  static HWY_INLINE IntVector merge(IntVector, IntVector stencil) { return stencil; }
  static HWY_INLINE void store(IntVector v, Word* p) { hn::Store(hn::DemoteTo(ByteTag(), v), ByteTag(), p); }
};

/// The reference against the stored value [GL1.5 §4.1.5]; both masked.
struct Less { static HWY_INLINE auto test(IntVector ref, IntVector v) { return hn::Lt(ref, v); } };
struct Lequal { static HWY_INLINE auto test(IntVector ref, IntVector v) { return hn::Not(hn::Gt(ref, v)); } };
struct Greater { static HWY_INLINE auto test(IntVector ref, IntVector v) { return hn::Gt(ref, v); } };
struct Gequal { static HWY_INLINE auto test(IntVector ref, IntVector v) { return hn::Not(hn::Lt(ref, v)); } };
struct Equal { static HWY_INLINE auto test(IntVector ref, IntVector v) { return hn::Eq(ref, v); } };
struct Notequal { static HWY_INLINE auto test(IntVector ref, IntVector v) { return hn::Ne(ref, v); } };

template <class Format, class Func>
HWY_INLINE std::uint64_t compare(const StencilFace& face, const typename Format::Word* words) {
  const IntTag d;
  const IntVector mask = hn::Set(d, face.compare_mask), reference = hn::Set(d, face.reference & face.compare_mask);
  std::uint64_t passed = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const IntVector value = hn::And(Format::stencil(Format::load(words + lane)), mask);
    passed |= bits_of(d, Func::test(reference, value)) << lane;
  }
  return passed;
}

/// The lanes of a block whose stencil value passes.
template <class Format>
HWY_INLINE std::uint64_t passing(const StencilFace& face, const typename Format::Word* words) {
  switch (face.func) {
    case CompareFunc::never: return 0;
    case CompareFunc::less: return compare<Format, Less>(face, words);
    case CompareFunc::lequal: return compare<Format, Lequal>(face, words);
    case CompareFunc::greater: return compare<Format, Greater>(face, words);
    case CompareFunc::gequal: return compare<Format, Gequal>(face, words);
    case CompareFunc::equal: return compare<Format, Equal>(face, words);
    case CompareFunc::notequal: return compare<Format, Notequal>(face, words);
    case CompareFunc::always: break;
  }
  return ~std::uint64_t{0};
}

/// A new stencil value, of which the low 8 bits count, from the stored one and the reference.
struct Zero { static HWY_INLINE IntVector of(IntVector, IntVector) { return hn::Zero(IntTag()); } };
struct Replace { static HWY_INLINE IntVector of(IntVector, IntVector reference) { return reference; } };
struct Increment {
  static HWY_INLINE IntVector of(IntVector v, IntVector) {
    return hn::Min(hn::Add(v, hn::Set(IntTag(), 1)), hn::Set(IntTag(), 0xFF));
  }
};
struct Decrement {
  static HWY_INLINE IntVector of(IntVector v, IntVector) {
    return hn::Max(hn::Sub(v, hn::Set(IntTag(), 1)), hn::Zero(IntTag()));
  }
};
struct Invert { static HWY_INLINE IntVector of(IntVector v, IntVector) { return hn::Not(v); } };
struct IncrementWrap { static HWY_INLINE IntVector of(IntVector v, IntVector) { return hn::Add(v, hn::Set(IntTag(), 1)); } };
struct DecrementWrap { static HWY_INLINE IntVector of(IntVector v, IntVector) { return hn::Sub(v, hn::Set(IntTag(), 1)); } };

template <class Format, class Op>
HWY_INLINE void update_lanes(const StencilFace& face, typename Format::Word* words, std::uint64_t lanes) {
  const IntTag d;
  const IntVector written = hn::Set(d, face.write_mask), reference = hn::Set(d, face.reference);
  const PairRange pairs = covered_pairs(lanes);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(d)) {
    const IntVector stored = Format::load(words + lane), value = Format::stencil(stored);
    const IntVector next = hn::Or(hn::And(Op::of(value, reference), written), hn::AndNot(written, value));
    Format::store(hn::IfThenElse(mask_of(d, lane_bits(lanes, lane)), Format::merge(stored, next), stored), words + lane);
  }
}

template <class Format>
HWY_INLINE void update(StencilOp op, const StencilFace& face, typename Format::Word* words, std::uint64_t lanes) {
  if (lanes == 0) return;
  switch (op) {
    case StencilOp::keep: return;
    case StencilOp::zero: return update_lanes<Format, Zero>(face, words, lanes);
    case StencilOp::replace: return update_lanes<Format, Replace>(face, words, lanes);
    case StencilOp::increment: return update_lanes<Format, Increment>(face, words, lanes);
    case StencilOp::decrement: return update_lanes<Format, Decrement>(face, words, lanes);
    case StencilOp::invert: return update_lanes<Format, Invert>(face, words, lanes);
    case StencilOp::increment_wrap: return update_lanes<Format, IncrementWrap>(face, words, lanes);
    case StencilOp::decrement_wrap: return update_lanes<Format, DecrementWrap>(face, words, lanes);
  }
}

template <class Format>
void stencil(FragmentBlock& block, const TileTarget& target) {
  const RasterBinding& binding = *block.primitive->binding;
  const StencilFace& face = block.primitive->back ? binding.state.stencil.back : binding.state.stencil.front;
  auto* const words = Format::words(target, block.first_pixel);

  const std::uint64_t met = block.coverage, passed = met & passing<Format>(face, words);
  update<Format>(face.fail, face, words, met & ~passed);
  block.coverage = passed;
  if (passed == 0) return;
  if (binding.passes.inner_depth != nullptr) binding.passes.inner_depth(block, target);
  update<Format>(face.depth_fail, face, words, passed & ~block.coverage);
  update<Format>(face.depth_pass, face, words, block.coverage);
}

FragmentPass select(DepthFormat format) {
  return format == DepthFormat::z24s8 ? stencil<InDepthWords> : stencil<Apart>;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
FragmentPass stencil_pass(DepthFormat format) { return GOURAUD_SIMD_PICK(select)(format); }
}  // namespace gouraud::pipeline
#endif
