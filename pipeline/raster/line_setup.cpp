// Lines and points to records [GL1.5 §3.3, §3.4]: where they cover pixels (line_coverage.h, a box, a smooth shape, a
// rectangle of samples), and how depth and colour vary along a line. Points are the same all over.
#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

#include "pipeline/raster/rectangle_edges.h"
#include "pipeline/raster/setup.h"
#include "pipeline/raster/smooth.h"

namespace gouraud::pipeline {
namespace {

std::int64_t snap(float coordinate) { return std::lrintf((coordinate - 0.5f) * subpixels); }

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PrimitiveRecord& new_record(const SetupState& state, void* memory, bool back = false) {
  auto& record = state.colors ? (new (memory) ColoredPrimitive)->record : *new (memory) PrimitiveRecord;
  record.binding = state.binding;
  record.back = back;
  return record;
}

/// Moves all depths, as far as there are depths. What lies beyond the ends of a line is extrapolated.
void offset_depth(double offset, const PlaneTargets& targets, DepthPlane& depth) {
  depth.origin += offset;
  depth.minimum = 0;
  depth.maximum = static_cast<float>(targets.depth_scale);
}

std::size_t varying_count(const SetupState& state) { return static_cast<std::size_t>(state.binding->varyings.count); }

std::byte* varying_memory(const SetupState& state, void* memory) {
  return static_cast<std::byte*>(memory) + (state.colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord));
}
VaryingRecord& varying_record(const SetupState& state, void* memory) { return *new (varying_memory(state, memory)) VaryingRecord; }

/// Gives the record its box. False if that is empty.
bool set_box(const SetupState& state, const PixelRect& box, PrimitiveRecord& record) {
  const PixelRect cut = intersection(box, state.scissor);
  record.x0 = cut.x0;
  record.y0 = cut.y0;
  record.x1 = cut.x1;
  record.y1 = cut.y1;
  record.scissored = true;
  return !cut.empty();
}

/// What varies along a line varies by t = (p - p0) . d / |d|^2 [GL1.5 §3.4.1 eq 3.3].
GradientBasis basis_of_line(const SetupState& state, const WindowVertex& v0, const WindowVertex& v1) {
  const double height = state.target_height_px;
  const Point2 p0{v0.x, height - v0.y_raster}, p1{v1.x, height - v1.y_raster};
  const double dx = p1.x - p0.x, dy = p1.y - p0.y, squared = dx * dx + dy * dy;
  const double scale = squared > 0 ? 1.0 / squared : 0.0;
  return {p0, {dx * scale, dy * scale}, {0, 0}};
}

/// A line's depth and colour.
PrimitiveRecord& write_line_record(const SetupState& state, const WindowVertex& v0, const WindowVertex& v1,
                                   const std::array<Rgba, 2>& colors, double depth_offset, void* memory) {
  PrimitiveRecord& record = new_record(state, memory);
  const GradientBasis basis = basis_of_line(state, v0, v1);
  std::array<ShadedVertex, 3> shaded{ShadedVertex{&v0, {}}, ShadedVertex{&v1, {}}, ShadedVertex{&v1, {}}};
  record.depth = make_depth_plane(basis, shaded, state.targets);
  offset_depth(depth_offset, state.targets, record.depth);
  if (!state.colors) return record;

  ColorRecord& color = reinterpret_cast<ColoredPrimitive*>(memory)->color;
  shaded[0].color = colors[0];
  shaded[1].color = shaded[2].color = colors[1];
  make_color_planes(basis, shaded, state.targets, color);
  // Beyond an end a line is extrapolated too, up to what a color can be; in perspective only up to the ends' colors,
  // because 1/w may pass zero there. So it is where a pixel's centre stands for samples that lie before the end.
  color.clamp = color.variation != ColorVariation::constant;
  if (color.variation == ColorVariation::affine && !state.binding->samples_apart) {
    color.minimum.fill(0.0f);
    color.maximum.fill(state.targets.color_scale);
  }
  return record;
}

std::array<Rgba, 2> colors_of_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line) {
  if (!state.colors) return {};
  const auto color = [&](std::size_t end) {
    return color_of_vertex(state, vertices, state.flat ? line.provoking : line.vertex[end], line.back);
  };
  return {color(0), color(1)};
}

