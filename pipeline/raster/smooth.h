// Smooth points, lines and polygons: a tile and a shape to FragmentBlocks with the share of each pixel that the shape
// covers [GL1.5 §3.3.1, §3.4.2, §3.5.3].
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// Finds the pixels of the smooth primitive's box in the tile whose first pixel is (tile_x, tile_y) and sends their
/// blocks through the primitive's passes.
void rasterize_smooth(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);

/// The same of a polygon's triangles: each pixel has one fragment, with what all of them cover of it and the depth and
/// colours of the one that covers most (the first of equals).
void rasterize_smooth(const SmoothPolygon& polygon, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);

/// The area that the shape shares with each of the 64 pixels from (x, y) on; returns which are at least least_coverage.
/// Exact for corners (to within rounding), to within 0.001 for discs. Of sampled shapes: which centres lie inside, with
/// the shape's fade.
std::uint64_t cover_block(const SmoothShape& shape, std::int32_t x, std::int32_t y, std::array<float, 64>& coverage);

/// The pixels that the shape can touch.
PixelRect box_of(const SmoothShape& shape);

}  // namespace gouraud::pipeline
