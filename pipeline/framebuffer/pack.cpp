// Takes the tiled target, gives linear rows in a program's channel order [GL1.5 §4.3.2]. Leaves out changes of
// precision: read.h has those.
#include "pipeline/framebuffer/pack.h"

#include <cassert>
#include <cstring>

#include "pipeline/framebuffer/read.h"
#include "pipeline/framebuffer/tile_bands.h"

namespace gouraud::pipeline {
namespace {

// Colours become the nearest of 5 and 6 bits [GL1.5 §2.14.9].
// deviation: so do Mesa's clears and softpipe; llvmpipe's draws cut the low bits off (MESA-RULES 4.2).
void pack_rgb565(const std::byte* in, std::size_t count, std::byte* out) {
  const auto nearest = [](std::uint8_t value, unsigned most) { return (value * most + 127) / 255; };
  for (std::size_t i = 0; i < count; ++i) {
    std::uint8_t rgba[4];
    std::memcpy(rgba, in + i * sizeof rgba, sizeof rgba);
    const auto word = static_cast<std::uint16_t>(nearest(rgba[0], 31) << 11 | nearest(rgba[1], 63) << 5 | nearest(rgba[2], 31));
    std::memcpy(out + i * sizeof word, &word, sizeof word);
  }
}

// Three of four channels; the first comes from channel `first`, the third from channel 2 - first.
template <class Channel, std::size_t first>
void pack_three_of_four(const std::byte* in, std::size_t count, std::byte* out) {
  for (std::size_t i = 0; i < count; ++i) {
    Channel wide[4];
    std::memcpy(wide, in + i * sizeof wide, sizeof wide);
    const Channel packed[3] = {wide[first], wide[1], wide[2 - first]};
    std::memcpy(out + i * sizeof packed, packed, sizeof packed);
  }
}

template <int bytes_in, class Convert>
void convert_rows(const TiledBuffer& buffer, int x, int y, int count, int rows, std::byte* out, std::ptrdiff_t stride, int bytes_out,
                  const Convert& convert) {
  assert(buffer.bytes_per_pixel() == bytes_in);
  for_each_band(y, rows, out, stride, [&](int band_y, int band_rows, std::byte* band) {
    convert_band<bytes_in>(buffer, x, band_y, count, band_rows, band, stride, bytes_out, convert);
  });
}

}  // namespace

void pack_bytes(const Framebuffer& target, const ByteOrder& order, int bytes_per_pixel, int x, int y, int count, int rows, std::byte* out,
                std::ptrdiff_t row_stride_bytes) {
  if (bytes_per_pixel == 4 && order == same_order) return read_color_rows(target, x, y, count, rows, out, row_stride_bytes);
  const ByteArrangement how(order, 4, bytes_per_pixel);
  const auto whole = [&](const std::byte* pixels, int tile_rows, std::byte* to, std::ptrdiff_t stride) {
    arrange_tile_rows(how, pixels, tile_rows, to, stride);
  };
  const auto part = [&](const std::byte* pixels, std::size_t length, std::byte* to) { arrange_bytes(how, pixels, length, to); };
  for_each_band(y, rows, out, row_stride_bytes, [&](int band_y, int band_rows, std::byte* band) {
    for_each_tile(target.color, x, band_y, count, band_rows, band, row_stride_bytes, bytes_per_pixel, whole, part);
  });
}

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
  const int bytes = bytes_per_pixel(layout);
  const auto pack = [&](const ByteOrder& order) { pack_bytes(target, order, bytes, x, y, count, rows, out, row_stride_bytes); };
  const auto convert = [&]<int bytes_in>(const auto& function) {
    convert_rows<bytes_in>(target.color, x, y, count, rows, out, row_stride_bytes, bytes, function);
  };
  switch (layout) {
    case PackedLayout::rgba8:
    case PackedLayout::rgba16:
    case PackedLayout::rgba32f:
      return read_color_rows(target, x, y, count, rows, out, row_stride_bytes);
    case PackedLayout::bgra8:
      return pack(red_and_blue_swapped);
    case PackedLayout::argb8:
      return pack({{3, 0, 1, 2}});
    case PackedLayout::rgb8:
      return pack(same_order);
    case PackedLayout::bgr8:
      return pack(red_and_blue_swapped);
    case PackedLayout::rgb565:
      return convert.template operator()<4>(pack_rgb565);
    case PackedLayout::rgb16:
      return convert.template operator()<8>(pack_three_of_four<std::uint16_t, 0>);
    case PackedLayout::bgr16:
      return convert.template operator()<8>(pack_three_of_four<std::uint16_t, 2>);
    case PackedLayout::rgb32f:
      return convert.template operator()<16>(pack_three_of_four<float, 0>);
    case PackedLayout::bgr32f:
      return convert.template operator()<16>(pack_three_of_four<float, 2>);
  }
}

}  // namespace gouraud::pipeline
