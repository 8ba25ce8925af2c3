// What a method needs to know of a triangle beside its record: the data that goes with it to its tiles and passes.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// The shape's corners are the window positions as they were before snapping, y up.
struct MethodTriangle : SmoothShape {
  /// Snapped to 1/256 pixel, relative to the centre of pixel (0, 0).
  struct Snapped {
    std::int64_t x = 0, y = 0;
  };
  std::array<Snapped, 3> snapped{};
  /// The vertices as setup had them, for passes that do without planes: null for a homogeneous triangle.
  std::array<const WindowVertex*, 3> window{};
  std::array<const Rgba*, 3> color{};      ///< in [0, 1]; of a plan that interpolates colours
  std::array<const float*, 3> varyings{};  ///< in the order of the layout
  float color_scale = 1;                   ///< what colours are stored times

  float epsilon = 0;  ///< of coverage=barycentric

  /// Of a homogeneous triangle: linear in the window, `origin` at the centre of pixel (0, 0).
  struct Function {
    double origin = 0, dx = 0, dy = 0;
    bool owns = false;  ///< an edge that samples on it belong to
  };
  std::array<Function, 3> edge{};
  Function behind_near{}, before_far{};  ///< not negative between the two planes

  /// The corners before the division, for rays: window x and y (y up) times w, clip z and w.
  struct RayCorner {
    double x = 0, y = 0, z = 0, w = 1;
  };
  std::array<RayCorner, 3> ray{};
};

/// Of a record whose shape is one.
inline const MethodTriangle& method_triangle_of(const PrimitiveRecord& record) {
  return static_cast<const MethodTriangle&>(*record.shape);
}

/// Null if the primitive has no vertices to interpolate between.
inline const MethodTriangle* vertices_of(const PrimitiveRecord& record) {
  if (record.shape == nullptr || record.shape->smooth) return nullptr;
  const MethodTriangle& triangle = method_triangle_of(record);
  return triangle.window[0] != nullptr ? &triangle : nullptr;
}

}  // namespace gouraud::pipeline
