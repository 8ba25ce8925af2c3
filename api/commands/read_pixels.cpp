// Takes a rectangle of the target, gives it to client memory: colour as bytes and floats, depth as unsigned integers
// and floats, stencil as bytes [GL1.5 §4.3.2, Tables 3.5, 3.6 and 4.6].
//
// choice: pixels outside the target, undefined by the specification, leave client memory as it is; Mesa's too.
// choice: float colour from a float target is not clamped; nothing outside [0, 1] can have been stored.
// Leaves out pixel transfer and the other types.
#include "api/commands/read_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "api/commands/pixel_store.h"
#include "pipeline/framebuffer/pack.h"
#include "pipeline/framebuffer/read.h"

namespace gouraud::api {
namespace {

using pipeline::ColorFormat;
using pipeline::DepthFormat;
using pipeline::Framebuffer;
using pipeline::PackedLayout;

/// Where a pixel's elements come from: 0 to 3 are R, G, B, A; `luminance` is R + G + B.
constexpr int luminance = 4;
struct Channels {
  int count = 0;
  std::array<int, 4> source{};
};

std::optional<Channels> channels_of(GLenum format) {
  switch (format) {
    case GL_RED:
      return Channels{1, {0}};
    case GL_GREEN:
      return Channels{1, {1}};
    case GL_BLUE:
      return Channels{1, {2}};
    case GL_ALPHA:
      return Channels{1, {3}};
    case GL_RGB:
      return Channels{3, {0, 1, 2}};
    case GL_BGR:
      return Channels{3, {2, 1, 0}};
    case GL_RGBA:
      return Channels{4, {0, 1, 2, 3}};
    case GL_BGRA:
      return Channels{4, {2, 1, 0, 3}};
    case GL_LUMINANCE:
      return Channels{1, {luminance}};
    case GL_LUMINANCE_ALPHA:
      return Channels{2, {luminance, 3}};
    default:
      return std::nullopt;
  }
}

bool is_format(GLenum format) {
  return channels_of(format) || format == GL_COLOR_INDEX || format == GL_STENCIL_INDEX || format == GL_DEPTH_COMPONENT;
}

bool is_plain_type(GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE:
    case GL_BITMAP:
    case GL_BYTE:
    case GL_UNSIGNED_SHORT:
    case GL_SHORT:
    case GL_UNSIGNED_INT:
    case GL_INT:
    case GL_FLOAT:
      return true;
    default:
      return false;
  }
}

// True if a packed type goes with the format [GL1.5 Table 3.8]; empty if it is not a packed type.
std::optional<bool> packed_type_matches(GLenum type, GLenum format) {
  switch (type) {
    case GL_UNSIGNED_BYTE_3_3_2:
    case GL_UNSIGNED_BYTE_2_3_3_REV:
    case GL_UNSIGNED_SHORT_5_6_5:
    case GL_UNSIGNED_SHORT_5_6_5_REV:
      return format == GL_RGB;
    case GL_UNSIGNED_SHORT_4_4_4_4:
    case GL_UNSIGNED_SHORT_4_4_4_4_REV:
    case GL_UNSIGNED_SHORT_5_5_5_1:
    case GL_UNSIGNED_SHORT_1_5_5_5_REV:
    case GL_UNSIGNED_INT_8_8_8_8:
    case GL_UNSIGNED_INT_8_8_8_8_REV:
    case GL_UNSIGNED_INT_10_10_10_2:
    case GL_UNSIGNED_INT_2_10_10_10_REV:
      return format == GL_RGBA || format == GL_BGRA;
    default:
      return std::nullopt;
  }
}

bool is_written(GLenum format, GLenum type) {
  if (format == GL_STENCIL_INDEX) return type == GL_UNSIGNED_BYTE;
  if (format != GL_DEPTH_COMPONENT) return type == GL_UNSIGNED_BYTE || type == GL_FLOAT;
  return type == GL_UNSIGNED_BYTE || type == GL_UNSIGNED_SHORT || type == GL_UNSIGNED_INT || type == GL_FLOAT;
}

struct Refusal {
  GLenum error;
  const char* message;
};

std::optional<Refusal> refusal(const Framebuffer& target, GLsizei width, GLsizei height, GLenum format, GLenum type) {
  const std::optional<bool> packed_matches = packed_type_matches(type, format);
  if (!is_format(format)) return Refusal{GL_INVALID_ENUM, "format is not a pixel format"};
  if (!is_plain_type(type) && !packed_matches) return Refusal{GL_INVALID_ENUM, "type is not a pixel type"};
  if (type == GL_BITMAP && format != GL_COLOR_INDEX && format != GL_STENCIL_INDEX) {
    return Refusal{GL_INVALID_ENUM, "GL_BITMAP goes with indices alone"};
  }
  if (width < 0 || height < 0) return Refusal{GL_INVALID_VALUE, "width and height must not be negative"};
  if (packed_matches == false)
    return Refusal{GL_INVALID_OPERATION, "type has another number of components than format"};
  if (format == GL_COLOR_INDEX) return Refusal{GL_INVALID_OPERATION, "there are no color indices in RGBA mode"};
  if (format == GL_DEPTH_COMPONENT && target.depth_format == DepthFormat::none) {
    return Refusal{GL_INVALID_OPERATION, "there is no depth buffer"};
  }
  if (format == GL_STENCIL_INDEX && target.stencil_bits == 0) {
    return Refusal{GL_INVALID_OPERATION, "there is no stencil buffer"};
  }
  if (!is_written(format, type)) return Refusal{GL_INVALID_OPERATION, "not implemented for this type"};
  return std::nullopt;
}

std::size_t size_of(GLenum type) {
  switch (type) {
    case GL_UNSIGNED_BYTE:
      return 1;
    case GL_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

/// A rectangle inside the target, and where its first row goes.
struct Transfer {
  int x = 0, y = 0, width = 0, height = 0;
  std::byte* out = nullptr;
  std::uintptr_t stride = 0;

  // Addresses wrap around like ClientRows does.
  std::byte* row(int i) const {
    return reinterpret_cast<std::byte*>(reinterpret_cast<std::uintptr_t>(out) +
                                        static_cast<std::uintptr_t>(i) * stride);
  }
};

// The part of the rectangle that lies inside the target.
Transfer clipped(const Framebuffer& target, GLint x, GLint y, GLsizei width, GLsizei height, const ClientRows& rows,
                 std::size_t pixel_size, void* pixels) {
  const std::int64_t x0 = std::max<std::int64_t>(x, 0), y0 = std::max<std::int64_t>(y, 0);
  const std::int64_t x1 = std::min<std::int64_t>(std::int64_t{x} + width, target.width_px);
  const std::int64_t y1 = std::min<std::int64_t>(std::int64_t{y} + height, target.height_px);
  if (x0 >= x1 || y0 >= y1) return {};
  const auto address = reinterpret_cast<std::uintptr_t>(pixels) + rows.first_pixel +
                       static_cast<std::uintptr_t>(x0 - x) * pixel_size +
                       static_cast<std::uintptr_t>(y0 - y) * rows.row_stride;
  return {static_cast<int>(x0),
          static_cast<int>(y0),
          static_cast<int>(x1 - x0),
          static_cast<int>(y1 - y0),
          reinterpret_cast<std::byte*>(address),
          rows.row_stride};
}

void swap_bytes(std::byte* elements, std::size_t count, std::size_t element_size) {
  for (std::size_t i = 0; i < count; ++i) std::reverse(elements + i * element_size, elements + (i + 1) * element_size);
}

float sum_of(const float* rgba) {
  return std::min((rgba[0] + rgba[1]) + rgba[2], 1.0f);
}
std::uint8_t sum_of(const std::uint8_t* rgba) {
  return static_cast<std::uint8_t>(std::min(rgba[0] + rgba[1] + rgba[2], 255));
}

template <int count, class Element>
void choose(const std::vector<Element>& rgba, const std::array<int, 4>& source, Element* out) {
  for (std::size_t pixel = 0; pixel < rgba.size(); pixel += 4) {
    for (std::size_t c = 0; c < count; ++c) *out++ = rgba[pixel + static_cast<std::size_t>(source[c])];
  }
}

// The elements of a row of R, G, B, A [GL1.5 §4.3.2]; luminance takes the place of red in `rgba`.
template <class Element>
void choose(std::vector<Element>& rgba, Channels channels, std::vector<Element>& out) {
  if (channels.source[0] == luminance) {
    for (std::size_t pixel = 0; pixel < rgba.size(); pixel += 4) rgba[pixel] = sum_of(&rgba[pixel]);
    channels.source[0] = 0;
  }
  switch (channels.count) {
    case 1:
      return choose<1>(rgba, channels.source, out.data());
    case 2:
      return choose<2>(rgba, channels.source, out.data());
    case 3:
      return choose<3>(rgba, channels.source, out.data());
    default:
      return choose<4>(rgba, channels.source, out.data());
  }
}

// read_row(y, out) gives a row of R, G, B, A; its elements are chosen, and put in their place.
template <class Element, class ReadRow>
void write_color(const Transfer& transfer, const Channels& channels, bool swapping, ReadRow read_row) {
  const auto pixels = static_cast<std::size_t>(transfer.width);
  std::vector<Element> rgba(pixels * 4), elements(pixels * static_cast<std::size_t>(channels.count));
  for (int i = 0; i < transfer.height; ++i) {
    read_row(transfer.y + i, rgba.data());
    choose(rgba, channels, elements);
    std::byte* const bytes = reinterpret_cast<std::byte*>(elements.data());
    if (swapping) swap_bytes(bytes, elements.size(), sizeof(Element));
    std::memcpy(transfer.row(i), bytes, elements.size() * sizeof(Element));
  }
}

// The formats that the target's bytes give at once.
std::optional<PackedLayout> direct_layout(const Framebuffer& target, GLenum format, GLenum type) {
  if (target.color_format != ColorFormat::rgba8 || type != GL_UNSIGNED_BYTE) return std::nullopt;
  switch (format) {
    case GL_RGBA:
      return PackedLayout::rgba8;
    case GL_BGRA:
      return PackedLayout::bgra8;
    case GL_RGB:
      return PackedLayout::rgb8;
    case GL_BGR:
      return PackedLayout::bgr8;
    default:
      return std::nullopt;
  }
}

void read_color(const Framebuffer& target, const Transfer& transfer, GLenum format, GLenum type, bool swapping) {
  if (const auto layout = direct_layout(target, format, type)) {
    return pack_color_rows(target, *layout, transfer.x, transfer.y, transfer.width, transfer.height, transfer.out,
                           static_cast<std::ptrdiff_t>(transfer.stride));
  }
  const Channels channels = *channels_of(format);
  if (type == GL_FLOAT) {
    write_color<float>(transfer, channels, swapping,
                       [&](int y, float* rgba) { read_color_row_float(target, transfer.x, y, transfer.width, rgba); });
  } else {
    write_color<std::uint8_t>(transfer, channels, false, [&](int y, std::uint8_t* rgba) {
      read_color_row_unorm8(target, transfer.x, y, transfer.width, rgba);
    });
  }
}

// Depth as 32-bit fixed point: stored integers repeat their bits downwards, so that all ones stay all ones.
void read_fixed_row(const Framebuffer& target, int x, int y, int count, std::uint32_t* out) {
  if (target.depth_format == DepthFormat::z32f) {
    std::vector<float> depths(static_cast<std::size_t>(count));
    read_depth_row_float(target, x, y, count, depths.data());
    std::transform(depths.begin(), depths.end(), out, [](float depth) {
      return static_cast<std::uint32_t>(static_cast<double>(depth) * 4294967295.0 + 0.5);
    });
    return;
  }
  read_depth_row(target, x, y, count, out);
  const bool wide = target.depth_format == DepthFormat::z24s8;
  std::transform(out, out + count, out, [wide](std::uint32_t z) { return wide ? z << 8 | z >> 16 : z << 16 | z; });
}

// As Mesa: words are the float to nearest, bytes are cut off, 32-bit integers come from what is stored.
void read_depth(const Framebuffer& target, const Transfer& transfer, GLenum type, bool swapping) {
  const auto count = static_cast<std::size_t>(transfer.width);
  std::vector<float> floats(count);
  std::vector<std::uint32_t> fixed(count);
  std::vector<std::uint16_t> words(count);
  std::vector<std::uint8_t> bytes(count);
  const auto put = [&](int row, auto& values) {
    auto* const data = reinterpret_cast<std::byte*>(values.data());
    if (swapping) swap_bytes(data, count, sizeof values[0]);
    std::memcpy(transfer.row(row), data, count * sizeof values[0]);
  };
  for (int i = 0; i < transfer.height; ++i) {
    const int y = transfer.y + i;
    if (type == GL_UNSIGNED_INT) {
      read_fixed_row(target, transfer.x, y, transfer.width, fixed.data());
      put(i, fixed);
      continue;
    }
    read_depth_row_float(target, transfer.x, y, transfer.width, floats.data());
    if (type == GL_UNSIGNED_SHORT) {
      std::transform(floats.begin(), floats.end(), words.begin(),
                     [](float depth) { return static_cast<std::uint16_t>(std::lrint(depth * 65535.0f)); });
      put(i, words);
    } else if (type == GL_UNSIGNED_BYTE) {
      std::transform(floats.begin(), floats.end(), bytes.begin(),
                     [](float depth) { return static_cast<std::uint8_t>(depth * 255.0f); });
      put(i, bytes);
    } else {
      put(i, floats);
    }
  }
}

void read_stencil(const Framebuffer& target, const Transfer& transfer) {
  std::vector<std::uint8_t> values(static_cast<std::size_t>(transfer.width));
  for (int i = 0; i < transfer.height; ++i) {
    read_stencil_row(target, transfer.x, transfer.y + i, transfer.width, values.data());
    std::memcpy(transfer.row(i), values.data(), values.size());
  }
}

}  // namespace

void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels) {
  if (context.read_target() == nullptr) return;
  const Framebuffer& target = *context.read_target();
  if (const auto refused = refusal(target, width, height, format, type)) {
    return context.record_error(refused->error, "glReadPixels", refused->message);
  }
  if (pixels == nullptr) return;

  const PixelStore& store = context.state.pack;
  const auto channels = channels_of(format);
  const std::size_t elements = channels ? static_cast<std::size_t>(channels->count) : 1, element_size = size_of(type);
  const ClientRows rows = client_rows(store, width, elements, element_size);
  const Transfer transfer = clipped(target, x, y, width, height, rows, elements * element_size, pixels);
  if (transfer.width == 0) return;

  context.finish_rendering();
  if (format == GL_DEPTH_COMPONENT) {
    read_depth(target, transfer, type, store.swap_bytes);
  } else if (format == GL_STENCIL_INDEX) {
    read_stencil(target, transfer);
  } else {
    read_color(target, transfer, format, type, store.swap_bytes);
  }
}

}  // namespace gouraud::api
