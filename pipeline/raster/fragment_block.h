// The narrow waist: every rasterizer makes FragmentBlocks, and nothing after it knows which one did.
//
// A block is 8x8 pixels of a tile, lane = row * 8 + column, row 0 at the bottom. Bit `lane` of `coverage` says that the
// fragment is alive; a pass clears the bits of those that fail its test.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/draw/limits.h"
#include "pipeline/raster/varyings.h"

namespace gouraud::pipeline {

struct PrimitiveRecord;

/// The tile's pixels in the target's buffers.
struct TileTarget {
  std::byte* color = nullptr;
  std::byte* depth = nullptr;
  std::byte* stencil = nullptr;  ///< only where the depth format does not hold it
  std::int32_t sample = 0;       ///< of a multisampled target: whose pixels these are
  float sample_x = 0.0f, sample_y = 0.0f;  ///< where depth is taken, in pixels from the pixel's centre
  bool keeps_depth = false;      ///< the depth test writes nothing
};

/// A block's pixels as packed bytes R, G, B, A.
struct PixelWords {
  alignas(64) std::array<std::int32_t, 64> word;
};

struct FragmentBlock {
  std::uint64_t coverage = 0;
  std::int32_t x = 0, y = 0;      ///< window position of lane 0's pixel
  std::int32_t first_pixel = 0;   ///< lane 0's place among the tile's pixels
  const PrimitiveRecord* primitive = nullptr;
  /// R, G, B, A of each lane, times the target's color_scale; valid behind the interpolating pass, if the plan has one.
  /// Lanes that are not alive hold anything.
  alignas(64) std::array<std::array<float, 64>, 4> color;
  /// In place of `color` behind a pass that gives the colours of an 8-bit target as it stores them.
  PixelWords words;
  /// Of each lane, covered or not, in the order of the binding's VaryingLayout; valid behind the pass that interpolates
  /// varyings, in pairs of rows that hold covered lanes. Not initialized: a block is cheap as long as nobody asks for them.
  alignas(64) std::array<std::array<float, 64>, max_varyings> varying;
  /// What a smooth point, line or polygon covers of each pixel, or how far a sampled point has faded, in [0, 1]; valid if
  /// the plan applies coverage.
  alignas(64) std::array<float, 64> pixel_coverage;
};

using FragmentPass = void (*)(FragmentBlock& block, const TileTarget& target);

struct TriangleGroup;  // triangles.h
struct SeenBlock;      // polygons.h
struct SampleBlock;    // sample_blocks.h
/// Coverage and early passes of a group of small triangles at once (draw/small_triangles.h), in one sample or in all: lists
/// the blocks that they leave in order and returns their number. `seen` has room for one more. The triangles of these have
/// their records begun.
struct SmallTriangleTests {
  std::size_t (*one)(TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target, SeenBlock* seen) = nullptr;
  std::size_t (*all)(TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y,
                     const std::array<TileTarget, max_samples>& targets, SampleBlock* seen) = nullptr;
  bool operator==(const SmallTriangleTests&) const = default;
};
/// Early passes of a group at once (draw/group_depth.h): leaves of the blocks that it covers those that are seen, in order, and
/// returns their number.
using GroupDepthTest = std::size_t (*)(const TriangleGroup& group, SeenBlock* blocks, std::size_t count, const TileTarget& target);

/// The fragment passes of a plan, in order. A block that has lost all its fragments goes no further.
struct FragmentPasses {
  static constexpr int max_passes = 16;
  std::array<FragmentPass, max_passes> pass{};
  std::int32_t count = 0;
  /// So many passes, the first ones, need neither colours nor varyings and touch no colour buffer: whoever draws several
  /// primitives may run these for all before the others for any, and the picture is the same.
  std::int32_t early = 0;
  /// Passes [early, shaded) are about a fragment and not about its samples: they run once for all of them.
  std::int32_t shaded = 0;
  /// The depth test that another pass runs: the stencil pass, or the one that rejects hidden fragments.
  FragmentPass inner_depth = nullptr;
  /// The last early pass rejects hidden fragments (fragment/depth.h): it tests depth and writes none.
  bool rejects_early = false;
  /// Where the early passes are a depth test and nothing else; null: small triangles go the way of all.
  SmallTriangleTests small_triangles{};
  /// The same for other triangles; null: block by block.
  GroupDepthTest group_depth = nullptr;

  void add(FragmentPass next) { pass[static_cast<std::size_t>(count++)] = next; }
  bool operator==(const FragmentPasses&) const = default;
};

}  // namespace gouraud::pipeline
