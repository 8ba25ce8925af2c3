// The lanes of a block against an edge, for kernels: included inside a kernel file, once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_RASTER_EDGE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_RASTER_EDGE_LANES_INL_H_
#undef GOURAUD_PIPELINE_RASTER_EDGE_LANES_INL_H_
#else
#define GOURAUD_PIPELINE_RASTER_EDGE_LANES_INL_H_
#endif

#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using IntTag = hn::CappedTag<std::int32_t, 16>;
using IntVector = hn::Vec<IntTag>;

alignas(64) constexpr std::int32_t lane_column[16] = {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr std::int32_t lane_row[16] = {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};

/// An edge's values in the lanes of a row pair, relative to lane 0, and from one pair to the next.
HWY_INLINE IntVector edge_pattern(std::int32_t a, std::int32_t b, std::size_t offset) {
  const IntTag d;
  return hn::Add(hn::Mul(hn::Load(d, lane_column + offset), hn::Set(d, a)), hn::Mul(hn::Load(d, lane_row + offset), hn::Set(d, b)));
}

HWY_INLINE std::uint64_t not_negative(IntVector v) {
  const IntTag d;
  std::uint64_t bits = 0;
  hn::StoreMaskBits(d, hn::Gt(v, hn::Set(d, -1)), reinterpret_cast<std::uint8_t*>(&bits));
  return bits;
}

/// Lanes of a block on the inner side of an edge whose value at lane 0 is `value`.
HWY_INLINE std::uint64_t inside(std::int32_t value, std::int32_t a, std::int32_t b) {
  const IntTag d;
  std::uint64_t mask = 0;
  for (std::size_t offset = 0; offset < 16; offset += hn::Lanes(d)) {
    IntVector v = hn::Add(hn::Set(d, value), edge_pattern(a, b, offset));
    for (std::size_t pair = 0; pair < 4; ++pair, v = hn::Add(v, hn::Set(d, 2 * b))) {
      mask |= not_negative(v) << (pair * 16 + offset);
    }
  }
  return mask;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
