// Row by row: the source row, as floats or as it is stored, is sampled along a list of columns that is made once.
//
// A destination pixel's centre has its place in the source by the rectangles' proportions. The nearest pixel holds that
// place; between pixels colours are interpolated from the four centres around it, none from outside the source rectangle.
//
// Where pixels keep their place, which is how programs resolve samples, tiles are copied or averaged as they lie in memory.
#include "pipeline/framebuffer/blit.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "pipeline/framebuffer/read.h"
#include "pipeline/framebuffer/resolve.h"
#include "pipeline/framebuffer/tile_runs.h"

namespace gouraud::pipeline {
namespace {

/// Where one axis of the source is read for a destination coordinate.
struct Tap {
  std::int32_t destination, first, second;  ///< second: only for interpolation
  float weight;                             ///< of the second
};

/// The taps of an axis. The products are exact in double and the quotient is rounded once, so that what is an integer
/// stays one.
std::vector<Tap> taps_of(std::int32_t source0, std::int32_t source1, std::int32_t destination0, std::int32_t destination1,
                         std::int32_t scissor0, std::int32_t scissor1, std::int32_t source_size, bool linear) {
  std::vector<Tap> taps;
  if (source0 == source1 || destination0 == destination1) return taps;
  const double length = static_cast<double>(destination1) - destination0, reach = static_cast<double>(source1) - source0;
  const std::int32_t begin = std::max(std::min(destination0, destination1), scissor0);
  const std::int32_t end = std::min(std::max(destination0, destination1), scissor1);
  const std::int32_t lowest = std::max(std::min(source0, source1), 0);
  const std::int32_t highest = std::min(std::max(source0, source1), source_size) - 1;
  for (std::int32_t at = begin; at < end; ++at) {
    const double place = source0 + (at + 0.5 - destination0) * reach / length;
    if (!(place >= 0 && place < source_size)) continue;
    if (!linear) {
      taps.push_back({at, static_cast<std::int32_t>(place), 0, 0.0f});
      continue;
    }
    const double low = std::floor(place - 0.5);
    const auto inside = [&](double pixel) { return std::clamp(static_cast<std::int32_t>(pixel), lowest, highest); };
    taps.push_back({at, inside(low), inside(low + 1), static_cast<float>(place - 0.5 - low)});
  }
  return taps;
}

/// Gives pixels to the places in a plane's row: write(pointer to the pixel, i) for every tap.
template <class Write>
void write_row(const TiledBuffer& plane, std::int32_t y, const std::vector<Tap>& columns, Write write) {
  for (std::size_t i = 0; i < columns.size(); ++i) write(plane.pixel(columns[i].destination, y), i);
}

float quantized(float value, float largest) { return std::nearbyint(std::clamp(value, 0.0f, 1.0f) * largest); }

/// Writes a row of colours R, G, B, A, leaving alone the channels that the plane does not have.
void write_colors(const Framebuffer& destination, std::int32_t y, const std::vector<Tap>& columns,
                  const std::vector<float>& colors) {
  const auto write = [&]<class Channel>(Channel, auto convert) {
    write_row(destination.color, y, columns, [&](std::byte* pixel, std::size_t i) {
      Channel channels[4];
      std::memcpy(channels, pixel, sizeof channels);
      for (std::size_t k = 0; k < 4; ++k) {
        if ((destination.color_channels >> k & 1) != 0) channels[k] = convert(colors[4 * i + k]);
      }
      std::memcpy(pixel, channels, sizeof channels);
    });
  };
  switch (destination.color_format) {
    case ColorFormat::rgba8:
      return write(std::uint8_t{}, [](float v) { return static_cast<std::uint8_t>(quantized(v, 255.0f)); });
    case ColorFormat::rgba16:
      return write(std::uint16_t{}, [](float v) { return static_cast<std::uint16_t>(quantized(v, 65535.0f)); });
    case ColorFormat::rgba32f:
      return write(float{}, [](float v) { return v; });
    case ColorFormat::none:
      return;
  }
}

/// A row of the source between the outermost columns that are read, all of them inside it.
struct SourceSpan {
  std::int32_t x = 0, count = 0;
  explicit SourceSpan(const std::vector<Tap>& columns, bool linear) {
    std::int32_t last = 0;
    x = columns.front().first;
    for (const Tap& tap : columns) {
      x = std::min(x, linear ? std::min(tap.first, tap.second) : tap.first);
      last = std::max(last, linear ? std::max(tap.first, tap.second) : tap.first);
    }
    count = last - x + 1;
  }
};

/// The average of a row's samples.
void read_resolved(const Framebuffer& source, const SourceSpan& span, std::int32_t y, std::vector<float>& row,
                   std::vector<float>& sample_row) {
  row.resize(static_cast<std::size_t>(span.count) * 4);
  read_color_row_float(source.sample(0), span.x, y, span.count, row.data());
  if (source.samples == 1) return;
  sample_row.resize(row.size());
  for (int sample = 1; sample < source.samples; ++sample) {
    read_color_row_float(source.sample(sample), span.x, y, span.count, sample_row.data());
    for (std::size_t i = 0; i < row.size(); ++i) row[i] += sample_row[i];
  }
  for (float& value : row) value /= static_cast<float>(source.samples);
}

/// Colours by way of floats: every format to every other.
void blit_color(const Framebuffer& source, const Framebuffer& destination, const std::vector<Tap>& columns,
                const std::vector<Tap>& rows, bool linear) {
  const SourceSpan span(columns, linear);
  std::vector<float> low, high, scratch, colors(columns.size() * 4);
  for (const Tap& row : rows) {
    read_resolved(source, span, row.first, low, scratch);
    if (linear) {
      read_resolved(source, span, row.second, high, scratch);
      for (std::size_t i = 0; i < low.size(); ++i) low[i] += row.weight * (high[i] - low[i]);
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const auto left = static_cast<std::size_t>(columns[i].first - span.x) * 4;
      const auto right = static_cast<std::size_t>((linear ? columns[i].second : columns[i].first) - span.x) * 4;
      for (std::size_t k = 0; k < 4; ++k) {
        colors[4 * i + k] = low[left + k] + columns[i].weight * (low[right + k] - low[left + k]);
      }
    }
    write_colors(destination, row.destination, columns, colors);
  }
}

/// Nearest colours of 8 bits, bytes as they are; several samples are averaged, to nearest even.
void blit_color_8(const Framebuffer& source, const Framebuffer& destination, const std::vector<Tap>& columns,
                  const std::vector<Tap>& rows) {
  const SourceSpan span(columns, false);
  std::uint32_t mask = 0;
  for (int k = 0; k < 4; ++k) mask |= (destination.color_channels >> k & 1) != 0 ? 0xFFu << (8 * k) : 0u;
  std::vector<std::uint32_t> words(static_cast<std::size_t>(span.count)), sample_words(words.size());
  std::vector<std::uint16_t> sums(source.samples > 1 ? words.size() * 4 : 0);
  for (const Tap& row : rows) {
    read_color_row(source, span.x, row.first, span.count, words.data());
    if (source.samples > 1) {
      std::fill(sums.begin(), sums.end(), std::uint16_t{0});
      auto* const bytes = reinterpret_cast<std::uint8_t*>(sample_words.data());
      for (int sample = 0; sample < source.samples; ++sample) {
        read_color_row(source.sample(sample), span.x, row.first, span.count, sample_words.data());
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = static_cast<std::uint16_t>(sums[i] + bytes[i]);
      }
      static_assert(max_samples == 4, "a sum is divided by 4");
      auto* const averages = reinterpret_cast<std::uint8_t*>(words.data());
      for (std::size_t i = 0; i < sums.size(); ++i) {
        averages[i] = static_cast<std::uint8_t>((sums[i] + 1 + (sums[i] >> 2 & 1)) >> 2);
      }
    }
    write_row(destination.color, row.destination, columns, [&](std::byte* pixel, std::size_t i) {
      std::uint32_t word;
      std::memcpy(&word, pixel, sizeof word);
      word = (words[static_cast<std::size_t>(columns[i].first - span.x)] & mask) | (word & ~mask);
      std::memcpy(pixel, &word, sizeof word);
    });
  }
}

template <class Word>
void copy_words(const TiledBuffer& source, const TiledBuffer& destination, const std::vector<Tap>& columns,
                const std::vector<Tap>& rows, Word mask) {
  std::vector<Word> words(columns.size());
  for (const Tap& row : rows) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      std::memcpy(&words[i], source.pixel_value(columns[i].first, row.first), sizeof(Word));
    }
    write_row(destination, row.destination, columns, [&](std::byte* pixel, std::size_t i) {
      Word word;
      std::memcpy(&word, pixel, sizeof word);
      word = static_cast<Word>((words[i] & mask) | (word & static_cast<Word>(~mask)));
      std::memcpy(pixel, &word, sizeof word);
    });
  }
}

