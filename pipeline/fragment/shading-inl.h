// Shading a block from its primitive's ColorRecord, for kernels: included inside a kernel file, once per instruction set.
// Where the colours go is the affair of a Sink: constructed from a block and its target, it has
//   write(r, g, b, a, covered, lane): the lanes [lane, lane + Lanes), those of `covered` alive;
// where it takes pixels of packed bytes as they are, write_words(words, covered, lane) as well, and whole_block(), the pixels.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_SHADING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_SHADING_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_SHADING_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_SHADING_INL_H_
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "pipeline/fragment/image_colors-inl.h"
#include "pipeline/raster/interpolation-inl.h"
#include "pipeline/raster/primitive.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// The planes of a primitive's colour at one block.
struct BlockColor {
  alignas(32) float base[4];
  alignas(32) float dx[4], dy[4];

  HWY_INLINE BlockColor(const ColorRecord& color, std::int32_t x, std::int32_t y) {
    const hn::CappedTag<double, 4> d;
    const hn::Rebind<float, decltype(d)> df;
    const auto vx = hn::Set(d, static_cast<double>(x)), vy = hn::Set(d, static_cast<double>(y));
    for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
      const auto rise_x = hn::Load(d, color.dx.data() + i), rise_y = hn::Load(d, color.dy.data() + i);
      const auto value = hn::Add(hn::Add(hn::Load(d, color.origin.data() + i), hn::Mul(rise_x, vx)), hn::Mul(rise_y, vy));
      hn::Store(hn::DemoteTo(df, value), df, base + i);
      hn::Store(hn::DemoteTo(df, rise_x), df, dx + i);
      hn::Store(hn::DemoteTo(df, rise_y), df, dy + i);
    }
  }
  HWY_INLINE BlockPlane plane(std::size_t k) const { return {base[k], dx[k], dy[k]}; }
};

HWY_INLINE BlockPlane inverse_w_plane(const ColorRecord& color, std::int32_t x, std::int32_t y) {
  return {static_cast<float>((color.inverse_w_origin + color.inverse_w_dx * x) + color.inverse_w_dy * y),
          static_cast<float>(color.inverse_w_dx), static_cast<float>(color.inverse_w_dy)};
}

template <class Sink>
HWY_INLINE void write_constant(const FragmentBlock& block, const ColorRecord& color, const Sink& sink) {
  const FloatTag d;
  const FloatVector r = hn::Set(d, color.base[0]), g = hn::Set(d, color.base[1]);
  const FloatVector b = hn::Set(d, color.base[2]), a = hn::Set(d, color.base[3]);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t covered = lane_bits(block.coverage, lane);
    if (covered == 0) continue;
    sink.write(r, g, b, a, covered, lane);
  }
}

/// Bytes v become v * scale / 255: exactly the byte for targets of bytes, 257 v for 16 bits.
template <class Sink>
HWY_INLINE void write_image_bytes(const FragmentBlock& block, const ColorRecord& color, const Sink& sink) {
  const IntTag di;
  const FloatTag d;
  const PlacedImage& image = *block.primitive->binding->image;
  if constexpr (requires { sink.whole_block(); }) {
    if (has_whole_rows(image, block)) return copy_image_rows(image, block, sink.whole_block());
  }
  alignas(64) std::int32_t word[64];
  load_image_words(image, block, word);
  const FloatVector scale = hn::Set(d, color.base[0]), most = hn::Set(d, 255.0f);
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t covered = lane_bits(block.coverage, lane);
    if (covered == 0) continue;
    const IntVector words = hn::Load(di, word + lane), low = hn::Set(di, 0xFF);
    if constexpr (requires { sink.write_words(words, covered, lane); }) {
      sink.write_words(words, covered, lane);
      continue;
    }
    const auto channel = [&](IntVector bits) HWY_ATTR {
      return hn::Div(hn::Mul(hn::ConvertTo(d, hn::And(bits, low)), scale), most);
    };
    sink.write(channel(words), channel(hn::ShiftRight<8>(words)), channel(hn::ShiftRight<16>(words)),
               channel(hn::ShiftRight<24>(words)), covered, lane);
  }
}

