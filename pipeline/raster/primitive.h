// A primitive after setup, as it waits in the tile bins: where it covers pixels, and planes that give depth and colour
// anywhere in the window.
//
// A plane is origin + dx * i + dy * j, in double, at the centre of pixel (i, j). Planes stem from the unsnapped window
// positions, coverage from the snapped ones (ARCHITECTURE §3).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/draw/draw_state.h"
#include "pipeline/draw/texture_state.h"
#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

struct TextureUnits;  // pipeline/texture/texture_units.h
class SampleCounter;  // pipeline/draw/sample_counter.h
struct MethodState;  // pipeline/draw/method_state.h
struct PixelWatch;  // pipeline/draw/watch.h
struct PlacedImage;  // pipeline/raster/pixel_image.h

/// What the bins keep of a draw: shared by all primitives of equal draws.
struct RasterBinding {
  RasterState state{};
  FragmentPasses passes{};
  VaryingLayout varyings{};
  bool colors = false;  ///< colours are interpolated: the records are ColoredPrimitives
  const TexturingState* texturing = nullptr;  ///< interned too; null: no unit is textured
  const TextureUnits* texture_units = nullptr;  ///< made of it
  SampleCounter* samples = nullptr;           ///< kept like textures; of the occlusion query that was active; null: none
  const MethodState* method = nullptr;        ///< interned too; what passes of methods need; null: there are none
  const PixelWatch* watch = nullptr;          ///< somebody looks on: passes tell what they do; null: nobody
  const PlacedImage* image = nullptr;         ///< of a pixel rectangle: gives colour or depth; null: none
  /// Of draws that go into all samples of their pixels at once (sample_blocks.h): bit k: into sample k. 0: into one.
  std::uint8_t sample_mask = 0;
  bool samples_apart = false;  ///< each sample has its own place; else all are where the pixel's centre is
  bool operator==(const RasterBinding&) const = default;
};

/// Pixel (i, j) lies on the inner side if a * i + b * j + c >= 0; the tie rule is part of c. Where a binding's samples are
/// apart, c is 256 times as fine: a sample (x, y) / 256 pixel from the centre has (c + a * x + b * y) / 256, rounded down.
///
/// Width: window coordinates are at most 2^16 pixels from the origin and a clipped primitive at most 2^14 across
/// (viewport_limits below), so in 1/256 pixel |a|, |b| <= 2^22 and |c| < 2^40: int64 with room. Relative to a 64x64
/// tile that the edge crosses, |value| <= 64 * (|a| + |b|) <= 2^29: int32 with room.
struct EdgeFunction {
  std::int64_t c = 0;
  std::int32_t a = 0, b = 0;
};
inline constexpr int subpixel_bits = 8;
inline constexpr int subpixels = 1 << subpixel_bits;
static_assert(64LL * 2 * ((16384LL << subpixel_bits) + 1) < (1LL << 31), "an edge's values inside a tile fit int32");

/// The edges of a rectangle whose samples are apart: opposite ones differ in sign and in c (rectangle_edges.h).
struct RectangleEdges {
  std::array<std::int64_t, 4> c;
  std::int32_t a, b;

  std::array<EdgeFunction, 4> all() const { return {{{c[0], a, b}, {c[1], -a, -b}, {c[2], b, -a}, {c[3], -b, a}}}; }
};

struct PrimitiveRecord;
/// As PolygonRasterizer (polygons.h): finds the primitive's pixels in a tile.
using ShapeRasterizer = void (*)(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y,
                                 const TileTarget& target);
void rasterize_smooth(const PrimitiveRecord& primitive, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target);

/// Where a smooth primitive lies, in window space: what it covers of a pixel is the area that both share
/// [GL1.5 §3.3.1, §3.4.2, §3.5.3].
struct SmoothShape {
  struct Corner {
    double x = 0, y = 0;
  };
  /// Of a triangle or a rectangle, in order; of a disc the first is the centre.
  std::array<Corner, 4> corner{};
  std::int32_t corner_count = 0;  ///< 0: a disc
  double radius = 0;
  /// A pixel counts if its centre lies inside, and then the whole of it, times `fade` [GL1.5 §3.2.1, §3.12].
  bool sampled = false;
  float fade = 1.0f;
  bool smooth = true;  ///< fragments have their pixel_coverage
  /// Who reads it: a primitive of another method (method_triangle.h) has its own.
  ShapeRasterizer rasterize = rasterize_smooth;
};