/// Calls run(offset, size) for each stretch of bytes that the planes' tiles have inside the box, at most of one tile, behind
/// begin(tile_x, tile_y).
template <class Begin, class Run>
void for_each_stretch(const Framebuffer& destination, const PixelRect& box, int bytes_per_pixel, const Begin& begin, const Run& run) {
  for (std::int32_t tile = 0; tile < destination.tile_count(); ++tile) {
    const TileCut in_tile(destination, tile, box);
    const std::int32_t x = in_tile.tile_x * tile_size, y = in_tile.tile_y * tile_size;
    const PixelRect cut{std::max(box.x0 - x, 0), std::max(box.y0 - y, 0), std::min(box.x1 - x, tile_size), std::min(box.y1 - y, tile_size)};
    if (cut.empty()) continue;
    begin(in_tile.tile_x, in_tile.tile_y);
    for_each_run(cut, [&](std::int32_t first, std::int32_t count) {
      run(static_cast<std::size_t>(first * bytes_per_pixel), static_cast<std::size_t>(count * bytes_per_pixel));
    });
  }
}

/// Bytes of colour keep their place; several samples are averaged. All channels are written.
void resolve_in_place(const Framebuffer& source, const Framebuffer& destination, const PixelRect& box) {
  const ByteAverager average = byte_averager();
  const std::byte* from[max_samples];
  std::byte* to = nullptr;
  const auto begin = [&](std::int32_t tile_x, std::int32_t tile_y) {
    for (int k = 0; k < source.samples; ++k) from[k] = source.sample(k).color.tile(tile_x, tile_y);
    to = destination.color.tile(tile_x, tile_y);
  };
  for_each_stretch(destination, box, 4, begin, [&](std::size_t offset, std::size_t size) {
    if (source.samples == 1) {
      std::memmove(to + offset, from[0] + offset, size);
      return;
    }
    const std::byte* const samples[max_samples] = {from[0] + offset, from[1] + offset, from[2] + offset, from[3] + offset};
    average(samples, to + offset, size);
  });
}

