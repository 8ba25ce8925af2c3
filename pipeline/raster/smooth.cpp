// Takes shapes, gives the area that they share with pixels.
//
// Corners: an edge that runs up has its left side counted in every pixel beside it, one that runs down takes it away
// again; what is left in a pixel is the area of the shape there. Along an edge the share of the pixel that lies to the
// right of it is a clamped line, whose mean over a stretch has a closed form.
// Discs: chords at the middle of strips, along whichever axis the circle is less steep on.
#include "pipeline/raster/smooth.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/polygons.h"

namespace gouraud::pipeline {
namespace {

using Corner = SmoothShape::Corner;
using Areas = std::array<double, 64>;

double unit_clamped(double value) { return std::min(std::max(value, 0.0), 1.0); }

/// The integral of unit_clamped from 0 on.
double clamped_integral(double u) {
  const double inside = unit_clamped(u);
  return 0.5 * inside * inside + std::max(u - 1.0, 0.0);
}

/// The mean of unit_clamped between u0 and u1.
double mean_clamped(double u0, double u1) {
  constexpr double steep_enough = 1e-5;  // else rounding is larger than what is neglected
  const double span = u1 - u0;
  if (std::abs(span) < steep_enough) return unit_clamped(0.5 * (u0 + u1));
  return (clamped_integral(u1) - clamped_integral(u0)) / span;
}

/// Adds the area to the right of an edge, signed by its direction; positions relative to the block.
void add_edge(Corner from, Corner to, Areas& area) {
  if (from.y == to.y) return;
  const double sign = from.y < to.y ? 1.0 : -1.0;
  if (sign < 0) std::swap(from, to);
  const double slope = (to.x - from.x) / (to.y - from.y);
  const double bottom = std::max(from.y, 0.0), top = std::min(to.y, 8.0);
  if (!(bottom < top)) return;
  const auto x_at = [&](double y) { return from.x + (y - from.y) * slope; };
  for (int row = static_cast<int>(bottom); row < 8 && row < top; ++row) {
    const double y0 = std::max(bottom, static_cast<double>(row)), y1 = std::min(top, row + 1.0);
    const double height = sign * (y1 - y0), x0 = x_at(y0), x1 = x_at(y1);
    for (int column = 0; column < 8; ++column) {
      area[static_cast<std::size_t>(8 * row + column)] += height * mean_clamped(column + 1 - x0, column + 1 - x1);
    }
  }
}

void cover_corners(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  const auto count = static_cast<std::size_t>(shape.corner_count);
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &from = shape.corner[i], &to = shape.corner[i + 1 < count ? i + 1 : 0];
    add_edge({from.x - x, from.y - y}, {to.x - x, to.y - y}, area);
  }
  for (double& a : area) a = std::abs(a);
}

/// The share of the disc around (0, 0) in the unit square whose lower left corner is (x, y).
double disc_in_pixel(double x, double y, double radius) {
  constexpr int strips = 32;
  // Mirror, so that the square lies further up than to the right: strips are then cut where the circle is flat.
  x = std::abs(x + 0.5) - 0.5;
  y = std::abs(y + 0.5) - 0.5;
  if (x > y) std::swap(x, y);
  const double squared = radius * radius, far_x = x + 1.0, far_y = y + 1.0;
  const double near_x = std::max(x, 0.0), near_y = std::max(y, 0.0);
  if (far_x * far_x + far_y * far_y <= squared) return 1.0;
  if (near_x * near_x + near_y * near_y >= squared) return 0.0;
  // Strips of that part of the square's width over which the disc reaches into it.
  const double reach = std::sqrt(squared - near_y * near_y);
  const double left = std::max(x, -reach), width = std::min(far_x, reach) - left;
  double area = 0;
  for (int strip = 0; strip < strips; ++strip) {
    const double at = left + width * ((strip + 0.5) / strips), half_chord = std::sqrt(std::max(squared - at * at, 0.0));
    area += std::max(std::min(far_y, half_chord) - std::max(y, -half_chord), 0.0);
  }
  return area * width / strips;
}

void cover_disc(const SmoothShape& shape, std::int32_t x, std::int32_t y, Areas& area) {
  const Corner& center = shape.corner[0];
  for (std::size_t lane = 0; lane < 64; ++lane) {
    const double left = x + static_cast<double>(lane % 8) - center.x, bottom = y + static_cast<double>(lane / 8) - center.y;
    area[lane] = disc_in_pixel(left, bottom, shape.radius);
  }
}

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

Areas areas_of(const SmoothShape& shape, std::int32_t x, std::int32_t y) {
  Areas area{};
  if (shape.corner_count == 0) {
    cover_disc(shape, x, y, area);
  } else {
    cover_corners(shape, x, y, area);
  }
  return area;
}

/// Calls draw(block) for every block of the tile that the box touches.
template <class Box, class DrawBlock>
void for_each_block(const Box& box, std::int32_t tile_x, std::int32_t tile_y, DrawBlock draw) {
  const std::int32_t column0 = std::max(box.x0 - tile_x, 0) / block_size, row0 = std::max(box.y0 - tile_y, 0) / block_size;
  const std::int32_t column1 = (std::min(box.x1 - tile_x, tile_size) - 1) / block_size;
  const std::int32_t row1 = (std::min(box.y1 - tile_y, tile_size) - 1) / block_size;
  FragmentBlock block;
  for (std::int32_t row = row0; row <= row1; ++row) {
    for (std::int32_t column = column0; column <= column1; ++column) {
      block.x = tile_x + column * block_size;
      block.y = tile_y + row * block_size;
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
  const Areas area = areas_of(shape, x, y);
  std::uint64_t covered = 0;
  for (std::size_t lane = 0; lane < 64; ++lane) {
    coverage[lane] = static_cast<float>(std::min(area[lane], 1.0));
    covered |= static_cast<std::uint64_t>(area[lane] >= least_coverage) << lane;
  }
  return covered;
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
  for_each_block(primitive, tile_x, tile_y, [&](FragmentBlock& block) {
    block.primitive = &primitive;
    block.coverage = cover_block(*primitive.shape, block.x, block.y, block.pixel_coverage) & box_mask(primitive, block.x, block.y);
    if (block.coverage != 0) run_passes(primitive.binding->passes, block, target);
  });
}

void rasterize_smooth(const SmoothPolygon& polygon, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const std::span parts(polygon.part, static_cast<std::size_t>(polygon.part_count));
  for_each_block(polygon, tile_x, tile_y, [&](FragmentBlock& block) {
    SharedBlock shared;
    for (const PrimitiveRecord* part : parts) {
      if (box_mask(*part, block.x, block.y) != 0) shared.add(*part, areas_of(*part->shape, block.x, block.y));
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
