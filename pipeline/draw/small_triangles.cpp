// Takes a group of small triangles (their pixels are known, triangles.h); gives what the depth test leaves of their blocks
// [GL1.5 §3.5.1, §4.1.6]. The same arithmetic as a triangle's record, a block of it and the depth pass, bit by bit.
//
// Why it pays: such a triangle has a handful of pixels in one to four blocks. Made one by one, each block costs a call, a
// plane at its corner in scalars and a guess at how many rows it has. Here all that a block needs is computed for a
// triangle a lane, and one loop runs over the row pairs that hold pixels, of all triangles of the group: a vector each.
// Only triangles that are seen get a record. (A sphere of 100,352 triangles: coverage and depth took 2.9 ms of 11.)
// Where samples are filled at once, the loop runs for each, and what concerns the triangles is done once.
#include "pipeline/draw/small_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "pipeline/raster/polygons.h"
#include "pipeline/raster/sample_blocks.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/draw/small_triangles.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/depth_formats-inl.h"
#include "pipeline/fragment/depth_pairs-inl.h"
#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/triangle_basis-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR  // one lane at a time would gain nothing

/// A triangle's box of 8x8 pixels touches four blocks at most: 0 and 1 of a row, 2 and 3 of the row above.
constexpr std::size_t blocks_of_triangle = 4;
constexpr std::size_t most_blocks = blocks_of_triangle * group_capacity;

/// What the loop over row pairs needs: of block k of triangle i at [k][i], of triangle i at [i].
struct SmallGroup {
  alignas(64) std::array<std::uint64_t, most_blocks> coverage;  ///< of block k of triangle i at 4 * i + k
  alignas(64) float base[blocks_of_triangle][group_capacity];   ///< depth at the block's first pixel, less `whole`
  alignas(64) float minimum[blocks_of_triangle][group_capacity], maximum[blocks_of_triangle][group_capacity];
  alignas(64) std::int32_t whole[blocks_of_triangle][group_capacity];  ///< less rounding_bits
  alignas(64) float dx[group_capacity], dy[group_capacity];
  alignas(64) float step[group_capacity];                        ///< from one row pair to the next
  alignas(64) std::int32_t column[group_capacity], row[group_capacity];  ///< block 0 in the tile
  std::uint64_t steep = 0;  ///< triangles whose depths are evaluated in double
  alignas(64) double origin[group_capacity], exact_dx[group_capacity], exact_dy[group_capacity];
  alignas(64) float least[group_capacity], most[group_capacity];
};

/// Where the depth of a pixel is taken, in pixels from its centre.
struct DepthPlace {
  double x = 0, y = 0;
};

using U = hn::RebindToUnsigned<D>;
using UV = hn::Vec<U>;
using UI = hn::RebindToUnsigned<I>;

HWY_INLINE UV widened_int(IV v) { return hn::PromoteTo(U(), hn::BitCast(UI(), v)); }

/// Where a triangle's 8x8 pixels begin: block 0, which lies in the tile or right before it (-1), and a pixel of it.
struct Places {
  IV column, row, right, up;
};

/// The pixels in the four blocks: see send_cut in polygons.cpp. Blocks outside the tile get none.
HWY_INLINE void cut_masks(UV mask, const Places& at, std::uint64_t* coverage) {
  const UV right = widened_int(at.right), up = hn::ShiftLeft<3>(widened_int(at.up));
  const UV eight = hn::Set(U(), 8);
  UV stay = hn::Shr(hn::Set(U(), 0xFF), right);
  stay = hn::Or(stay, hn::ShiftLeft<8>(stay));
  stay = hn::Or(stay, hn::ShiftLeft<16>(stay));
  stay = hn::Or(stay, hn::ShiftLeft<32>(stay));
  const UV left_half = hn::Shl(hn::And(mask, stay), right);
  const UV right_half = hn::Shr(hn::AndNot(stay, mask), hn::Sub(eight, right));
  const UV down = hn::Sub(hn::Set(U(), 56), up);

  const I i;
  const auto lanes_where = [&](hn::Mask<I> condition) HWY_ATTR {
    return hn::BitCast(U(), hn::PromoteTo(hn::RebindToSigned<D>(), hn::VecFromMask(i, condition)));
  };
  const IV last = set_int(blocks_per_tile_row - 1), minus_one = set_int(-1);
  const UV column_0 = lanes_where(hn::Gt(at.column, minus_one)), column_1 = lanes_where(hn::Lt(at.column, last));
  const UV row_0 = lanes_where(hn::Gt(at.row, minus_one)), row_1 = lanes_where(hn::Lt(at.row, last));
  const UV left = hn::And(left_half, column_0), next = hn::And(right_half, column_1);
  hn::StoreInterleaved4(hn::And(hn::Shl(left, up), row_0), hn::And(hn::Shl(next, up), row_0),
                        hn::And(hn::ShiftRight<8>(hn::Shr(left, down)), row_1),
                        hn::And(hn::ShiftRight<8>(hn::Shr(next, down)), row_1), U(), coverage);
}

