// Takes a block and its primitive's colour planes, gives pixels, or colours in the block for passes that follow. Colours
// arrive scaled to the buffer's integers:
// float to 8 bits is clamp, times 255, round to nearest even (MESA-RULES 4.2). Setup has seen to it that a plane stays
// in range by itself, or has set `clamp`.
#include "pipeline/fragment/color_write.h"

#include <cstddef>

#include "pipeline/raster/primitive.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/fragment/color_write.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

#include "pipeline/fragment/pixel_words-inl.h"
#include "pipeline/fragment/shading-inl.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// 8-bit targets: four channels packed into one word a pixel.
template <bool all_channels>
struct Unorm8Sink {
  Unorm8Writer<all_channels> writer;
  HWY_INLINE Unorm8Sink(FragmentBlock& block, const TileTarget& target)
      : writer(target, block.first_pixel, block.primitive->binding->state.color_write_mask) {}
  HWY_INLINE void write(FloatVector r, FloatVector g, FloatVector b, FloatVector a, std::uint64_t covered,
                        std::size_t lane) const {
    writer.put(pack_unorm8(r, g, b, a), covered, lane);
  }
  HWY_INLINE void write_words(IntVector words, std::uint64_t covered, std::size_t lane) const { writer.put(words, covered, lane); }
  HWY_INLINE std::int32_t* whole_block() const requires all_channels { return writer.pixels(); }
};

/// Wider targets: four words a pixel, written lane by lane.
template <class Word>
struct WideSink {
  WideWriter<Word> writer;
  HWY_INLINE WideSink(FragmentBlock& block, const TileTarget& target)
      : writer(target, block.first_pixel, block.primitive->binding->state.color_write_mask) {}
  HWY_INLINE void write(FloatVector r, FloatVector g, FloatVector b, FloatVector a, std::uint64_t covered,
                        std::size_t lane) const {
    const FloatTag d;
    alignas(64) float values[4][16];
    hn::Store(r, d, values[0]);
    hn::Store(g, d, values[1]);
    hn::Store(b, d, values[2]);
    hn::Store(a, d, values[3]);
    for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
      if ((covered >> i & 1u) != 0) writer.put(values[0][i], values[1][i], values[2][i], values[3][i], lane + i);
    }
  }
};

/// The block itself, for passes that follow.
struct BlockSink {
  FragmentBlock& block;
  HWY_INLINE BlockSink(FragmentBlock& b, const TileTarget&) : block(b) {}
  HWY_INLINE void write(FloatVector r, FloatVector g, FloatVector b, FloatVector a, std::uint64_t, std::size_t lane) const {
    const FloatTag d;
    hn::Store(r, d, block.color[0].data() + lane);
    hn::Store(g, d, block.color[1].data() + lane);
    hn::Store(b, d, block.color[2].data() + lane);
    hn::Store(a, d, block.color[3].data() + lane);
  }
};

FragmentPass select(ColorFormat format, std::uint8_t write_mask) {
  switch (format) {
    case ColorFormat::rgba16: return shade<WideSink<std::uint16_t>>;
    case ColorFormat::rgba32f: return shade<WideSink<float>>;
    case ColorFormat::rgba8:
    case ColorFormat::none: break;
  }
  return write_mask == 0xF ? shade<Unorm8Sink<true>> : shade<Unorm8Sink<false>>;
}

FragmentPass select_interpolation() { return shade<BlockSink>; }

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

FragmentPass color_interpolation_pass() { return GOURAUD_SIMD_PICK(select_interpolation)(); }

FragmentPass color_write_pass(ColorFormat format, std::uint8_t write_mask) {
  return GOURAUD_SIMD_PICK(select)(format, write_mask);
}

float color_scale(ColorFormat format) {
  switch (format) {
    case ColorFormat::rgba8: return 255.0f;
    case ColorFormat::rgba16: return 65535.0f;
    case ColorFormat::rgba32f:
    case ColorFormat::none: break;
  }
  return 1.0f;
}

}  // namespace gouraud::pipeline
#endif
