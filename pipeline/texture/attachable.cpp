#include "pipeline/texture/attachable.h"

#include <cstring>
#include <memory>
#include <vector>

#include "pipeline/texture/texel_rows.h"

namespace gouraud::pipeline {
namespace {

ColorFormat color_format(TexelFormat format) {
  switch (format) {
    case TexelFormat::rgba8: return ColorFormat::rgba8;
    case TexelFormat::rgba16: return ColorFormat::rgba16;
    case TexelFormat::rgba32f: return ColorFormat::rgba32f;
    default: return ColorFormat::none;
  }
}

DepthFormat depth_format(TexelFormat format) {
  switch (format) {
    case TexelFormat::z16: return DepthFormat::z16;
    case TexelFormat::z24s8: return DepthFormat::z24s8;
    case TexelFormat::z32f: return DepthFormat::z32f;
    default: return DepthFormat::none;
  }
}

bool holds_stencil(const std::vector<std::byte>& words) {
  for (std::size_t i = 3; i < words.size(); i += 4) {
    if (words[i] != std::byte{0}) return true;
  }
  return false;
}

}  // namespace

bool is_attachable(const Image& image) {
  const bool drawable = color_format(image.format) != ColorFormat::none || depth_format(image.format) != DepthFormat::none;
  return !image.empty() && drawable && image.border == 0 && image.depth == 1;
}

void put_into_tiles(Image& image) {
  if (image.tiles != nullptr) return;
  Image tiled = image;
  tiled.texels = nullptr;
  tiled.tiles = std::make_shared<TiledBuffer>(image.width, image.height, bytes_per_texel(image.format));
  std::vector<std::byte> row(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(bytes_per_texel(image.format)));
  bool any = false;
  for (int y = 0; y < image.height; ++y) {
    read_texels(image, 0, y, 0, image.width, row.data());
    // Tiles are zero at first, without being touched: so stays an image that has no texels yet.
    if (std::memchr(row.data(), 0, row.size()) == row.data() &&
        std::memcmp(row.data(), row.data() + 1, row.size() - 1) == 0) {
      continue;
    }
    write_texels(tiled, 0, y, 0, image.width, row.data());
    any = any || (image.format == TexelFormat::z24s8 && holds_stencil(row));
  }
  if (any) tiled.tiles->use_stencil();
  image = tiled;
}

Surface surface_of(const Image& image, bool has_stencil) {
  Surface surface;
  surface.width_px = image.width;
  surface.height_px = image.height;
  surface.color_format = color_format(image.format);
  surface.channels = image.base_format == BaseFormat::rgb ? 0b0111 : 0b1111;
  surface.depth_format = depth_format(image.format);
  surface.has_depth = surface.depth_format != DepthFormat::none;
  surface.has_stencil = has_stencil && surface.depth_format == DepthFormat::z24s8;
  if (image.tiles == nullptr) return surface;
  (surface.has_depth ? surface.depth : surface.color) = *image.tiles;
  return surface;
}

}  // namespace gouraud::pipeline
