// Takes the tiled target, gives linear rows in a program's channel order [GL1.5 §4.3.2].
//
// One block row, eight pixels, is converted at a time: a size known at compile time, so each converter's loop becomes
// a few vector instructions. Leaves out changes of precision: read.h has those.
#include "pipeline/framebuffer/pack.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "pipeline/framebuffer/read.h"

namespace gouraud::pipeline {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes R, G, B, A are a word with red in its low bits");

/// Converters work on one 32-bit word a pixel: `word` gives the pixel's new word.
struct Bgra8 {
  static constexpr std::uint32_t word(std::uint32_t rgba) {
    return (rgba & 0xFF00FF00u) | (rgba >> 16 & 0xFFu) | (rgba & 0xFFu) << 16;
  }
};
struct Argb8 {
  static constexpr std::uint32_t word(std::uint32_t rgba) { return rgba << 8 | rgba >> 24; }
};

template <class Order>
struct Words {
  static constexpr int bytes_in = 4, bytes_out = 4;
  static void run(const std::byte* in, std::byte* out) {
    std::uint32_t words[block_size];
    std::memcpy(words, in, sizeof words);
    for (std::uint32_t& word : words) word = Order::word(word);
    std::memcpy(out, words, sizeof words);
  }
};

// Drops the fourth byte of every pixel. Two pixels, a 64-bit word, become 48 bits; two of these, twelve bytes.
struct Rgb8 {
  static constexpr int bytes_in = 4, bytes_out = 3;
  static constexpr std::uint64_t joined(std::uint64_t pixels) {
    return (pixels & 0xFFFFFFu) | (pixels >> 8 & 0xFFFFFF000000u);
  }
  static void run(const std::byte* in, std::byte* out) {
    for (int i = 0; i < block_size / 4; ++i) {
      std::uint64_t pixels[2];
      std::memcpy(pixels, in + i * 16, sizeof pixels);
      const std::uint64_t first = joined(pixels[0]), second = joined(pixels[1]);
      const std::uint64_t low = first | second << 48;
      const auto high = static_cast<std::uint32_t>(second >> 16);
      std::memcpy(out + i * 12, &low, sizeof low);
      std::memcpy(out + i * 12 + 8, &high, sizeof high);
    }
  }
};

// The same after red and blue have changed places.
struct Bgr8 {
  static constexpr int bytes_in = 4, bytes_out = 3;
  static void run(const std::byte* in, std::byte* out) {
    std::byte swapped[block_size * 4];
    Words<Bgra8>::run(in, swapped);
    Rgb8::run(swapped, out);
  }
};

// The low bits are cut off, not rounded away (MESA-RULES 4.2).
struct Rgb565 {
  static constexpr int bytes_in = 4, bytes_out = 2;
  static void run(const std::byte* in, std::byte* out) {
    std::uint32_t words[block_size];
    std::uint16_t packed[block_size];
    std::memcpy(words, in, sizeof words);
    for (int i = 0; i < block_size; ++i) {
      packed[i] =
          static_cast<std::uint16_t>((words[i] & 0xF8u) << 8 | (words[i] >> 5 & 0x7E0u) | (words[i] >> 19 & 0x1Fu));
    }
    std::memcpy(out, packed, sizeof packed);
  }
};

// Three of four channels, each a Channel; the first comes from channel `first`, the third from channel 2 - first.
template <class Channel, int first>
struct ThreeOfFour {
  static constexpr int bytes_in = 4 * sizeof(Channel), bytes_out = 3 * sizeof(Channel);
  static void run(const std::byte* in, std::byte* out) {
    Channel wide[4 * block_size], packed[3 * block_size];
    std::memcpy(wide, in, sizeof wide);
    for (int i = 0; i < block_size; ++i) {
      packed[i * 3] = wide[i * 4 + first];
      packed[i * 3 + 1] = wide[i * 4 + 1];
      packed[i * 3 + 2] = wide[i * 4 + 2 - first];
    }
    std::memcpy(out, packed, sizeof packed);
  }
};

// A rectangle that begins or ends inside a block takes part of that block's row only.
template <class Converter>
void convert_part(const std::byte* in, std::byte* out, int length) {
  std::byte wide[block_size * Converter::bytes_in] = {}, packed[block_size * Converter::bytes_out];
  std::memcpy(wide, in, static_cast<std::size_t>(length) * Converter::bytes_in);
  Converter::run(wide, packed);
  std::memcpy(out, packed, static_cast<std::size_t>(length) * Converter::bytes_out);
}

template <class Converter>
void convert_rows(const TiledBuffer& buffer, int x, int y, int count, int rows, std::byte* out, std::ptrdiff_t stride) {
  assert(buffer.bytes_per_pixel() == Converter::bytes_in);
  while (rows > 0) {
    const int band = std::min(rows, block_size - y % block_size);
    std::byte* destination = out;
    for (int left = count, at = x; left > 0;) {
      const int length = std::min(left, block_size - at % block_size);
      const std::byte* pixels = buffer.pixel(at, y);
      for (int row = 0; row < band; ++row, pixels += block_size * Converter::bytes_in) {
        if (length == block_size) {
          Converter::run(pixels, destination + row * stride);
        } else {
          convert_part<Converter>(pixels, destination + row * stride, length);
        }
      }
      destination += length * Converter::bytes_out;
      at += length;
      left -= length;
    }
    out += band * stride;
    y += band;
    rows -= band;
  }
}

}  // namespace