/// Depth at the first pixel of the four blocks: as depth_of_block (block_depth-inl.h), a triangle a lane.
HWY_INLINE void begin_blocks(const Places& at, std::int32_t tile_x, std::int32_t tile_y, DepthPlace sample, std::size_t first, SmallGroup& out) {
  const D d;
  const F f;
  const V origin = hn::Load(d, out.origin + first), dx = hn::Load(d, out.exact_dx + first), dy = hn::Load(d, out.exact_dy + first);
  const V size = set(block_size);
  const auto place = [&](std::int32_t tile, IV block, double in_pixel) HWY_ATTR {
    return hn::Add(hn::PromoteTo(d, hn::Add(set_int(tile), hn::Mul(block, set_int(block_size)))), set(in_pixel));
  };
  const V x = place(tile_x, at.column, sample.x), y = place(tile_y, at.row, sample.y);
  const V rise_x[2] = {hn::Mul(dx, x), hn::Mul(dx, hn::Add(x, size))};
  const V rise_y[2] = {hn::Mul(dy, y), hn::Mul(dy, hn::Add(y, size))};
  const V minimum = hn::PromoteTo(d, hn::Load(f, out.least + first)), maximum = hn::PromoteTo(d, hn::Load(f, out.most + first));
  for (std::size_t k = 0; k < blocks_of_triangle; ++k) {
    const V base = hn::Add(hn::Add(origin, rise_x[k % 2]), rise_y[k / 2]), whole = hn::Round(base);
    hn::Store(hn::DemoteTo(f, hn::Sub(base, whole)), f, out.base[k] + first);
    hn::Store(hn::DemoteTo(f, hn::Sub(minimum, whole)), f, out.minimum[k] + first);
    hn::Store(hn::DemoteTo(f, hn::Sub(maximum, whole)), f, out.maximum[k] + first);
    hn::Store(hn::Sub(hn::DemoteTo(I(), whole), set_int(rounding_bits)), I(), out.whole[k] + first);
  }
}

/// Everything that concerns triangles and not their samples, one a lane.
void prepare_small_group(TriangleGroup& group, SmallGroup& out) {
  const D d;
  const F f;
  const SetupState& state = *group.state;
  group.repeat_last();
  for (std::size_t first = 0; first < group_capacity; first += hn::Lanes(d)) {
    const Corners corners = load_corners(group, first);
    const Basis basis = basis_of(corners, state.target_height_px);
    keep_basis(basis, corners, group, first);
    const DepthLanes depth = depth_of(basis, corners.z, state.targets);
    out.steep |= depth.steep << first;
    hn::Store(depth.plane.origin, d, out.origin + first);
    hn::Store(depth.plane.dx, d, out.exact_dx + first);
    hn::Store(depth.plane.dy, d, out.exact_dy + first);
    hn::Store(depth.minimum, f, out.least + first);
    hn::Store(depth.maximum, f, out.most + first);
    const auto dx = hn::DemoteTo(f, depth.plane.dx), dy = hn::DemoteTo(f, depth.plane.dy);
    hn::Store(dx, f, out.dx + first);
    hn::Store(dy, f, out.dy + first);
    hn::Store(hn::Add(dy, dy), f, out.step + first);
  }
}

