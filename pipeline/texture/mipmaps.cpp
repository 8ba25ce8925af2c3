#include "pipeline/texture/mipmaps.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "pipeline/draw/byte_count.h"
#include "pipeline/texture/completeness.h"
#include "pipeline/texture/halved_rows.h"
#include "pipeline/texture/halved_srgb_rows.h"
#include "pipeline/texture/texel_access.h"

namespace gouraud::pipeline {
namespace {

/// The texels of the larger image that one of the smaller covers along a dimension, and their shares.
struct Taps {
  int first = 0, count = 1;
  std::array<double, 3> weight{1, 0, 0};
};

/// For each texel of the smaller image. A border texel covers the border texel at the same end.
std::vector<Taps> taps_along(int size, int border) {
  const int interior = size - 2 * border, half = std::max(interior / 2, 1);
  std::vector<Taps> taps(static_cast<std::size_t>(half + 2 * border));
  for (int i = 0; i < half; ++i) {
    Taps& tap = taps[static_cast<std::size_t>(i + border)];
    tap.first = border + (interior > 1 ? 2 * i : 0);
    if (interior == 1) continue;
    if (interior % 2 == 0) {
      tap.count = 2;
      tap.weight = {0.5, 0.5, 0};
    } else {
      const double n = interior;
      tap.count = 3;
      tap.weight = {(half - i) / n, half / n, (i + 1) / n};
    }
  }
  if (border > 0) {
    taps.front() = {0, 1, {1, 0, 0}};
    taps.back() = {size - 1, 1, {1, 0, 0}};
  }
  return taps;
}

/// How many channels of a texel are sRGB-encoded.
std::size_t encoded_channels(const Image& image) {
  if (!image.srgb) return 0;
  return image.format == TexelFormat::rgba8 ? 3 : 1;
}

Texel average(const Image& image, const Taps& x, const Taps& y, const Taps& z) {
  const std::size_t encoded = encoded_channels(image);
  std::array<double, 4> sum{};
  for (int k = 0; k < z.count; ++k) {
    for (int j = 0; j < y.count; ++j) {
      for (int i = 0; i < x.count; ++i) {
        Texel texel = stored_channels(image.format, texel_address(image, x.first + i, y.first + j, z.first + k));
        const double weight = x.weight[static_cast<std::size_t>(i)] * y.weight[static_cast<std::size_t>(j)] *
                              z.weight[static_cast<std::size_t>(k)];
        for (std::size_t c = 0; c < 4; ++c) {
          if (c < encoded) texel[c] = decode_srgb(static_cast<std::uint8_t>(texel[c] * 255.0f + 0.5f));
          sum[c] += weight * texel[c];
        }
      }
    }
  }
  Texel out;
  for (std::size_t c = 0; c < 4; ++c) {
    out[c] = static_cast<float>(sum[c]);
    if (c < encoded) out[c] = static_cast<float>(encode_srgb(out[c])) / 255.0f;
  }
  return out;
}

int unorm8_channels(TexelFormat format) {
  switch (format) {
    case TexelFormat::r8: return 1;
    case TexelFormat::rg8: return 2;
    case TexelFormat::rgba8: return 4;
    default: return 0;
  }
}

/// Whether pairs of rows and columns of bytes are all there is to average.
bool is_simple(const Image& image) {
  return unorm8_channels(image.format) > 0 && !image.tiles && image.border == 0 && image.depth == 1 &&
         image.width % 2 == 0 && image.height % 2 == 0;
}

}  // namespace

std::shared_ptr<std::byte[]> allocate_texels(TexelFormat format, int width, int height, int depth) {
  constexpr std::size_t spare = 16;
  const std::size_t bytes = byte_count({width, height, depth, bytes_per_texel(format)});
  std::shared_ptr<std::byte[]> texels(new std::byte[bytes + spare]);
  std::memset(texels.get() + bytes, 0, spare);
  return texels;
}

Image next_level(TextureTarget target, const Image& image) {
  const LevelSize size = next_level_size(target, image);
  Image out;
  out.format = image.format;
  out.base_format = image.base_format;
  out.colors = image.colors;
  out.srgb = image.srgb;
  out.has_stencil = image.has_stencil;
  out.border = image.border;
  out.width = size.width;
  out.height = size.height;
  out.depth = size.depth;
  return out;
}

void fill_half_size(TextureTarget target, const Image& image, const Image& out) {
  if (is_simple(image)) {
    const auto halve_rows = image.srgb ? halve_rows_srgb8 : halve_rows_unorm8;
    for (int y = 0; y < out.height; ++y) {
      halve_rows(texel_address(image, 0, 2 * y, 0), texel_address(image, 0, 2 * y + 1, 0), unorm8_channels(image.format), out.width,
                 texel_address(out, 0, y, 0));
    }
    return;
  }
  const auto border = [&](int dimension) { return dimension < dimensions(target) ? image.border : 0; };
  const std::vector<Taps> along_x = taps_along(image.width, border(0)), along_y = taps_along(image.height, border(1));
  const std::vector<Taps> along_z = taps_along(image.depth, border(2));
  for (int z = 0; z < out.depth; ++z) {
    for (int y = 0; y < out.height; ++y) {
      for (int x = 0; x < out.width; ++x) {
        const Texel texel = average(image, along_x[static_cast<std::size_t>(x)], along_y[static_cast<std::size_t>(y)],
                                    along_z[static_cast<std::size_t>(z)]);
        store_channels(out.format, texel, texel_address(out, x, y, z));
      }
    }
  }
}

Image half_size(TextureTarget target, const Image& image) {
  Image out = next_level(target, image);
  out.texels = allocate_texels(out.format, out.width, out.height, out.depth);
  fill_half_size(target, image, out);
  return out;
}

void generate_mipmaps(Texture& texture, int base_level, int last_level) {
  if (base_level < 0 || !usable_levels(texture, base_level, base_level, false)) return;
  auto faces = texture.faces;
  for (auto& face : faces) {
    for (int level = base_level; level < std::min(last_level, max_texture_levels - 1); ++level) {
      const Image& image = face[static_cast<std::size_t>(level)];
      if (is_last_level(texture.target, image)) break;
      face[static_cast<std::size_t>(level) + 1] = half_size(texture.target, image);
    }
  }
  texture.faces = std::move(faces);
}

}  // namespace gouraud::pipeline
