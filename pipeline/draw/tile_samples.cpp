// What waits for all samples of a tile's pixels [GL1.5 §3.2.1]: coverage and the early passes for each sample, shading once, the
// late passes for each again (pipeline/raster/sample_blocks.h).
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "pipeline/draw/tiles.h"

namespace gouraud::pipeline {

/// Coverage and the early passes of a group whose depths are set up: lists the blocks that are left.
std::size_t TileBins::find_seen(const TriangleGroup& group, std::int32_t x, std::int32_t y, const SampleTargets& targets,
                                const Rasterizers& rasterize, SampleBlock* seen) {
  const RasterBinding& binding = *group.state->binding;
  std::size_t count = 0;
  for (std::size_t i = 0; i < group.count; ++i) {
    const WaitingTriangle& triangle = *group.triangle[i];
    const std::size_t found = triangle.small()
        ? rasterize.cut_masks(masks_of(triangle, binding, group.vertex_bytes), triangle.x0, triangle.y0, x, y, seen + count)
        : rasterize.sample_blocks(group.record(i), x, y, seen + count);
    for (std::size_t k = count, end = count + found; k < end; ++k) {
      if (!run_early_passes(group.record(i), seen[k], targets)) continue;
      seen[count] = seen[k];
      seen[count++].primitive = static_cast<std::int32_t>(i);
    }
  }
  return count;
}

void TileBins::run_group(TriangleGroup& group, std::int32_t x, std::int32_t y, const SampleTargets& targets, const Rasterizers& rasterize) {
  if (group.count == 0) return;
  std::array<SampleBlock, group_capacity * most_sample_blocks + 3> seen;  // a cutter writes four before it counts
  std::size_t count = 0;
  if (group.all_small) {
    count = group.state->binding->passes.small_triangles.all(group, x, y, targets, seen.data());
  } else {
    set_up_depths(group);
    count = find_seen(group, x, y, targets, rasterize, seen.data());
  }
  std::uint32_t seen_triangles = 0;
  for (const SampleBlock& block : std::span(seen).first(count)) seen_triangles |= 1u << block.primitive;
  if (seen_triangles != 0) set_up_colors(group, seen_triangles);
  for (const SampleBlock& block : std::span(seen).first(count)) {
    run_late_passes(group.record(static_cast<std::size_t>(block.primitive)), block, targets);
  }
  group.count = 0;
}

void TileBins::run_polygon(const PrimitiveRecord& polygon, std::int32_t x, std::int32_t y, const SampleTargets& pixels,
                           SampleBlockFinder find) {
  const SampleTargets targets = place_samples(pixels, *polygon.binding);
  std::array<SampleBlock, most_sample_blocks> found;
  for (SampleBlock& block : std::span(found).first(find(polygon, x, y, found.data()))) {
    if (run_early_passes(polygon, block, targets)) run_late_passes(polygon, block, targets);
  }
}

}  // namespace gouraud::pipeline
