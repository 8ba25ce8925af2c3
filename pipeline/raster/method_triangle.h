// Triangles whose pixels another method than the default finds: what such a method needs beside the record. They go to
// the tiles one by one, like smooth ones, each with the rasterizer of its method.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/draw/methods.h"
#include "pipeline/raster/polygons.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/raster/setup.h"

namespace gouraud::pipeline {

/// The shape's corners are the window positions as they were before snapping, y up.
struct MethodTriangle : SmoothShape {
  /// Snapped to 1/256 pixel, relative to the centre of pixel (0, 0).
  struct Snapped {
    std::int64_t x = 0, y = 0;
  };
  std::array<Snapped, 3> snapped{};
};

/// The method's own part of a triangle that has been set up; the record's edges become those of the ownership wanted.
MethodTriangle method_triangle(const WaitingTriangle& triangle, const Methods& methods, PrimitiveRecord& record);

inline const MethodTriangle& method_triangle_of(const PrimitiveRecord& record) {
  return static_cast<const MethodTriangle&>(*record.shape);
}

/// The methods' rasterizers: integer edge functions all, so that they find the same pixels as the default.
void rasterize_bounding_box(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);
void rasterize_incrementally(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);

}  // namespace gouraud::pipeline
