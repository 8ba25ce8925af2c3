// Colours as the target stores them, and writing them under coverage and colour mask [GL1.5 §4.2.2]; for kernels:
// included inside a kernel file, once per instruction set.
#include <hwy/highway.h>

#if defined(GOURAUD_PIPELINE_FRAGMENT_PIXEL_WORDS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GOURAUD_PIPELINE_FRAGMENT_PIXEL_WORDS_INL_H_
#undef GOURAUD_PIPELINE_FRAGMENT_PIXEL_WORDS_INL_H_
#else
#define GOURAUD_PIPELINE_FRAGMENT_PIXEL_WORDS_INL_H_
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "pipeline/raster/fragment_block.h"
#include "pipeline/raster/interpolation-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {

/// Writes packed pixels of a block.
template <bool all_channels>
class Unorm8Writer {
 public:
  HWY_INLINE Unorm8Writer(const TileTarget& target, std::int32_t first_pixel, std::uint8_t write_mask)
      : pixels_(reinterpret_cast<std::int32_t*>(target.color) + first_pixel) {
    std::uint32_t bits = 0;
    for (std::uint32_t k = 0; k < 4; ++k) bits |= (write_mask >> k & 1u) != 0 ? 0xFFu << (8 * k) : 0u;
    channel_bits_ = static_cast<std::int32_t>(bits);
  }
  HWY_INLINE std::int32_t* pixels() const { return pixels_; }
  HWY_INLINE IntVector stored(std::size_t lane) const { return hn::Load(IntTag(), pixels_ + lane); }
  HWY_INLINE void put(IntVector packed, std::uint64_t covered, std::size_t lane) const {
    if constexpr (all_channels) {
      if (all_lanes(covered)) return hn::Store(packed, IntTag(), pixels_ + lane);
    }
    put_some(packed, covered, lane);
  }
  /// The same where small triangles are expected: whether all lanes are covered is hard to guess.
  HWY_INLINE void put_some(IntVector packed, std::uint64_t covered, std::size_t lane) const {
    const IntTag d;
    std::int32_t* const out = pixels_ + lane;
    const IntVector old = hn::Load(d, out);
    if constexpr (!all_channels) {
      const IntVector channels = hn::Set(d, channel_bits_);
      packed = hn::Or(hn::And(packed, channels), hn::AndNot(channels, old));
    }
    hn::Store(hn::IfThenElse(mask_of(d, covered), packed, old), d, out);
  }

 private:
  std::int32_t* pixels_;
  std::int32_t channel_bits_;
};

/// Writes pixels of a block one by one, for targets of 16-bit integers or of floats.
template <class Word>
class WideWriter {
 public:
  HWY_INLINE WideWriter(const TileTarget& target, std::int32_t first_pixel, std::uint8_t write_mask)
      : pixels_(reinterpret_cast<Word*>(target.color) + 4 * first_pixel), write_mask_(write_mask) {}
  static HWY_INLINE Word quantized(float value) {
    if constexpr (std::is_same_v<Word, float>) return value;
    else return static_cast<Word>(std::nearbyint(value));
  }
  HWY_INLINE Word stored(std::size_t lane, std::size_t k) const { return pixels_[4 * lane + k]; }
  HWY_INLINE void put(const std::array<Word, 4>& words, std::size_t lane) const {
    for (std::size_t k = 0; k < 4; ++k) {
      if ((write_mask_ >> k & 1u) != 0) pixels_[4 * lane + k] = words[k];
    }
  }
  HWY_INLINE void put(float r, float g, float b, float a, std::size_t lane) const {
    put({quantized(r), quantized(g), quantized(b), quantized(a)}, lane);
  }

 private:
  Word* pixels_;
  std::uint8_t write_mask_;
};

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
