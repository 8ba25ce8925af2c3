// Takes lines of width 1, gives their pixels by a walk: one pixel a step, and blocks as it meets them. The edges that
// LineCoverage has found say everything, and a walk along them finds the same pixels as an evaluation in every block of the
// line's box; but the box of a line has many blocks, of which the line meets few.
#include "pipeline/raster/lines.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/polygons.h"

namespace gouraud::pipeline {
namespace {

/// Half-open.
struct Range {
  std::int32_t begin, end;
  bool holds(std::int32_t i) const { return i >= begin && i < end; }
};

/// A line in a tile, along the major axis i and across it j: pixel j of step i is the floor of a quotient that goes on by
/// what its remainder overflows, and by -1 each step if the line falls.
struct Walk {
  Range major, minor;
  std::int32_t length, slope;  ///< |slope| <= length < 2^22
  std::int32_t j, remainder;   ///< of the first step
};

/// Which way a step goes, and where a block begins, is a coin toss: masks decide, where a branch would be guessed wrong.
template <bool steep>
std::size_t walk(const Walk& line, BlockMask* blocks) {
  const std::int32_t whole_step = line.slope < 0 ? -1 : 0, part_step = line.slope < 0 ? line.slope + line.length : line.slope;
  std::int32_t j = line.j, remainder = line.remainder, last_block = -1;
  std::uint64_t coverage = 0;
  std::size_t count = 0;
  for (std::int32_t i = line.major.begin; i < line.major.end; ++i) {
    if (line.minor.holds(j)) {
      const std::int32_t x = steep ? j : i, y = steep ? i : j;
      const std::int32_t block = y / block_size * blocks_per_tile_row + x / block_size;
      const std::uint64_t is_new = block != last_block;
      coverage = (coverage & (is_new - 1)) | std::uint64_t{1} << (y % block_size * block_size + x % block_size);
      count += is_new;
      blocks[count - 1] = {coverage, block};
      last_block = block;
    }
    remainder += part_step;
    const std::int32_t over = (line.length - 1 - remainder) >> 31;  // -1 or 0
    j += whole_step - over;
    remainder -= line.length & over;
  }
  return count;
}

}  // namespace

std::size_t walk_line(const PrimitiveRecord& line, std::int32_t tile_x, std::int32_t tile_y, BlockMask* blocks) {
  // The first edge is slope * i - length * j + c >= 0, and with the second it leaves one j for each i:
  // floor((slope * i + c) / length).
  const EdgeFunction& edge = line.edges[0];
  const bool steep = std::abs(edge.a) > std::abs(edge.b);
  const std::int32_t length = steep ? -edge.a : -edge.b, slope = steep ? edge.b : edge.a;
  const auto in_tile = [](std::int32_t begin, std::int32_t end, std::int32_t tile) {
    return Range{std::max(begin - tile, 0), std::min(end - tile, tile_size)};
  };
  const Range columns = in_tile(line.x0, line.x1, tile_x), rows = in_tile(line.y0, line.y1, tile_y);
  const Range major = steep ? rows : columns, minor = steep ? columns : rows;
  const std::int32_t major_tile = steep ? tile_y : tile_x, minor_tile = steep ? tile_x : tile_y;

  const std::int64_t first = std::int64_t{slope} * (major_tile + major.begin) + edge.c - std::int64_t{length} * minor_tile;
  const std::int64_t quotient = first / length - (first % length < 0 ? 1 : 0);
  const Walk start{major, minor, length, slope, static_cast<std::int32_t>(quotient), static_cast<std::int32_t>(first - quotient * length)};
  return steep ? walk<true>(start, blocks) : walk<false>(start, blocks);
}

void rasterize_thin_line(const PrimitiveRecord& line, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  // Only those that are found are written.
  alignas(BlockMask) std::array<std::byte, most_line_blocks * sizeof(BlockMask)> memory;
  auto* const blocks = reinterpret_cast<BlockMask*>(memory.data());
  const std::size_t count = walk_line(line, tile_x, tile_y, blocks);
  FragmentBlock block;
  block.primitive = &line;
  for (std::size_t i = 0; i < count; ++i) {
    block.coverage = blocks[i].coverage;
    block.x = tile_x + blocks[i].block % blocks_per_tile_row * block_size;
    block.y = tile_y + blocks[i].block / blocks_per_tile_row * block_size;
    block.first_pixel = blocks[i].block * pixels_per_block;
    run_passes(line.binding->passes, block, target);
  }
}

}  // namespace gouraud::pipeline
