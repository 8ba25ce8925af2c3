// Setup: window-space primitives to records that the tile bins can hold [GL1.5 §3.3, §3.4.1, §3.5.1].
//
// Takes processed vertices and indices, gives records: vertices snapped to 1/256 pixel, edge functions in exact integers,
// planes of depth and colour. Filled triangles have a header of their own: triangles.h.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
#include "pipeline/raster/line_coverage.h"
#include "pipeline/raster/planes.h"
#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// What setup needs of a draw: constant over a batch.
struct SetupState {
  const RasterBinding* binding = nullptr;
  PixelRect scissor{};
  std::int32_t target_height_px = 0;
  FrontFace front_face = FrontFace::ccw;
  CullMode cull = CullMode::none;
  bool flat = false;
  bool colors = false;             ///< records are ColoredPrimitives
  bool two_sided = false;          ///< back faces take color_back
  bool sampled = false;    ///< lines and points are sampled shapes, not smooth ones (where the binding's samples are apart: into all samples)
  bool color_sum = false;  ///< the secondary colour is added here: where no texture stands between, the sum is linear
  PlaneTargets targets{};
  PointState points{};
  LineState lines{};
  PolygonState polygons{};
  bool operator==(const SetupState&) const = default;
};

/// Bytes of the record that setup writes.
inline std::size_t record_size(const SetupState& state) {
  const std::size_t bytes = state.colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord);
  const auto varyings = static_cast<std::size_t>(state.binding->varyings.count);
  if (varyings == 0) return bytes;
  return bytes + sizeof(VaryingRecord) + (varyings * sizeof(VaryingPlane) + 63) / 64 * 64;
}

/// The colour that setup gives to a vertex of a front or back face: the colour sum, not clamped [GL1.5 §3.9].
inline Rgba color_of_vertex(const SetupState& state, const ProcessedVertices& vertices, std::uint16_t index, bool back) {
  back = back && state.two_sided;
  Rgba color = back ? vertices.color_back[index] : vertices.color_front[index];
  if (state.color_sum) {
    const Rgba& specular = back ? vertices.specular_back[index] : vertices.specular_front[index];
    color.r += specular.r;
    color.g += specular.g;
    color.b += specular.b;
  }
  return color;
}

/// Copies the varyings of a vertex of a front or back face to `out`, in the layout's order. The secondary colour is that
/// of the vertex `shading`: another one where shading is flat.
inline void copy_varyings(const SetupState& state, const ProcessedVertices& vertices, std::uint16_t index, std::uint16_t shading,
                          bool back, float* out) {
  const VaryingLayout& layout = state.binding->varyings;
  const auto count = static_cast<std::size_t>(layout.of_vertices());
  for (std::size_t k = 0; k < count; ++k) out[k] = vertices.varying[k][index];
  if (layout.secondary_color < 0) return;
  const Rgba& secondary = back && state.two_sided ? vertices.specular_back[shading] : vertices.specular_front[shading];
  float* const target = out + layout.secondary_color;
  target[0] = secondary.r;
  target[1] = secondary.g;
  target[2] = secondary.b;
}

/// Facing of a triangle drawn as lines or points: by the sign of its unsnapped area; zero counts as back
/// (MESA-RULES 2.5). True for front.
bool faces_front(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle);
/// Twice that area, positive for front. Of a triangle that was clipped, the parts' areas add up: a part may have none.
double front_area(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle);
/// True if CullFace removes such a face.
bool is_culled(CullMode cull, bool front);

/// What PolygonOffset adds to the depths of this triangle, in buffer units [GL1.5 §3.5.5 eq 3.9]: for triangles that are
/// drawn as lines or points.
double depth_offset(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle);

/// The offset in buffer units of a triangle with these slopes (in buffer units a pixel) and largest depth; at most the
/// whole range of depths.
/// choice: m is the larger of both slopes (eq 3.8). r is two steps of an integer buffer, as Mesa's (MESA-RULES 4.4): one
/// would keep depths apart, but programs have tuned their units to two. Of a floating-point buffer it is two steps at the
/// largest depth of the polygon. The bias of EXT_polygon_offset is a part of the range of depths, not of its steps.
inline constexpr double offset_unit = 2.0;
double depth_offset(const PolygonState& state, const PlaneTargets& targets, double dx, double dy, double largest_depth);

/// How many fragments of stippled lines came before, since the last reset [GL1.5 §3.4.2].
using StippleCount = std::int64_t;
/// Whether the stipple keeps the fragment behind so many others.
inline bool stipple_keeps(const LineState& lines, StippleCount count) {
  return (lines.stipple_pattern >> (count / lines.stipple_factor % 16) & 1) != 0;
}

