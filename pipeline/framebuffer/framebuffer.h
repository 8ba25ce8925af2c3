// The render target: colour, depth and stencil in tiles.
//
// Pixels are stored by 64x64 tile, in a tile by 8x8 block, in a block by row; y up, tile (0, 0) at the bottom left. So
// what a worker touches is contiguous: one tile of 8-bit colour is 16 KiB, one block of it 256 bytes, and a kernel's
// 64 lanes are 64 neighbours in memory. The storage is padded to whole tiles; what lies outside the picture is never
// read by an application.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace gouraud::pipeline {

inline constexpr int tile_size = 64;
inline constexpr int block_size = 8;
inline constexpr int pixels_per_tile = tile_size * tile_size;
inline constexpr int pixels_per_block = block_size * block_size;
inline constexpr int blocks_per_tile_row = tile_size / block_size;

/// How a pixel's colour is stored. The bytes or words of a pixel are in the order R, G, B, A.
enum class ColorFormat : std::uint8_t { none, rgba8, rgba16, rgba32f };

/// How depth and stencil are stored; z24s8 holds depth in the low 24 bits of a 32-bit word and stencil in the top 8.
/// z32f is one float a pixel, z32 an integer of 32 bits (of the method depth=z32 alone); their stencil lies apart.
enum class DepthFormat : std::uint8_t { none, z16, z24s8, z32, z32f };

constexpr int bytes_per_pixel(ColorFormat format) {
  switch (format) {
    case ColorFormat::none: return 0;
    case ColorFormat::rgba8: return 4;
    case ColorFormat::rgba16: return 8;
    case ColorFormat::rgba32f: return 16;
  }
  return 0;
}
constexpr int bytes_per_pixel(DepthFormat format) {
  switch (format) {
    case DepthFormat::none: return 0;
    case DepthFormat::z16: return 2;
    case DepthFormat::z24s8:
    case DepthFormat::z32:
    case DepthFormat::z32f: return 4;
  }
  return 0;
}

constexpr int depth_bits(DepthFormat format) {
  switch (format) {
    case DepthFormat::none: return 0;
    case DepthFormat::z16: return 16;
    case DepthFormat::z24s8: return 24;
    case DepthFormat::z32:
    case DepthFormat::z32f: return 32;
  }
  return 0;
}

/// What multiplies a depth in [0, 1] to give buffer units.
constexpr double depth_scale(DepthFormat format) {
  const bool is_float = format == DepthFormat::z32f || format == DepthFormat::none;
  return is_float ? 1.0 : static_cast<double>((std::uint64_t{1} << depth_bits(format)) - 1);
}

/// The bytes of a pixel, repeated to fill 16: every format's pixels take 1, 2, 4, 8 or 16 bytes.
using PixelBytes = std::array<std::uint8_t, 16>;

/// One tiled plane of pixels, zero at first. A handle: copies share the pixels. So a renderbuffer or a level of a
/// texture is the same plane in every framebuffer that it is attached to, and lives as long as one of them needs it.
///
/// Clearing a whole tile writes nothing: the tile remembers the value until somebody asks for its pixels. So a large
/// buffer that is cleared often and drawn to in places costs what is drawn. Threads may work on different tiles.
class TiledBuffer {
 public:
  TiledBuffer() = default;
  /// Storage for `planes` planes (the samples of pixels, the slices of a texture) of width x height pixels of
  /// `bytes_per_pixel` bytes, all zero; throws std::bad_alloc. The handle is to the first plane.
  TiledBuffer(int width_px, int height_px, int bytes_per_pixel, int planes = 1);
  /// The handle to another plane, counted from this one.
  TiledBuffer plane(int index) const;

