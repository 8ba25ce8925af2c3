// Which pixels an aliased line has [GL1.5 §3.4.1, §3.4.2]: exact integers of end points in 1/256 pixel.
//
// A line makes the fragment of every diamond |x - xc| + |y - yc| < 1/2 that it touches, except the one that its end
// lies in. For a line more horizontal than vertical that is one pixel in every column whose centre it crosses, plus
// the start's diamond, less the end's. Both end points count as moved by (-eps, -eps^2), which decides all ties.
//
// So the pixels of a row of columns are those between two straight lines: two edge functions and a box. A wide line is
// moved in the minor direction, and has that many pixels in each column.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "pipeline/raster/primitive.h"

namespace gouraud::pipeline {

/// A fragment on its own, for primitives that are walked pixel by pixel.
struct PixelPosition {
  std::int32_t x = 0, y = 0;
  bool operator==(const PixelPosition&) const = default;
};

/// A position in 1/256 pixel, y up; pixel centres lie at multiples of 256.
struct SubpixelPoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const SubpixelPoint&) const = default;
};

class LineCoverage {
 public:
  /// The line from a to b, which differ; `width` >= 1.
  LineCoverage(SubpixelPoint a, SubpixelPoint b, std::int32_t width);

  /// True if edges() and box() say it all: the columns then follow each other without a gap. (Start points on a
  /// diamond's border can make a second pixel in a column.)
  bool is_simple() const { return simple_; }
  /// Simple lines: pixels with non-negative values and inside the box.
  std::array<EdgeFunction, 2> edges() const;
  PixelRect box() const;

  /// Appends the lowest pixel of each column (the leftmost of each row, if the line is steep), in order from a to b.
  void list_columns(std::vector<PixelPosition>& pixels) const;
  /// Appends the pixels of the column that starts with `lowest`.
  void list_column(PixelPosition lowest, std::vector<PixelPosition>& pixels) const;

 private:
  PixelPosition pixel(std::int64_t column, std::int64_t row) const;
  PixelPosition pixel_at(std::int64_t column) const;
  bool is_lowest(PixelPosition pixel) const;
  void find_columns();

  SubpixelPoint a_, b_;
  std::int32_t width_;
  bool steep_;
  std::int64_t major_a_, minor_a_, major_b_, minor_b_, length_, direction_, rise_;
  /// The line's height over column i is (start_ + rise_ * direction_ * 256 i) / (256 * length_), less `tie_` before it is
  /// rounded down.
  std::int64_t start_, tie_;
  std::optional<PixelPosition> start_pixel_, end_pixel_;
  std::int64_t first_, end_;    ///< columns whose centres it crosses: [first_, end_)
  std::int64_t first_drawn_, end_drawn_;
  bool simple_ = true;
};

}  // namespace gouraud::pipeline
