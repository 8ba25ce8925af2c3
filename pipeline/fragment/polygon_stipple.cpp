// Takes a block, gives it without the fragments of polygons whose bit in the pattern is 0 [GL1.5 §3.5.2]. A block's row is
// a byte of a pattern's row: blocks begin at multiples of 8, the pattern at multiples of 32.
#include "pipeline/fragment/polygon_stipple.h"

#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {
namespace {

void apply_stipple(FragmentBlock& block, const TileTarget&) {
  if (!block.primitive->is_polygon) return;
  const auto& rows = block.primitive->binding->state.polygon_stipple.rows;
  std::uint64_t mask = 0;
  for (std::int32_t row = 0; row < 8; ++row) {
    const std::uint64_t bits = rows[static_cast<std::size_t>((block.y + row) & 31)] >> (block.x & 31) & 0xFF;
    mask |= bits << (8 * row);
  }
  block.coverage &= mask;
}

}  // namespace

FragmentPass polygon_stipple_pass() { return apply_stipple; }

}  // namespace gouraud::pipeline
