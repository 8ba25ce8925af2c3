// Takes smooth primitives, gives blocks with what they cover (areas.h) of each pixel.
#include "pipeline/raster/smooth.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/areas.h"
#include "pipeline/raster/polygons.h"

namespace gouraud::pipeline {
namespace {

using Corner = SmoothShape::Corner;

/// Whether a point lies inside: left and bottom edges own theirs.
bool is_inside(const SmoothShape& shape, double x, double y) {
  if (shape.corner_count == 0) {
    const double dx = x - shape.corner[0].x, dy = y - shape.corner[0].y;
    return dx * dx + dy * dy < shape.radius * shape.radius;
  }
  const auto count = static_cast<std::size_t>(shape.corner_count);
  bool left_of_all = true, right_of_all = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &from = shape.corner[i], &to = shape.corner[i + 1 < count ? i + 1 : 0];
    const double dx = to.x - from.x, dy = to.y - from.y, side = dx * (y - from.y) - dy * (x - from.x);
    // Seen along the edge the inside is on the left if the corners run counterclockwise, else on the right.
    left_of_all &= side > 0 || (side == 0 && (dy < 0 || (dy == 0 && dx > 0)));
    right_of_all &= side < 0 || (side == 0 && (dy > 0 || (dy == 0 && dx < 0)));
  }
  return left_of_all || right_of_all;
}

std::uint64_t sample_block(const SmoothShape& shape, std::int32_t x, std::int32_t y, std::array<float, 64>& coverage) {
  std::uint64_t covered = 0;
  for (std::size_t lane = 0; lane < 64; ++lane) {
    covered |= static_cast<std::uint64_t>(is_inside(shape, x + static_cast<double>(lane % 8) + 0.5, y + static_cast<double>(lane / 8) + 0.5)) << lane;
  }
  coverage.fill(shape.fade);
  return covered;
}

/// Calls draw(block) for every block of the tile that the box touches, row by row. `columns(y)` is the stretch outside of
/// which a row of blocks has nothing.
template <class Box, class Columns, class DrawBlock>
void for_each_block(const Box& box, std::int32_t tile_x, std::int32_t tile_y, Columns columns, DrawBlock draw) {
  const std::int32_t x0 = std::max(box.x0 - tile_x, 0), x1 = std::min(box.x1 - tile_x, tile_size) - 1;
  const std::int32_t y0 = std::max(box.y0 - tile_y, 0), y1 = std::min(box.y1 - tile_y, tile_size) - 1;
  FragmentBlock block;
  for (std::int32_t row = y0 / block_size; row <= y1 / block_size; ++row) {
    block.y = tile_y + row * block_size;
    const Stretch stretch = columns(block.y);
    if (!(stretch.x0 - tile_x <= x1 + 1 && stretch.x1 - tile_x >= x0)) continue;
    const auto first = static_cast<std::int32_t>(std::max(stretch.x0 - tile_x, static_cast<double>(x0)));
    const auto last = static_cast<std::int32_t>(std::min(stretch.x1 - tile_x, static_cast<double>(x1)));
    for (std::int32_t column = first / block_size; column <= last / block_size; ++column) {
      block.x = tile_x + column * block_size;
      block.first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
      draw(block);
    }
  }
}

/// What a polygon's triangles cover of 64 pixels, and which of them covers most.
struct SharedBlock {
  Areas sum{}, largest{};
  std::array<const PrimitiveRecord*, 64> owner{};

  void add(const PrimitiveRecord& part, const Areas& area) {
    for (std::size_t lane = 0; lane < 64; ++lane) {
      sum[lane] += area[lane];
      if (area[lane] <= largest[lane]) continue;
      largest[lane] = area[lane];
      owner[lane] = &part;
    }
  }
};

}  // namespace

std::uint64_t cover_block(const SmoothShape& shape, std::int32_t x, std::int32_t y, std::array<float, 64>& coverage) {
  if (shape.sampled) return sample_block(shape, x, y, coverage);
  const BlockPlace place = place_of_block(shape, x, y);
  if (place != BlockPlace::crossed) {
    coverage.fill(place == BlockPlace::inside ? 1.0f : 0.0f);
    return place == BlockPlace::inside ? ~std::uint64_t{0} : 0;
  }
  return shares_of(shape, x, y, coverage);
}

PixelRect box_of(const SmoothShape& shape) {
  double x0 = shape.corner[0].x, y0 = shape.corner[0].y, x1 = x0, y1 = y0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(shape.corner_count); ++i) {
    x0 = std::min(x0, shape.corner[i].x);
    x1 = std::max(x1, shape.corner[i].x);
    y0 = std::min(y0, shape.corner[i].y);
    y1 = std::max(y1, shape.corner[i].y);
  }
  return {static_cast<std::int32_t>(std::floor(x0 - shape.radius)), static_cast<std::int32_t>(std::floor(y0 - shape.radius)),
          static_cast<std::int32_t>(std::ceil(x1 + shape.radius)), static_cast<std::int32_t>(std::ceil(y1 + shape.radius))};
}

void rasterize_smooth(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const auto columns = [&](std::int32_t y) { return stretch_of(*primitive.shape, y); };
  for_each_block(primitive, tile_x, tile_y, columns, [&](FragmentBlock& block) {
    block.primitive = &primitive;
    block.coverage = cover_block(*primitive.shape, block.x, block.y, block.pixel_coverage) & box_mask(primitive, block.x, block.y);
    if (block.coverage != 0) run_passes(primitive.binding->passes, block, target);
  });
}

void rasterize_smooth(const SmoothPolygon& polygon, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const std::span parts(polygon.part, static_cast<std::size_t>(polygon.part_count));
  const auto columns = [&](std::int32_t y) {
    Stretch all = stretch_of(*parts[0]->shape, y);
    for (const PrimitiveRecord* part : parts.subspan(1)) {
      const Stretch stretch = stretch_of(*part->shape, y);
      all = {std::min(all.x0, stretch.x0), std::max(all.x1, stretch.x1)};
    }
    return all;
  };
  for_each_block(polygon, tile_x, tile_y, columns, [&](FragmentBlock& block) {
    SharedBlock shared;
    for (const PrimitiveRecord* part : parts) {
      if (box_mask(*part, block.x, block.y) == 0) continue;
      const BlockPlace place = place_of_block(*part->shape, block.x, block.y);
      if (place == BlockPlace::outside) continue;
      Areas area;
      place == BlockPlace::inside ? area.fill(1.0) : areas_of(*part->shape, block.x, block.y, area);
      shared.add(*part, area);
    }
    for (const PrimitiveRecord* part : parts) {
      block.coverage = 0;
      for (std::size_t lane = 0; lane < 64; ++lane) {
        const bool drawn = shared.owner[lane] == part && shared.sum[lane] >= least_coverage;
        block.coverage |= static_cast<std::uint64_t>(drawn) << lane;
      }
      block.coverage &= box_mask(*part, block.x, block.y);
      if (block.coverage == 0) continue;
      block.primitive = part;
      for (std::size_t lane = 0; lane < 64; ++lane) block.pixel_coverage[lane] = static_cast<float>(std::min(shared.sum[lane], 1.0));
      run_passes(part->binding->passes, block, target);
    }
  });
}

}  // namespace gouraud::pipeline
