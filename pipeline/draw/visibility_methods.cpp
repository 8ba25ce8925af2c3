#include "pipeline/draw/visibility_methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <new>
#include <span>

#include "pipeline/raster/tile_pixels.h"

namespace gouraud::pipeline {
namespace {

/// What the rays of a sample may meet: the shape of a record that stands for all of them.
struct RayScene : SmoothShape {
  struct Target {
    const PrimitiveRecord* record = nullptr;
    double sign = 1;  ///< -1: the farther one is seen
  };
  const Target* targets = nullptr;
  std::size_t count = 0;
};

using Vector = std::array<double, 3>;
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector cross(const Vector& a, const Vector& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
double dot(const Vector& a, const Vector& b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

/// The depth at which the ray from the eye through (x, y) meets the triangle; infinity if it does not.
/// In the space of (x w, y w, w) the eye is the origin and a pixel's ray has the direction (x, y, 1): so perspective and orthographic
/// projections are the same to it.
double meet(const MethodTriangle& triangle, double x, double y) {
  constexpr double misses = std::numeric_limits<double>::infinity();
  const auto corner = [&](std::size_t i) { return Vector{triangle.ray[i].x, triangle.ray[i].y, triangle.ray[i].w}; };
  const Vector v0 = corner(0), edge1 = minus(corner(1), v0), edge2 = minus(corner(2), v0), direction{x, y, 1.0};
  const Vector p = cross(direction, edge2);
  const double determinant = dot(edge1, p);
  if (determinant == 0) return misses;
  const Vector to_eye{-v0[0], -v0[1], -v0[2]};
  const double u = dot(to_eye, p) / determinant;
  if (!(u >= 0 && u <= 1)) return misses;
  const Vector q = cross(to_eye, edge1);
  const double v = dot(direction, q) / determinant, distance = dot(edge2, q) / determinant;
  if (!(v >= 0 && u + v <= 1 && distance > 0)) return misses;
  const auto& c = triangle.ray;
  return ((1 - u - v) * c[0].z + u * c[1].z + v * c[2].z) / distance;
}

/// The target that each lane sees: an index, or -1.
void cast_rays(std::span<const RayScene::Target* const> near_by, FragmentBlock& block, std::array<std::int32_t, 64>& seen) {
  seen.fill(-1);
  std::array<double, 64> depth;
  depth.fill(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < near_by.size(); ++i) {
    const PrimitiveRecord& record = *near_by[i]->record;
    for (std::uint64_t left = box_mask(record, block.x, block.y); left != 0; left &= left - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctzll(left));
      const double x = block.x + static_cast<double>(lane % 8) + 0.5, y = block.y + static_cast<double>(lane / 8) + 0.5;
      const double met = meet(method_triangle_of(record), x, y);
      if (!std::isfinite(met) || !(near_by[i]->sign * met <= depth[lane])) continue;
      depth[lane] = near_by[i]->sign * met;
      seen[lane] = static_cast<std::int32_t>(i);
    }
  }
}

void rasterize_scene(const PrimitiveRecord& all, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target) {
  const auto& scene = static_cast<const RayScene&>(*all.shape);
  std::vector<const RayScene::Target*> near_by;
  for (const RayScene::Target& t : std::span(scene.targets, scene.count)) {
    const PrimitiveRecord& r = *t.record;
    if (r.x0 < tile_x + tile_size && r.x1 > tile_x && r.y0 < tile_y + tile_size && r.y1 > tile_y) near_by.push_back(&t);
  }
  FragmentBlock block;
  std::array<std::int32_t, 64> seen;
  for (std::int32_t index = 0; index < blocks_per_tile_row * blocks_per_tile_row; ++index) {
    block.x = tile_x + index % blocks_per_tile_row * block_size;
    block.y = tile_y + index / blocks_per_tile_row * block_size;
    block.first_pixel = index * pixels_per_block;
    cast_rays(near_by, block, seen);
    for (std::size_t lane = 0; lane < 64; ++lane) {
      const std::int32_t first = seen[lane];
      if (first < 0) continue;
      block.coverage = 0;
      for (std::size_t other = lane; other < 64; ++other) {
        if (seen[other] != first) continue;
        block.coverage |= std::uint64_t{1} << other;
        seen[other] = -1;
      }
      block.primitive = near_by[static_cast<std::size_t>(first)]->record;
      run_passes(block.primitive->binding->passes, block, target);
    }
  }
}

}  // namespace

void GatheredTriangles::add(const PrimitiveRecord& record, std::int32_t sample, bool nearest) {
  const MethodTriangle& triangle = method_triangle_of(record);
  double depth = 0;
  for (const MethodTriangle::RayCorner& corner : triangle.ray) depth += corner.z / corner.w / 3;
  if (!std::isfinite(depth)) depth = 0;  // of corners on the plane of the eye
  triangles_.push_back({&record, nearest ? depth : -depth, sample});
}

void GatheredTriangles::give_rays(TileBins& bins, std::size_t first, std::size_t end) {
  // Chunks, since the bins' memory comes in pieces; the nearest of a later chunk is drawn over an earlier one's.
  auto* const record = new (bins.allocate(sizeof(PrimitiveRecord))) PrimitiveRecord;
  auto* const scene = new (bins.allocate(sizeof(RayScene))) RayScene;
  auto* const targets = static_cast<RayScene::Target*>(bins.allocate((end - first) * sizeof(RayScene::Target)));
  *record = *triangles_[first].record;
  record->shape = scene;
  scene->smooth = false;
  scene->rasterize = rasterize_scene;
  scene->targets = targets;
  scene->count = end - first;
  for (std::size_t i = first; i < end; ++i) {
    const PrimitiveRecord& r = *triangles_[i].record;
    const bool nearest = r.binding->state.depth.func == CompareFunc::less || r.binding->state.depth.func == CompareFunc::lequal;
    new (targets + (i - first)) RayScene::Target{&r, nearest ? 1.0 : -1.0};
    record->x0 = std::min(record->x0, r.x0);
    record->y0 = std::min(record->y0, r.y0);
    record->x1 = std::max(record->x1, r.x1);
    record->y1 = std::max(record->y1, r.y1);
  }
  bins.add_smooth(*record);
}

void GatheredTriangles::give_to(TileBins& bins, DepthMethod method) {
  const auto by_depth = [](const Gathered& a, const Gathered& b) { return a.sample != b.sample ? a.sample < b.sample : a.depth > b.depth; };
  std::stable_sort(triangles_.begin(), triangles_.end(), by_depth);
  constexpr std::size_t most_targets = 65536;  // what an allocation of the bins holds
  for (std::size_t i = 0; i < triangles_.size();) {
    bins.select_sample(triangles_[i].sample);
    std::size_t end = i;
    if (method == DepthMethod::painter) {
      bins.add_smooth(*triangles_[end++].record);
    } else {
      while (end < triangles_.size() && triangles_[end].sample == triangles_[i].sample && end - i < most_targets) ++end;
      give_rays(bins, i, end);
    }
    i = end;
  }
  bins.select_sample(0);
  triangles_.clear();
}

}  // namespace gouraud::pipeline
