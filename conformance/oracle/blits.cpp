#include "conformance/oracle/blits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "conformance/oracle/fragments.h"

namespace gouraud::oracle {
namespace {

using pipeline::Blit;

/// Where an axis of the source is read for a pixel of the destination.
struct Taps {
  int first = 0, second = 0;  ///< the pixels on both sides of the place; of a nearest filter the two that are legal
  double weight = 0;          ///< of the second, under a linear filter
};

/// One axis of both rectangles.
struct Axis {
  std::int64_t source0, source1, destination0, destination1;
  int source_size;
  bool linear;

  /// Nothing if the place lies outside the source.
  std::optional<Taps> taps_at(int pixel) const {
    if (source0 == source1 || destination0 == destination1) return std::nullopt;
    // The place is n / d.
    std::int64_t d = 2 * (destination1 - destination0);
    std::int64_t n = source0 * d + (2 * (pixel - destination0) + 1) * (source1 - source0);
    if (d < 0) n = -n, d = -d;
    if (n < 0 || n >= source_size * d) return std::nullopt;
    if (!linear) {
      const auto nearest = static_cast<int>(n / d);
      return Taps{nearest, n % d == 0 ? std::max(nearest - 1, 0) : nearest, 0};
    }
    // Half a pixel back: (2 n - d) / (2 d), at least -1/2.
    const std::int64_t floor = (2 * n - d + 2 * d) / (2 * d) - 1;
    const double weight = static_cast<double>(2 * n - d - floor * 2 * d) / static_cast<double>(2 * d);
    return Taps{inside(floor), inside(floor + 1), weight};
  }
  int inside(std::int64_t pixel) const {
    const std::int64_t low = std::max<std::int64_t>(std::min(source0, source1), 0);
    const std::int64_t high = std::min<std::int64_t>(std::max(source0, source1), source_size) - 1;
    return static_cast<int>(std::clamp(pixel, low, high));
  }
  bool holds(int pixel) const { return pixel >= std::min(destination0, destination1) && pixel < std::max(destination0, destination1); }
};

/// A channel as it is stored, and the range of what may be stored.
struct Channel {
  double value = 0, lowest = 0, highest = 0;
  void add(const Channel& other, double weight) {
    value += weight * other.value;
    lowest += weight * other.lowest;
    highest += weight * other.highest;
  }
  bool is_exact() const { return lowest == highest; }
};

Channel channel_of(const OraclePixel& pixel, std::size_t i) {
  const bool exact = pixel.color_lowest[i] == pixel.color_highest[i];
  const double lowest = exact ? pixel.color[i] : static_cast<double>(pixel.color_lowest[i]);
  const double highest = exact ? pixel.color[i] : static_cast<double>(pixel.color_highest[i]);
  return {pixel.color_unorm8[i] / 255.0, std::nearbyint(lowest * 255 - color_slack_bytes) / 255, std::nearbyint(highest * 255 + color_slack_bytes) / 255};
}

void set_channel(OraclePixel& pixel, std::size_t i, const Channel& channel) {
  pixel.color[i] = channel.value;
  pixel.color_unorm8[i] = static_cast<std::uint8_t>(std::nearbyint(channel.value * 255));
  pixel.color_lowest[i] = static_cast<float>(channel.lowest);
  pixel.color_highest[i] = static_cast<float>(channel.highest);
}

/// The weighted sum of pixels' colours; depth and stencil of the first.
PixelOutcomes mixed(const std::vector<std::pair<PixelOutcomes, double>>& parts) {
  PixelOutcomes out = parts.front().first;
  for (const auto& part : parts) out.flags |= part.first.flags;
  for (std::size_t i = 0; i < 4; ++i) {
    Channel sum;
    for (const auto& [part, weight] : parts) sum.add(channel_of(part.pixel, i), weight);
    if (!sum.is_exact()) out.flags |= pixel_extrapolated;
    set_channel(out.pixel, i, sum);
  }
  return out;
}

/// What a pixel of the source is to the destination's sample k: its own sample, or all of them.
PixelOutcomes read(const Samples& source, const Samples& destination, std::size_t k, int x, int y) {
  const auto of_sample = [&](std::size_t sample) { return with_all_outcomes(source[sample], source[sample].index(x, y)); };
  if (source.size() == 1) return of_sample(0);
  if (source.size() == destination.size()) return of_sample(k);
  std::vector<std::pair<PixelOutcomes, double>> parts;
  for (std::size_t sample = 0; sample < source.size(); ++sample) parts.emplace_back(of_sample(sample), 1.0 / static_cast<double>(source.size()));
  return mixed(parts);
}

template <class Read>
PixelOutcomes filtered(const Taps& column, const Taps& row, bool linear, const Read& at) {
  if (linear) {
    return mixed({{at(column.first, row.first), (1 - column.weight) * (1 - row.weight)},
                  {at(column.second, row.first), column.weight * (1 - row.weight)},
                  {at(column.first, row.second), (1 - column.weight) * row.weight},
                  {at(column.second, row.second), column.weight * row.weight}});
  }
  PixelOutcomes out = at(column.first, row.first);
  for (const int x : {column.first, column.second}) {
    for (const int y : {row.first, row.second}) {
      if (x != column.first || y != row.first) out.include(at(x, y));
    }
  }
  return out;
}

void write(OraclePicture& picture, std::size_t index, const Blit& blit, std::uint8_t channels, const PixelOutcomes& from) {
  const auto copy = [&](OraclePixel& pixel) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!blit.color || (channels >> i & 1) == 0) continue;
      pixel.color[i] = from.pixel.color[i];
      pixel.color_unorm8[i] = from.pixel.color_unorm8[i];
      pixel.color_lowest[i] = from.pixel.color_lowest[i];
      pixel.color_highest[i] = from.pixel.color_highest[i];
    }
    if (blit.depth) {
      pixel.depth_units = from.pixel.depth_units;
      pixel.depth_stored = from.pixel.depth_stored;
      pixel.depth_lowest = from.pixel.depth_lowest;
      pixel.depth_highest = from.pixel.depth_highest;
    }
    if (blit.stencil) pixel.stencil = from.pixel.stencil;
  };
  const int x = static_cast<int>(index) % picture.width_px, y = static_cast<int>(index) / picture.width_px;
  const OraclePixel before = picture.pixels[index];
  change_pixels(picture, {x, y, x + 1, y + 1}, copy);
  if (blit.color || blit.depth) picture.flags[index] |= from.flags | pixel_covered;
  const OraclePixel& now = picture.pixels[index];
  const bool changed = now.color_unorm8 != before.color_unorm8 || now.depth_stored != before.depth_stored;
  if (changed) ++picture.fragments_written[index];
}

}  // namespace

void blit_samples(const Samples& source, Samples& destination, const Blit& blit, std::uint8_t channels) {
  const pipeline::BlitRect &from = blit.source, &to = blit.destination;
  const Axis columns{from.x0, from.x1, to.x0, to.x1, source[0].width_px, blit.linear};
  const Axis rows{from.y0, from.y1, to.y0, to.y1, source[0].height_px, blit.linear};
  for (std::size_t k = 0; k < destination.size(); ++k) {
    OraclePicture& picture = destination[k];
    for (int y = std::max(blit.scissor.y0, 0); y < std::min(blit.scissor.y1, picture.height_px); ++y) {
      for (int x = std::max(blit.scissor.x0, 0); x < std::min(blit.scissor.x1, picture.width_px); ++x) {
        if (!columns.holds(x) || !rows.holds(y)) continue;
        const auto column = columns.taps_at(x), row = rows.taps_at(y);
        if (!column || !row) continue;
        const auto at = [&](int i, int j) { return read(source, destination, k, i, j); };
        write(picture, picture.index(x, y), blit, channels, filtered(*column, *row, blit.linear, at));
      }
    }
  }
}

}  // namespace gouraud::oracle