PrimitiveRecord& write_line_record(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line,
                                   void* memory) {
  const WindowVertex &v0 = vertices.window[line.vertex[0]], &v1 = vertices.window[line.vertex[1]];
  if (const std::size_t count = varying_count(state); count > 0) {
    std::array<std::array<float, max_varyings>, 2> varyings;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::uint16_t shading = state.flat ? line.provoking : line.vertex[i];
      copy_varyings(state, vertices, line.vertex[i], shading, line.back, varyings[i].data());
    }
    VaryingRecord& out = varying_record(state, memory);
    make_varying_planes(basis_of_line(state, v0, v1), {&v0, &v1, &v1},
                        {varyings[0].data(), varyings[1].data(), varyings[1].data()}, count, out);
    out.clamp = out.perspective || state.binding->samples_apart;  // as colors, above
  }
  PrimitiveRecord& record = write_line_record(state, v0, v1, colors_of_line(state, vertices, line), line.depth_offset, memory);
  record.back = line.back;
  return record;
}

struct SnappedLine {
  SubpixelPoint a, b;
};
SnappedLine snapped(const SetupState& state, const WindowVertex& v0, const WindowVertex& v1) {
  const std::int64_t top = (static_cast<std::int64_t>(state.target_height_px) - 1) * subpixels;
  return {{snap(v0.x), top - snap(v0.y_raster)}, {snap(v1.x), top - snap(v1.y_raster)}};
}

PrimitiveRecord& write_point_record(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point,
                                    void* memory) {
  const WindowVertex& vertex = vertices.window[point.vertex];
  PrimitiveRecord& record = new_record(state, memory, point.back);
  const std::array<ShadedVertex, 3> shaded{ShadedVertex{&vertex, {}}, ShadedVertex{&vertex, {}}, ShadedVertex{&vertex, {}}};
  record.depth = make_depth_plane({}, shaded, state.targets);
  offset_depth(point.depth_offset, state.targets, record.depth);
  if (const std::size_t count = varying_count(state); count > 0) {
    std::array<float, max_varyings> varyings;
    copy_varyings(state, vertices, point.vertex, state.flat ? point.provoking : point.vertex, point.back, varyings.data());
    make_constant_varyings(varyings.data(), count, varying_record(state, memory));
  }
  if (state.colors) {
    make_constant_color(color_of_vertex(state, vertices, state.flat ? point.provoking : point.vertex, point.back),
                        state.targets, reinterpret_cast<ColoredPrimitive*>(memory)->color);
  }
  return record;
}

/// Coordinates that run over the sprite in place of the vertex's: s from left to right, t from top to bottom, r = 0 and
/// q = 1 [ARB_point_sprite].
void run_over_sprite(const SetupState& state, const WindowVertex& vertex, double size_px, const TextureCoordinateLayout& layout,
                     VaryingRecord& out) {
  const double slope = 1.0 / size_px;
  const double left = vertex.x - 0.5 * size_px;
  const double top = static_cast<double>(state.target_height_px) - vertex.y_raster + 0.5 * size_px;
  // At the centre of pixel (0, 0).
  const std::array<VaryingPlane, 3> planes{VaryingPlane{(0.5 - left) * slope, slope, 0, 0, 0, 1},
                                           VaryingPlane{(top - 0.5) * slope, 0, -slope, 0, 0, 1}, VaryingPlane{}};
  auto* const first = reinterpret_cast<VaryingPlane*>(&out + 1) + layout.first;
  std::copy_n(planes.begin(), layout.dimensions, first);
  if (layout.has_q) first[layout.dimensions] = {0, 0, 0, 1, 1, 1};
  out.constant &= ~(std::uint64_t{layout.dimensions > 1 ? 3u : 1u} << layout.first);
  out.clamp = true;
}

