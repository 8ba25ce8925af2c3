// Triangles whose pixels another method than the default finds: what such a method needs beside the record. They go to
// the tiles one by one, like smooth ones, each with the rasterizer of its method.
#pragma once

#include <cstdint>

#include "pipeline/draw/methods.h"
#include "pipeline/raster/method_shape.h"
#include "pipeline/raster/polygons.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/triangles.h"

namespace gouraud::pipeline {

/// The method's own part of a triangle that has been set up and lives as long as its record; the record's edges become
/// those of the ownership wanted.
MethodTriangle method_triangle(const SetupState& state, const WaitingTriangle& triangle, const Methods& methods, PrimitiveRecord& record);

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
