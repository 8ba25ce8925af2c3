// A clear is a pattern for each plane: which bits of a pixel it sets, and to what. A pattern that sets every bit of a
// whole tile is left with the plane (TiledBuffer::clear_tile); so is one that meets a clear which still waits there.
#include "pipeline/framebuffer/clear.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "pipeline/framebuffer/tile_runs.h"

namespace gouraud::pipeline {
namespace {

/// The bits of `mask` become those of `value`; both repeat with every pixel.
struct Pattern {
  PixelBytes value{}, mask{};

  bool sets_something() const { return mask != PixelBytes{}; }
  bool sets_everything() const {
    return std::all_of(mask.begin(), mask.end(), [](std::uint8_t bits) { return bits == 0xFF; });
  }
  std::uint8_t applied(std::uint8_t old, std::size_t i) const {
    return static_cast<std::uint8_t>((old & ~mask[i]) | (value[i] & mask[i]));
  }
};

template <class Word>
PixelBytes repeated(const Word& pixel) {
  PixelBytes bytes;
  for (std::size_t i = 0; i < bytes.size(); i += sizeof pixel) std::memcpy(&bytes[i], &pixel, sizeof pixel);
  return bytes;
}

/// Sets `size` bytes that begin with a pixel, in whole patterns where there is room.
void apply(const Pattern& pattern, std::byte* pixels, std::size_t size) {
  constexpr std::size_t step = std::tuple_size_v<PixelBytes>;
  using Words = std::array<std::uint64_t, step / sizeof(std::uint64_t)>;
  const auto value = std::bit_cast<Words>(pattern.value), mask = std::bit_cast<Words>(pattern.mask);
  std::size_t done = 0;
  for (; done + step <= size; done += step) {
    Words words;
    std::memcpy(words.data(), pixels + done, step);
    for (std::size_t i = 0; i < words.size(); ++i) words[i] = (words[i] & ~mask[i]) | (value[i] & mask[i]);
    std::memcpy(pixels + done, words.data(), step);
  }
  for (std::size_t i = 0; done + i < size; ++i) {
    pixels[done + i] = static_cast<std::byte>(pattern.applied(static_cast<std::uint8_t>(pixels[done + i]), i));
  }
}

void clear_plane(const TiledBuffer& plane, const TileCut& tile, const Pattern& pattern) {
  if (plane.empty() || !pattern.sets_something()) return;
  const PixelRect cut = tile.of(plane);
  if (cut.empty()) return;
  if (cut == whole_tile) {
    if (pattern.sets_everything()) return plane.clear_tile(tile.tile_x, tile.tile_y, pattern.value);
    if (const PixelBytes* waiting = plane.waiting_clear(tile.tile_x, tile.tile_y)) {
      PixelBytes both = *waiting;
      for (std::size_t i = 0; i < both.size(); ++i) both[i] = pattern.applied(both[i], i);
      return plane.clear_tile(tile.tile_x, tile.tile_y, both);
    }
  }
  std::byte* const pixels = plane.tile(tile.tile_x, tile.tile_y);
  const auto bytes = static_cast<std::size_t>(plane.bytes_per_pixel());
  for_each_run(cut, [&](std::int32_t first, std::int32_t count) {
    apply(pattern, pixels + static_cast<std::size_t>(first) * bytes, static_cast<std::size_t>(count) * bytes);
  });
}

/// Four channels of which `write_mask` names those that are written.
template <class Channel>
Pattern channel_pattern(const std::array<Channel, 4>& color, std::uint8_t write_mask) {
  std::array<std::uint8_t, 4 * sizeof(Channel)> mask{};
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = (write_mask >> (i / sizeof(Channel)) & 1) != 0 ? 0xFF : 0;
  return {repeated(color), repeated(mask)};
}

Pattern color_pattern(ColorFormat format, const ClearState& state) {
  const auto unorm = [&]<class Channel>(Channel largest) {
    std::array<Channel, 4> color;
    for (int k = 0; k < 4; ++k) {
      const float value = std::clamp(state.clear_color[k], 0.0f, 1.0f) * static_cast<float>(largest);
      color[static_cast<std::size_t>(k)] = static_cast<Channel>(std::nearbyint(value));
    }
    return channel_pattern(color, state.color_write_mask);
  };
  switch (format) {
    case ColorFormat::rgba8: return unorm(std::uint8_t{0xFF});
    case ColorFormat::rgba16: return unorm(std::uint16_t{0xFFFF});
    case ColorFormat::rgba32f: {
      const glm::vec4& c = state.clear_color;
      return channel_pattern(std::array<float, 4>{c[0], c[1], c[2], c[3]}, state.color_write_mask);
    }
    case ColorFormat::none: break;
  }
  return {};
}

Pattern depth_pattern(const Framebuffer& target, const ClearState& state) {
  const double depth = std::clamp(state.clear_depth, 0.0, 1.0);
  const PixelBytes all = repeated(std::uint8_t{0xFF});
  switch (target.depth_format) {
    case DepthFormat::z24s8: {
      const auto value = static_cast<std::uint32_t>(std::nearbyint(depth * 0xFFFFFF));
      // Where all stencil values are zero, whole words are right as well, and no old word needs to be read.
      if (!target.depth.stencil_in_use()) return {repeated(value), state.depth ? all : PixelBytes{}};
      const std::uint32_t stencil_mask = state.stencil ? state.stencil_write_mask << 24 : 0u;
      return {repeated(value | state.clear_stencil << 24), repeated((state.depth ? 0xFFFFFFu : 0u) | stencil_mask)};
    }
    case DepthFormat::z16:
      if (state.depth) return {repeated(static_cast<std::uint16_t>(std::nearbyint(depth * 0xFFFF))), all};
      break;
    case DepthFormat::z32:
      if (state.depth) return {repeated(static_cast<std::uint32_t>(std::nearbyint(depth * 0xFFFFFFFF))), all};
      break;
    case DepthFormat::z32f:
      if (state.depth) return {repeated(static_cast<float>(depth)), all};
      break;
    case DepthFormat::none: break;
  }
  return {};
}

}  // namespace

void clear_tile(const Framebuffer& target, std::int32_t tile_index, const ClearState& state) {
  const TileCut tile(target, tile_index, state.scissor);
  if (state.color) clear_plane(target.color, tile, color_pattern(target.color_format, state));
  if ((state.depth || state.stencil) && !target.depth.empty()) clear_plane(target.depth, tile, depth_pattern(target, state));
  if (state.stencil) {
    clear_plane(target.stencil, tile,
                {repeated(static_cast<std::uint8_t>(state.clear_stencil)),
                 repeated(static_cast<std::uint8_t>(state.stencil_write_mask))});
  }
  if (state.accum) {
    const glm::vec4& c = state.clear_accum;
    clear_plane(target.accum, tile, channel_pattern(std::array<float, 4>{c[0], c[1], c[2], c[3]}, 0xF));
  }
}

}  // namespace gouraud::pipeline
