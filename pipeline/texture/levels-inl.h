// From a block's texture coordinates to the levels that its lanes read [GL1.5 §3.8.8, §3.8.9]; for kernels: included inside
// a kernel file, once per instruction set. Levels are read one at a time, for all lanes that need them: a block in which
// every lane has the same level reads it without asking lane by lane.
// choice: magnification begins at lambda = 0 whatever the filters are, as Mesa has it, and not at 1/2 for NEAREST_MIPMAP
// minification with LINEAR magnification [GL1.5 §3.8.9].
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_LEVELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_LEVELS_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_LEVELS_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_LEVELS_INL_H_
#endif

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/texture/lod-inl.h"
#include "pipeline/texture/texture_units.h"
#include "pipeline/texture/wrap-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

HWY_INLINE const TextureCoordinateLayout& layout_of(const FragmentBlock& block, const PreparedUnit& unit) {
  return block.primitive->binding->varyings.texture_coordinates[unit.state.unit];
}

/// The coordinates of a unit, divided by q if it has one.
struct DividedCoordinates {
  alignas(64) float lanes[3][64];
  std::array<const float*, 3> coordinate{};

  HWY_INLINE DividedCoordinates(const FragmentBlock& block, const TextureCoordinateLayout& layout) {
    const FloatTag d;
    const auto first = static_cast<std::size_t>(layout.first), count = static_cast<std::size_t>(layout.dimensions);
    for (std::size_t k = 0; k < count; ++k) coordinate[k] = block.varying[first + k].data();
    if (!layout.has_q) return;
    const PairRange pairs = covered_pairs(block.coverage);
    for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes; lane += hn::Lanes(d)) {
      const FloatVector q = hn::Load(d, block.varying[first + count].data() + lane);
      for (std::size_t k = 0; k < count; ++k) hn::Store(hn::Div(hn::Load(d, coordinate[k] + lane), q), d, lanes[k] + lane);
    }
    for (std::size_t k = 0; k < count; ++k) coordinate[k] = lanes[k];
  }
};

/// The level that a LOD selects (below it, for a linear filter between levels), relative to the base level.
HWY_INLINE float selected_level(MipFilter filter, float lod, float last) {
  // [GL1.5 §3.8.8 eq 3.23]: lambda + 1/2 rounded up, minus 1. [eq 3.24]: rounded down.
  const FloatTag d;
  const FloatVector v = hn::Set(d, lod);
  const FloatVector level = filter == MipFilter::nearest ? hn::Sub(hn::Ceil(hn::Add(v, hn::Set(d, 0.5f))), hn::Set(d, 1.0f)) : hn::Floor(v);
  return hn::GetLane(kept_between(level, 0.0f, last));
}

/// Lanes whose value equals.
HWY_INLINE std::uint64_t lanes_equal(const float* values, float value) {
  const FloatTag d;
  std::uint64_t lanes = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    lanes |= bits_of(d, hn::Eq(hn::Load(d, values + lane), hn::Set(d, value))) << lane;
  }
  return lanes;
}
HWY_INLINE std::uint64_t lanes_above(const float* values, float value) {
  const FloatTag d;
  std::uint64_t lanes = 0;
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    lanes |= bits_of(d, hn::Gt(hn::Load(d, values + lane), hn::Set(d, value))) << lane;
  }
  return lanes;
}

HWY_INLINE std::uint64_t lanes_above_zero(const float* values) { return lanes_above(values, 0.0f); }

// A Reader reads levels of one unit's texture into its own output:
//   read(index, filter, lanes, keeps_others)       one level
//   read_two(index, share, lanes, keeps_others)    levels index and index + 1, of which `share` counts, minified
// `keeps_others`: lanes besides keep what the output holds.

