// The vertices of a batch after the vertex stages, and the primitives made of them: the data that flows between
// geometry stages and into raster setup. Entry i < batch.count belongs to batch vertex i; entries from batch.count on
// are made by the clipper.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "pipeline/geometry/vertex_batch.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

/// Room for a batch and for vertices that clipping makes.
inline constexpr int processed_stride = 2 * batch_stride;

template <int components>
using ProcessedArray = std::array<std::array<float, processed_stride>, components>;

/// Outcode bits: set if the vertex is outside that plane; in the order in which triangles are clipped (MESA-RULES 2.4).
enum Outcode : std::uint16_t {
  outside_right = 1 << 0,   // x > w
  outside_left = 1 << 1,    // x + w < 0
  outside_top = 1 << 2,     // y > w
  outside_bottom = 1 << 3,  // y + w < 0
  outside_near = 1 << 4,    // z + w < 0 (z < 0: see near_plane_w)
  outside_far = 1 << 5,     // z > w
  outside_invalid = 1 << 6, // a coordinate is NaN or infinite: primitives that use the vertex are dropped
  outside_clip_plane_0 = 1 << 7,  // the DrawState's first clip plane; the others' bits follow
};

/// A vertex in window space, as setup wants it.
struct alignas(16) WindowVertex {
  float x = 0;         ///< pixels from the left edge of the target
  float y_raster = 0;  ///< pixels from the TOP edge (see ViewportState); not snapped
  float z = 0;         ///< window depth, in [0, 1] up to rounding
  float w_inverse = 0; ///< 1 / w_clip
};

struct alignas(16) Rgba {
  float r = 0, g = 0, b = 0, a = 0;
};

struct ProcessedVertices {
  std::int32_t count = 0;
  /// The near plane is z = -near_plane_w * w: 1, or 0 where depth is clipped to [0, 1] [ARB_clip_control].
  float near_plane_w = 1.0f;
  alignas(64) ProcessedArray<4> position_clip;
  alignas(64) ProcessedArray<4> position_eye;  ///< only if the plan needs eye positions
  alignas(64) ProcessedArray<3> normal_eye;    ///< only if the plan lights; after rescaling or normalizing
  alignas(64) std::array<std::uint16_t, processed_stride> outcode;
  alignas(64) std::array<WindowVertex, processed_stride> window;  ///< valid where outcode == 0
  alignas(64) std::array<Rgba, processed_stride> color_front;     ///< clamped to [0, 1]
  alignas(64) std::array<Rgba, processed_stride> color_back;      ///< only with two-sided lighting
  /// The secondary colour, clamped, alpha 0: only with separate specular or a colour sum.
  alignas(64) std::array<Rgba, processed_stride> specular_front;
  alignas(64) std::array<Rgba, processed_stride> specular_back;
  /// Texture coordinates behind texgen and texture matrix, fog coordinate: the first VaryingLayout::of_vertices()
  /// arrays are valid, in the layout's order.
  alignas(64) ProcessedArray<max_varyings> varying;
};

/// Indices into ProcessedVertices. Flat-shaded colours come from `provoking`. Bit k of `edges` says that the edge from
/// vertex k to vertex (k + 1) % 3 is a boundary edge of the original polygon: drawn in polygon mode line.
struct AssembledTriangle {
  std::array<std::uint16_t, 3> vertex{};
  std::uint16_t provoking = 0;
  std::uint8_t edges = 7;
  bool continues = false;  ///< another part of the same polygon came right before
};
/// A line or point made from a polygon (polygon mode) that faces away is `back`: it takes the back side's colours, if
/// lighting is two-sided, and its stencil test. `depth_offset` is the polygon's, in units of the depth buffer.
struct AssembledLine {
  std::array<std::uint16_t, 2> vertex{};
  std::uint16_t provoking = 0;
  bool back = false;
  double depth_offset = 0;
};
struct AssembledPoint {
  std::uint16_t vertex = 0;
  std::uint16_t provoking = 0;  ///< == vertex, except for the points of flat-shaded polygons
  bool back = false;
  double depth_offset = 0;
};

}  // namespace gouraud::pipeline