/// Lists the pixels of the columns that the stipple keeps, and counts all columns.
void list_pixels(const LineState& lines, const LineCoverage& coverage, StippleCount& count,
                 std::vector<PixelPosition>& pixels) {
  std::vector<PixelPosition> columns;
  coverage.list_columns(columns);
  for (const PixelPosition& lowest : columns) {
    if (stipple_keeps(lines, count++)) coverage.list_column(lowest, pixels);
  }
}

/// A half-open range of pixels of this length around a position in 1/256 pixel.
struct Range {
  std::int32_t begin, end;
};
Range pixels_around(std::int64_t position, std::int32_t size) {
  const std::int64_t first = size % 2 != 0 ? (position >> subpixel_bits) - size / 2
                                           : ((position + subpixels / 2) >> subpixel_bits) - size / 2;
  return {static_cast<std::int32_t>(first), static_cast<std::int32_t>(first + size)};
}

PixelRect box_of_point(const SetupState& state, const WindowVertex& vertex, float size_px) {
  const auto round_away = [](float coordinate) {
    const float scaled = coordinate * subpixels;
    return static_cast<std::int64_t>(std::floor(std::abs(scaled) + 0.5f)) * (scaled < 0 ? -1 : 1);
  };
  const std::int32_t size = std::max(static_cast<std::int32_t>(std::ceil(size_px - 0.5f)), 1);
  const Range columns = pixels_around(round_away(vertex.x), size);
  const std::int64_t height = static_cast<std::int64_t>(state.target_height_px) * subpixels;
  const Range rows = pixels_around(height - round_away(vertex.y_raster), size);
  return {columns.begin, rows.begin, columns.end, rows.end};
}

/// As a filled square would be: left and bottom edges own the samples on them.
PixelRect box_of_sprite(const SetupState& state, const WindowVertex& vertex, float size_px) {
  const float half = 0.5f * size_px;
  const auto first_sample = [](std::int64_t edge) { return static_cast<std::int32_t>((edge + subpixels - 1) >> subpixel_bits); };
  const std::int64_t top = (static_cast<std::int64_t>(state.target_height_px) - 1) * subpixels;
  return {first_sample(snap(vertex.x - half)), first_sample(top - snap(vertex.y_raster + half)),
          first_sample(snap(vertex.x + half)), first_sample(top - snap(vertex.y_raster - half))};
}

/// The rectangle of a line's stretch: its first and second corner lie on the right of its way.
SmoothShape shape_of_stretch(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, double begin,
                             double end) {
  const double length = length_of(vertices, line);
  const WindowVertex &v0 = vertices.window[line.vertex[0]], &v1 = vertices.window[line.vertex[1]];
  const double along_x = (static_cast<double>(v1.x) - v0.x) / length;
  const double along_y = (static_cast<double>(v0.y_raster) - v1.y_raster) / length;
  const double x = v0.x, y = static_cast<double>(state.target_height_px) - v0.y_raster, half = 0.5 * state.lines.width_px;
  const auto corner = [&](double along, double across) {
    return SmoothShape::Corner{x + along_x * along - along_y * across, y + along_y * along + along_x * across};
  };
  return {{corner(begin, -half), corner(end, -half), corner(end, half), corner(begin, half)}, 4, 0.0, state.sampled};
}

/// The record covers the samples inside the rectangle.
void set_rectangle(const SmoothShape& shape, double width, PrimitiveRecord& record) {
  const auto& corner = shape.corner;
  const auto between = [](SmoothShape::Corner a, SmoothShape::Corner b) { return Point2{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)}; };
  new (&record.rectangle) RectangleEdges(edges_of_rectangle(between(corner[0], corner[3]), between(corner[1], corner[2]), width));
  record.is_rectangle = true;
}

/// A disc, or the square of a sprite.
SmoothShape shape_of_point(const SetupState& state, const WindowVertex& vertex, double size_px) {
  const double x = vertex.x, y = static_cast<double>(state.target_height_px) - vertex.y_raster, half = 0.5 * size_px;
  if (!state.points.sprite) return {{SmoothShape::Corner{x, y}}, 0, half, state.sampled};
  return {{SmoothShape::Corner{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}}, 4, 0.0, state.sampled};
}

}  // namespace

