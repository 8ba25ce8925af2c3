// Takes pixels of one to four bytes, gives pixels of one to four bytes: four at a time, whose bytes one instruction puts
// where they go. Nothing outside a row is read or written.
#include "pipeline/framebuffer/byte_orders.h"

#include <cstring>

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/simd/dispatch.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/framebuffer/byte_orders.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gouraud::pipeline::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void arrange_one_by_one(const ByteArrangement& how, const std::byte* in, std::size_t pixels, std::byte* out) {
  for (std::size_t i = 0; i < pixels; ++i, in += how.bytes_in, out += how.bytes_out) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(how.bytes_out); ++k) {
      const std::int8_t source = how.order.source[k];
      out[k] = source >= 0 ? in[source] : source == ByteOrder::full ? std::byte{255} : std::byte{0};
    }
  }
}

#if HWY_TARGET == HWY_SCALAR  // has no vectors of bytes

void arrange(const ByteArrangement& how, const std::byte* in, std::size_t pixels, std::byte* out) {
  arrange_one_by_one(how, in, pixels, out);
}

void arrange_runs(const ByteArrangement& how, const std::byte* pixels, int rows, std::byte* out, std::ptrdiff_t stride) {
  for (int row = 0; row < rows; ++row, pixels += block_size * 4, out += stride) {
    for (int i = 0; i < blocks_per_tile_row; ++i) {
      arrange_one_by_one(how, pixels + i * pixels_per_block * 4, block_size, out + i * block_size * how.bytes_out);
    }
  }
}

#else

/// The vector's bytes, arranged.
template <class D>
struct Arranged {
  D d;
  hn::Vec<D> place, bits;
  HWY_INLINE explicit Arranged(D tag, const ByteArrangement& how)
      : d(tag), place(hn::LoadDup128(d, how.place.data())), bits(hn::LoadDup128(d, how.bits.data())) {}
  HWY_INLINE hn::Vec<D> operator()(const std::uint8_t* in) const {
    return hn::Or(hn::TableLookupBytesOr0(hn::LoadU(d, in), place), bits);
  }
};

/// As far as the 16 bytes read and written lie inside the row; gives how many pixels that were.
template <class D>
HWY_INLINE std::size_t arrange_vectors(D d, const ByteArrangement& how, const std::uint8_t* in, std::size_t pixels, std::uint8_t* out) {
  const Arranged<D> arranged(d, how);
  const auto from = static_cast<std::size_t>(how.bytes_in), to = static_cast<std::size_t>(how.bytes_out);
  const std::size_t step = hn::Lanes(d) / 4, narrow = from < to ? from : to, room = (hn::Lanes(d) + narrow - 1) / narrow;
  std::size_t left = pixels;
  for (; left >= room; left -= step, in += step * from, out += step * to) hn::StoreU(arranged(in), d, out);
  return pixels - left;
}

void arrange(const ByteArrangement& how, const std::byte* in, std::size_t pixels, std::byte* out) {
  const bool words = how.bytes_in == 4 && how.bytes_out == 4;
  const auto* const source = reinterpret_cast<const std::uint8_t*>(in);
  auto* const target = reinterpret_cast<std::uint8_t*>(out);
  const std::size_t done = words ? arrange_vectors(hn::ScalableTag<std::uint8_t>(), how, source, pixels, target)
                                 : arrange_vectors(hn::Full128<std::uint8_t>(), how, source, pixels, target);
  arrange_one_by_one(how, in + done * static_cast<std::size_t>(how.bytes_in), pixels - done,
                     out + done * static_cast<std::size_t>(how.bytes_out));
}

/// A run of eight pixels in a block becomes eight words.
void arrange_runs_of_words(const ByteArrangement& how, const std::uint8_t* pixels, int rows, std::uint8_t* out, std::ptrdiff_t stride) {
  constexpr std::size_t run = block_size * 4, block = pixels_per_block * 4;
  const hn::CappedTag<std::uint8_t, run> d;
  const Arranged<decltype(d)> arranged(d, how);
  for (int row = 0; row < rows; ++row, pixels += run, out += stride) {
    for (std::size_t i = 0; i < blocks_per_tile_row; ++i) {
      for (std::size_t k = 0; k < run; k += hn::Lanes(d)) hn::StoreU(arranged(pixels + i * block + k), d, out + i * run + k);
    }
  }
}

/// Four pixels are stored as 16 bytes, of which the next four overwrite what is too much; the last two runs of a row by way
/// of memory.
void arrange_runs(const ByteArrangement& how, const std::byte* pixels, int rows, std::byte* out, std::ptrdiff_t stride) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(pixels);
  auto* to = reinterpret_cast<std::uint8_t*>(out);
  if (how.bytes_out == 4) return arrange_runs_of_words(how, from, rows, to, stride);
  constexpr std::size_t run = block_size * 4, block = pixels_per_block * 4;
  const hn::Full128<std::uint8_t> d;
  const Arranged<decltype(d)> arranged(d, how);
  const std::size_t four = 4 * static_cast<std::size_t>(how.bytes_out);
  for (int row = 0; row < rows; ++row, from += run, to += stride) {
    const auto store_run = [&](std::size_t i, std::uint8_t* at) HWY_ATTR {
      hn::StoreU(arranged(from + i * block), d, at);
      hn::StoreU(arranged(from + i * block + 16), d, at + four);
    };
    constexpr std::size_t direct = blocks_per_tile_row - 2;
    for (std::size_t i = 0; i < direct; ++i) store_run(i, to + i * 2 * four);
    std::uint8_t last[64];
    store_run(direct, last);
    store_run(direct + 1, last + 2 * four);
    std::memcpy(to + direct * 2 * four, last, 4 * four);
  }
}

#endif

}  // namespace gouraud::pipeline::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gouraud::pipeline {

ByteArrangement::ByteArrangement(const ByteOrder& byte_order, int in, int out) : order(byte_order), bytes_in(in), bytes_out(out) {
  constexpr std::uint8_t nothing = 0x80;
  std::size_t i = 0;
  for (int first = 0; first < 4 * in; first += in) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(out); ++k, ++i) {
      const std::int8_t source = order.source[k];
      place[i] = source >= 0 ? static_cast<std::uint8_t>(first + source) : nothing;
      bits[i] = source == ByteOrder::full ? 255 : 0;
    }
  }
}

void arrange_bytes(const ByteArrangement& arrangement, const std::byte* in, std::size_t pixels, std::byte* out) {
  if (arrangement.bytes_in == 4 && arrangement.bytes_out == 4 && arrangement.order == same_order) {
    std::memcpy(out, in, 4 * pixels);
  } else {
    GOURAUD_SIMD_PICK(arrange)(arrangement, in, pixels, out);
  }
}

void arrange_tile_rows(const ByteArrangement& arrangement, const std::byte* pixels, int rows, std::byte* out, std::ptrdiff_t stride) {
  GOURAUD_SIMD_PICK(arrange_runs)(arrangement, pixels, rows, out, stride);
}

}  // namespace gouraud::pipeline
#endif