/// The blocks of the triangles, one a lane: the pixels of `mask`, depths at the sample's place.
void place_small_group(const TriangleGroup& group, const std::uint64_t* mask, std::int32_t tile_x, std::int32_t tile_y,
                       DepthPlace sample, SmallGroup& out) {
  alignas(64) std::int32_t x[group_capacity], y[group_capacity];
  for (std::size_t i = 0; i < group_capacity; ++i) {
    const WaitingTriangle& triangle = *group.triangle[std::min(i, group.count - 1)];
    x[i] = triangle.x0 - tile_x;
    y[i] = triangle.y0 - tile_y;
  }
  for (std::size_t first = 0; first < group_capacity; first += hn::Lanes(D())) {
    const IV in_tile_x = hn::Load(I(), x + first), in_tile_y = hn::Load(I(), y + first), in_block = set_int(block_size - 1);
    const Places at{hn::ShiftRight<3>(in_tile_x), hn::ShiftRight<3>(in_tile_y), hn::And(in_tile_x, in_block), hn::And(in_tile_y, in_block)};
    static_assert(block_size == 8);
    hn::Store(at.column, I(), out.column + first);
    hn::Store(at.row, I(), out.row + first);
    cut_masks(hn::Load(U(), mask + first), at, out.coverage.data() + blocks_of_triangle * first);
    begin_blocks(at, tile_x, tile_y, sample, first, out);
  }
}

/// The group's blocks as test_pairs sees them, from block `first` on.
struct SmallBlocks {
  const SmallGroup& group;
  std::int32_t tile_x, tile_y;
  DepthPlace sample;
  std::size_t first;

  static HWY_INLINE std::size_t corner(std::size_t n) { return n % blocks_of_triangle; }
  HWY_INLINE std::size_t triangle(std::size_t n) const { return (first + n) / blocks_of_triangle; }
  HWY_INLINE std::int32_t column(std::size_t n) const { return group.column[triangle(n)] + static_cast<std::int32_t>(corner(n) % 2); }
  HWY_INLINE std::int32_t row(std::size_t n) const { return group.row[triangle(n)] + static_cast<std::int32_t>(corner(n) / 2); }

  HWY_INLINE std::uint64_t coverage(std::size_t n) const { return group.coverage[first + n]; }
  HWY_INLINE std::int32_t first_pixel(std::size_t n) const { return (row(n) * blocks_per_tile_row + column(n)) * pixels_per_block; }
  HWY_INLINE bool steep(std::size_t n) const { return (group.steep >> triangle(n) & 1) != 0; }
  HWY_INLINE BlockDepth depth(std::size_t n) const {
    const std::size_t i = triangle(n), k = corner(n);
    return {{group.base[k][i], group.dx[i], group.dy[i]}, group.step[i], group.minimum[k][i], group.maximum[k][i], group.whole[k][i]};
  }
  void exact(std::size_t n, std::size_t pair, std::int32_t* depth) const {
    const std::size_t i = triangle(n);
    const DepthPlane plane{group.origin[i], group.exact_dx[i], group.exact_dy[i], group.least[i], group.most[i]};
    const std::int32_t x = tile_x + column(n) * block_size, y = tile_y + row(n) * block_size + static_cast<std::int32_t>(2 * pair);
    exact_pair(plane, x + sample.x, y + sample.y, depth);
  }
};

/// What the depth test leaves of a group's blocks.
using PassedBlocks = std::array<std::uint64_t, most_blocks>;

template <class Format, class Func>
void test_small_group(const SmallGroup& small, bool write, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target, PassedBlocks& passed) {
  auto* const passed_pairs = reinterpret_cast<std::uint16_t*>(passed.data());
  for (std::size_t first = 0; first < most_blocks; first += word_blocks) {
    const SmallBlocks blocks{small, tile_x, tile_y, {target.sample_x, target.sample_y}, first};
    test_pairs<Format, Func>(blocks, find_pairs(small.coverage.data() + first), write, target.depth, passed_pairs + first * row_pairs);
  }
}

/// Calls add(i, column, row, block) for every block of the group: block `block` of all, of triangle i.
template <class Add>
HWY_INLINE void for_each_block(const TriangleGroup& group, const SmallGroup& small, const Add& add) {
  for (std::size_t i = 0; i < group.count; ++i) {
    for (std::size_t k = 0; k < blocks_of_triangle; ++k) {
      add(i, small.column[i] + static_cast<std::int32_t>(k % 2), small.row[i] + static_cast<std::int32_t>(k / 2), blocks_of_triangle * i + k);
    }
  }
}

