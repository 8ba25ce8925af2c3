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

/// Of colours.
bool has_alpha(BaseFormat base) {
  return base == BaseFormat::rgba || base == BaseFormat::alpha || base == BaseFormat::luminance_alpha || base == BaseFormat::depth;
}

/// The channels that framebuffers write, R in bit 0: L and I take R [ARB_framebuffer_object, "Framebuffer Objects"].
std::uint8_t written_channels(const Image& image) {
  switch (image.base_format) {
    case BaseFormat::alpha: return 0b1000;
    case BaseFormat::luminance:
    case BaseFormat::intensity: return 0b0001;
    case BaseFormat::luminance_alpha: return 0b1001;
    case BaseFormat::rgb: return static_cast<std::uint8_t>((1 << image.colors) - 1);
    default: return 0b1111;
  }
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
  const bool drawable = color_format(wide_format(image.format)) != ColorFormat::none || depth_format(image.format) != DepthFormat::none;
  return !image.empty() && drawable && up(image.width) * up(image.height) * image.depth <= most_pixels;
}

void widen(Image& image) {
  if (image.empty() || wide_format(image.format) == image.format) return;
  Image wide = image;
  wide.format = wide_format(image.format);
  allocate_texels(wide);
  const auto count = static_cast<std::size_t>(image.width);
  std::vector<float> colors(4 * count);
  for (int z = 0; z < image.depth; ++z) {
    for (int y = 0; y < image.height; ++y) {
      load_colors(image, texel_row(image, y, z), count, colors.data());
      store_colors(wide, colors.data(), count, texel_row(wide, y, z));
    }
  }
  image = wide;
}

void widen(Texture& texture) {
  for (auto& face : texture.faces) {
    for (Image& image : face) widen(image);
  }
}

bool has_widened_images(const Texture& texture) {
  return std::any_of(texture.faces.begin(), texture.faces.end(), [](const auto& face) { return std::any_of(face.begin(), face.end(), is_widened); });
}

void put_into_tiles(Image& image) {
  if (image.tiles != nullptr) return;
  widen(image);
  Image tiled = image;
  tiled.texels = nullptr;
  tiled.tiles = std::make_shared<TiledBuffer>(image.width, image.height, bytes_per_texel(image.format), image.depth);
  make_stencil_plane(tiled);
  const bool opaque = !has_alpha(image.base_format);
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
  surface.color_format = color_format(wide_format(image.format));
  surface.channels = written_channels(image);
  surface.red_is_luminance = image.base_format != BaseFormat::rgb && image.base_format != BaseFormat::rgba;
  surface.depth_format = depth_format(image.format);
  surface.has_depth = surface.depth_format != DepthFormat::none;
  surface.has_stencil = image.has_stencil;
  if (image.tiles == nullptr) return surface;
  (surface.has_depth ? surface.depth : surface.color) = image.tiles->plane(slice);
  if (image.stencil != nullptr) surface.stencil = *image.stencil;
  return surface;
}

}  // namespace gouraud::pipeline
