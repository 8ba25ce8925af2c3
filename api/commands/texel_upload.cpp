#include "api/commands/texel_upload.h"

#include <optional>
#include <vector>

#include "api/commands/unpack_rows.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

using pipeline::BaseFormat;
using pipeline::ByteOrder;
using pipeline::Image;

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

/// How texels are made of pixels, where both are bytes.
struct TexelBytes {
  ByteOrder order;
  int count = 0;  ///< of a texel
};
std::optional<TexelBytes> texel_bytes(const ByteOrder& rgba, const Image& image) {
  if (!pipeline::has_byte_channels(image.format) || pipeline::is_widened(image)) return std::nullopt;
  switch (image.base_format) {
    case BaseFormat::alpha: return TexelBytes{{{rgba.source[3]}}, 1};
    case BaseFormat::luminance:
    case BaseFormat::intensity: return TexelBytes{{{rgba.source[0]}}, 1};
    case BaseFormat::luminance_alpha: return TexelBytes{{{rgba.source[0], rgba.source[3]}}, 2};
    case BaseFormat::rgb: {
      const auto kept = [&](std::size_t color) { return color < image.colors ? rgba.source[color] : ByteOrder::zero; };
      return TexelBytes{{{rgba.source[0], kept(1), kept(2), ByteOrder::full}}, 4};
    }
    case BaseFormat::rgba: return TexelBytes{rgba, 4};
    case BaseFormat::depth: break;
  }
  return std::nullopt;
}

/// Whether the client's rows lie one behind the other, and so do their texels: then a slice is one long row.
bool is_one_row(const ClientImage& client, const Image& image, const TexelPosition& at) {
  return image.tiles == nullptr && at.x == 0 && client.size.width == image.width && client.row_stride == client.row_bytes();
}

void upload_bytes(const ClientImage& client, const ByteOrder& order, const Image& image, const TexelPosition& at) {
  const auto width = static_cast<std::size_t>(client.size.width);
  if (const auto texel = texel_bytes(order, image)) {
    const pipeline::ByteArrangement how(texel->order, client.layout.pixel_bytes, texel->count);
    if (is_one_row(client, image, at)) {
      for (GLsizei z = 0; z < client.size.depth; ++z) {
        pipeline::arrange_bytes(how, client.row(0, z), width * static_cast<std::size_t>(client.size.height),
                                pipeline::texel_row(image, at.y, at.z + z));
      }
      return;
    }
    return for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
      pipeline::arrange_bytes(how, client.row(run.y, run.z), width, out);
    });
  }
  std::vector<std::byte> rgba(4 * width);
  for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
    unpack_bytes(client, order, run, rgba.data());
    pipeline::store_colors(image, reinterpret_cast<const std::uint8_t*>(rgba.data()), width, out);
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
  if (const auto order = byte_order(context, client)) return upload_bytes(client, *order, image, at);
  const auto width = static_cast<std::size_t>(client.size.width);
  std::vector<float> rgba(4 * width);
  for_rows(client, image, at, [&](const PixelRun& run, std::byte* out) {
    transferred_color(context, client, run, rgba.data());
    pipeline::store_colors(image, rgba.data(), width, out);
  });
}

}  // namespace gouraud::api