bool has_shape(const SetupState& state) { return state.points.smooth || (state.points.sprite && state.sampled); }

LinePixels setup_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line,
                      StippleCount& count, void* memory, std::vector<PixelPosition>& pixels) {
  const auto [a, b] = snapped(state, vertices.window[line.vertex[0]], vertices.window[line.vertex[1]]);
  if (a == b) return LinePixels::none;
  const LineCoverage coverage(a, b, static_cast<std::int32_t>(state.lines.width_px));
  if (state.lines.stipple_pattern != 0xFFFF || !coverage.is_simple()) {
    list_pixels(state.lines, coverage, count, pixels);
    if (pixels.empty()) return LinePixels::none;
    write_line_record(state, vertices, line, memory);
    return LinePixels::list;
  }
  const PixelRect box = coverage.box();
  if (intersection(box, state.scissor).empty()) return LinePixels::none;
  PrimitiveRecord& record = write_line_record(state, vertices, line, memory);
  set_box(state, box, record);
  const auto edges = coverage.edges();
  record.edges = {edges[0], edges[1], {}};
  return LinePixels::edges;
}

bool are_plain_lines(const SetupState& state) {
  return !state.lines.smooth && state.lines.stipple_pattern == 0xFFFF && state.binding->varyings.count == 0;
}

LinePixels select_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, WaitingLine& out) {
  const WindowVertex &v0 = vertices.window[line.vertex[0]], &v1 = vertices.window[line.vertex[1]];
  const auto [a, b] = snapped(state, v0, v1);
  if (a == b) return LinePixels::none;
  const LineCoverage coverage(a, b, static_cast<std::int32_t>(state.lines.width_px));
  if (!coverage.is_simple()) return LinePixels::list;
  const PixelRect box = intersection(coverage.box(), state.scissor);
  if (box.empty()) return LinePixels::none;
  const std::array<Rgba, 2> colors = colors_of_line(state, vertices, line);
  out.vertex = {KeptVertex{v0, colors[0]}, KeptVertex{v1, colors[1]}};
  out.edges = coverage.edges();
  out.state = &state;
  out.x0 = static_cast<std::int16_t>(box.x0);
  out.y0 = static_cast<std::int16_t>(box.y0);
  out.x1 = static_cast<std::int16_t>(box.x1);
  out.y1 = static_cast<std::int16_t>(box.y1);
  out.back = line.back;
  return LinePixels::edges;
}

void setup_waiting_line(const WaitingLine& line, void* memory) {
  const SetupState& state = *line.state;
  PrimitiveRecord& record = write_line_record(state, line.vertex[0].window, line.vertex[1].window,
                                              {line.vertex[0].color, line.vertex[1].color}, 0.0, memory);
  record.back = line.back;
  set_box(state, {line.x0, line.y0, line.x1, line.y1}, record);
  record.edges = {line.edges[0], line.edges[1], {}};
}

bool are_plain_points(const SetupState& state) {
  const PointState& points = state.points;
  return points.size_px == 1.0f && !points.smooth && !points.sprite && !points.attenuated && state.binding->varyings.count == 0;
}

bool select_point(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point, WaitingPoint& out) {
  const WindowVertex& vertex = vertices.window[point.vertex];
  const PixelRect pixel = box_of_point(state, vertex, 1.0f);
  if (intersection(pixel, state.scissor).empty()) return false;
  out.x = static_cast<std::int16_t>(pixel.x0);
  out.y = static_cast<std::int16_t>(pixel.y0);
  out.z = vertex.z;
  out.back = point.back;
  if (state.colors) out.color = color_of_vertex(state, vertices, state.flat ? point.provoking : point.vertex, point.back);
  return true;
}

