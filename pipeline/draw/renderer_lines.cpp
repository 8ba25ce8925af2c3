// Assembled lines and points to the tile bins [GL1.5 §3.3, §3.4].
#include "pipeline/draw/renderer_implementation.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "pipeline/geometry/affine.h"
#include "pipeline/raster/line_methods.h"

namespace gouraud::pipeline {
namespace {

/// Where a line that will be clipped would have begun and ended, for the phase of its stipple.
/// choice: the specification leaves the phase of a clipped line open [GL1.5 §3.4.2]; ours is that of the whole line, as
/// long as both ends lie in front of the eye. (Mesa starts at the border.)
struct LineSpan {
  double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool steep() const { return std::abs(y1 - y0) > std::abs(x1 - x0); }
  static StippleCount rounded(double length) { return static_cast<StippleCount>(std::min(length + 0.5, 1e15)); }
  StippleCount fragments() const { return rounded(steep() ? std::abs(y1 - y0) : std::abs(x1 - x0)); }
  StippleCount fragments_to(const WindowVertex& v) const {
    return std::min(rounded(steep() ? std::abs(v.y_raster - y0) : std::abs(v.x - x0)), fragments());
  }
};

LineSpan unclipped_span(const ViewportState& viewport, const ProcessedVertices& vertices, const AssembledLine& line) {
  std::array<double, 2> x, y;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto clip = [&](std::size_t k) { return static_cast<double>(vertices.position_clip[k][line.vertex[i]]); };
    x[i] = clip(0) / clip(3) * 0.5 * viewport.width_px;
    y[i] = (viewport.upper_left ? clip(1) : -clip(1)) / clip(3) * 0.5 * viewport.height_px;
    if (!(clip(3) > 0) || !std::isfinite(x[i]) || !std::isfinite(y[i])) return {};
    x[i] += viewport.x + 0.5 * viewport.width_px + viewport.sample_shift_x;
    y[i] += viewport.target_height_px - (viewport.y + 0.5 * viewport.height_px) - viewport.sample_shift_y;
  }
  return {x[0], y[0], x[1], y[1]};
}

}  // namespace

void Renderer::Implementation::draw_line(AssembledLine line) {
  const std::int32_t count = vertices.count;
  const unsigned outcodes = vertices.outcode[line.vertex[0]] | vertices.outcode[line.vertex[1]];
  if (outcodes == 0) {
    draw_clipped_line(line);
  } else {
    const AssembledLine whole = line;
    const StippleCount before = stipple_count;
    const LineSpan span = stippled() ? unclipped_span(viewport, vertices, whole) : LineSpan{};
    if (clip_line(line, viewport, clip_attributes, vertices)) {
      if (methods.colors == InterpolationMethod::affine) forget_distances(count, vertices);
      stipple_count += span.fragments_to(vertices.window[line.vertex[0]]);
      draw_clipped_line(line);
    }
    stipple_count = before + span.fragments();
  }
  vertices.count = count;
}

/// A line inside the clip volume.
void Renderer::Implementation::draw_clipped_line(const AssembledLine& line) {
  if (setup->binding->samples_apart) return draw_sampled_line(line);
  if (setup->lines.smooth) return draw_smooth_line(line);
  if (plain_lines && line.depth_offset == 0) {
    WaitingLine waiting;
    const LinePixels found = select_line(*setup, vertices, line, waiting);
    if (found == LinePixels::edges) return bins.add_line(waiting);
    if (found == LinePixels::none) return;
  }
  const std::size_t bytes = record_size(*setup);
  void* memory = bins.allocate(bytes);
  const auto& record = *static_cast<PrimitiveRecord*>(memory);
  pixels.clear();
  if (methods.walks_lines() && setup->lines.width_px == 1.0f && !stippled()) return walk_line_by_method(line, memory);
  switch (setup_line(*setup, vertices, line, stipple_count, memory, pixels)) {
    case LinePixels::none: bins.take_back(bytes); break;
    case LinePixels::edges: bins.add_polygon(record); break;
    case LinePixels::list: bins.add_pixels(record, pixels, setup->scissor); break;
  }
}

/// The record is the default's, the pixels are the method's.
void Renderer::Implementation::walk_line_by_method(const AssembledLine& line, void* memory) {
  if (setup_line(*setup, vertices, line, stipple_count, memory, pixels) == LinePixels::none) return bins.take_back(record_size(*setup));
  const auto position = [&](std::size_t i) {
    const WindowVertex& vertex = vertices.window[line.vertex[i]];
    return Point2{vertex.x, static_cast<double>(setup->target_height_px) - vertex.y_raster};
  };
  pixels.clear();
  walk_line(methods.lines, position(0), position(1), pixels);
  bins.add_pixels(*static_cast<const PrimitiveRecord*>(memory), pixels, setup->scissor);
}

/// Whole, or the stretches of unit rectangles that the stipple keeps [GL1.5 §3.4.2].
/// choice: neighbours make one rectangle, as they do without a stipple.
template <class DrawStretch>
void Renderer::Implementation::draw_stretches(const AssembledLine& line, DrawStretch draw_stretch) {
  const double length = length_of(vertices, line);
  if (!stippled()) return draw_stretch(0.0, length);
  const auto rectangles = static_cast<StippleCount>(std::ceil(length));
  for (StippleCount i = 0; i < rectangles;) {
    StippleCount end = i;
    while (end < rectangles && stipple_keeps(setup->lines, stipple_count + end)) ++end;
    if (end > i) draw_stretch(static_cast<double>(i), std::min(static_cast<double>(end), length));
    i = end + 1;
  }
  stipple_count += rectangles;
}

void Renderer::Implementation::draw_smooth_line(const AssembledLine& line) {
  draw_stretches(line, [&](double begin, double end) {
    auto* shape = new (bins.allocate(sizeof(SmoothShape))) SmoothShape;
    void* memory = bins.allocate(record_size(*setup));
    if (setup_smooth_line(*setup, vertices, line, begin, end, memory, *shape)) {
      bins.add_smooth(*static_cast<PrimitiveRecord*>(memory));
    }
  });
}

/// Into all samples of its pixels at once [GL1.5 §3.4.4].
void Renderer::Implementation::draw_sampled_line(const AssembledLine& line) {
  const std::size_t bytes = record_size(*setup);
  draw_stretches(line, [&](double begin, double end) {
    void* memory = bins.allocate(bytes);
    if (!setup_sampled_line(*setup, vertices, line, begin, end, memory)) return bins.take_back(bytes);
    bins.add_polygon(*static_cast<PrimitiveRecord*>(memory));
  });
}

void Renderer::Implementation::draw_point(const AssembledPoint& point) {
  if (vertices.outcode[point.vertex] != 0) return;
  if (plain_points && point.depth_offset == 0) {
    WaitingPoint waiting;
    if (select_point(*setup, vertices, point, waiting)) bins.add_point(*setup, waiting);
    return;
  }
  const auto& eye = vertices.position_eye;
  const float size_px = derived_point_size(setup->points, eye[0][point.vertex], eye[1][point.vertex], eye[2][point.vertex]);
  auto* shape = has_shape(*setup) ? new (bins.allocate(sizeof(SmoothShape))) SmoothShape : nullptr;
  const std::size_t bytes = record_size(*setup);
  void* memory = bins.allocate(bytes);
  if (!setup_point(*setup, vertices, point, size_px, memory, shape)) return bins.take_back(bytes);
  const auto& record = *static_cast<PrimitiveRecord*>(memory);
  shape != nullptr && !setup->binding->samples_apart ? bins.add_smooth(record) : bins.add_polygon(record);
}

}  // namespace gouraud::pipeline
