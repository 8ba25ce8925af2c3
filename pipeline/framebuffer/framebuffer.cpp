#include "pipeline/framebuffer/framebuffer.h"

#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif


namespace gouraud::pipeline {
namespace {

constexpr int tiles_across(int pixels) { return (pixels + tile_size - 1) / tile_size; }
constexpr std::size_t small_alignment = 64;
constexpr std::size_t large_page = std::size_t{1} << 21;

}  // namespace

// calloc gives large blocks as fresh pages that cost nothing until they are touched; the pixels are aligned inside.
// A large buffer asks for large pages: the first frame touches all of it, and page faults are most of that frame.
TiledBuffer::Storage::Storage(std::size_t bytes) {
  const std::size_t alignment = bytes >= large_page ? large_page : small_alignment;
  block = std::calloc(1, bytes + alignment);
  if (block == nullptr) throw std::bad_alloc();
  const auto address = reinterpret_cast<std::uintptr_t>(block);
  pixels = reinterpret_cast<std::byte*>((address + alignment - 1) / alignment * alignment);
#if defined(__linux__)
  if (bytes >= large_page) ::madvise(pixels, bytes, MADV_HUGEPAGE);
#endif
}

TiledBuffer::Storage::~Storage() { std::free(block); }

TiledBuffer::TiledBuffer(int width, int height, int bytes)
    : width_px_(width), height_px_(height), tiles_per_row_(tiles_across(width)), bytes_per_pixel_(bytes) {
  const std::size_t size = static_cast<std::size_t>(tiles_per_row_) * static_cast<std::size_t>(tiles_across(height)) *
                           pixels_per_tile * static_cast<std::size_t>(bytes);
  if (size == 0) return;
  storage_ = std::make_shared<Storage>(size);
  pixels_ = storage_->pixels;
}

Framebuffer::Framebuffer(int width, int height, ColorFormat color_layout, DepthFormat depth_layout, int stencil_depth)
    : width_px(width),
      height_px(height),
      tiles_x(tiles_across(width)),
      tiles_y(tiles_across(height)),
      color_format(color_layout),
      depth_format(depth_layout),
      stencil_bits(stencil_depth),
      color(width, height, pipeline::bytes_per_pixel(color_layout)),
      depth(width, height, pipeline::bytes_per_pixel(depth_layout)),
      stencil(width, height, stencil_depth > 0 && depth_layout != DepthFormat::z24s8 ? 1 : 0) {}

}  // namespace gouraud::pipeline
