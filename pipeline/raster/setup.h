// Setup: window-space primitives to records that the tile bins can hold [GL1.5 §3.3, §3.4.1, §3.5.1].
//
// Takes processed vertices and indices, gives records: facing decided, culled, vertices snapped to 1/256 pixel, edge
// functions in exact integers, planes of depth and colour.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/processed_vertices.h"
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
  bool separate_specular = false;  ///< the secondary colour is added here: without texture the sum is linear
  PlaneTargets targets{};
  bool operator==(const SetupState&) const = default;
};

/// Bytes of the record that setup writes.
inline std::size_t record_size(const SetupState& state) {
  return state.colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord);
}

/// The colour that setup gives to a vertex of a front or back face: the colour sum, not clamped [GL1.5 §3.9].
inline Rgba color_of_vertex(const SetupState& state, const ProcessedVertices& vertices, std::uint16_t index, bool back) {
  Rgba color = back ? vertices.color_back[index] : vertices.color_front[index];
  if (state.separate_specular) {
    const Rgba& specular = back ? vertices.specular_back[index] : vertices.specular_front[index];
    color.r += specular.r;
    color.g += specular.g;
    color.b += specular.b;
  }
  return color;
}

/// A triangle that will touch pixels, before its setup. A third of a record: small ones wait like this in the bins, so
/// that more of them meet in a tile while it is in the cache, and the tile sets them up.
struct alignas(64) WaitingTriangle {
  std::array<WindowVertex, 3> window;
  std::array<Rgba, 3> color;  ///< of the side that faces the viewer; flat: the first is the provoking vertex's
  const SetupState* state;
  std::int16_t x0, y0, x1, y1;  ///< pixels [x0, x1) x [y0, y1) that it may touch; inside the scissor
  bool scissored;               ///< the scissor cuts its box
};
static_assert(sizeof(WaitingTriangle) == 128);

/// Most triangles that one call of select_triangles or setup_triangles takes.
inline constexpr std::size_t setup_batch = 32;

/// Copies the triangles that draw something to `out`, in order, and returns their number. Left out are those that are
/// culled, without area after snapping, or between the samples.
std::size_t select_triangles(const SetupState& state, const ProcessedVertices& vertices,
                             std::span<const AssembledTriangle> triangles, WaitingTriangle* out);

/// Sets up triangles of one state: their records, one after the other, in `records` (record_size bytes each, 64-byte
/// aligned).
void setup_triangles(std::span<const WaitingTriangle* const> triangles, std::byte* records);

/// Facing of a triangle drawn as lines or points: by the sign of its unsnapped area; zero counts as back
/// (MESA-RULES 2.5). True for front.
bool faces_front(const SetupState& state, const ProcessedVertices& vertices, const AssembledTriangle& triangle);
/// True if CullFace removes such a face.
bool is_culled(CullMode cull, bool front);

/// A fragment on its own, for primitives that are walked pixel by pixel.
struct PixelPosition {
  std::int32_t x = 0, y = 0;
  bool operator==(const PixelPosition&) const = default;
};

/// Sets up a line of width 1 and lists its pixels in order, not yet scissored [GL1.5 §3.4.1]: strict diamond exit on
/// end points snapped to 1/256 pixel, ties broken by the specification's shift (-eps, -eps^2).
/// False if it draws nothing.
bool setup_line(const SetupState& state, const ProcessedVertices& vertices, const AssembledLine& line, void* record,
                std::vector<PixelPosition>& pixels);

/// Sets up a point of size 1 [GL1.5 §3.3]. choice: its position is rounded to 1/256 pixel, halves away from zero,
/// before the pixel is found (MESA-RULES 5.4). False if it draws nothing.
bool setup_point(const SetupState& state, const ProcessedVertices& vertices, const AssembledPoint& point, void* record,
                 PixelPosition& pixel);

}  // namespace gouraud::pipeline
