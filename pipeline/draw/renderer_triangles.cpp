// Assembled triangles to the tile bins: clipped, unfilled, smooth, or as they are [GL1.5 §2.12, §3.5].
#include "pipeline/draw/renderer_implementation.h"

#include <algorithm>
#include <new>

#include "pipeline/geometry/affine.h"

namespace gouraud::pipeline {

void Renderer::Implementation::draw_triangle(const AssembledTriangle& triangle) {
  if (smooth_polygons && !triangle.continues) finish_polygons();
  ready.push_back(triangle);
  if (ready.size() == selection_batch) flush_triangles();
}

void Renderer::Implementation::flush_triangles() {
  if (ready.empty()) return;
  if (setup->polygons.smooth) return flush_shapes();
  select_and_add(ready, {});
  ready.clear();
}

void Renderer::Implementation::select_and_add(std::span<const AssembledTriangle> triangles, SharedVertices of_range) {
  while (!triangles.empty()) {
    const auto some = triangles.first(std::min(triangles.size(), selection_batch));
    triangles = triangles.subspan(some.size());
    const std::size_t count = select_triangles(*setup, vertices, some, of_range, selected.data());
    bins.add_triangles(*setup, selected.data(), count, of_range.front != nullptr);
  }
}

/// Vertices that the triangles of a range share, if it pays: two of three corners must be another triangle's too.
SharedVertices Renderer::Implementation::share_vertices(const PrimitiveRange& range) {
  const std::int32_t used = range.indexed ? batch_count : range.count;
  if (!may_share_vertices(*setup) || 2 * assembled.triangles.size() <= static_cast<std::size_t>(used)) return {};
  if (range.indexed && shared.front != nullptr) return shared;
  const std::int32_t first = range.indexed ? 0 : range.first;
  const auto count = static_cast<std::size_t>(used);
  auto* const memory = static_cast<std::byte*>(bins.allocate(shared_vertices_size(*setup, count)));
  const SharedVertices result = keep_vertices(*setup, vertices, static_cast<std::size_t>(first), count, memory);
  if (range.indexed) shared = result;
  return result;
}

/// Those that the clip volume holds wholly go on in stretches. Others have vertices of the clipper's, which are soon
/// overwritten: their parts keep their own.
void Renderer::Implementation::draw_range_of_triangles(const PrimitiveRange& range) {
  const std::span<const AssembledTriangle> triangles = assembled.triangles;
  // Of a polygon that is longer than a batch, the rest is still to come.
  const bool goes_on = range.mode == PrimitiveMode::polygon && !range.ends && (bins.target()->samples == 1 || samples_at_once);
  if (triangles.empty()) return goes_on ? void() : finish_polygons();
  const bool plain = !unfilled && !setup->polygons.smooth;
  const SharedVertices of_range = plain ? share_vertices(range) : SharedVertices{};
  const auto is_inside = [this](const AssembledTriangle& triangle) {
    const auto& outcode = vertices.outcode;
    return (outcode[triangle.vertex[0]] | outcode[triangle.vertex[1]] | outcode[triangle.vertex[2]]) == 0;
  };
  for (std::size_t i = 0; i < triangles.size();) {
    if (!is_inside(triangles[i])) {
      clip_and_draw(triangles[i++]);
      continue;
    }
    const std::size_t first = i++;
    if (!plain) {
      emit(triangles[first]);
      continue;
    }
    while (i < triangles.size() && is_inside(triangles[i])) ++i;
    flush_triangles();
    select_and_add(triangles.subspan(first, i - first), of_range);
  }
  goes_on ? flush_triangles() : finish_polygons();
}

/// A smooth polygon has one fragment in each pixel, whatever triangles it was split into [GL1.5 §3.5.3].
void Renderer::Implementation::set_up_smooth_part(const WaitingTriangle& triangle) {
  auto* memory = static_cast<std::byte*>(bins.allocate(record_size(*setup)));
  set_up_triangle(*setup, triangle, memory);
  auto& record = *reinterpret_cast<PrimitiveRecord*>(memory);
  record.shape = new (bins.allocate(sizeof(SmoothShape))) SmoothShape(smooth_triangle(*setup, triangle));
  record.scissored = true;
  smooth_parts.push_back(&record);
}

/// What comes next belongs to no polygon before it. choice: one that is longer than a batch and drawn for each of several
/// samples (a method against jagged edges) shows the seam where it was cut.
void Renderer::Implementation::finish_polygons() {
  flush_triangles();
  add_smooth_polygon();
}

void Renderer::Implementation::add_smooth_polygon() {
  if (smooth_parts.empty()) return;
  const std::int32_t selected_sample = bins.selected_sample();
  if (samples_at_once) bins.select_sample(TileBins::all_samples);
  const auto count = static_cast<std::int32_t>(smooth_parts.size());
  if (count == 1) {
    bins.add_smooth(*smooth_parts[0]);
  } else {
    auto* const parts = static_cast<const PrimitiveRecord**>(bins.allocate(smooth_parts.size() * sizeof(PrimitiveRecord*)));
    std::ranges::copy(smooth_parts, parts);
    const PrimitiveRecord& first = *parts[0];
    auto& polygon = *new (bins.allocate(sizeof(SmoothPolygon))) SmoothPolygon{parts, count, first.x0, first.y0, first.x1, first.y1};
    for (const PrimitiveRecord* part : smooth_parts) {
      polygon.x0 = std::min(polygon.x0, part->x0);
      polygon.y0 = std::min(polygon.y0, part->y0);
      polygon.x1 = std::max(polygon.x1, part->x1);
      polygon.y1 = std::max(polygon.y1, part->y1);
    }
    bins.add_smooth(polygon);
  }
  bins.select_sample(selected_sample);
  smooth_parts.clear();
}

/// Polygon modes [GL1.5 §3.5.4]: the face decides between filling, the boundary edges and their vertices.
/// choice: edges 2-0, 0-1, 1-2, as Mesa (MESA-RULES 5.5): a polygon's fan then gives the polygon's edges in order.
void Renderer::Implementation::draw_unfilled(const AssembledTriangle& triangle, bool front) {
  if (is_culled(setup->cull, front)) return;
  const PolygonMode mode = front ? mode_front : mode_back;
  if (mode == PolygonMode::fill) return draw_triangle(triangle);
  finish_polygons();
  const bool back = !front;
  const bool offset = mode == PolygonMode::line ? setup->polygons.offset_line : setup->polygons.offset_point;
  const double depth_offset = offset ? pipeline::depth_offset(*setup, vertices, triangle) : 0.0;
  if (!triangle.continues) stipple_count = 0;
  const std::size_t first = mode == PolygonMode::line ? 2 : 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = (first + i) % 3;
    if ((triangle.edges >> k & 1) == 0) continue;
    const std::uint16_t from = triangle.vertex[k], to = triangle.vertex[(k + 1) % 3];
    if (mode == PolygonMode::line) {
      draw_clipped_line({{from, to}, triangle.provoking, back, depth_offset});
    } else {
      draw_point({from, triangle.provoking, back, depth_offset});
    }
  }
}

void Renderer::Implementation::clip_and_draw(const AssembledTriangle& triangle) {
  const auto outcode = [&](std::size_t i) { return vertices.outcode[triangle.vertex[i]]; };
  if ((outcode(0) & outcode(1) & outcode(2)) != 0) return;
  if (methods.leaves_viewport() && draw_unclipped(triangle)) return;
  if (vertices.count + max_clip_vertices > processed_stride) {
    flush_triangles();
    vertices.count = batch_count;
  }
  clipped.clear();
  const std::int32_t first_new = vertices.count;
  clip_triangle(triangle, viewport, clip_attributes, vertices, clipped);
  if (methods.colors == InterpolationMethod::affine) forget_distances(first_new, vertices);
  double area = 0.0;
  for (std::size_t i = 0; unfilled && i < clipped.size(); ++i) area += front_area(*setup, vertices, clipped[i]);
  for (const AssembledTriangle& part : clipped) unfilled ? draw_unfilled(part, area > 0.0) : draw_triangle(part);
}

}  // namespace gouraud::pipeline