/// The filled triangles that make up one smooth polygon: together they give each pixel one fragment.
struct SmoothPolygon {
  const PrimitiveRecord* const* part = nullptr;
  std::int32_t part_count = 0;
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< the box of all their boxes
};

/// How colour varies over the primitive.
/// `image`: each fragment has its own, from the binding's image.
enum class ColorVariation : std::uint8_t { constant, affine, perspective, image };

struct DepthPlane {
  double origin = 0, dx = 0, dy = 0;  ///< in buffer units (0 .. 2^bits - 1); in [0, 1] for float depth
  float minimum = 0, maximum = 0;     ///< range of the vertices: no fragment leaves it
  bool steep = false;                 ///< float steps inside a block would err visibly: evaluate in double
};

struct alignas(64) PrimitiveRecord {
  const RasterBinding* binding = nullptr;
  union {
    std::array<EdgeFunction, 3> edges{};
    RectangleEdges rectangle;  ///< if is_rectangle
  };
  std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< pixels [x0, x1) x [y0, y1) that it may touch; inside the scissor
  bool is_rectangle = false;
  bool scissored = false;  ///< the scissor cuts the edges' box: block masks are cut to the box above
  bool is_polygon = false; ///< filled: the polygon stipple applies
  bool back = false;       ///< of a polygon that faces away: it takes the back side's stencil test
  DepthPlane depth{};
  const SmoothShape* shape = nullptr;  ///< null: the edges say it all
};
static_assert(sizeof(PrimitiveRecord) == 128);

/// Follows the PrimitiveRecord in memory if the plan interpolates colours; setup fills what the variation needs. Colour is
///   plane (affine), base + plane / inverse_w_plane (perspective), or base (constant),
/// scaled by the plan's color_scale. A channel that does not vary has no slope and stays exactly what it is: under
/// perspective its plane is zero.
struct ColorRecord {
  alignas(32) std::array<double, 4> origin, dx, dy;  ///< planes of r, g, b, a
  double inverse_w_origin, inverse_w_dx, inverse_w_dy;  ///< of 1/w relative to its largest vertex value; if perspective
  alignas(16) std::array<float, 4> base;
  alignas(16) std::array<float, 4> minimum;
  alignas(16) std::array<float, 4> maximum;
  float inverse_w_minimum, inverse_w_maximum;
  ColorVariation variation;
  /// A fragment could leave the vertices' range by more than rounding forgives (slivers, colour sums): clamp each.
  bool clamp;
};

struct alignas(64) ColoredPrimitive {
  PrimitiveRecord record;
  ColorRecord color;
};

/// Follows the ColoredPrimitive (the PrimitiveRecord, if the plan interpolates no colours) if the layout has varyings, and
/// layout.count VaryingPlanes follow it. Varying k is
///   plane_k (affine), base_k + plane_k / inverse_w (perspective), or base_k (its bit in `constant` is set),
/// as in a ColorRecord. So ds/dx = (plane_k.dx - (s - base_k) * inverse_w.dx) / inverse_w. All numbers are finite.
struct VaryingPlane {
  double origin = 0, dx = 0, dy = 0;
  float base = 0, minimum = 0, maximum = 0;
};
struct alignas(64) VaryingRecord {
  double inverse_w_origin = 1, inverse_w_dx = 0, inverse_w_dy = 0;  ///< relative to its largest vertex value
  float inverse_w_minimum = 1, inverse_w_maximum = 1;
  std::uint64_t constant = 0;  ///< bit k: varying k does not vary
  bool perspective = false;
  bool clamp = false;  ///< each fragment stays in the vertices' range, wherever snapping and rounding have put it
};

/// The colour part of a record whose plan interpolates colours.
inline const ColorRecord& color_of(const PrimitiveRecord& record) {
  return reinterpret_cast<const ColoredPrimitive&>(record).color;
}

/// The varyings of a record whose layout has some, and their planes.
inline const VaryingRecord& varyings_of(const PrimitiveRecord& record) {
  const auto* bytes = reinterpret_cast<const std::byte*>(&record);
  const std::size_t before = record.binding->colors ? sizeof(ColoredPrimitive) : sizeof(PrimitiveRecord);
  return *reinterpret_cast<const VaryingRecord*>(bytes + before);
}
inline const VaryingPlane* planes_of(const VaryingRecord& record) {
  return reinterpret_cast<const VaryingPlane*>(&record + 1);
}

/// 64 pixels of a tile: `block` counts the tile's blocks row by row.
struct BlockMask {
  std::uint64_t coverage = 0;
  std::int32_t block = 0;
};

}  // namespace gouraud::pipeline