  /// The pixels of the tile at this place of the buffer's own grid of tiles: the one way to them.
  std::byte* tile(int tile_x, int tile_y) const {
    const std::size_t index = index_of(tile_x, tile_y);
    if (waiting_clears_[index].waits) carry_out_clear(index);
    return pixels_of(index);
  }
  /// Where the tile's pixels lie, for prefetching: what is there may be out of date.
  const std::byte* tile_storage(int tile_x, int tile_y) const { return pixels_of(index_of(tile_x, tile_y)); }
  std::byte* pixel(int x, int y) const {
    return tile(x / tile_size, y / tile_size) + offset_in_tile(x, y);
  }
  /// The pixel for reading alone. Threads may read what lies in the same tile.
  const std::byte* pixel_value(int x, int y) const {
    const std::size_t index = index_of(x / tile_size, y / tile_size);
    if (waiting_clears_[index].waits) return reinterpret_cast<const std::byte*>(waiting_clears_[index].value.data());
    return pixels_of(index) + offset_in_tile(x, y);
  }
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }
  int bytes_per_pixel() const { return bytes_per_pixel_; }
  bool empty() const { return pixels_ == nullptr; }
  /// Whether both are the same plane.
  bool operator==(const TiledBuffer& other) const { return storage_ == other.storage_ && pixels_ == other.pixels_; }

  /// Sets every pixel of the tile to `value`, sooner or later.
  void clear_tile(int tile_x, int tile_y, const PixelBytes& value) const {
    waiting_clears_[index_of(tile_x, tile_y)] = {value, true};
  }
  /// What every pixel of the tile has by a clear not yet carried out; null if there is none.
  const PixelBytes* waiting_clear(int tile_x, int tile_y) const {
    const WaitingClear& clear = waiting_clears_[index_of(tile_x, tile_y)];
    return clear.waits ? &clear.value : nullptr;
  }

  /// For textures, which are read at any place by any thread: where the tiles lie one after the other, and those of the
  /// planes that follow, each valid behind
  /// make_readable() of its index. Several threads may make the same tile readable while nobody draws or clears.
  const std::byte* storage() const { return pixels_; }
  int tiles_per_row() const { return tiles_per_row_; }
  int pixels_per_plane() const { return static_cast<int>(tiles_per_plane()) * pixels_per_tile; }
  void make_readable(int tile_index) const;

  /// False as long as every stencil value in the plane is zero: then a clear of depth alone may write whole words.
  /// Shared like the pixels. Not for an empty buffer.
  bool stencil_in_use() const { return storage_->stencil_in_use; }
  void use_stencil() const { storage_->stencil_in_use = true; }

 private:
  struct WaitingClear {
    PixelBytes value{};
    bool waits = true;
  };
  struct Storage {
    Storage(std::size_t tiles, std::size_t bytes);
    ~Storage();
    Storage(const Storage&) = delete;
    Storage& operator=(const Storage&) = delete;

    void* block = nullptr;
    std::byte* pixels = nullptr;  ///< in the block, aligned
    std::unique_ptr<WaitingClear[]> waiting_clears;  ///< one a tile
    bool stencil_in_use = false;
  };
  std::size_t index_of(int tile_x, int tile_y) const {
    return static_cast<std::size_t>(tile_y) * static_cast<std::size_t>(tiles_per_row_) + static_cast<std::size_t>(tile_x);
  }
  std::byte* pixels_of(std::size_t index) const {
    return pixels_ + index * pixels_per_tile * static_cast<std::size_t>(bytes_per_pixel_);
  }
  std::size_t offset_in_tile(int x, int y) const {
    const int block = (y % tile_size / block_size) * blocks_per_tile_row + x % tile_size / block_size;
    const int lane = (y % block_size) * block_size + x % block_size;
    return static_cast<std::size_t>((block * pixels_per_block + lane) * bytes_per_pixel_);
  }
  std::size_t tiles_per_plane() const;
  void carry_out_clear(std::size_t index) const;

  std::shared_ptr<Storage> storage_;
  std::byte* pixels_ = nullptr;
  WaitingClear* waiting_clears_ = nullptr;
  int width_px_ = 0, height_px_ = 0;
  int tiles_per_row_ = 0;
  int bytes_per_pixel_ = 0;
};

/// A picture that can be attached to framebuffers: a renderbuffer or a level of a texture. It has a colour plane, or
/// planes of depth and stencil.
struct Surface {
  int width_px = 0, height_px = 0;  ///< 0: no picture
  int samples = 1;                  ///< of each pixel: each has a plane of its own (TiledBuffer::plane)
  ColorFormat color_format = ColorFormat::none;
  /// The channels that the picture has, bit 0 red to bit 3 alpha. The others hold 0, alpha 1, and are never written.
  std::uint8_t channels = 0xF;
  bool red_is_luminance = false;  ///< or intensity: what R holds is called so
  DepthFormat depth_format = DepthFormat::none;  ///< of `depth`
  bool has_depth = false, has_stencil = false;
  TiledBuffer color, depth, stencil;  ///< `stencil` only where the depth format does not hold it

  /// Gives the picture, whose formats are set, this size and new planes: all zero, but alpha 1 where it has none.
  /// Throws std::bad_alloc, and nothing is changed.
  void allocate(int width_px, int height_px, int samples = 1);
};

/// What is drawn into: a view of planes, which may be larger than it is and belong to other framebuffers as well. Pixel
/// (0, 0) is that of each plane. Copies are other views of the same planes.
struct Framebuffer {
  Framebuffer() = default;
  /// A zeroed target of 1..16384 pixels a side; throws std::bad_alloc. `stencil_bits` is 0 or 8; `accumulates` asks for
  /// an accumulation buffer. Without alpha, that is 1 everywhere, and nothing changes it.
  Framebuffer(int width_px, int height_px, ColorFormat color_format, DepthFormat depth_format, int stencil_bits,
              bool accumulates = false, bool has_alpha = true);
  /// A view of these surfaces (null: none), of a size that none of them is smaller than. Depth and stencil, if both are
  /// there, share a plane or have one each.
  Framebuffer(int width_px, int height_px, const Surface* color, const Surface* depth, const Surface* stencil);

  int width_px = 0, height_px = 0;
  int tiles_x = 0, tiles_y = 0;
  int samples = 1;  ///< of each pixel; the planes below are those of the first, the others' follow: see sample()
  ColorFormat color_format = ColorFormat::none;
  std::uint8_t color_channels = 0xF;  ///< those that the colour plane has: see Surface
  DepthFormat depth_format = DepthFormat::none;
  bool has_depth = false;  ///< false, though depth_format may be z24s8, where only the stencil of such a plane is used
  int stencil_bits = 0;
  TiledBuffer color, depth, stencil;  ///< `stencil` only where the depth format does not hold it
  TiledBuffer accum;                  ///< R, G, B, A in [-1, 1] as floats [GL1.5 §4.2.4]; memory once it is used

  int tile_count() const { return tiles_x * tiles_y; }
  /// The view of one sample of each pixel.
  Framebuffer sample(int index) const;
  bool operator==(const Framebuffer&) const = default;
};

}  // namespace gouraud::pipeline
