// Texels that lie in the tiles of a framebuffer's attachment; for kernels: included inside a kernel file, once per instruction
// set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_TEXTURE_TILES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_TEXTURE_TILES_INL_H_
#undef GOURAUD_PIPELINE_TEXTURE_TILES_INL_H_
#else
#define GOURAUD_PIPELINE_TEXTURE_TILES_INL_H_
#endif

#include <cstdint>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Tiles that a cleared framebuffer owes its pixels (TiledBuffer) get them before these lanes' texels are read; negative
/// offsets are none. `last` is the tile that was asked for last: neighbours mostly lie in the same.
HWY_INLINE void make_tiles_readable(const TiledBuffer& tiles, IntVector offset, std::uint64_t lanes, std::int32_t& last) {
  const IntTag d;
  static_assert(pixels_per_tile == 1 << 12);
  const IntVector tile = hn::ShiftRight<12>(offset);
  lanes &= ~bits_of(d, hn::Or(hn::Lt(tile, hn::Zero(d)), hn::Eq(tile, hn::Set(d, last))));
  if (HWY_LIKELY(lanes == 0)) return;
  alignas(64) std::int32_t of_lane[pair_lanes];
  hn::Store(tile, d, of_lane);
  while (lanes != 0) {
    last = of_lane[hwy::Num0BitsBelowLS1Bit_Nonzero64(lanes)];
    tiles.make_readable(last);
    lanes &= ~bits_of(d, hn::Eq(tile, hn::Set(d, last)));
  }
}

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
