#include "pipeline/framebuffer/framebuffer.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#include "pipeline/draw/byte_count.h"
#include "pipeline/framebuffer/clear.h"

namespace gouraud::pipeline {
namespace {

constexpr int tiles_across(int pixels) { return (pixels + tile_size - 1) / tile_size; }
constexpr std::size_t small_alignment = 64;
constexpr std::size_t large_page = std::size_t{1} << 21;

}  // namespace

// malloc gives large blocks as fresh pages that cost nothing until they are touched; the pixels are aligned inside.
// A large buffer asks for large pages: the first frame touches all of it, and page faults are most of that frame.
TiledBuffer::Storage::Storage(std::size_t tiles, std::size_t bytes)
    : waiting_clears(std::make_unique<WaitingClear[]>(tiles)) {
  const std::size_t alignment = bytes >= large_page ? large_page : small_alignment;
  block = std::malloc(bytes + alignment);
  if (block == nullptr) throw std::bad_alloc();
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  pixels = reinterpret_cast<std::byte*>((address + alignment - 1) / alignment * alignment);
#if defined(__linux__)
  if (bytes >= large_page) ::madvise(pixels, bytes, MADV_HUGEPAGE);
#endif
}

TiledBuffer::Storage::~Storage() { std::free(block); }

TiledBuffer::TiledBuffer(int width, int height, int bytes, int planes)
    : width_px_(width), height_px_(height), tiles_per_row_(tiles_across(width)), bytes_per_pixel_(bytes) {
  const std::size_t size = byte_count({tiles_per_row_, tiles_across(height), planes, pixels_per_tile, bytes});
  if (size == 0) return;
  const std::size_t tiles = tiles_per_plane() * static_cast<std::size_t>(planes);
  storage_ = std::make_shared<Storage>(tiles, size);
  pixels_ = storage_->pixels;
  waiting_clears_ = storage_->waiting_clears.get();
}

std::size_t TiledBuffer::tiles_per_plane() const {
  return static_cast<std::size_t>(tiles_per_row_) * static_cast<std::size_t>(tiles_across(height_px_));
}

TiledBuffer TiledBuffer::plane(int index) const {
  TiledBuffer other = *this;
  if (empty()) return other;
  const std::size_t tiles = tiles_per_plane() * static_cast<std::size_t>(index);
  other.pixels_ = pixels_of(tiles);
  other.waiting_clears_ = waiting_clears_ + tiles;
  return other;
}

// One block, then copies of it, which the C library does at memory speed.
void TiledBuffer::carry_out_clear(std::size_t index) const {
  WaitingClear& clear = waiting_clears_[index];
  std::byte* const pixels = pixels_of(index);
  const std::size_t block = pixels_per_block * static_cast<std::size_t>(bytes_per_pixel_);
  for (std::size_t i = 0; i < block; i += sizeof clear.value) std::memcpy(pixels + i, clear.value.data(), sizeof clear.value);
  for (std::size_t i = 1; i < pixels_per_tile / pixels_per_block; ++i) std::memcpy(pixels + i * block, pixels, block);
  std::atomic_ref(clear.waits).store(false, std::memory_order_release);
}

void TiledBuffer::make_readable(int tile_index) const {
  static std::mutex one_at_a_time;
  const auto index = static_cast<std::size_t>(tile_index);
  const std::atomic_ref waits(waiting_clears_[index].waits);
  if (!waits.load(std::memory_order_acquire)) return;
  const std::lock_guard lock(one_at_a_time);
  if (waits.load(std::memory_order_relaxed)) carry_out_clear(index);
}

namespace {

void make_opaque(const Framebuffer& target) {
  const ClearState opaque{
      .color = true, .scissor = {0, 0, target.width_px, target.height_px}, .clear_color = {0.0f, 0.0f, 0.0f, 1.0f}};
  for (int tile = 0; tile < target.tile_count(); ++tile) clear_tile(target, tile, opaque);
}

}  // namespace

void Surface::allocate(int width, int height, int sample_count) {
  const bool stencil_apart = has_stencil && depth_format != DepthFormat::z24s8;
  Surface fresh = *this;
  fresh.color = TiledBuffer(width, height, bytes_per_pixel(color_format), sample_count);
  fresh.depth = TiledBuffer(width, height, bytes_per_pixel(depth_format), sample_count);
  fresh.stencil = TiledBuffer(width, height, stencil_apart ? 1 : 0, sample_count);
  fresh.width_px = width;
  fresh.height_px = height;
  fresh.samples = sample_count;
  *this = fresh;
  if ((channels & 0b1000) != 0 || color.empty()) return;
  for (int sample = 0; sample < samples; ++sample) {
    Framebuffer view(width, height, this, nullptr, nullptr);
    view.color = color.plane(sample);
    make_opaque(view);
  }
}

Framebuffer::Framebuffer(int width, int height, ColorFormat color_layout, DepthFormat depth_layout, int stencil_depth,
                         bool accumulates, bool has_alpha)
    : width_px(width),
      height_px(height),
      tiles_x(tiles_across(width)),
      tiles_y(tiles_across(height)),
      color_format(color_layout),
      depth_format(depth_layout),
      has_depth(depth_layout != DepthFormat::none),
      stencil_bits(stencil_depth),
      color(width, height, pipeline::bytes_per_pixel(color_layout)),
      depth(width, height, pipeline::bytes_per_pixel(depth_layout)),
      stencil(width, height, stencil_depth > 0 && depth_layout != DepthFormat::z24s8 ? 1 : 0),
      accum(width, height, accumulates ? 4 * static_cast<int>(sizeof(float)) : 0) {
  if (has_alpha || color.empty()) return;
  color_channels = 0b0111;
  make_opaque(*this);
}

Framebuffer::Framebuffer(int width, int height, const Surface* color_surface, const Surface* depth_surface,
                         const Surface* stencil_surface)
    : width_px(width), height_px(height), tiles_x(tiles_across(width)), tiles_y(tiles_across(height)) {
  for (const Surface* surface : {color_surface, depth_surface, stencil_surface}) {
    if (surface != nullptr) samples = surface->samples;
  }
  if (color_surface != nullptr) {
    color_format = color_surface->color_format;
    color_channels = color_surface->channels;
    color = color_surface->color;
  }
  if (depth_surface != nullptr) {
    depth_format = depth_surface->depth_format;
    depth = depth_surface->depth;
    has_depth = true;
  }
  if (stencil_surface != nullptr) {
    stencil_bits = 8;
    stencil = stencil_surface->stencil;
    if (stencil.empty() && depth.empty()) {
      depth_format = stencil_surface->depth_format;
      depth = stencil_surface->depth;
    }
  }
}

Framebuffer Framebuffer::sample(int index) const {
  Framebuffer one = *this;
  one.samples = 1;
  for (TiledBuffer* plane : {&one.color, &one.depth, &one.stencil}) *plane = plane->plane(index);
  return one;
}

}  // namespace gouraud::pipeline
