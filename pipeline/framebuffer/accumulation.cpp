// Takes a tile's colours and sums, gives new sums, or colours from them [GL1.5 §4.2.4].
//
// Colours and sums lie in the same order, four channels a pixel, so one loop over channels serves all formats; the colour
// mask is a pattern that repeats with every pixel.
#include "pipeline/framebuffer/accumulation.h"

#include <array>
#include <cstddef>
#include <cstdint>

#include "pipeline/framebuffer/tile_runs.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/framebuffer/accumulation.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A vector is one pixel: runs end at any pixel, and memory is the bottleneck.
using FloatTag = hn::CappedTag<float, 4>;
using FloatVector = hn::Vec<FloatTag>;

HWY_INLINE FloatVector within(FloatVector v, float low, float high) {
  const FloatTag d;
  return hn::Min(hn::Max(v, hn::Set(d, low)), hn::Set(d, high));
}

/// How a stored channel becomes a number in [0, largest], and back.
template <class Channel>
struct Stored {
  static constexpr float largest = sizeof(Channel) == 1 ? 255.0f : 65535.0f;
  using Tag = hn::Rebind<Channel, FloatTag>;
  static HWY_INLINE FloatVector load(const Channel* p) {
    return hn::ConvertTo(FloatTag(), hn::PromoteTo(hn::RebindToSigned<FloatTag>(), hn::Load(Tag(), p)));
  }
  static HWY_INLINE void store(FloatVector v, const Channel* mask, Channel* p) {
    const Tag d;
    const auto rounded = hn::DemoteTo(d, hn::NearestInt(v)), written = hn::Load(d, mask);
    hn::Store(hn::Or(hn::And(rounded, written), hn::AndNot(written, hn::Load(d, p))), d, p);
  }
};
template <>
struct Stored<float> {
  static constexpr float largest = 1.0f;
  static HWY_INLINE FloatVector load(const float* p) { return hn::Load(FloatTag(), p); }
  static HWY_INLINE void store(FloatVector v, const float* mask, float* p) {
    const FloatTag d;
    hn::Store(hn::IfThenElse(hn::Ne(hn::Load(d, mask), hn::Zero(d)), v, hn::Load(d, p)), d, p);
  }
};

/// Calls each(offset) for every vector of `channels` channels.
template <class Each>
HWY_INLINE void for_each_vector(std::size_t channels, const Each& each) {
  for (std::size_t i = 0; i < channels; i += hn::Lanes(FloatTag())) each(i);
}

/// Loads colours into the sums, replacing or adding.
template <class Channel, bool adds>
HWY_INLINE void take_colors(const Channel* colors, float* sums, std::size_t channels, float value) {
  const FloatTag d;
  const FloatVector factor = hn::Set(d, value / Stored<Channel>::largest);
  for_each_vector(channels, [&](std::size_t i) HWY_ATTR {
    FloatVector sum = hn::Mul(Stored<Channel>::load(colors + i), factor);
    if constexpr (adds) sum = hn::Add(sum, hn::Load(d, sums + i));
    hn::Store(within(sum, -1.0f, 1.0f), d, sums + i);
  });
}

template <class Channel>
HWY_INLINE void give_colors(Channel* colors, const Channel* mask, const float* sums, std::size_t channels, float value) {
  const FloatTag d;
  const FloatVector factor = hn::Set(d, value), largest = hn::Set(d, Stored<Channel>::largest);
  for_each_vector(channels, [&](std::size_t i) HWY_ATTR {
    const FloatVector color = within(hn::Mul(hn::Load(d, sums + i), factor), 0.0f, 1.0f);
    Stored<Channel>::store(hn::Mul(color, largest), mask + i % 4, colors + i);
  });
}

HWY_INLINE void change_sums(float* sums, std::size_t channels, float factor, float summand) {
  const FloatTag d;
  for_each_vector(channels, [&](std::size_t i) HWY_ATTR {
    const FloatVector sum = hn::Add(hn::Mul(hn::Load(d, sums + i), hn::Set(d, factor)), hn::Set(d, summand));
    hn::Store(within(sum, -1.0f, 1.0f), d, sums + i);
  });
}

/// What one operation does to a run of pixels.
template <class Channel>
HWY_INLINE void accumulate_run(const AccumState& state, const Channel* mask, Channel* colors, float* sums,
                               std::size_t channels) {
  switch (state.op) {
    case AccumOp::accumulate: return take_colors<Channel, true>(colors, sums, channels, state.value);
    case AccumOp::load: return take_colors<Channel, false>(colors, sums, channels, state.value);
    case AccumOp::add: return change_sums(sums, channels, 1.0f, state.value);
    case AccumOp::multiply: return change_sums(sums, channels, state.value, 0.0f);
    case AccumOp::give_back: return give_colors<Channel>(colors, mask, sums, channels, state.value);
  }
}

template <class Channel>
void accumulate(const Framebuffer& target, const TileCut& tile, const AccumState& state) {
  alignas(16) std::array<Channel, 4> mask;
  for (std::size_t k = 0; k < 4; ++k) {
    mask[k] = (state.color_write_mask >> k & 1) != 0 ? static_cast<Channel>(-1) : Channel{0};
  }
  auto* const colors = reinterpret_cast<Channel*>(target.color.tile(tile.tile_x, tile.tile_y));
  auto* const sums = reinterpret_cast<float*>(target.accum.tile(tile.tile_x, tile.tile_y));
  for_each_run(tile.of(target.accum), [&](std::int32_t first, std::int32_t count) HWY_ATTR {
    const auto channel = 4 * static_cast<std::size_t>(first);
    accumulate_run(state, mask.data(), colors + channel, sums + channel, 4 * static_cast<std::size_t>(count));
  });
}

void accumulate_format(const Framebuffer& target, const TileCut& tile, const AccumState& state) {
  switch (target.color_format) {
    case ColorFormat::rgba8: return accumulate<std::uint8_t>(target, tile, state);
    case ColorFormat::rgba16: return accumulate<std::uint16_t>(target, tile, state);
    case ColorFormat::rgba32f: return accumulate<float>(target, tile, state);
    case ColorFormat::none: break;
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

void accumulate_tile(const Framebuffer& target, std::int32_t tile_index, const AccumState& state) {
  GOURAUD_SIMD_PICK(accumulate_format)(target, TileCut(target, tile_index, state.scissor), state);
}

}  // namespace gouraud::pipeline
#endif
