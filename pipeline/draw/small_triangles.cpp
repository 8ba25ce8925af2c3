// Takes a group of small triangles (their pixels are known, triangles.h); gives what the depth test leaves of their blocks
// [GL1.5 §3.5.1, §4.1.6]. The same arithmetic as a triangle's record, a block of it and the depth pass, bit by bit.
//
// Why it pays: such a triangle has a handful of pixels in one to four blocks. Made one by one, each block costs a call, a
// plane at its corner in scalars and a guess at how many rows it has. Here all that a block needs is computed for a
// triangle a lane, and one loop runs over the row pairs that hold pixels, of all triangles of the group: a vector each.
// Only triangles that are seen get a record. (A sphere of 100,352 triangles: coverage and depth took 2.9 ms of 11.)
#include "pipeline/draw/small_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "pipeline/raster/polygons.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/draw/small_triangles.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/depth_formats-inl.h"
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

using U = hn::RebindToUnsigned<D>;
using UV = hn::Vec<U>;
using UI = hn::RebindToUnsigned<I>;

HWY_INLINE UV widened_int(IV v) { return hn::PromoteTo(U(), hn::BitCast(UI(), v)); }

/// Where a triangle's 8x8 pixels begin: block 0, which lies in the tile or right before it (-1), and a pixel of it.
struct Places {
  IV column, row, right, up;
};

/// The pixels in the four blocks: see cut_mask in polygons.cpp. Blocks outside the tile get none.
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

/// Depth at the first pixel of the four blocks: an integer and a float offset from it, as in depth.cpp.
HWY_INLINE void begin_blocks(const DepthLanes& depth, const Places& at, std::int32_t tile_x, std::int32_t tile_y,
                             std::size_t first, SmallGroup& out) {
  const D d;
  const F f;
  const PlaneLanes& plane = depth.plane;
  const V size = set(block_size);
  const auto place = [&](std::int32_t tile, IV block) HWY_ATTR {
    return hn::PromoteTo(d, hn::Add(set_int(tile), hn::Mul(block, set_int(block_size))));
  };
  const V x = place(tile_x, at.column), y = place(tile_y, at.row);
  const V rise_x[2] = {hn::Mul(plane.dx, x), hn::Mul(plane.dx, hn::Add(x, size))};
  const V rise_y[2] = {hn::Mul(plane.dy, y), hn::Mul(plane.dy, hn::Add(y, size))};
  const V minimum = hn::PromoteTo(d, depth.minimum), maximum = hn::PromoteTo(d, depth.maximum);
  for (std::size_t k = 0; k < blocks_of_triangle; ++k) {
    const V base = hn::Add(hn::Add(plane.origin, rise_x[k % 2]), rise_y[k / 2]), whole = hn::Round(base);
    hn::Store(hn::DemoteTo(f, hn::Sub(base, whole)), f, out.base[k] + first);
    hn::Store(hn::DemoteTo(f, hn::Sub(minimum, whole)), f, out.minimum[k] + first);
    hn::Store(hn::DemoteTo(f, hn::Sub(maximum, whole)), f, out.maximum[k] + first);
    hn::Store(hn::Sub(hn::DemoteTo(I(), whole), set_int(rounding_bits)), I(), out.whole[k] + first);
  }
  const auto dx = hn::DemoteTo(f, plane.dx), dy = hn::DemoteTo(f, plane.dy);
  hn::Store(dx, f, out.dx + first);
  hn::Store(dy, f, out.dy + first);
  hn::Store(hn::Add(dy, dy), f, out.step + first);
}