/// Those of the triangles that are seen. Depth is needed again where the test has only rejected.
HWY_INLINE void begin_records(const TriangleGroup& group, const SmallGroup& small, std::uint32_t triangles) {
  const bool again = group.state->binding->passes.rejects_early;
  for (; triangles != 0; triangles &= triangles - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(triangles));
    PrimitiveRecord& record = begin_record(group, i);
    if (again) record.depth = {small.origin[i], small.exact_dx[i], small.exact_dy[i], small.least[i], small.most[i], (small.steep >> i & 1) != 0};
  }
}

/// Lists what passed, in order, and begins the records of the triangles that are seen.
template <class Format, class Func>
std::size_t test_group(TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target, SeenBlock* seen) {
  alignas(64) std::uint64_t mask[group_capacity];
  for (std::size_t i = 0; i < group_capacity; ++i) mask[i] = i < group.count ? group.triangle[i]->mask : 0;
  SmallGroup small;
  prepare_small_group(group, small);
  place_small_group(group, mask, tile_x, tile_y, {}, small);
  alignas(64) PassedBlocks passed{};
  test_small_group<Format, Func>(small, writes_early(*group.state->binding), tile_x, tile_y, target, passed);

  std::size_t count = 0;
  std::uint32_t triangles = 0;
  for_each_block(group, small, [&](std::size_t i, std::int32_t column, std::int32_t row, std::size_t block) HWY_ATTR {
    seen[count] = {passed[block], tile_x + column * block_size, tile_y + row * block_size,
                   (row * blocks_per_tile_row + column) * pixels_per_block, static_cast<std::int32_t>(i)};
    const std::uint32_t some = passed[block] != 0 ? 1 : 0;
    count += some;
    triangles |= some << i;
  });
  begin_records(group, small, triangles);
  return count;
}

/// The same for all samples.
template <class Format, class Func>
std::size_t test_samples(TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, const std::array<TileTarget, max_samples>& targets, SampleBlock* seen) {
  const RasterBinding& binding = *group.state->binding;
  alignas(64) std::uint64_t mask[max_samples][group_capacity] = {};
  for (std::size_t i = 0; i < group.count; ++i) {
    const SampleMasks masks = masks_of(*group.triangle[i], binding, group.vertex_bytes);
    for (std::size_t k = 0; k < max_samples; ++k) mask[k][i] = masks[k];
  }
  SmallGroup small;
  prepare_small_group(group, small);
  alignas(64) PassedBlocks passed[max_samples] = {};
  for (std::size_t k = 0; k < max_samples; ++k) {
    if ((binding.sample_mask >> k & 1) == 0) continue;
    place_small_group(group, mask[k], tile_x, tile_y, {targets[k].sample_x, targets[k].sample_y}, small);
    test_small_group<Format, Func>(small, writes_early(binding), tile_x, tile_y, targets[k], passed[k]);
  }

  std::size_t count = 0;
  std::uint32_t triangles = 0;
  for_each_block(group, small, [&](std::size_t i, std::int32_t column, std::int32_t row, std::size_t block) HWY_ATTR {
    std::uint64_t some = 0;
    for (std::size_t k = 0; k < max_samples; ++k) some |= seen[count].coverage[k] = passed[k][block];
    seen[count].x = tile_x + column * block_size;
    seen[count].y = tile_y + row * block_size;
    seen[count].first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block;
    seen[count].primitive = static_cast<std::int32_t>(i);
    count += some != 0 ? 1 : 0;
    triangles |= (some != 0 ? 1u : 0u) << i;
  });
  begin_records(group, small, triangles);
  return count;
}

struct SmallTriangleRoad {
  template <class Format, class Func>
  static SmallTriangleTests of() { return {test_group<Format, Func>, test_samples<Format, Func>}; }
};

SmallTriangleTests select_small_test(CompareFunc func, DepthFormat format) { return road_for<SmallTriangleRoad>(func, format); }

#else

SmallTriangleTests select_small_test(CompareFunc, DepthFormat) { return {}; }

#endif

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
SmallTriangleTests small_triangle_tests(CompareFunc func, DepthFormat format) { return GOURAUD_SIMD_PICK(select_small_test)(func, format); }
}  // namespace gouraud::pipeline
#endif
