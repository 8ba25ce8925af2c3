// Takes the tiled target, gives linear rows of it [GL1.5 §4.3.2].
//
// Eight pixels of a block row are neighbours in memory, so a row is a walk over runs of at most eight pixels, and many
// rows are a walk over blocks. Everything a caller asks for is one of the two, with a conversion of a run.
#include "pipeline/framebuffer/read.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "pipeline/framebuffer/depth_values.h"
#include "pipeline/framebuffer/tile_bands.h"

namespace gouraud::pipeline {
namespace {

// Calls visit(pointer to the run's first pixel, its length) for the runs of row y that make up [x, x + count).
template <class Visit>
void for_each_run(const TiledBuffer& buffer, int x, int y, int count, Visit visit) {
  while (count > 0) {
    const int length = std::min(count, block_size - x % block_size);
    visit(buffer.pixel(x, y), length);
    x += length;
    count -= length;
  }
}

// Converts a row value by value. A whole run has a size known at compile time and becomes a few vector instructions.
template <class Stored, int values_per_pixel, class Out, class Convert>
void convert_row(const TiledBuffer& buffer, int x, int y, int count, Out* out, Convert convert) {
  for_each_run(buffer, x, y, count, [&](const std::byte* pixels, int length) {
    constexpr int most = block_size * values_per_pixel;
    Stored values[most] = {};
    Out converted[most];
    const auto given = static_cast<std::size_t>(length * values_per_pixel);
    std::memcpy(values, pixels, length == block_size ? sizeof values : given * sizeof(Stored));
    for (int i = 0; i < most; ++i) converted[i] = convert(values[i]);
    std::memcpy(out, converted, length == block_size ? sizeof converted : given * sizeof(Out));
    out += given;
  });
}

void copy_rows(const TiledBuffer& buffer, int x, int y, int count, int rows, std::byte* out, std::ptrdiff_t stride) {
  for_each_band(y, rows, out, stride, [&](int band_y, int band_rows, std::byte* band) {
    copy_band(buffer, x, band_y, count, band_rows, band, stride);
  });
}

// Clamps to [0, 1] (NaN gives 0), multiplies by 255 and rounds to nearest even: adding 1.5 * 2^23 leaves the rounded
// integer in the low bits of the float (MESA-RULES 4.2).
std::uint8_t unorm8_of_float(float value) {
  const float clamped = value > 0.0f ? (value < 1.0f ? value : 1.0f) : 0.0f;
  const float shifted = clamped * 255.0f + 12582912.0f;
  std::uint32_t bits;
  std::memcpy(&bits, &shifted, sizeof bits);
  return static_cast<std::uint8_t>(bits & 0xFFu);
}

// 65535 = 257 * 255, so a word's nearest byte is word / 257 to nearest; 257 is odd, there are no ties.
std::uint8_t unorm8_of_unorm16(std::uint16_t value) {
  return static_cast<std::uint8_t>((value + 128u) / 257u);
}

}  // namespace

void read_color_row(const Framebuffer& target, int x, int y, int count, void* out) {
  read_color_rows(target, x, y, count, 1, static_cast<std::byte*>(out), 0);
}

void read_color_rows(const Framebuffer& target, int x, int y, int count, int rows, std::byte* out,
                     std::ptrdiff_t row_stride_bytes) {
  copy_rows(target.color, x, y, count, rows, out, row_stride_bytes);
}

void read_depth_rows(const Framebuffer& target, int x, int y, int count, int rows, std::byte* out,
                     std::ptrdiff_t row_stride_bytes) {
  copy_rows(target.depth, x, y, count, rows, out, row_stride_bytes);
}

void read_depth_rows_float(const Framebuffer& target, int x, int y, int count, int rows, std::byte* out,
                           std::ptrdiff_t row_stride_bytes) {
  const auto read = [&]<int bytes_per_pixel>(const auto& convert) {
    for_each_band(y, rows, out, row_stride_bytes, [&](int band_y, int band_rows, std::byte* band) {
      convert_band<bytes_per_pixel>(target.depth, x, band_y, count, band_rows, band, row_stride_bytes, sizeof(float), convert);
    });
  };
  switch (target.depth_format) {
    case DepthFormat::none: return;
    case DepthFormat::z16: return read.template operator()<2>(depths_of_z16);
    case DepthFormat::z24s8: return read.template operator()<4>(depths_of_z24s8);
    case DepthFormat::z32: return read.template operator()<4>(depths_of_z32);
    case DepthFormat::z32f: return read_depth_rows(target, x, y, count, rows, out, row_stride_bytes);
  }
}

void read_color_row_float(const Framebuffer& target, int x, int y, int count, float* out_rgba) {
  switch (target.color_format) {
    case ColorFormat::none:
      std::fill_n(out_rgba, static_cast<std::size_t>(count) * 4, 0.0f);
      break;
    case ColorFormat::rgba8:
      convert_row<std::uint8_t, 4>(target.color, x, y, count, out_rgba,
                                   [](std::uint8_t value) { return static_cast<float>(value) * (1.0f / 255.0f); });
      break;
    case ColorFormat::rgba16:
      convert_row<std::uint16_t, 4>(target.color, x, y, count, out_rgba,
                                    [](std::uint16_t value) { return static_cast<float>(value) * (1.0f / 65535.0f); });
      break;
    case ColorFormat::rgba32f:
      read_color_row(target, x, y, count, out_rgba);
      break;
  }
}

void read_color_row_unorm8(const Framebuffer& target, int x, int y, int count, std::uint8_t* out_rgba) {
  switch (target.color_format) {
    case ColorFormat::none:
      std::fill_n(out_rgba, static_cast<std::size_t>(count) * 4, std::uint8_t{0});
      break;
    case ColorFormat::rgba8:
      read_color_row(target, x, y, count, out_rgba);
      break;
    case ColorFormat::rgba16:
      convert_row<std::uint16_t, 4>(target.color, x, y, count, out_rgba, unorm8_of_unorm16);
      break;
    case ColorFormat::rgba32f:
      convert_row<float, 4>(target.color, x, y, count, out_rgba, unorm8_of_float);
      break;
  }
}

void read_depth_row(const Framebuffer& target, int x, int y, int count, std::uint32_t* out) {
  assert(target.depth_format != DepthFormat::z32f);
  switch (target.depth_format) {
    case DepthFormat::z16:
      convert_row<std::uint16_t, 1>(target.depth, x, y, count, out,
                                    [](std::uint16_t value) { return std::uint32_t{value}; });
      break;
    case DepthFormat::z24s8:
      convert_row<std::uint32_t, 1>(target.depth, x, y, count, out,
                                    [](std::uint32_t word) { return word & 0xFFFFFFu; });
      break;
    case DepthFormat::z32:
      convert_row<std::uint32_t, 1>(target.depth, x, y, count, out, [](std::uint32_t value) { return value; });
      break;
    case DepthFormat::z32f:
    case DepthFormat::none:
      std::fill_n(out, count, 0u);
      break;
  }
}

void read_depth_row_float(const Framebuffer& target, int x, int y, int count, float* out) {
  switch (target.depth_format) {
    case DepthFormat::none:
      std::fill_n(out, count, 0.0f);
      break;
    case DepthFormat::z16:
      convert_row<std::uint16_t, 1>(target.depth, x, y, count, out,
                                    [](std::uint16_t value) { return static_cast<float>(value) / 65535.0f; });
      break;
    case DepthFormat::z24s8:  // 24 bits fit a signed integer, which every instruction set converts
      convert_row<std::uint32_t, 1>(target.depth, x, y, count, out, [](std::uint32_t word) {
        return static_cast<float>(static_cast<std::int32_t>(word & 0xFFFFFFu)) / 16777215.0f;
      });
      break;
    case DepthFormat::z32:
      convert_row<std::uint32_t, 1>(target.depth, x, y, count, out,
                                    [](std::uint32_t value) { return static_cast<float>(value / 4294967295.0); });
      break;
    case DepthFormat::z32f:
      read_depth_rows(target, x, y, count, 1, reinterpret_cast<std::byte*>(out), 0);
      break;
  }
}

void read_stencil_row(const Framebuffer& target, int x, int y, int count, std::uint8_t* out) {
  if (target.stencil_bits == 0) {
    std::fill_n(out, count, std::uint8_t{0});
  } else if (target.depth_format == DepthFormat::z24s8) {
    convert_row<std::uint32_t, 1>(target.depth, x, y, count, out,
                                  [](std::uint32_t word) { return static_cast<std::uint8_t>(word >> 24); });
  } else {
    convert_row<std::uint8_t, 1>(target.stencil, x, y, count, out, [](std::uint8_t value) { return value; });
  }
}

}  // namespace gouraud::pipeline
