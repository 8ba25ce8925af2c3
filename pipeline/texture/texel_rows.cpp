#include "pipeline/texture/texel_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <utility>

#include "pipeline/draw/byte_count.h"

namespace gouraud::pipeline {
namespace {

/// Which of R, G, B, A a texel's channels hold.
struct Channels {
  int count = 4;
  std::array<std::uint8_t, 4> source{0, 1, 2, 3};
};

Channels channels_of(const Image& image) {
  if (has_four_channels(image.format)) return {};
  switch (image.base_format) {
    case BaseFormat::alpha: return {1, {3}};
    case BaseFormat::luminance:
    case BaseFormat::intensity:
    case BaseFormat::depth: return {1, {0}};
    case BaseFormat::luminance_alpha: return {2, {0, 3}};
    case BaseFormat::rgb:
    case BaseFormat::rgba: break;
  }
  return {};
}

/// A float as a channel of type T.
template <class T>
T quantized(float value) {
  if constexpr (std::is_floating_point_v<T>) return value;
  else {
    constexpr auto most = static_cast<float>(T(~T{0}));
    if (!(value > 0.0f)) return 0;
    return static_cast<T>(std::min(value, 1.0f) * most + 0.5f);
  }
}

template <class T>
constexpr T full_channel() {
  if constexpr (std::is_floating_point_v<T>) return T(1);
  else return T(~T{0});
}

template <class T>
void put(std::byte* out, std::size_t index, T value) { std::memcpy(out + index * sizeof(T), &value, sizeof(T)); }
template <class T>
T take(const std::byte* in, std::size_t index) {
  T value;
  std::memcpy(&value, in + index * sizeof(T), sizeof(T));
  return value;
}

/// Of four channels, those that the base format lacks: 0, and 1 for alpha.
template <class T>
void fill_missing(const Image& image, std::size_t count, std::byte* out) {
  const BaseFormat base = image.base_format;
  const bool alpha = base == BaseFormat::alpha || base == BaseFormat::luminance_alpha;
  const std::size_t colors = base == BaseFormat::rgb ? image.colors : base == BaseFormat::alpha ? 0 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = colors; c < 3; ++c) put<T>(out, 4 * i + c, T{0});
    if (!alpha) put<T>(out, 4 * i + 3, full_channel<T>());
  }
}

/// convert(component) gives a channel.
template <class T, class Component, class Convert>
void store_channels(const Image& image, const Component* rgba, std::size_t count, std::byte* out, Convert convert) {
  const Channels channels = channels_of(image);
  if (channels.count == 1) {
    const Component* in = rgba + channels.source[0];
    for (std::size_t i = 0; i < count; ++i) put<T>(out, i, convert(in[4 * i]));
  } else if (channels.count == 2) {
    for (std::size_t i = 0; i < count; ++i) {
      put<T>(out, 2 * i, convert(rgba[4 * i]));
      put<T>(out, 2 * i + 1, convert(rgba[4 * i + 3]));
    }
  } else {
    for (std::size_t i = 0; i < 4 * count; ++i) put<T>(out, i, convert(rgba[i]));
    if (image.base_format != BaseFormat::rgba) fill_missing<T>(image, count, out);
  }
}

/// The reverse: convert(channel) gives a component; one(full) is that of a channel that is full.
template <class T, class Component, class Convert>
void load_channels(const Image& image, const std::byte* texels, std::size_t count, Component* rgba, Convert convert,
                   Component one) {
  const Channels channels = channels_of(image);
  const auto step = static_cast<std::size_t>(channels.count);
  for (std::size_t i = 0; i < count; ++i, rgba += 4) {
    rgba[0] = rgba[1] = rgba[2] = Component{0};
    rgba[3] = one;
    for (std::size_t c = 0; c < step; ++c) rgba[channels.source[c]] = convert(take<T>(texels, i * step + c));
    if (image.base_format == BaseFormat::rgb) rgba[3] = one;
  }
}

double clamped_depth(double depth) { return depth > 0.0 ? std::min(depth, 1.0) : 0.0; }

}  // namespace