ColorFormat stored_format(PackedLayout layout) {
  if (layout <= PackedLayout::rgb565) return ColorFormat::rgba8;
  return layout <= PackedLayout::bgr16 ? ColorFormat::rgba16 : ColorFormat::rgba32f;
}

int bytes_per_pixel(PackedLayout layout) {
  switch (layout) {
    case PackedLayout::rgb565:
      return 2;
    case PackedLayout::rgb8:
    case PackedLayout::bgr8:
      return 3;
    case PackedLayout::rgba8:
    case PackedLayout::bgra8:
    case PackedLayout::argb8:
      return 4;
    case PackedLayout::rgb16:
    case PackedLayout::bgr16:
      return 6;
    case PackedLayout::rgba16:
      return 8;
    case PackedLayout::rgb32f:
    case PackedLayout::bgr32f:
      return 12;
    case PackedLayout::rgba32f:
      return 16;
  }
  return 0;
}

void pack_color_rows(const Framebuffer& target, PackedLayout layout, int x, int y, int count, int rows, std::byte* out,
                     std::ptrdiff_t row_stride_bytes) {
  assert(target.color_format == stored_format(layout));
  const auto convert = [&]<class Converter>(Converter) {
    convert_rows<Converter>(target.color, x, y, count, rows, out, row_stride_bytes);
  };
  switch (layout) {
    case PackedLayout::rgba8:
    case PackedLayout::rgba16:
    case PackedLayout::rgba32f:
      return read_color_rows(target, x, y, count, rows, out, row_stride_bytes);
    case PackedLayout::bgra8:
      return convert(Words<Bgra8>{});
    case PackedLayout::argb8:
      return convert(Words<Argb8>{});
    case PackedLayout::rgb8:
      return convert(Rgb8{});
    case PackedLayout::bgr8:
      return convert(Bgr8{});
    case PackedLayout::rgb565:
      return convert(Rgb565{});
    case PackedLayout::rgb16:
      return convert(ThreeOfFour<std::uint16_t, 0>{});
    case PackedLayout::bgr16:
      return convert(ThreeOfFour<std::uint16_t, 2>{});
    case PackedLayout::rgb32f:
      return convert(ThreeOfFour<float, 0>{});
    case PackedLayout::bgr32f:
      return convert(ThreeOfFour<float, 2>{});
  }
}

}  // namespace gouraud::pipeline