/// Reads minified lanes: the levels that their LODs select, mixed if the filter is linear between levels.
template <class Reader>
HWY_INLINE void read_minified(const PreparedUnit& unit, Reader& reader, float lowest, float highest, float* lod, std::uint64_t lanes,
                              bool keeps_others) {
  const FloatTag d;
  const SamplerState& sampler = unit.state.sampler;
  const auto last = static_cast<float>(unit.level_count - 1);
  alignas(64) float levels[64];
  const float first_level = selected_level(sampler.mip, lowest, last), last_level = selected_level(sampler.mip, highest, last);
  const bool one_level = first_level == last_level;
  const bool mixes = sampler.mip == MipFilter::linear;

  // The level of each lane; its LOD becomes the share of the next level.
  const PairRange pairs = covered_pairs(lanes);
  for (std::size_t lane = pairs.first * pair_lanes; lane < pairs.end * pair_lanes && (mixes || !one_level); lane += hn::Lanes(d)) {
    const FloatVector v = hn::Load(d, lod + lane);
    if (one_level) {
      hn::Store(clamp_lanes(hn::Sub(v, hn::Set(d, first_level)), hn::Zero(d), hn::Set(d, 1.0f)), d, lod + lane);
      continue;
    }
    const FloatVector level = mixes ? hn::Floor(v) : hn::Sub(hn::Ceil(hn::Add(v, hn::Set(d, 0.5f))), hn::Set(d, 1.0f));
    const FloatVector kept = kept_between(level, first_level, last_level);
    hn::Store(kept, d, levels + lane);
    if (mixes) hn::Store(clamp_lanes(hn::Sub(v, kept), hn::Zero(d), hn::Set(d, 1.0f)), d, lod + lane);
  }
  for (std::uint64_t left = lanes; left != 0;) {
    const float level = one_level ? first_level : levels[hwy::Num0BitsBelowLS1Bit_Nonzero64(left)];
    const std::uint64_t group = one_level ? left : left & lanes_equal(levels, level);
    const bool part = keeps_others || group != lanes;
    const auto index = static_cast<std::int32_t>(level);
    if (mixes && index + 1 < unit.level_count) reader.read_two(index, lod, group, part);
    else reader.read(index, sampler.minify, group, part);
    left &= ~group;
  }
}

/// Whether the level of detail makes no difference.
HWY_INLINE bool needs_no_lod(const SamplerState& sampler) {
  return sampler.mip == MipFilter::none && sampler.minify == sampler.magnify;
}

HWY_INLINE std::array<float, 3> base_size(const PreparedUnit& unit) {
  std::array<float, 3> size{};
  for (std::size_t k = 0; k < static_cast<std::size_t>(unit.dimensions); ++k) {
    size[k] = unit.state.target == TextureTarget::rectangle ? 1.0f : static_cast<float>(unit.level(0, 0).size[k]);
  }
  return size;
}

/// Magnified and minified lanes of one face.
template <class Reader>
HWY_INLINE void read_levels(const PreparedUnit& unit, Reader& reader, const CoordinatePlanes& planes, std::uint64_t lanes, bool keeps_others) {
  const FloatTag d;
  const SamplerState& sampler = unit.state.sampler;
  const BlockLod lod(planes, base_size(unit));
  const auto adjusted = [&](FloatVector v) HWY_ATTR {
    return kept_between(hn::Add(v, hn::Set(d, sampler.lod_bias)), sampler.min_lod, sampler.max_lod);
  };
  const float lowest = hn::GetLane(adjusted(hn::Set(d, lod.lowest()))), highest = hn::GetLane(adjusted(hn::Set(d, lod.highest())));
  if (highest <= 0.0f) return reader.read(0, sampler.magnify, lanes, keeps_others);
  if (sampler.mip == MipFilter::none && lowest > 0.0f) return reader.read(0, sampler.minify, lanes, keeps_others);

  alignas(64) float lambda[64];
  lod.lanes(covered_pairs(lanes), lambda, adjusted);
  const std::uint64_t minified = sampler.minify == sampler.magnify ? lanes : lanes & lanes_above_zero(lambda);
  if (minified != lanes) {
    reader.read(0, sampler.magnify, lanes & ~minified, keeps_others);
    keeps_others = true;
  }
  if (minified == 0) return;
  if (sampler.mip == MipFilter::none) return reader.read(0, sampler.minify, minified, keeps_others);
  read_minified(unit, reader, lowest, highest, lambda, minified, keeps_others);
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