void store_colors(const Image& image, const float* rgba, std::size_t count, std::byte* out) {
  switch (image.format) {
    case TexelFormat::r8:
    case TexelFormat::rg8:
    case TexelFormat::rgba8:
      return store_channels<std::uint8_t>(image, rgba, count, out, quantized<std::uint8_t>);
    case TexelFormat::r16:
    case TexelFormat::rg16:
    case TexelFormat::rgba16:
      return store_channels<std::uint16_t>(image, rgba, count, out, quantized<std::uint16_t>);
    default:
      return store_channels<float>(image, rgba, count, out, quantized<float>);
  }
}

void store_colors(const Image& image, const std::uint8_t* rgba, std::size_t count, std::byte* out) {
  switch (image.format) {
    case TexelFormat::r8:
    case TexelFormat::rg8:
    case TexelFormat::rgba8:
      return store_channels<std::uint8_t>(image, rgba, count, out, [](std::uint8_t v) { return v; });
    case TexelFormat::r16:
    case TexelFormat::rg16:
    case TexelFormat::rgba16:
      return store_channels<std::uint16_t>(image, rgba, count, out,
                                           [](std::uint8_t v) { return static_cast<std::uint16_t>(v * 257); });
    default:
      return store_channels<float>(image, rgba, count, out,
                                   [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; });
  }
}

void store_depths(const Image& image, const double* depths, const std::uint32_t* stencils, std::size_t count, std::byte* out) {
  switch (image.format) {
    case TexelFormat::z16:
      for (std::size_t i = 0; i < count; ++i) {
        put(out, i, static_cast<std::uint16_t>(clamped_depth(depths[i]) * 65535.0 + 0.5));
      }
      break;
    case TexelFormat::z24s8:
      for (std::size_t i = 0; i < count; ++i) {
        const auto depth = static_cast<std::uint32_t>(clamped_depth(depths[i]) * 16777215.0 + 0.5);
        put(out, i, depth | (stencils != nullptr ? stencils[i] << 24 : 0u));
      }
      break;
    default:
      for (std::size_t i = 0; i < count; ++i) put(out, i, static_cast<float>(clamped_depth(depths[i])));
      break;
  }
}

void load_colors(const Image& image, const std::byte* texels, std::size_t count, float* rgba) {
  switch (image.format) {
    case TexelFormat::r8:
    case TexelFormat::rg8:
    case TexelFormat::rgba8:
      return load_channels<std::uint8_t>(image, texels, count, rgba,
                                         [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; }, 1.0f);
    case TexelFormat::r16:
    case TexelFormat::rg16:
    case TexelFormat::rgba16:
      return load_channels<std::uint16_t>(image, texels, count, rgba,
                                          [](std::uint16_t v) { return static_cast<float>(v) / 65535.0f; }, 1.0f);
    default:
      return load_channels<float>(image, texels, count, rgba, [](float v) { return v; }, 1.0f);
  }
}

void load_colors(const Image& image, const std::byte* texels, std::size_t count, std::uint8_t* rgba) {
  load_channels<std::uint8_t>(image, texels, count, rgba, [](std::uint8_t v) { return v; }, std::uint8_t{255});
}

bool has_byte_channels(TexelFormat format) {
  return format == TexelFormat::r8 || format == TexelFormat::rg8 || format == TexelFormat::rgba8;
}

void load_depths(const Image& image, const std::byte* texels, std::size_t count, double* depths, std::uint32_t* stencils) {
  const bool packed = image.format == TexelFormat::z24s8;
  for (std::size_t i = 0; i < count; ++i) {
    switch (image.format) {
      case TexelFormat::z16: depths[i] = take<std::uint16_t>(texels, i) / 65535.0; break;
      case TexelFormat::z24s8: depths[i] = (take<std::uint32_t>(texels, i) & 0xFFFFFFu) / 16777215.0; break;
      default: depths[i] = static_cast<double>(take<float>(texels, i)); break;
    }
    if (stencils != nullptr) stencils[i] = packed ? take<std::uint32_t>(texels, i) >> 24 : 0u;
  }
}

