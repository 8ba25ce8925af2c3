// The depths of a block in units of the buffer, for kernels: included inside a kernel file, once per instruction set.
//
// They are an integer at the block's first pixel plus a small float offset, rounded once: float steps alone could not hold 24 bits.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_BLOCK_DEPTH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_BLOCK_DEPTH_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_BLOCK_DEPTH_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_BLOCK_DEPTH_INL_H_
#endif

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pipeline/fragment/depth_formats-inl.h"
#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

struct BlockDepth {
  BlockPlane part;         ///< base is at the block's first pixel, less the integer
  float step;              ///< from one row pair to the next
  float minimum, maximum;  ///< less the integer
  std::int32_t whole;      ///< less rounding_bits
};

/// Of a plane that is not steep, where depths are taken at (x, y) and whole pixels from there. Inside the block no covered lane
/// is more than 14 * 65536 units from the plane at (x, y): within reach of rounding_magic. So is the nearer limit where a
/// polygon's offset took the plane far out of the range: the integer stays near the limits.
HWY_INLINE BlockDepth depth_of_block(const DepthPlane& plane, double x, double y) {
  constexpr double reach = 1 << 20;
  static_assert(reach >= 14 * 65536);
  const double base = plane_at(plane, x, y);
  const double whole = std::nearbyint(std::clamp(base, plane.minimum - reach, plane.maximum + reach));
  const auto dy = static_cast<float>(plane.dy);
  return {{static_cast<float>(base - whole), static_cast<float>(plane.dx), dy}, 2.0f * dy, static_cast<float>(plane.minimum - whole),
          static_cast<float>(plane.maximum - whole), static_cast<std::int32_t>(whole) - rounding_bits};
}

/// Depths of lanes whose distance from the first pixel is `part`.
HWY_INLINE IntVector depth_at(const BlockDepth& depth, FloatVector part) {
  const FloatTag d;
  const FloatVector clamped = clamp_lanes(part, hn::Set(d, depth.minimum), hn::Set(d, depth.maximum));
  return hn::Add(bits_after_adding(rounding_magic, clamped), hn::Set(IntTag(), depth.whole));
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
