// Triangles whose pixels another method than the default finds: what such a method needs beside the record. They go to
// the tiles one by one, like smooth ones, each with the rasterizer of its method.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/draw/methods.h"
#include "pipeline/raster/polygons.h"
#include "pipeline/raster/primitive.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"

namespace gouraud::pipeline {

/// The shape's corners are the window positions as they were before snapping, y up.
struct MethodTriangle : SmoothShape {
  /// Snapped to 1/256 pixel, relative to the centre of pixel (0, 0).
  struct Snapped {
    std::int64_t x = 0, y = 0;
  };
  std::array<Snapped, 3> snapped{};
  float epsilon = 0;  ///< of coverage=barycentric

  /// Of a homogeneous triangle: linear in the window, `origin` at the centre of pixel (0, 0).
  struct Function {
    double origin = 0, dx = 0, dy = 0;
    bool owns = false;  ///< an edge that samples on it belong to
  };
  std::array<Function, 3> edge{};
  Function z_ndc{};  ///< depth in [z_near, 1] in front of the near and far planes
  double z_near = -1;
};

/// The method's own part of a triangle that has been set up; the record's edges become those of the ownership wanted.
MethodTriangle method_triangle(const SetupState& state, const WaitingTriangle& triangle, const Methods& methods, PrimitiveRecord& record);

inline const MethodTriangle& method_triangle_of(const PrimitiveRecord& record) {
  return static_cast<const MethodTriangle&>(*record.shape);
}

/// The methods' rasterizers. Of integer edge functions: they find the default's pixels.
void rasterize_bounding_box(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);
void rasterize_incrementally(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);
ShapeRasterizer block_rasterizer(CoverageMethod method);
/// Of the corners in float.
void rasterize_scanlines(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);
void rasterize_by_areas(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);
void rasterize_float_edges(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);
void rasterize_float_steps(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);

}  // namespace gouraud::pipeline