/// The bits of words of depth that `mask` names keep their place.
template <class Word>
void copy_in_place(const TiledBuffer& source, const Framebuffer& destination, const PixelRect& box, Word mask) {
  const std::byte* from = nullptr;
  std::byte* to = nullptr;
  const auto begin = [&](std::int32_t tile_x, std::int32_t tile_y) {
    from = source.tile(tile_x, tile_y);
    to = destination.depth.tile(tile_x, tile_y);
  };
  for_each_stretch(destination, box, sizeof(Word), begin, [&](std::size_t offset, std::size_t size) {
    const auto* const words = reinterpret_cast<const Word*>(from + offset);
    auto* const out = reinterpret_cast<Word*>(to + offset);
    for (std::size_t i = 0; i < size / sizeof(Word); ++i) out[i] = static_cast<Word>((words[i] & mask) | (out[i] & ~mask));
  });
}

/// Calls copy(mask) with the bits of a word of depth.
template <class Copy>
void with_depth_mask(DepthFormat format, const Copy& copy) {
  switch (format) {
    case DepthFormat::z16: return copy(std::uint16_t{0xFFFF});
    case DepthFormat::z24s8: return copy(std::uint32_t{0xFFFFFF});
    case DepthFormat::z32:
    case DepthFormat::z32f: return copy(~std::uint32_t{0});
    case DepthFormat::none: return;
  }
}

