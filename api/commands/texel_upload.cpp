#include "api/commands/texel_upload.h"

#include <cstring>
#include <vector>

#include "api/commands/unpack_rows.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

using pipeline::BaseFormat;
using pipeline::Image;
using pipeline::TexelFormat;

/// Calls write(run, out) for each row of the client's image, `out` being its texels' place; rows of an image in tiles
/// go by way of a buffer.
template <class Write>
void for_rows(const ClientImage& client, const Image& image, const TexelPosition& at, Write write) {
  const ImageSize& size = client.size;
  const auto texel_bytes = static_cast<std::size_t>(pipeline::bytes_per_texel(image.format));
  std::vector<std::byte> buffer;
  if (image.tiles != nullptr) buffer.resize(static_cast<std::size_t>(size.width) * texel_bytes);
  for (GLsizei z = 0; z < size.depth; ++z) {
    for (GLsizei y = 0; y < size.height; ++y) {
      const PixelRun run = whole_row(client, y, z);
      if (image.tiles != nullptr) {
        write(run, buffer.data());
        pipeline::write_texels(image, at.x, at.y + y, at.z + z, size.width, buffer.data());
      } else {
        write(run, pipeline::texel_row(image, at.y + y, at.z + z) + static_cast<std::size_t>(at.x) * texel_bytes);
      }
    }
  }
}

/// True if pixels are stored just as they are.
bool same_bytes(const ClientImage& client, const ByteOrder& order, const Image& image) {
  using Order = std::array<std::int8_t, 4>;
  const int bytes = client.layout.pixel_bytes;
  switch (image.base_format) {
    case BaseFormat::alpha: return image.format == TexelFormat::r8 && bytes == 1 && order.source[3] == 0;
    case BaseFormat::luminance:
    case BaseFormat::intensity: return image.format == TexelFormat::r8 && bytes == 1 && order.source[0] == 0;
    case BaseFormat::luminance_alpha:
      return image.format == TexelFormat::rg8 && bytes == 2 && order.source[0] == 0 && order.source[3] == 1;
    case BaseFormat::rgba:
      return image.format == TexelFormat::rgba8 && bytes == 4 && order.source == Order{0, 1, 2, 3};
    default: return false;
  }
}

void upload_bytes(const ClientImage& client, const ByteOrder& order, const Image& image, const TexelPosition& at) {
  const auto width = static_cast<std::size_t>(client.size.width);
  if (same_bytes(client, order, image)) {
    const std::size_t bytes = width * client.layout.pixel_bytes;
    for_rows(client, image, at,
             [&](const PixelRun& run, std::byte* out) { std::memcpy(out, client.row(run.y, run.z), bytes); });
    return;
  }
  if (image.format == TexelFormat::rgba8) {
    const bool drops_alpha = image.base_format == BaseFormat::rgb && order.source[3] != ByteOrder::full;
    for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
      auto* const rgba = reinterpret_cast<std::uint8_t*>(out);
      unpack_bytes(client, order, run, rgba);
      if (!drops_alpha) return;
      for (std::size_t i = 0; i < width; ++i) rgba[4 * i + 3] = 255;
    });
    return;
  }
  std::vector<std::uint8_t> rgba(4 * width);
  for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
    unpack_bytes(client, order, run, rgba.data());
    pipeline::store_colors(image, rgba.data(), width, out);
  });
}

void upload_depths(const Context& context, const ClientImage& client, const Image& image, const TexelPosition& at) {
  const auto width = static_cast<std::size_t>(client.size.width);
  const bool with_stencil = client.layout.kind == PixelKind::depth_stencil;
  std::vector<double> depths(width);
  std::vector<std::uint32_t> stencils(with_stencil ? width : 0);
  for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
    transferred_depth(context, client, run, depths.data());
    if (with_stencil) transferred_stencil(context, client, run, stencils.data());
    pipeline::store_depths(image, depths.data(), with_stencil ? stencils.data() : nullptr, width, out);
    if (with_stencil) pipeline::write_stencils(image, at.x, at.y + static_cast<int>(run.y), client.size.width, stencils.data());
  });
}

}  // namespace

void upload(const Context& context, const ClientImage& client, const Image& image, const TexelPosition& at) {
  if (image.base_format == BaseFormat::depth) return upload_depths(context, client, image, at);
  if (const ByteOrder order = byte_order(context, client); order.exists) {
    return upload_bytes(client, order, image, at);
  }
  const auto width = static_cast<std::size_t>(client.size.width);
  std::vector<float> rgba(4 * width);
  for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
    transferred_color(context, client, run, rgba.data());
    pipeline::store_colors(image, rgba.data(), width, out);
  });
}

}  // namespace gouraud::api