/// Everything that concerns triangles, one a lane.
void prepare_small_group(TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, SmallGroup& out) {
  const D d;
  const F f;
  const SetupState& state = *group.state;
  alignas(64) std::uint64_t mask[group_capacity];
  alignas(64) std::int32_t x[group_capacity], y[group_capacity];
  for (std::size_t i = 0; i < group_capacity; ++i) {
    const WaitingTriangle& triangle = *group.triangle[std::min(i, group.count - 1)];
    mask[i] = i < group.count ? triangle.mask : 0;
    x[i] = triangle.x0 - tile_x;
    y[i] = triangle.y0 - tile_y;
  }
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

    const IV in_tile_x = hn::Load(I(), x + first), in_tile_y = hn::Load(I(), y + first), in_block = set_int(block_size - 1);
    const Places at{hn::ShiftRight<3>(in_tile_x), hn::ShiftRight<3>(in_tile_y), hn::And(in_tile_x, in_block), hn::And(in_tile_y, in_block)};
    static_assert(block_size == 8);
    hn::Store(at.column, I(), out.column + first);
    hn::Store(at.row, I(), out.row + first);
    cut_masks(hn::Load(U(), mask + first), at, out.coverage.data() + blocks_of_triangle * first);
    begin_blocks(depth, at, tile_x, tile_y, first, out);
  }
}

/// One bit for each row pair of each block: set if it holds pixels.
struct PairBits {
  std::array<std::uint64_t, most_blocks * row_pairs / 64> word;
};
HWY_INLINE PairBits find_pairs(const SmallGroup& group) {
  const hn::CappedTag<std::uint16_t, 32> d;
  static_assert(pair_lanes == 16);
  const auto* halves = reinterpret_cast<const std::uint16_t*>(group.coverage.data());
  PairBits bits{};
  for (std::size_t i = 0; i < most_blocks * row_pairs; i += hn::Lanes(d)) {
    std::uint64_t found = 0;
    hn::StoreMaskBits(d, hn::Ne(hn::Load(d, halves + i), hn::Zero(d)), reinterpret_cast<std::uint8_t*>(&found));
    bits.word[i / 64] |= found << i % 64;
  }
  return bits;
}

/// Depths of a row pair, each pixel from the plane in double.
void exact_pair(const SmallGroup& group, std::size_t triangle, std::int32_t x, std::int32_t y, std::int32_t* depth) {
  const DepthPlane plane{group.origin[triangle], group.exact_dx[triangle], group.exact_dy[triangle]};
  for (std::int32_t lane = 0; lane < static_cast<std::int32_t>(pair_lanes); ++lane) {
    const double z = std::clamp<double>(plane_at(plane, x + lane % 8, y + lane / 8), group.least[triangle], group.most[triangle]);
    depth[lane] = static_cast<std::int32_t>(std::nearbyint(z));
  }
}

/// What passed: lists the blocks, in order, and begins the records of their triangles.
HWY_INLINE std::size_t list_seen(const TriangleGroup& group, const SmallGroup& small, const std::array<std::uint64_t, most_blocks>& passed,
                                 std::int32_t tile_x, std::int32_t tile_y, SeenBlock* seen) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < group.count; ++i) {
    const std::size_t before = count;
    for (std::size_t k = 0; k < blocks_of_triangle; ++k) {
      const std::int32_t column = small.column[i] + static_cast<std::int32_t>(k % 2), row = small.row[i] + static_cast<std::int32_t>(k / 2);
      const std::uint64_t coverage = passed[blocks_of_triangle * i + k];
      seen[count] = {coverage, tile_x + column * block_size, tile_y + row * block_size,
                     (row * blocks_per_tile_row + column) * pixels_per_block, static_cast<std::int32_t>(i)};
      count += coverage != 0 ? 1 : 0;
    }
    if (count != before) begin_record(group, i);
  }
  return count;
}

