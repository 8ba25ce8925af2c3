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

void TiledBuffer::Free::operator()(std::byte* data) const { std::free(reinterpret_cast<void**>(data)[-1]); }

// calloc gives large blocks as fresh pages that cost nothing until they are touched; the storage is aligned inside.
// A large buffer asks for large pages: the first frame touches all of it, and page faults are most of that frame.
TiledBuffer::TiledBuffer(int width_px, int height_px, int bytes)
    : tiles_per_row_(tiles_across(width_px)), bytes_per_pixel_(bytes) {
  const std::size_t size = static_cast<std::size_t>(tiles_per_row_) * static_cast<std::size_t>(tiles_across(height_px)) *
                           pixels_per_tile * static_cast<std::size_t>(bytes);
  if (size == 0) return;
  const std::size_t alignment = size >= large_page ? large_page : small_alignment;
  void* block = std::calloc(1, size + alignment + sizeof(void*));
  if (block == nullptr) throw std::bad_alloc();
  const auto address = reinterpret_cast<std::uintptr_t>(block) + sizeof(void*);
  const auto aligned = (address + alignment - 1) / alignment * alignment;
  reinterpret_cast<void**>(aligned)[-1] = block;
  data_.reset(reinterpret_cast<std::byte*>(aligned));
#if defined(__linux__)
  if (size >= large_page) ::madvise(data_.get(), size, MADV_HUGEPAGE);
#endif
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
