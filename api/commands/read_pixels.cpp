// Takes a rectangle of the target, gives it to client memory [GL1.5 §4.3.2, Tables 3.5, 3.6 and 4.6].
//
// choice: pixels outside the target, undefined by the specification, leave client memory as it is; Mesa's too.
// choice: float colour from a float target is not clamped; nothing outside [0, 1] can have been stored.
#include "api/commands/read_pixels.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "api/commands/client_pixels.h"
#include "api/commands/pack_rows.h"
#include "api/commands/pixel_transfer.h"
#include "api/commands/target_values.h"
#include "pipeline/framebuffer/pack.h"
#include "pipeline/framebuffer/read.h"

namespace gouraud::api {
namespace {

using pipeline::ByteOrder;
using pipeline::ColorFormat;
using pipeline::DepthFormat;
using pipeline::Framebuffer;

/// A rectangle inside the target, and its first pixel's place in the image.
struct Transfer {
  int x = 0, y = 0, width = 0, height = 0;
  GLsizei first = 0, first_row = 0;

  std::byte* first_pixel(const ClientImage& image) const {
    return image.row(first_row) + static_cast<std::size_t>(first) * image.layout.pixel_bytes;
  }
  PixelRun run(int row) const { return {first_row + row, 0, first, width}; }
};

// The part of the rectangle that lies inside the target.
Transfer clipped(const Framebuffer& target, GLint x, GLint y, GLsizei width, GLsizei height) {
  const std::int64_t x0 = std::max<std::int64_t>(x, 0), y0 = std::max<std::int64_t>(y, 0);
  const std::int64_t x1 = std::min<std::int64_t>(std::int64_t{x} + width, target.width_px);
  const std::int64_t y1 = std::min<std::int64_t>(std::int64_t{y} + height, target.height_px);
  if (x0 >= x1 || y0 >= y1) return {};
  return {static_cast<int>(x0),      static_cast<int>(y0),          static_cast<int>(x1 - x0),
          static_cast<int>(y1 - y0), static_cast<GLsizei>(x0 - x), static_cast<GLsizei>(y0 - y)};
}

// How pixels are made of the target's bytes, where nothing else is done to them.
std::optional<ByteOrder> direct_order(const Framebuffer& target, const ClientImage& image) {
  const PixelLayout& layout = image.layout;
  const bool bytes = layout.element == ElementType::unsigned_byte;
  const bool words = layout.element == ElementType::packed_int && layout.field[0].bits == 8;
  if (target.color_format != ColorFormat::rgba8 || !(bytes || words)) return std::nullopt;
  ByteOrder order;
  for (std::size_t c = 0; c < layout.element_count; ++c) {
    if (layout.channel[c] == channel_luminance) return std::nullopt;
    const std::size_t in_word = layout.field[c].shift / 8u;
    order.source[bytes ? c : image.swap_bytes ? 3 - in_word : in_word] = static_cast<std::int8_t>(layout.channel[c]);
  }
  return order;
}

// After pixel transfer colours are clamped, unless the target stores floats [GL1.5 §4.3.2].
void read_transferred_color(const Context& context, const Framebuffer& target, const Transfer& transfer,
                            const ClientImage& image) {
  std::vector<float> rgba(static_cast<std::size_t>(transfer.width) * 4);
  const bool transfers = transfers_color(context.state.pixel.transfer);
  for (int i = 0; i < transfer.height; ++i) {
    read_color_row_float(target, transfer.x, transfer.y + i, transfer.width, rgba.data());
    if (transfers) {
      transfer_color(context.state, rgba.data(), static_cast<std::size_t>(transfer.width));
      if (target.color_format != ColorFormat::rgba32f) {
        for (float& value : rgba) value = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
      }
    }
    pack_color(image, transfer.run(i), rgba.data());
  }
}

void read_color(const Context& context, const Framebuffer& target, const Transfer& transfer, const ClientImage& image) {
  const bool transfers = transfers_color(context.state.pixel.transfer);
  const auto order = transfers ? std::nullopt : direct_order(target, image);
  if (order) {
    return pack_bytes(target, *order, image.layout.pixel_bytes, transfer.x, transfer.y, transfer.width, transfer.height,
                      transfer.first_pixel(image), static_cast<std::ptrdiff_t>(image.row_stride));
  }
  const bool wants_bytes = image.layout.element == ElementType::unsigned_byte;
  if (transfers || !(target.color_format == ColorFormat::rgba8 || wants_bytes)) {
    return read_transferred_color(context, target, transfer, image);
  }
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(transfer.width) * 4);
  for (int i = 0; i < transfer.height; ++i) {
    read_color_row_unorm8(target, transfer.x, transfer.y + i, transfer.width, rgba.data());
    pack_color(image, transfer.run(i), rgba.data());
  }
}

// Depth as 32-bit fixed point: stored integers repeat their bits downwards, so that all ones stay all ones.
void read_fixed_row(const Framebuffer& target, int x, int y, int count, std::uint32_t* out) {
  read_depth_row(target, x, y, count, out);
  if (target.depth_format == DepthFormat::z32) return;
  const bool wide = target.depth_format == DepthFormat::z24s8;
  std::transform(out, out + count, out, [wide](std::uint32_t z) { return wide ? z << 8 | z >> 16 : z << 16 | z; });
}

void read_other(const Context& context, const Framebuffer& target, const Transfer& transfer, const ClientImage& image) {
  const auto count = static_cast<std::size_t>(transfer.width);
  const bool transfers = transfers_depth(context.state.pixel.transfer);
  const bool fixed = image.layout.kind == PixelKind::depth && image.layout.element == ElementType::unsigned_int &&
                     target.depth_format != DepthFormat::z32f && !transfers;
  if (image.layout.kind == PixelKind::depth && image.layout.element == ElementType::floating && !transfers && !image.swap_bytes) {
    return read_depth_rows_float(target, transfer.x, transfer.y, transfer.width, transfer.height, transfer.first_pixel(image),
                                 static_cast<std::ptrdiff_t>(image.row_stride));
  }
  std::vector<double> depths(count);
  std::vector<std::uint32_t> words(count);
  for (int i = 0; i < transfer.height; ++i) {
    const int y = transfer.y + i;
    if (fixed) {
      read_fixed_row(target, transfer.x, y, transfer.width, words.data());
      pack_fixed_depth(image, transfer.run(i), words.data());
      continue;
    }
    if (image.layout.kind != PixelKind::stencil_index) {
      read_depths(target, transfer.x, y, transfer.width, depths.data());
      if (transfers) {
        transfer_depth(context.state, depths.data(), count);
        for (double& depth : depths) depth = depth > 0.0 ? std::min(depth, 1.0) : 0.0;
      }
    }
    if (image.layout.kind != PixelKind::depth) {
      read_stencils(target, transfer.x, y, transfer.width, words.data());
      if (transfers_stencil(context.state.pixel.transfer)) transfer_stencil(context.state, words.data(), count);
    }
    switch (image.layout.kind) {
      case PixelKind::depth: pack_depth(image, transfer.run(i), depths.data()); break;
      case PixelKind::stencil_index: pack_indices(image, transfer.run(i), words.data()); break;
      default: pack_depth_stencil(image, transfer.run(i), depths.data(), words.data()); break;
    }
  }
}

}  // namespace

void ReadPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type,
                void* pixels) {
  constexpr auto command = "glReadPixels";
  if (!context.can_read(command) || context.read_target() == nullptr) return;
  const Framebuffer& target = *context.read_target();
  ClientImage image;
  if (!check_pack(context, command, {width, height}, format, type, pixels, image)) return;
  const char* problem = missing_buffer(target, image.layout.kind);
  if (image.layout.kind == PixelKind::color_index) problem = "there are no color indices in RGBA mode";
  if (image.layout.kind == PixelKind::color && target.color_format == ColorFormat::none) problem = "the read buffer is GL_NONE";
  if (problem != nullptr) return context.record_error(GL_INVALID_OPERATION, command, problem);
  const Transfer transfer = clipped(target, x, y, width, height);
  if (image.null() || transfer.width == 0) return;

  context.finish_rendering();
  if (image.layout.kind == PixelKind::color) {
    read_color(context, target, transfer, image);
  } else {
    read_other(context, target, transfer, image);
  }
}

}  // namespace gouraud::api
