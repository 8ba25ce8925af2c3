#include "pipeline/draw/antialiasing.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "pipeline/raster/sample_positions.h"

namespace gouraud::pipeline {
namespace {

/// Samples along one side of a pixel.
int grid_of(AntialiasingMethod method) {
  switch (method) {
    case AntialiasingMethod::supersample2: return 2;
    case AntialiasingMethod::supersample4: return 4;
    case AntialiasingMethod::supersample8: return 8;
    case AntialiasingMethod::supersample16: return 16;
    case AntialiasingMethod::supersample32: return 32;
    case AntialiasingMethod::none:
    case AntialiasingMethod::area:
    case AntialiasingMethod::multisample4: break;
  }
  return 1;
}

/// Copies the pixels of a plane.
void copy_plane(const Framebuffer& size, const TiledBuffer& from, const TiledBuffer& to) {
  if (from.empty()) return;
  const auto bytes = static_cast<std::size_t>(from.bytes_per_pixel());
  for (int y = 0; y < size.height_px; ++y) {
    for (int x = 0; x < size.width_px; x += block_size) {  // a block's row lies in one piece
      std::memcpy(to.pixel(x, y), from.pixel(x, y), bytes * static_cast<std::size_t>(std::min(block_size, size.width_px - x)));
    }
  }
}

void store_mean(double sum, int samples, std::uint8_t& out) { out = static_cast<std::uint8_t>(sum / samples + 0.5); }
void store_mean(double sum, int samples, std::uint16_t& out) { out = static_cast<std::uint16_t>(sum / samples + 0.5); }
void store_mean(double sum, int samples, float& out) { out = static_cast<float>(sum / samples); }

template <class Word>
void resolve_colors(const Framebuffer& sampled, const Framebuffer& to) {
  std::vector<TiledBuffer> samples;
  for (int sample = 0; sample < sampled.samples; ++sample) samples.push_back(sampled.color.plane(sample));
  for (int y = 0; y < to.height_px; ++y) {
    for (int x = 0; x < to.width_px; ++x) {
      std::array<double, 4> sum{};
      for (const TiledBuffer& plane : samples) {
        std::array<Word, 4> color;
        std::memcpy(color.data(), plane.pixel_value(x, y), sizeof color);
        for (std::size_t k = 0; k < 4; ++k) sum[k] += static_cast<double>(color[k]);
      }
      std::array<Word, 4> mean;
      for (std::size_t k = 0; k < 4; ++k) store_mean(sum[k], sampled.samples, mean[k]);
      std::memcpy(to.color.pixel(x, y), mean.data(), sizeof mean);
    }
  }
}

}  // namespace

int samples_of(AntialiasingMethod method) {
  const int grid = grid_of(method);
  return method == AntialiasingMethod::multisample4 ? static_cast<int>(sample_positions.size()) : grid * grid;
}

std::array<float, 2> sample_position(AntialiasingMethod method, std::size_t sample) {
  if (method == AntialiasingMethod::multisample4) return sample_positions[sample];
  const auto grid = static_cast<std::size_t>(grid_of(method));
  const auto place = [grid](std::size_t index) { return (static_cast<float>(index) + 0.5f) / static_cast<float>(grid); };
  return {place(sample % grid), place(sample / grid)};
}

Framebuffer make_sampled(const Framebuffer& like, int samples) {
  Framebuffer result = like;
  result.samples = samples;
  result.accum = {};
  for (TiledBuffer* plane : {&result.color, &result.depth, &result.stencil}) {
    if (!plane->empty()) *plane = TiledBuffer(like.width_px, like.height_px, plane->bytes_per_pixel(), samples);
  }
  return result;
}

void load_samples(const Framebuffer& from, const Framebuffer& sampled) {
  for (int i = 0; i < sampled.samples; ++i) {
    const Framebuffer sample = sampled.sample(i);
    copy_plane(from, from.color, sample.color);
    copy_plane(from, from.depth, sample.depth);
    copy_plane(from, from.stencil, sample.stencil);
  }
  if (!from.depth.empty() && from.depth_format == DepthFormat::z24s8 && from.depth.stencil_in_use()) sampled.depth.use_stencil();
}

void resolve_samples(const Framebuffer& sampled, const Framebuffer& to) {
  switch (to.color_format) {
    case ColorFormat::rgba8: resolve_colors<std::uint8_t>(sampled, to); break;
    case ColorFormat::rgba16: resolve_colors<std::uint16_t>(sampled, to); break;
    case ColorFormat::rgba32f: resolve_colors<float>(sampled, to); break;
    case ColorFormat::none: break;
  }
  int side = 1;
  while (side * side < sampled.samples) ++side;
  const Framebuffer middle = sampled.sample(side / 2 * side + side / 2);
  copy_plane(to, middle.depth, to.depth);
  copy_plane(to, middle.stencil, to.stencil);
  if (!to.depth.empty() && to.depth_format == DepthFormat::z24s8 && sampled.depth.stencil_in_use()) to.depth.use_stencil();
}

}  // namespace gouraud::pipeline
