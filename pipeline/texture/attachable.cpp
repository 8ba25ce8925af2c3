#include "pipeline/texture/attachable.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
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

bool is_zero(const std::vector<std::byte>& row) {
  return std::all_of(row.begin(), row.end(), [](std::byte byte) { return byte == std::byte{0}; });
}

/// The last of a texel's four channels becomes 1.
void make_opaque(TexelFormat format, std::span<std::byte> texels) {
  const auto size = static_cast<std::size_t>(bytes_per_texel(format)), channel = size / 4;
  constexpr float one = 1.0f;
  for (std::size_t at = size - channel; at < texels.size(); at += size) {
    if (format == TexelFormat::rgba32f) std::memcpy(&texels[at], &one, sizeof one);
    else std::fill_n(&texels[at], channel, std::byte{0xFF});
  }
}

void clear_to_opaque(const Image& tiled) {
  PixelBytes black{};
  make_opaque(tiled.format, std::as_writable_bytes(std::span(black)));
  for (int z = 0; z < tiled.depth; ++z) {
    const TiledBuffer plane = tiled.tiles->plane(z);
    for (int y = 0; y < tiled.height; y += tile_size) {
      for (int x = 0; x < tiled.width; x += tile_size) plane.clear_tile(x / tile_size, y / tile_size, black);
    }
  }
}

}  // namespace

bool is_attachable(const Image& image) {
  // As the sampler counts (wrap-inl.h): tiles may take several times what the texels do.
  constexpr std::int64_t most_pixels = std::int64_t{1} << 28;
  const auto up = [](std::int64_t size) { return (size + tile_size - 1) / tile_size * tile_size; };
  const bool drawable = color_format(image.format) != ColorFormat::none || depth_format(image.format) != DepthFormat::none;
  return !image.empty() && drawable && up(image.width) * up(image.height) * image.depth <= most_pixels;
}

void put_into_tiles(Image& image) {
  if (image.tiles != nullptr) return;
  Image tiled = image;
  tiled.texels = nullptr;
  tiled.tiles = std::make_shared<TiledBuffer>(image.width, image.height, bytes_per_texel(image.format), image.depth);
  make_stencil_plane(tiled);
  const bool opaque = image.base_format == BaseFormat::rgb;
  if (opaque) clear_to_opaque(tiled);
  std::vector<std::byte> row(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(bytes_per_texel(image.format)));
  bool any = false;
  for (int z = 0; z < image.depth; ++z) {
    for (int y = 0; y < image.height; ++y) {
      read_texels(image, 0, y, z, image.width, row.data());
      // Tiles are clear at first, without being touched: so stays an image that has no texels yet.
      if (is_zero(row)) continue;
      if (opaque) make_opaque(image.format, row);
      write_texels(tiled, 0, y, z, image.width, row.data());
      any = any || (image.format == TexelFormat::z24s8 && holds_stencil(row));
    }
  }
  if (any) tiled.tiles->use_stencil();
  image = tiled;
}

Surface surface_of(const Image& image, int slice) {
  Surface surface;
  surface.width_px = image.width;
  surface.height_px = image.height;
  surface.color_format = color_format(image.format);
  surface.channels = image.base_format == BaseFormat::rgb ? 0b0111 : 0b1111;
  surface.depth_format = depth_format(image.format);
  surface.has_depth = surface.depth_format != DepthFormat::none;
  surface.has_stencil = image.has_stencil;
  if (image.tiles == nullptr) return surface;
  (surface.has_depth ? surface.depth : surface.color) = image.tiles->plane(slice);
  if (image.stencil != nullptr) surface.stencil = *image.stencil;
  return surface;
}

}  // namespace gouraud::pipeline
