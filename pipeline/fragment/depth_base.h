// The integer that a block's depths are counted from.
#pragma once

#include <algorithm>
#include <cmath>

#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// The integer nearest to `base`, the plane's depth at the block's first pixel; not for steep planes. Inside the block no
/// covered lane is more than 14 * 65536 units from `base`: within reach of rounding_magic. So is the nearer limit where a
/// polygon's offset took the plane far out of the range: the integer stays near the limits.
inline double whole_depth(const DepthPlane& plane, double base) {
  constexpr double reach = 1 << 20;
  static_assert(reach >= 14 * 65536);
  return std::nearbyint(std::clamp(base, plane.minimum - reach, plane.maximum + reach));
}

}  // namespace gouraud::pipeline
