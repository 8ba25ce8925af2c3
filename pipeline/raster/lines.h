// Lines of width 1: a tile and a line's record to FragmentBlocks [GL1.5 §3.4.1].
#pragma once

#include <cstddef>
#include <cstdint>

#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// The blocks of a tile that a line of width 1 meets: it is 64 pixels long at most in there.
inline constexpr std::size_t most_line_blocks = 64;

/// Finds the pixels between the record's first two edges (LineCoverage::edges() of a line of width 1) and in its box, in the
/// tile whose first pixel is (tile_x, tile_y): the same as a PolygonRasterizer, by walking along the line. Writes them to
/// `blocks` and returns how many there are.
std::size_t walk_line(const PrimitiveRecord& line, std::int32_t tile_x, std::int32_t tile_y, BlockMask* blocks);

/// Sends them through the line's passes.
void rasterize_thin_line(const PrimitiveRecord& line, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);

}  // namespace gouraud::pipeline