template <class Format, class Func>
std::size_t test_group(TriangleGroup& group, std::int32_t tile_x, std::int32_t tile_y, const TileTarget& target, SeenBlock* seen) {
  const IntTag di;
  const FloatTag df;
  SmallGroup small;
  prepare_small_group(group, tile_x, tile_y, small);
  const bool write = group.state->binding->state.depth.write_enabled;
  auto* const words = reinterpret_cast<typename Format::Word*>(target.depth);
  alignas(64) std::array<std::uint64_t, most_blocks> passed{};
  auto* const passed_pairs = reinterpret_cast<std::uint16_t*>(passed.data());
  const PairBits pairs = find_pairs(small);
  for (std::size_t w = 0; w < pairs.word.size(); ++w) {
    for (std::uint64_t left = pairs.word[w]; left != 0; left &= left - 1) {
      const std::size_t at = 64 * w + static_cast<std::size_t>(__builtin_ctzll(left));
      const std::size_t pair = at % row_pairs, block = at / row_pairs, k = block % blocks_of_triangle, i = block / blocks_of_triangle;
      const std::int32_t column = small.column[i] + static_cast<std::int32_t>(k % 2), row = small.row[i] + static_cast<std::int32_t>(k / 2);
      const std::int32_t first_pixel = (row * blocks_per_tile_row + column) * pixels_per_block + static_cast<std::int32_t>(pair * pair_lanes);
      const bool steep = (small.steep >> i & 1) != 0;
      alignas(64) std::int32_t exact[pair_lanes];
      if (HWY_UNLIKELY(steep)) {
        exact_pair(small, i, tile_x + column * block_size, tile_y + row * block_size + static_cast<std::int32_t>(2 * pair), exact);
      }
      const std::uint64_t covered = small.coverage[block] >> (pair * pair_lanes);
      // What a step adds for pairs behind the first, and nothing before.
      const float steps[2] = {0.0f, small.step[i]};
      std::uint64_t bits = 0;
      for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(di)) {
        FloatVector part = first_pair({small.base[k][i], small.dx[i], small.dy[i]}, offset);
        for (std::size_t p = 0; p + 1 < row_pairs; ++p) part = hn::Add(part, hn::Set(df, steps[pair > p ? 1 : 0]));
        const FloatVector clamped = clamp_lanes(part, hn::Set(df, small.minimum[k][i]), hn::Set(df, small.maximum[k][i]));
        IntVector z = hn::Add(bits_after_adding(rounding_magic, clamped), hn::Set(di, small.whole[k][i]));
        if (HWY_UNLIKELY(steep)) z = hn::Load(di, exact + offset);
        auto* const at_pixels = words + first_pixel + offset;
        const auto stored = Format::load(at_pixels);
        const auto passes = hn::And(Func::test(z, Format::depth(stored)), mask_of(di, lane_bits(covered, offset)));
        if (write) Format::store(hn::IfThenElse(passes, Format::merge(stored, z), stored), at_pixels);
        bits |= bits_of(di, passes) << offset;
      }
      passed_pairs[at] = static_cast<std::uint16_t>(bits);
    }
  }
  return list_seen(group, small, passed, tile_x, tile_y, seen);
}

template <class Format>
SmallTriangleTest test_for(CompareFunc func) {
  switch (func) {
    case CompareFunc::less: return test_group<Format, Less>;
    case CompareFunc::lequal: return test_group<Format, Lequal>;
    case CompareFunc::greater: return test_group<Format, Greater>;
    case CompareFunc::gequal: return test_group<Format, Gequal>;
    case CompareFunc::equal: return test_group<Format, Equal>;
    case CompareFunc::notequal: return test_group<Format, Notequal>;
    case CompareFunc::never: return nullptr;
    case CompareFunc::always: break;
  }
  return test_group<Format, Always>;
}

SmallTriangleTest select_small_test(CompareFunc func, DepthFormat format) {
  switch (format) {
    case DepthFormat::z16: return test_for<Z16>(func);
    case DepthFormat::z24s8: return test_for<Z24S8>(func);
    case DepthFormat::z32:
    case DepthFormat::z32f:
    case DepthFormat::none: break;
  }
  return nullptr;
}

#else

SmallTriangleTest select_small_test(CompareFunc, DepthFormat) { return nullptr; }

#endif

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
SmallTriangleTest small_triangle_test(CompareFunc func, DepthFormat format) { return GOURAUD_SIMD_PICK(select_small_test)(func, format); }
}  // namespace gouraud::pipeline
#endif