/// Stencil lies in the depth words or apart, here and there.
void blit_stencil(const Framebuffer& source, const Framebuffer& destination, const std::vector<Tap>& columns,
                  const std::vector<Tap>& rows) {
  const bool in_words = destination.depth_format == DepthFormat::z24s8;
  if (in_words) destination.depth.use_stencil();
  const SourceSpan span(columns, false);
  std::vector<std::uint8_t> values(static_cast<std::size_t>(span.count)), chosen(columns.size());
  for (const Tap& row : rows) {
    read_stencil_row(source, span.x, row.first, span.count, values.data());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      chosen[i] = values[static_cast<std::size_t>(columns[i].first - span.x)];
    }
    const TiledBuffer& plane = in_words ? destination.depth : destination.stencil;
    write_row(plane, row.destination, columns, [&](std::byte* pixel, std::size_t i) {
      pixel[in_words ? 3 : 0] = static_cast<std::byte>(chosen[i]);  // the top byte of a little-endian word
    });
  }
}

}  // namespace

void blit(const Framebuffer& source, const Framebuffer& destination, const Blit& blit) {
  const BlitRect &from = blit.source, &to = blit.destination;
  const auto columns_of = [&](bool linear) {
    return taps_of(from.x0, from.x1, to.x0, to.x1, blit.scissor.x0, blit.scissor.x1, source.width_px, linear);
  };
  const auto rows_of = [&](bool linear) {
    return taps_of(from.y0, from.y1, to.y0, to.y1, blit.scissor.y0, blit.scissor.y1, source.height_px, linear);
  };
  const std::vector<Tap> columns = columns_of(false), rows = rows_of(false);
  if (columns.empty() || rows.empty()) return;
  const bool in_place = from.x0 == to.x0 && from.y0 == to.y0 && from.x1 == to.x1 && from.y1 == to.y1;
  const auto ends_of = [](const std::vector<Tap>& taps) {
    return std::minmax(taps.front().destination, taps.back().destination);
  };
  const auto [x0, x1] = ends_of(columns);
  const auto [y0, y1] = ends_of(rows);
  const PixelRect box{x0, y0, x1 + 1, y1 + 1};

  const bool color = blit.color && !source.color.empty() && !destination.color.empty();
  const bool bytes = source.color_format == ColorFormat::rgba8 && destination.color_format == ColorFormat::rgba8;
  for (int sample = 0; sample < destination.samples; ++sample) {
    const Framebuffer target = destination.sample(sample);
    const Framebuffer origin = destination.samples == source.samples ? source.sample(sample) : source;
    if (color && bytes && in_place && destination.color_channels == 0xF) {
      resolve_in_place(origin, target, box);
    } else if (color && bytes && !blit.linear) {
      blit_color_8(origin, target, columns, rows);
    } else if (color) {
      blit_color(origin, target, columns_of(blit.linear), rows_of(blit.linear), blit.linear);
    }
    if (blit.depth && source.has_depth && destination.has_depth) {
      with_depth_mask(destination.depth_format, [&](auto mask) {
        in_place ? copy_in_place(origin.depth, target, box, mask) : copy_words(origin.depth, target.depth, columns, rows, mask);
      });
    }
    if (blit.stencil && source.stencil_bits > 0 && destination.stencil_bits > 0) {
      blit_stencil(origin, target, columns, rows);
    }
  }
}

}  // namespace gouraud::pipeline
