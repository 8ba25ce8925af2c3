// Planes over a triangle or along a line: from values at the vertices to value, d/dx and d/dy, in double.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

struct Point2 {
  double x = 0, y = 0;  ///< window space, y up, in pixels
};

/// Turns differences of a value into its gradient: d/dx = first.x * (v1 - v0) + second.x * (v2 - v0), d/dy likewise.
struct GradientBasis {
  Point2 anchor;  ///< position of vertex 0
  Point2 first, second;
};

struct Plane {
  double origin = 0, dx = 0, dy = 0;
};

/// The plane through value0 at the anchor that rises by `rise1`, `rise2` to the other vertices.
inline Plane make_plane(const GradientBasis& basis, double value0, double rise1, double rise2) {
  const double dx = basis.first.x * rise1 + basis.second.x * rise2;
  const double dy = basis.first.y * rise1 + basis.second.y * rise2;
  return {value0 - (dx * (basis.anchor.x - 0.5) + dy * (basis.anchor.y - 0.5)), dx, dy};
}

/// What setup needs to know of the draw and its target.
struct PlaneTargets {
  double depth_scale = 0;   ///< buffer units for depth 1; 1 for float depth
  bool depth_is_float = false;
  float color_scale = 1;    ///< colours are stored times this
  bool operator==(const PlaneTargets&) const = default;
};

/// A sample inside the snapped primitive is a convex combination of its vertices moved by at most half a sub-pixel a
/// coordinate, so a plane leaves the range of its vertices by at most this share of |dx| + |dy|.
inline constexpr double snap_overshoot = 0.5 / subpixels;

/// Overshoot of a colour, relative to the full range, that rounding to 8 bits forgives.
inline constexpr double harmless_overshoot = 1.0 / 2048.0;

/// Depth planes steeper than this are evaluated in double: float steps would err by more than 1/16 unit in a block.
constexpr double steep_slope(const PlaneTargets& targets) { return targets.depth_is_float ? 0.0 : 65536.0; }

/// A vertex as plane setup sees it; for lines the third vertex repeats the second.
struct ShadedVertex {
  const WindowVertex* window = nullptr;
  Rgba color{};
};

/// Depth plane of a primitive, from its vertices' window depths.
DepthPlane make_depth_plane(const GradientBasis& basis, const std::array<ShadedVertex, 3>& vertices,
                            const PlaneTargets& targets);

/// Colour planes of a primitive. Colours may exceed 1 (a colour sum): fragments are clamped to [0, 1] then.
void make_color_planes(const GradientBasis& basis, const std::array<ShadedVertex, 3>& vertices,
                       const PlaneTargets& targets, ColorRecord& out);

/// Planes of `count` varyings of a triangle or a line, and of 1/w, into the record and behind it; `values[i]` are those of
/// vertex i. What is not finite becomes constant.
void make_varying_planes(const GradientBasis& basis, const std::array<const WindowVertex*, 3>& vertices,
                         const std::array<const float*, 3>& values, std::size_t count, VaryingRecord& out);

/// Varyings that are those of one vertex all over.
void make_constant_varyings(const float* values, std::size_t count, VaryingRecord& out);

/// Planes of a primitive whose colours are those of one vertex all over.
void make_constant_color(Rgba color, const PlaneTargets& targets, ColorRecord& out);

}  // namespace gouraud::pipeline
