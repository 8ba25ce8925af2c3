// Takes the blocks that a group of triangles covers, gives what the depth test leaves of them [GL1.5 §4.1.6], in order. The
// same arithmetic as the depth pass, bit by bit.
#include "pipeline/draw/group_depth.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pipeline/raster/polygons.h"
#include "pipeline/raster/triangles.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/draw/group_depth.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/block_depth-inl.h"
#include "pipeline/fragment/depth_formats-inl.h"
#include "pipeline/fragment/depth_pairs-inl.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR  // one lane at a time would gain nothing

/// Some of the listed blocks as test_pairs sees them.
class ListedBlocks {
 public:
  /// `count` is at most word_blocks.
  HWY_INLINE ListedBlocks(const TriangleGroup& group, const SeenBlock* blocks, std::size_t count, const TileTarget& target)
      : group_(group), blocks_(blocks), target_(target) {
    for (std::size_t n = 0; n < count; ++n) prepare(n);
  }
  HWY_INLINE const std::uint64_t* coverages() const { return coverage_.data(); }

  HWY_INLINE std::uint64_t coverage(std::size_t n) const { return coverage_[n]; }
  HWY_INLINE std::int32_t first_pixel(std::size_t n) const { return blocks_[n].first_pixel; }
  HWY_INLINE bool steep(std::size_t n) const { return (steep_ >> n & 1) != 0; }
  HWY_INLINE const BlockDepth& depth(std::size_t n) const { return depth_[n]; }
  void exact(std::size_t n, std::size_t pair, std::int32_t* out) const {
    exact_pair(plane(n), blocks_[n].x + double{target_.sample_x}, blocks_[n].y + static_cast<double>(2 * pair) + double{target_.sample_y}, out);
  }

 private:
  HWY_INLINE const DepthPlane& plane(std::size_t n) const { return group_.record(static_cast<std::size_t>(blocks_[n].primitive)).depth; }
  HWY_INLINE void prepare(std::size_t n) {
    coverage_[n] = blocks_[n].coverage;
    const DepthPlane& from = plane(n);
    if (HWY_UNLIKELY(from.steep)) {
      steep_ |= 1u << n;
      depth_[n] = {};
      return;
    }
    depth_[n] = depth_of_block(from, blocks_[n].x + double{target_.sample_x}, blocks_[n].y + double{target_.sample_y});
  }

  const TriangleGroup& group_;
  const SeenBlock* const blocks_;
  const TileTarget& target_;
  alignas(64) std::array<std::uint64_t, word_blocks> coverage_{};
  std::array<BlockDepth, word_blocks> depth_;
  std::uint32_t steep_ = 0;  ///< bit n: of block n
};

template <class Format, class Func>
std::size_t test_blocks(const TriangleGroup& group, SeenBlock* blocks, std::size_t count, const TileTarget& target) {
  const bool write = writes_early(*group.state->binding);
  std::size_t seen = 0;
  for (std::size_t first = 0; first < count; first += word_blocks) {
    const std::size_t some = std::min(word_blocks, count - first);
    const ListedBlocks listed(group, blocks + first, some, target);
    alignas(8) std::array<std::uint16_t, word_blocks * row_pairs> passed{};
    test_pairs<Format, Func>(listed, find_pairs(listed.coverages()), write, target.depth, passed.data());
    for (std::size_t n = 0; n < some; ++n) {
      SeenBlock block = blocks[first + n];
      std::memcpy(&block.coverage, passed.data() + n * row_pairs, sizeof block.coverage);
      blocks[seen] = block;
      seen += block.coverage != 0 ? 1 : 0;
    }
  }
  return seen;
}

struct GroupDepthRoad {
  template <class Format, class Func>
  static GroupDepthTest of() { return test_blocks<Format, Func>; }
};

GroupDepthTest select_group_test(CompareFunc func, DepthFormat format) { return road_for<GroupDepthRoad>(func, format); }

#else

GroupDepthTest select_group_test(CompareFunc, DepthFormat) { return nullptr; }

#endif

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {
GroupDepthTest group_depth_test(CompareFunc func, DepthFormat format) { return GOURAUD_SIMD_PICK(select_group_test)(func, format); }
}  // namespace gouraud::pipeline
#endif