std::size_t texel_bytes(const Image& image) {
  return byte_count({image.width, image.height, image.depth, bytes_per_texel(image.format)});
}

void make_stencil_plane(Image& image) {
  if (!image.has_stencil || image.format != TexelFormat::z32f || image.stencil != nullptr) return;
  image.stencil = std::make_shared<TiledBuffer>(image.width, image.height, 1);
}

/// glibc maps each block from 128 KiB on, at the cost of a page that is hardly used and of a page fault every 4 KiB, until it
/// has seen a larger one given back: textures that come and go are then of memory that is there.
static void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr std::size_t largest_kept = std::size_t{8} << 20;
  [[maybe_unused]] static const bool once = [] {
    void* volatile block = std::malloc(largest_kept);
    std::free(block);
    return true;
  }();
#endif
}

void allocate_texels(Image& image, bool zeroed) {
  constexpr std::size_t readable_behind = 16;
  keep_freed_memory();
  const std::size_t size = texel_bytes(image);
  auto* const bytes = static_cast<std::byte*>(zeroed ? std::calloc(size + readable_behind, 1) : std::malloc(size + readable_behind));
  if (bytes == nullptr) throw std::bad_alloc();
  std::shared_ptr<std::byte[]> texels(bytes, [](std::byte* p) { std::free(p); });
  std::memset(bytes + size, 0, readable_behind);
  image.tiles = nullptr;
  image.stencil = nullptr;
  make_stencil_plane(image);
  image.texels = std::move(texels);
}

std::byte* texel_row(const Image& image, int y, int z) {
  const auto row = static_cast<std::size_t>(z) * static_cast<std::size_t>(image.height) + static_cast<std::size_t>(y);
  return image.texels.get() +
         row * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(bytes_per_texel(image.format));
}

namespace {

/// Calls copy(texel's byte in the image, byte offset in the row, bytes) for runs that lie side by side.
template <class Copy>
void for_runs(const Image& image, int x, int y, int z, int count, Copy copy) {
  const auto size = static_cast<std::size_t>(bytes_per_texel(image.format));
  if (image.tiles == nullptr) {
    copy(texel_row(image, y, z) + static_cast<std::size_t>(x) * size, 0, static_cast<std::size_t>(count) * size);
    return;
  }
  const TiledBuffer plane = image.tiles->plane(z);
  for (int done = 0; done < count;) {
    const int run = std::min(block_size - (x + done) % block_size, count - done);
    copy(plane.pixel(x + done, y), static_cast<std::size_t>(done) * size, static_cast<std::size_t>(run) * size);
    done += run;
  }
}

}  // namespace

void read_texels(const Image& image, int x, int y, int z, int count, std::byte* out) {
  for_runs(image, x, y, z, count, [out](const std::byte* at, std::size_t offset, std::size_t bytes) {
    std::memcpy(out + offset, at, bytes);
  });
}

void write_texels(const Image& image, int x, int y, int z, int count, const std::byte* texels) {
  if (image.tiles != nullptr && image.format == TexelFormat::z24s8) image.tiles->use_stencil();
  for_runs(image, x, y, z, count, [texels](std::byte* at, std::size_t offset, std::size_t bytes) {
    std::memcpy(at, texels + offset, bytes);
  });
}

void read_stencils(const Image& image, int x, int y, int count, std::uint32_t* out) {
  for (int i = 0; i < count; ++i) {
    out[i] = image.stencil != nullptr ? std::to_integer<std::uint32_t>(*image.stencil->pixel_value(x + i, y)) : 0u;
  }
}

void write_stencils(const Image& image, int x, int y, int count, const std::uint32_t* stencils) {
  if (image.stencil == nullptr) return;
  for (int i = 0; i < count; ++i) *image.stencil->pixel(x + i, y) = static_cast<std::byte>(stencils[i]);
}

}  // namespace gouraud::pipeline
