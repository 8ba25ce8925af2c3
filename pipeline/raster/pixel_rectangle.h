// Pixel rectangles: which pixels of the window belong to which pixel of an image [GL1.5 §3.6.4].
#pragma once

#include <cstdint>
#include <vector>

#include "pipeline/draw/draw_state.h"
#include "pipeline/raster/pixel_image.h"

namespace gouraud::pipeline {

/// One axis: window pixels [begin, end), and the source of each (counted from the first that was asked for). No table:
/// begin + i has source `first_source` + i.
struct AxisMap {
  std::int32_t begin = 0, end = 0;
  std::int32_t first_source = 0;
  std::vector<std::int32_t> source;
  bool empty() const { return begin >= end; }
  std::int32_t source_of(std::int32_t pixel) const {
    return source.empty() ? first_source + (pixel - begin) : source[static_cast<std::size_t>(pixel - begin)];
  }
};

/// Sources n in [0, count) lie between origin + zoom * (first + n) and origin + zoom * (first + n + 1); a window pixel
/// in [low, high) whose centre lies between them, or on the lower end, is n's. Empty for a zoom of 0, NaN or infinity.
AxisMap map_axis(double origin, double zoom, std::int32_t first, std::int32_t count, std::int32_t low, std::int32_t high);

/// Sources [first, end) of the axis that have a pixel in its range.
struct SourceRange {
  std::int32_t first = 0, end = 0;
  std::int32_t count() const { return end - first; }
};
SourceRange visible_sources(const AxisMap& axis);

}  // namespace gouraud::pipeline
