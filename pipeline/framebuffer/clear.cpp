#include "pipeline/framebuffer/clear.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace gouraud::pipeline {
namespace {

/// Calls run(first_pixel, count) for each run of pixels of the tile that lie inside `cut` (tile-relative): one run for
/// the whole tile, else one for each row of each block.
template <class Run>
void for_each_run(const PixelRect& cut, const Run& run) {
  if (cut == PixelRect{0, 0, tile_size, tile_size}) return run(0, pixels_per_tile);
  for (std::int32_t y = cut.y0; y < cut.y1; ++y) {
    for (std::int32_t x = cut.x0; x < cut.x1;) {
      const std::int32_t block_end = std::min((x / block_size + 1) * block_size, cut.x1);
      const std::int32_t block = y / block_size * blocks_per_tile_row + x / block_size;
      run(block * pixels_per_block + y % block_size * block_size + x % block_size, block_end - x);
      x = block_end;
    }
  }
}

/// Sets whole words: a block of them, then copies of that block, which the C library does at memory speed.
template <class Word>
void fill_words(Word* words, std::int32_t count, Word value) {
  const std::int32_t first = std::min(count, pixels_per_block);
  std::fill_n(words, first, value);
  for (std::int32_t done = first; done < count; done += first) {
    std::memcpy(words + done, words, static_cast<std::size_t>(std::min(first, count - done)) * sizeof(Word));
  }
}

/// Sets the bits of `mask` in each word of the runs to those of `value`.
template <class Word>
void fill(std::byte* tile, const PixelRect& cut, Word value, Word mask) {
  Word* words = reinterpret_cast<Word*>(tile);
  for_each_run(cut, [=](std::int32_t first, std::int32_t count) {
    if (mask == static_cast<Word>(~Word{0})) return fill_words(words + first, count, value);
    for (std::int32_t i = first; i < first + count; ++i) {
      words[i] = static_cast<Word>((words[i] & static_cast<Word>(~mask)) | (value & mask));
    }
  });
}

template <class Channel>
void fill_channels(std::byte* tile, const PixelRect& cut, const std::array<Channel, 4>& value, std::uint8_t write_mask) {
  auto* channels = reinterpret_cast<Channel*>(tile);
  for_each_run(cut, [&](std::int32_t first, std::int32_t count) {
    for (std::int32_t i = first; i < first + count; ++i) {
      for (std::int32_t k = 0; k < 4; ++k) {
        if ((write_mask >> k & 1) != 0) channels[4 * i + k] = value[static_cast<std::size_t>(k)];
      }
    }
  });
}

void clear_color(const Framebuffer& target, std::byte* tile, const PixelRect& cut, const ClearState& state) {
  const auto unorm = [&](int channel, float scale) {
    return static_cast<std::uint32_t>(std::nearbyint(std::clamp(state.clear_color[channel], 0.0f, 1.0f) * scale));
  };
  switch (target.color_format) {
    case ColorFormat::rgba8: {
      std::uint32_t value = 0, mask = 0;
      for (int k = 0; k < 4; ++k) {
        value |= unorm(k, 255.0f) << (8 * k);
        if ((state.color_write_mask >> k & 1) != 0) mask |= 0xFFu << (8 * k);
      }
      return fill(tile, cut, value, mask);
    }
    case ColorFormat::rgba16: {
      std::array<std::uint16_t, 4> value;
      for (int k = 0; k < 4; ++k) value[static_cast<std::size_t>(k)] = static_cast<std::uint16_t>(unorm(k, 65535.0f));
      return fill_channels(tile, cut, value, state.color_write_mask);
    }
    case ColorFormat::rgba32f: {
      const std::array<float, 4> value{state.clear_color[0], state.clear_color[1], state.clear_color[2], state.clear_color[3]};
      return fill_channels(tile, cut, value, state.color_write_mask);
    }
    case ColorFormat::none: return;
  }
}

void clear_depth_stencil(const Framebuffer& target, std::byte* tile, const PixelRect& cut, const ClearState& state) {
  const double depth = std::clamp(state.clear_depth, 0.0, 1.0);
  switch (target.depth_format) {
    case DepthFormat::z24s8: {
      const std::uint32_t value = static_cast<std::uint32_t>(std::nearbyint(depth * 0xFFFFFF)) | state.clear_stencil << 24;
      const std::uint32_t mask = (state.depth ? 0xFFFFFFu : 0u) | (state.stencil ? state.stencil_write_mask << 24 : 0u);
      // Where all stencil values are zero, whole words are right as well, and no old word needs to be read.
      const bool whole = state.depth && !target.depth.stencil_in_use();
      return fill(tile, cut, whole ? value & 0xFFFFFFu : value, whole ? ~0u : mask);
    }
    case DepthFormat::z16:
      if (state.depth) {
        fill(tile, cut, static_cast<std::uint16_t>(std::nearbyint(depth * 0xFFFF)), std::uint16_t{0xFFFF});
      }
      break;
    case DepthFormat::z32f:
      if (state.depth) fill(tile, cut, std::bit_cast<std::uint32_t>(static_cast<float>(depth)), ~0u);
      break;
    case DepthFormat::none: break;
  }
}

}  // namespace

void clear_tile(const Framebuffer& target, std::int32_t tile, const ClearState& state) {
  const std::int32_t tile_x = tile % target.tiles_x, tile_y = tile / target.tiles_x;
  const std::int32_t x = tile_x * tile_size, y = tile_y * tile_size;
  const PixelRect& box = state.scissor;
  // A scissor box that reaches a plane's edge may as well clear the padding beyond it.
  const auto cut = [&](const TiledBuffer& plane) -> PixelRect {
    const std::int32_t x1 = box.x1 >= plane.width_px() ? tile_size : box.x1 - x;
    const std::int32_t y1 = box.y1 >= plane.height_px() ? tile_size : box.y1 - y;
    return {std::max(box.x0 - x, 0), std::max(box.y0 - y, 0), std::min(x1, tile_size), std::min(y1, tile_size)};
  };
  if (state.color && state.color_write_mask != 0 && !target.color.empty()) {
    clear_color(target, target.color.tile(tile_x, tile_y), cut(target.color), state);
  }
  if ((state.depth || state.stencil) && !target.depth.empty()) {
    clear_depth_stencil(target, target.depth.tile(tile_x, tile_y), cut(target.depth), state);
  }
  if (state.stencil && !target.stencil.empty()) {
    fill(target.stencil.tile(tile_x, tile_y), cut(target.stencil), static_cast<std::uint8_t>(state.clear_stencil),
         static_cast<std::uint8_t>(state.stencil_write_mask));
  }
}

}  // namespace gouraud::pipeline