/// What setup_line found.
enum class LinePixels : std::uint8_t {
  none,   ///< nothing is drawn
  edges,  ///< the pixels inside the record's edges and box
  list,   ///< the pixels that it listed, not yet scissored
};

/// Sets up a line that is not smooth [GL1.5 §3.4.1, §3.4.2]: strict diamond exit on end points snapped to 1/256 pixel,
/// ties broken by the specification's shift (-eps, -eps^2). Stippled ones move `count` on.
LinePixels setup_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line,
                      StippleCount& count, void* record, std::vector<PixelPosition>& pixels);

/// What waits in the bins of a vertex. A triangle's varyings stand behind it, if the layout has some.
struct alignas(32) KeptVertex {
  WindowVertex window;
  Rgba color;  ///< of the side that faces the viewer; where shading is flat, the provoking vertex's
};

/// A line before its setup, less than half a record: as for triangles, more of them meet in a tile while it is in the cache.
struct alignas(64) WaitingLine {
  std::array<KeptVertex, 2> vertex;
  std::array<EdgeFunction, 2> edges;
  const SetupState* state;
  std::int16_t x0, y0, x1, y1;  ///< pixels [x0, x1) x [y0, y1) that it may touch; inside the scissor
  bool back;                    ///< of a polygon that faces away
};
static_assert(sizeof(WaitingLine) == 128);

/// Whether lines of this draw may wait like that: not smooth, not stippled, and nothing varies but colour and depth.
bool are_plain_lines(const SetupState& state);
/// `edges`: `out` is to wait. `list`: setup_line has to list its pixels.
LinePixels select_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, WaitingLine& out);
/// The record of a waiting line, in `record`: record_size bytes.
void setup_waiting_line(const WaitingLine& line, void* record);
/// The same of several lines of one state, at most group_capacity (record_group.h): their records, one after the other.
void setup_waiting_lines(std::span<const WaitingLine> lines, std::byte* records);

/// A smooth line, or a stretch of it [GL1.5 §3.4.2]: `begin`, `end` in pixels from its start. False if it draws nothing.
bool setup_smooth_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, double begin,
                       double end, void* record, SmoothShape& shape);
/// The same of a line that goes into all samples of its pixels [GL1.5 §3.4.4]: the record is a rectangle.
bool setup_sampled_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, double begin,
                        double end, void* record);
/// The same of a line that goes into all samples of its pixels [GL1.5 §3.4.4]: its record is a rectangle.
bool setup_sampled_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, double begin,
                        double end, void* record);
/// Its length in pixels.
double length_of(const ProcessedVertices& vertices, const AssembledLine& line);

/// The size of a point before it is rounded for what it is [GL1.5 §3.3]. `x`, `y`, `z` is its eye position; used if sizes
/// are attenuated.
/// deviation: the distance is that from the eye, as the specification says; Mesa takes |z_eye| (MESA-RULES 5.4).
float derived_point_size(const PointState& points, float x, float y, float z);

/// A plain point of one pixel, as it waits in the bins: many of them share a chunk, and the tile makes their records.
struct WaitingPoint {
  Rgba color;
  float z;             ///< window depth
  std::int16_t x, y;   ///< its pixel
  bool back;           ///< of a polygon that faces away
};
static_assert(sizeof(WaitingPoint) == 32);
struct alignas(64) PointChunk {
  static constexpr std::int32_t capacity = 31;
  const SetupState* state = nullptr;
  std::int32_t count = 0;
  std::array<WaitingPoint, capacity> point;
};

/// Whether points of this draw may wait like that: one pixel each, and nothing that varies but colour and depth.
bool are_plain_points(const SetupState& state);
/// False if it misses the scissor box.
bool select_point(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point, WaitingPoint& out);
/// The record of a waiting point, in `record`: record_size bytes.
void setup_waiting_point(const SetupState& state, const WaitingPoint& point, void* record);

/// Whether points of this draw have a shape: smooth or sampled ones.
bool has_shape(const SetupState& state);

/// Sets up a point of this size [GL1.5 §3.3]: its record has a box; `shape` becomes the disc of a smooth one or the shape of
/// a sampled one, and is not used by others. False if it misses the scissor box. A sampled point that is too small fades. choice: a size is rounded to the nearest integer, halves down, and the position to 1/256 pixel, halves
/// away from zero, before the pixels are found (MESA-RULES 5.4). Sprites are squares of exactly their size.
bool setup_point(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point, float size_px,
                 void* record, SmoothShape* shape);

/// The record of a bitmap or pixel rectangle: all over what vertex 0 is, inside `box`, which is not empty.
PrimitiveRecord& setup_fragments(const SetupState& state, const ProcessedVertices& vertices, const PixelRect& box,
                                 void* record);

}  // namespace gouraud::pipeline