template <class Sink>
HWY_INLINE void write_image_floats(const FragmentBlock& block, const ColorRecord& color, const Sink& sink) {
  const FloatTag d;
  alignas(64) float value[4][64];
  for_image_pixels(*block.primitive->binding->image, block, [&](std::int32_t lane, const std::byte* pixel) {
    float rgba[4];
    std::memcpy(rgba, pixel, sizeof rgba);
    for (std::size_t k = 0; k < 4; ++k) value[k][lane] = rgba[k] * color.base[0];
  });
  for (std::size_t lane = 0; lane < 64; lane += hn::Lanes(d)) {
    const std::uint64_t covered = lane_bits(block.coverage, lane);
    if (covered == 0) continue;
    const auto channel = [&](std::size_t k) HWY_ATTR { return hn::Load(d, value[k] + lane); };
    sink.write(channel(0), channel(1), channel(2), channel(3), covered, lane);
  }
}

/// A pixel rectangle's fragments; `base[0]` is the target's color_scale.
template <class Sink>
HWY_INLINE void write_image(const FragmentBlock& block, const ColorRecord& color, const Sink& sink) {
  if (block.primitive->binding->image->format == PixelImageFormat::rgba8) {
    write_image_bytes(block, color, sink);
  } else {
    write_image_floats(block, color, sink);
  }
}

template <class Sink, bool perspective, bool clamp, bool whole_block>
HWY_INLINE void write_lanes(const FragmentBlock& block, const ColorRecord& color, const Sink& sink) {
  const FloatTag d;
  const BlockColor planes(color, block.x, block.y);
  const BlockPlane red = planes.plane(0), green = planes.plane(1), blue = planes.plane(2), alpha = planes.plane(3);
  const BlockPlane inverse_w = perspective ? inverse_w_plane(color, block.x, block.y) : BlockPlane{};
  const PairRange pairs = whole_block ? PairRange{0, row_pairs} : covered_pairs(block.coverage);
  for (std::size_t offset = 0; offset < pair_lanes; offset += hn::Lanes(d)) {
    FloatVector r = first_pair(red, offset), g = first_pair(green, offset);
    FloatVector b = first_pair(blue, offset), a = first_pair(alpha, offset);
    FloatVector q = perspective ? first_pair(inverse_w, offset) : hn::Zero(d);
    for (std::size_t pair = 0; pair < pairs.end; ++pair) {
      if (whole_block || pair >= pairs.first) {
        const std::size_t first_lane = pair * pair_lanes + offset;
        const std::uint64_t covered = lane_bits(whole_block ? ~std::uint64_t{0} : block.coverage, first_lane);
        FloatVector w = q;
        if constexpr (perspective && clamp) {
          w = clamp_lanes(q, hn::Set(d, color.inverse_w_minimum), hn::Set(d, color.inverse_w_maximum));
        }
        if constexpr (perspective) w = hn::Div(hn::Set(d, 1.0f), w);
        const auto channel = [&](FloatVector value, std::size_t k) HWY_ATTR {
          if constexpr (perspective) value = hn::Add(hn::Mul(value, w), hn::Set(d, color.base[k]));
          if constexpr (clamp) value = clamp_lanes(value, hn::Set(d, color.minimum[k]), hn::Set(d, color.maximum[k]));
          return value;
        };
        sink.write(channel(r, 0), channel(g, 1), channel(b, 2), channel(a, 3), covered, first_lane);
      }
      r = hn::Add(r, pair_step(red));
      g = hn::Add(g, pair_step(green));
      b = hn::Add(b, pair_step(blue));
      a = hn::Add(a, pair_step(alpha));
      if constexpr (perspective) q = hn::Add(q, pair_step(inverse_w));
    }
  }
}

template <class Sink, bool perspective, bool clamp>
HWY_INLINE void write_varying(const FragmentBlock& block, const ColorRecord& color, const Sink& sink) {
  if (block.coverage == ~std::uint64_t{0}) {
    write_lanes<Sink, perspective, clamp, true>(block, color, sink);
  } else {
    write_lanes<Sink, perspective, clamp, false>(block, color, sink);
  }
}

template <class Sink>
void shade(FragmentBlock& block, const TileTarget& target) {
  const ColorRecord& color = color_of(*block.primitive);
  const Sink sink(block, target);
  switch (color.variation) {
    case ColorVariation::constant: return write_constant<Sink>(block, color, sink);
    case ColorVariation::image: return write_image<Sink>(block, color, sink);
    case ColorVariation::affine:
      return color.clamp ? write_varying<Sink, false, true>(block, color, sink)
                         : write_varying<Sink, false, false>(block, color, sink);
    case ColorVariation::perspective:
      return color.clamp ? write_varying<Sink, true, true>(block, color, sink)
                         : write_varying<Sink, true, false>(block, color, sink);
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