void setup_waiting_point(const SetupState& state, const WaitingPoint& point, void* memory) {
  PrimitiveRecord& record = new_record(state, memory, point.back);
  record.depth.origin = std::clamp(static_cast<double>(point.z), 0.0, 1.0) * state.targets.depth_scale;
  record.depth.minimum = record.depth.maximum = static_cast<float>(record.depth.origin);
  if (state.colors) make_constant_color(point.color, state.targets, reinterpret_cast<ColoredPrimitive*>(memory)->color);
}

double length_of(const ProcessedVertices& vertices, const AssembledLine& line) {
  const WindowVertex &v0 = vertices.window[line.vertex[0]], &v1 = vertices.window[line.vertex[1]];
  const double dx = static_cast<double>(v1.x) - v0.x, dy = static_cast<double>(v1.y_raster) - v0.y_raster;
  return std::sqrt(dx * dx + dy * dy);
}

bool setup_smooth_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, double begin,
                       double end, void* memory, SmoothShape& shape) {
  if (!(length_of(vertices, line) > 0)) return false;
  shape = shape_of_stretch(state, vertices, line, begin, end);
  const PixelRect box = box_of(shape);
  if (intersection(box, state.scissor).empty()) return false;
  PrimitiveRecord& record = write_line_record(state, vertices, line, memory);
  set_box(state, box, record);
  record.shape = &shape;
  return true;
}

bool setup_sampled_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, double begin,
                        double end, void* memory) {
  if (!(length_of(vertices, line) > 0)) return false;
  const SmoothShape shape = shape_of_stretch(state, vertices, line, begin, end);
  const PixelRect box = box_of(shape);
  if (intersection(box, state.scissor).empty()) return false;
  PrimitiveRecord& record = write_line_record(state, vertices, line, memory);
  set_box(state, box, record);
  set_rectangle(shape, state.lines.width_px, record);
  return true;
}

float derived_point_size(const PointState& points, float x, float y, float z) {
  if (!points.attenuated) return points.size_px;
  const double squared = (static_cast<double>(x) * x + static_cast<double>(y) * y) + static_cast<double>(z) * z;
  const double divisor = (static_cast<double>(points.attenuation.x) + points.attenuation.y * std::sqrt(squared)) +
                         points.attenuation.z * squared;
  const auto size = static_cast<float>(points.size_px * std::sqrt(1.0 / divisor));
  // Written so that what is no number becomes the smallest size.
  return size > points.smallest_px ? std::min(size, points.largest_px) : points.smallest_px;
}

bool setup_point(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point, float size_px,
                 void* memory, SmoothShape* shape) {
  const WindowVertex& vertex = vertices.window[point.vertex];
  const float drawn_px = std::max(size_px, state.points.fade_threshold_px);
  PixelRect box;
  if (has_shape(state)) {
    *shape = shape_of_point(state, vertex, static_cast<double>(drawn_px));
    shape->fade = (size_px / drawn_px) * (size_px / drawn_px);
    box = box_of(*shape);
  } else {
    box = state.points.sprite ? box_of_sprite(state, vertex, size_px) : box_of_point(state, vertex, size_px);
  }
  if (intersection(box, state.scissor).empty()) return false;
  PrimitiveRecord& record = write_point_record(state, vertices, point, memory);
  set_box(state, box, record);
  const TexturingState* const texturing = state.binding->texturing;
  for (unsigned units = texturing != nullptr ? texturing->sprite_units : 0; units != 0; units &= units - 1) {
    const auto unit = static_cast<std::size_t>(std::countr_zero(units));
    run_over_sprite(state, vertex, static_cast<double>(drawn_px), state.binding->varyings.texture_coordinates[unit],
                    *reinterpret_cast<VaryingRecord*>(varying_memory(state, memory)));
  }
  if (has_shape(state)) record.shape = shape;
  if (state.points.sprite && state.binding->samples_apart) set_rectangle(*shape, static_cast<double>(drawn_px), record);
  return true;
}

PrimitiveRecord& setup_fragments(const SetupState& state, const ProcessedVertices& vertices, const PixelRect& box,
                                 void* memory) {
  PrimitiveRecord& record = write_point_record(state, vertices, {}, memory);
  set_box(state, box, record);
  return record;
}

}  // namespace gouraud::pipeline
