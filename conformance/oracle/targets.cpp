#include "conformance/oracle/targets.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "conformance/oracle/fragments.h"

namespace gouraud::oracle {
namespace {

using pipeline::ColorFormat;
using pipeline::DepthFormat;
using pipeline::Framebuffer;
using pipeline::TiledBuffer;

template <class Word>
Word word_at(const TiledBuffer& plane, int x, int y, std::size_t index = 0) {
  Word word;
  std::memcpy(&word, plane.pixel_value(x, y) + index * sizeof(Word), sizeof(Word));
  return word;
}

double channel_at(const Framebuffer& framebuffer, int x, int y, std::size_t channel) {
  switch (framebuffer.color_format) {
    case ColorFormat::rgba8: return word_at<std::uint8_t>(framebuffer.color, x, y, channel) / 255.0;
    case ColorFormat::rgba16: return word_at<std::uint16_t>(framebuffer.color, x, y, channel) / 65535.0;
    case ColorFormat::rgba32f: return static_cast<double>(word_at<float>(framebuffer.color, x, y, channel));
    case ColorFormat::none: break;
  }
  return 0;
}

double depth_units_at(const Framebuffer& framebuffer, int x, int y) {
  switch (framebuffer.depth_format) {
    case DepthFormat::z16: return word_at<std::uint16_t>(framebuffer.depth, x, y);
    case DepthFormat::z24s8: return word_at<std::uint32_t>(framebuffer.depth, x, y) & 0xFFFFFF;
    case DepthFormat::z32: return word_at<std::uint32_t>(framebuffer.depth, x, y);
    case DepthFormat::z32f: return static_cast<double>(word_at<float>(framebuffer.depth, x, y)) * depth_units_of(32);
    case DepthFormat::none: break;
  }
  return 0;
}

std::uint8_t stencil_at(const Framebuffer& framebuffer, int x, int y) {
  if (!framebuffer.stencil.empty()) return word_at<std::uint8_t>(framebuffer.stencil, x, y);
  if (framebuffer.depth_format != DepthFormat::z24s8 || framebuffer.depth.empty()) return 0;
  return static_cast<std::uint8_t>(word_at<std::uint32_t>(framebuffer.depth, x, y) >> 24);
}

/// What the planes hold. Of several samples the first one's: they begin alike.
OraclePixel as_stored(const Framebuffer& framebuffer, int x, int y) {
  OraclePixel pixel;
  for (std::size_t i = 0; i < 4 && !framebuffer.color.empty(); ++i) {
    pixel.color[i] = channel_at(framebuffer, x, y, i);
    pixel.color_unorm8[i] = static_cast<std::uint8_t>(std::nearbyint(std::clamp(pixel.color[i], 0.0, 1.0) * 255));
    pixel.color_lowest[i] = pixel.color_highest[i] = static_cast<float>(pixel.color[i]);
  }
  if (!framebuffer.depth.empty()) {
    pixel.depth_units = depth_units_at(framebuffer, x, y);
    pixel.depth_stored = pixel.depth_lowest = pixel.depth_highest = static_cast<std::uint32_t>(std::nearbyint(pixel.depth_units));
  }
  pixel.stencil = stencil_at(framebuffer, x, y);
  return pixel;
}

/// Where pixels are outside of the other picture there is nothing to copy.
template <class Copy>
void copy_plane(const Samples& from, Samples& to, std::uint8_t flags_copied, const Copy& copy) {
  for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) {
    for (int y = 0; y < std::min(from[k].height_px, to[k].height_px); ++y) {
      for (int x = 0; x < std::min(from[k].width_px, to[k].width_px); ++x) {
        const auto [pixel, flags] = with_all_outcomes(from[k], from[k].index(x, y));
        copy(pixel, to[k].pixels[to[k].index(x, y)]);
        to[k].flags[to[k].index(x, y)] |= static_cast<std::uint8_t>(flags & flags_copied);
      }
    }
  }
}

void copy_colors(const OraclePixel& from, OraclePixel& to) {
  to.color = from.color;
  to.color_unorm8 = from.color_unorm8;
  to.color_lowest = from.color_lowest;
  to.color_highest = from.color_highest;
}

void copy_depths(const OraclePixel& from, OraclePixel& to) {
  to.depth_units = from.depth_units;
  to.depth_stored = from.depth_stored;
  to.depth_lowest = from.depth_lowest;
  to.depth_highest = from.depth_highest;
}

}  // namespace

const Targets::Target* Targets::latest_with(TiledBuffer Framebuffer::*plane, const TiledBuffer& buffer) const {
  if (buffer.empty()) return nullptr;
  const auto found = std::ranges::find_if(targets_, [&](const Target& target) { return target.framebuffer.*plane == buffer; });
  return found != targets_.end() ? &*found : nullptr;
}

Samples Targets::made_of_latest(const Framebuffer& framebuffer) const {
  const int depth_bits = pipeline::depth_bits(framebuffer.depth_format);
  OraclePicture picture = make_picture(framebuffer.width_px, framebuffer.height_px, depth_bits);
  for (int y = 0; y < picture.height_px; ++y) {
    for (int x = 0; x < picture.width_px; ++x) picture.pixels[picture.index(x, y)] = as_stored(framebuffer, x, y);
  }
  Samples samples(static_cast<std::size_t>(framebuffer.samples), picture);
  constexpr std::uint8_t all_flags = 0xFF;
  if (const Target* target = latest_with(&Framebuffer::color, framebuffer.color)) copy_plane(target->samples, samples, all_flags, copy_colors);
  if (const Target* target = latest_with(&Framebuffer::depth, framebuffer.depth)) {
    copy_plane(target->samples, samples, 0, copy_depths);
    const bool in_words = framebuffer.stencil.empty();
    if (in_words) copy_plane(target->samples, samples, 0, [](const OraclePixel& from, OraclePixel& to) { to.stencil = from.stencil; });
  }
  if (const Target* target = latest_with(&Framebuffer::stencil, framebuffer.stencil)) {
    copy_plane(target->samples, samples, 0, [](const OraclePixel& from, OraclePixel& to) { to.stencil = from.stencil; });
  }
  return samples;
}

Samples& Targets::pictures_of(const Framebuffer& framebuffer) {
  const auto found = std::ranges::find(targets_, framebuffer, &Target::framebuffer);
  const auto is_latest = [&](TiledBuffer Framebuffer::*plane) {
    const TiledBuffer& buffer = framebuffer.*plane;
    return buffer.empty() || latest_with(plane, buffer) == &*found;
  };
  const bool up_to_date = found != targets_.end() && is_latest(&Framebuffer::color) && is_latest(&Framebuffer::depth) &&
                          is_latest(&Framebuffer::stencil);
  if (up_to_date) {
    targets_.splice(targets_.begin(), targets_, found);
    return targets_.front().samples;
  }
  Target made{framebuffer, made_of_latest(framebuffer)};
  if (found != targets_.end()) targets_.erase(found);
  targets_.push_front(std::move(made));
  return targets_.front().samples;
}

}  // namespace gouraud::oracle
