// How depths lie in the buffer and how they are compared [GL1.5 §4.1.6], for kernels that test them: included inside a
// kernel file, once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_DEPTH_FORMATS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_DEPTH_FORMATS_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_DEPTH_FORMATS_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_DEPTH_FORMATS_INL_H_
#endif

#include <cstdint>

#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE double plane_at(const DepthPlane& plane, double x, double y) {
  return (plane.origin + plane.dx * x) + plane.dy * y;
}

/// How depth lies in memory: load and store of one vector of stored values, beside whatever shares their words.
struct Z24S8 {
  using Tag = IntTag;
  using Depth = std::int32_t;
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
  using Tag = IntTag;
  using Depth = std::int32_t;
  using Word = std::uint16_t;
  using Tag16 = hn::Rebind<std::uint16_t, IntTag>;
  static HWY_INLINE IntVector load(const Word* p) { return hn::PromoteTo(IntTag(), hn::Load(Tag16(), p)); }
  static HWY_INLINE IntVector depth(IntVector stored) { return stored; }
  static HWY_INLINE IntVector merge(IntVector, IntVector z) { return z; }
  static HWY_INLINE void store(IntVector v, Word* p) { hn::Store(hn::DemoteTo(Tag16(), v), Tag16(), p); }
};
/// Less 2^31, so that signed numbers compare as the unsigned ones that are stored.
struct Z32 {
  using Tag = IntTag;
  using Depth = std::int32_t;
  using Word = std::int32_t;
  static HWY_INLINE IntVector flipped(IntVector v) { return hn::Xor(v, hn::Set(IntTag(), INT32_MIN)); }
  static HWY_INLINE IntVector load(const Word* p) { return flipped(hn::Load(IntTag(), p)); }
  static HWY_INLINE IntVector depth(IntVector stored) { return stored; }
  static HWY_INLINE IntVector merge(IntVector, IntVector z) { return z; }
  static HWY_INLINE void store(IntVector v, Word* p) { hn::Store(flipped(v), IntTag(), p); }
};
struct Z32F {
  using Tag = FloatTag;
  using Depth = float;
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

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
