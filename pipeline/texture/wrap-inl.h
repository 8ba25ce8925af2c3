// From texture coordinates to texels along one axis [GL1.5 §3.8.7, §3.8.8]; for kernels: included inside a kernel file,
// once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_WRAP_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_WRAP_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_WRAP_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_WRAP_INL_H_
#endif

#include <cstddef>
#include <cstdint>

#include "pipeline/draw/texture_state.h"
#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/simd/math-inl.h"
#include "pipeline/texture/texture_units.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Of an axis' part of an offset; three of them and any texel's offset still give a negative sum. An image has at most
/// 2^28 texels.
inline constexpr std::int32_t border_mark = -(1 << 29);

/// Clamp; NaN gives the lower bound.
HWY_INLINE FloatVector kept_between(FloatVector v, float low, float high) {
  const FloatTag d;
  return hn::Min(at_least(d, v, hn::Set(d, low)), hn::Set(d, high));
}

/// The texel coordinate u of s, before it is clamped. `scale` is the number of texels that s = 1 stands for.
template <WrapMode mode>
HWY_INLINE FloatVector wrapped(FloatVector s, float scale) {
  const FloatTag d;
  if constexpr (mode == WrapMode::repeat) s = hn::Sub(s, hn::Floor(s));
  if constexpr (mode == WrapMode::mirrored_repeat) {
    // The distance from the nearest even number.
    const FloatVector period = hn::Sub(s, hn::Mul(hn::Set(d, 2.0f), hn::Floor(hn::Mul(s, hn::Set(d, 0.5f)))));
    s = hn::Min(period, hn::Sub(hn::Set(d, 2.0f), period));
  }
  return hn::Mul(s, hn::Set(d, scale));
}

/// Where texels lie along an axis.
struct AxisAddress {
  enum class Layout : std::uint8_t { rows, tile_columns, tile_rows };
  Layout layout = Layout::rows;
  std::int32_t stride = 1;
  std::int32_t border = 0;  ///< of the image
  std::int32_t size = 1;
  bool marks = false;       ///< indices outside [0, size) mean the border colour

  HWY_INLINE IntVector operator()(IntVector index) const {
    const IntTag d;
    const IntVector place = border != 0 ? hn::Add(index, hn::Set(d, border)) : index;
    IntVector offset = place;
    if (layout == Layout::rows) {
      if (stride != 1) offset = hn::Mul(place, hn::Set(d, stride));
    } else {
      static_assert(tile_size == 64 && block_size == 8);
      const IntVector tile = hn::ShiftRight<6>(place), block = hn::And(place, hn::Set(d, 56)), lane = hn::And(place, hn::Set(d, 7));
      offset = layout == Layout::tile_columns
                   ? hn::Or(hn::ShiftLeft<12>(tile), hn::Or(hn::ShiftLeft<3>(block), lane))
                   : hn::Add(hn::Mul(tile, hn::Set(d, stride * pixels_per_tile)), hn::Or(hn::ShiftLeft<6>(block), hn::ShiftLeft<3>(lane)));
    }
    if (!marks) return offset;
    const auto outside = hn::Or(hn::Lt(index, hn::Zero(d)), hn::Gt(index, hn::Set(d, size - 1)));
    return hn::IfThenElse(outside, hn::Set(d, border_mark), offset);
  }
};

template <WrapMode mode>
HWY_INLINE void nearest_texels(const float* s, float scale, const AxisAddress& address, std::uint64_t lanes, AxisTexels& out) {
  const FloatTag d;
  const auto size = static_cast<float>(address.size);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    if (lane_bits(lanes, lane) == 0) continue;
    FloatVector u = wrapped<mode>(hn::Load(d, s + lane), scale);
    if constexpr (mode == WrapMode::clamp_to_border) {
      u = hn::Floor(kept_between(u, -1.0f, size));
    } else {
      u = kept_between(u, 0.0f, size - 0.5f);
    }
    hn::Store(address(hn::ConvertTo(IntTag(), u)), IntTag(), out.first.data() + lane);
  }
}

template <WrapMode mode>
HWY_INLINE void linear_texels(const float* s, float scale, const AxisAddress& address, std::uint64_t lanes, AxisTexels& out) {
  const FloatTag d;
  const IntTag di;
  constexpr bool to_edge = mode == WrapMode::clamp_to_edge || mode == WrapMode::mirrored_repeat;
  constexpr bool to_border = mode == WrapMode::clamp_to_border;
  const auto size = static_cast<float>(address.size);
  const float low = to_edge ? 0.0f : to_border ? -1.0f : -0.5f;
  const float high = to_edge ? size - 1.0f : to_border ? size : size - 0.5f;
  const IntVector one = hn::Set(di, 1), last = hn::Set(di, address.size - 1);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    if (lane_bits(lanes, lane) == 0) continue;
    const FloatVector u = kept_between(hn::Sub(wrapped<mode>(hn::Load(d, s + lane), scale), hn::Set(d, 0.5f)), low, high);
    const FloatVector floor = hn::Floor(u);
    IntVector first = hn::ConvertTo(di, floor);
    IntVector second = hn::Add(first, one);
    if constexpr (mode == WrapMode::repeat) {
      first = hn::IfThenElse(hn::Lt(first, hn::Zero(di)), last, first);
      second = hn::IfThenElse(hn::Gt(second, last), hn::Zero(di), second);
    } else {
      second = hn::Min(second, to_edge ? last : hn::Add(last, one));
    }
    hn::Store(hn::Sub(u, floor), d, out.weight.data() + lane);
    hn::Store(address(first), di, out.first.data() + lane);
    hn::Store(address(second), di, out.second.data() + lane);
  }
}

template <bool linear>
HWY_INLINE void axis_texels(WrapMode mode, const float* s, float scale, const AxisAddress& address, std::uint64_t lanes,
                            AxisTexels& out) {
  const auto run = [&]<WrapMode wrap>() HWY_ATTR {
    if constexpr (linear) linear_texels<wrap>(s, scale, address, lanes, out);
    else nearest_texels<wrap>(s, scale, address, lanes, out);
  };
  switch (mode) {
    case WrapMode::repeat: return run.template operator()<WrapMode::repeat>();
    case WrapMode::clamp: return run.template operator()<WrapMode::clamp>();
    case WrapMode::clamp_to_edge: return run.template operator()<WrapMode::clamp_to_edge>();
    case WrapMode::clamp_to_border: return run.template operator()<WrapMode::clamp_to_border>();
    case WrapMode::mirrored_repeat: return run.template operator()<WrapMode::mirrored_repeat>();
  }
}

/// Whether texels beyond the image's edge can be asked for.
HWY_INLINE bool can_leave(WrapMode mode, bool linear) {
  return mode == WrapMode::clamp_to_border || (linear && mode == WrapMode::clamp);
}

/// The address rule of axis k of a level.
HWY_INLINE AxisAddress address_of(const PreparedLevel& level, std::size_t k, bool leaves) {
  AxisAddress address;
  if (level.tiled && k < 2) address.layout = k == 0 ? AxisAddress::Layout::tile_columns : AxisAddress::Layout::tile_rows;
  address.stride = level.stride[k];
  address.border = level.border[k];
  address.size = level.size[k];
  address.marks = leaves && level.border[k] == 0;
  return address;
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
