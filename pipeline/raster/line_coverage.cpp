#include "pipeline/raster/line_coverage.h"

#include <algorithm>
#include <cstdlib>

namespace gouraud::pipeline {
namespace {

constexpr std::int64_t half_pixel = subpixels / 2;

constexpr std::int64_t floor_of_pixels(std::int64_t subpixel) { return subpixel >> subpixel_bits; }

std::int64_t floor_divide(std::int64_t numerator, std::int64_t positive) {
  const std::int64_t quotient = numerator / positive;
  return quotient - (numerator % positive < 0 ? 1 : 0);
}

/// The pixel whose diamond holds the point moved by (-eps, -eps^2), if any.
std::optional<PixelPosition> diamond_around(SubpixelPoint p) {
  const std::int64_t i = floor_of_pixels(p.x + half_pixel), j = floor_of_pixels(p.y + half_pixel);
  const std::int64_t dx = p.x - i * subpixels, dy = p.y - j * subpixels;
  const std::int64_t distance = std::abs(dx) + std::abs(dy);
  const PixelPosition pixel{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j)};
  // On the boundary the shift leads inside from the right. (dx = 128 was rounded into the next pixel, as dx = -128:
  // from that pixel's right corner the shift leads inside the left neighbour.)
  if (distance < half_pixel || (distance == half_pixel && dx > 0)) return pixel;
  if (dx == -half_pixel && dy == 0) return PixelPosition{pixel.x - 1, pixel.y};
  return std::nullopt;
}

}  // namespace

LineCoverage::LineCoverage(SubpixelPoint a, SubpixelPoint b, std::int32_t width)
    : a_(a), b_(b), width_(width), steep_(std::abs(b.y - a.y) > std::abs(b.x - a.x)) {
  const std::int64_t shift = half_pixel * (width - 1);
  (steep_ ? a_.x : a_.y) -= shift;
  (steep_ ? b_.x : b_.y) -= shift;
  major_a_ = steep_ ? a_.y : a_.x;
  minor_a_ = steep_ ? a_.x : a_.y;
  major_b_ = steep_ ? b_.y : b_.x;
  minor_b_ = steep_ ? b_.x : b_.y;
  length_ = std::abs(major_b_ - major_a_);
  direction_ = major_b_ > major_a_ ? 1 : -1;
  rise_ = minor_b_ - minor_a_;

  // The shift moves a height on the border between two pixels up if the line rises to the right, and down otherwise.
  // In rows (steep lines) it moves it left.
  start_ = (minor_a_ + half_pixel) * length_ - rise_ * direction_ * major_a_;
  tie_ = !steep_ && rise_ * direction_ > 0 ? 0 : 1;
  start_pixel_ = diamond_around(a_);
  end_pixel_ = diamond_around(b_);
  first_ = floor_of_pixels(std::min(major_a_, major_b_) + subpixels - 1);
  end_ = floor_of_pixels(std::max(major_a_, major_b_) + subpixels - 1);
  find_columns();
}

PixelPosition LineCoverage::pixel(std::int64_t column, std::int64_t row) const {
  const auto i = static_cast<std::int32_t>(column), j = static_cast<std::int32_t>(row);
  return steep_ ? PixelPosition{j, i} : PixelPosition{i, j};
}

PixelPosition LineCoverage::pixel_at(std::int64_t column) const {
  return pixel(column, floor_divide(start_ + rise_ * direction_ * subpixels * column - tie_, subpixels * length_));
}

bool LineCoverage::is_lowest(PixelPosition pixel) const {
  const std::int64_t column = steep_ ? pixel.y : pixel.x, row = steep_ ? pixel.x : pixel.y;
  const std::int64_t above = start_ + rise_ * direction_ * subpixels * column - tie_ - subpixels * length_ * row;
  return above >= 0 && above < subpixels * length_;
}

/// Adds the start's column and takes away the end's, where the line's height gives the same pixels as their diamonds.
void LineCoverage::find_columns() {
  first_drawn_ = first_;
  end_drawn_ = end_;
  const auto column_of = [this](PixelPosition p) { return static_cast<std::int64_t>(steep_ ? p.y : p.x); };
  if (start_pixel_ && !(end_pixel_ && *end_pixel_ == *start_pixel_)) {
    const std::int64_t column = column_of(*start_pixel_);
    const bool crossed = column >= first_ && column < end_;
    simple_ = is_lowest(*start_pixel_) && (crossed || first_ == end_ || column == (direction_ > 0 ? first_ - 1 : end_));
    if (!crossed) {
      first_drawn_ = first_ == end_ ? column : std::min(first_, column);
      end_drawn_ = first_ == end_ ? column + 1 : std::max(end_, column + 1);
    }
  }
  if (end_pixel_ && first_ < end_) {
    const std::int64_t column = column_of(*end_pixel_), last = direction_ > 0 ? end_ - 1 : first_;
    if (column == last && is_lowest(*end_pixel_)) {
      (direction_ > 0 ? end_drawn_ : first_drawn_) -= direction_;
    } else if (column >= first_ && column < end_ && is_lowest(*end_pixel_)) {
      simple_ = false;
    }
  }
}

std::array<EdgeFunction, 2> LineCoverage::edges() const {
  // Of the pixels (i, j) of a column: start + 256 slope i - tie - 256 length (j - width + 1) >= 0, and
  // 256 length (j + 1) - (start + 256 slope i - tie) > 0. All coefficients are multiples of 256.
  const std::int64_t slope = rise_ * direction_;
  const std::int64_t from_above = floor_of_pixels(start_ - tie_) + length_ * (width_ - 1);
  const std::int64_t from_below = floor_of_pixels(subpixels * length_ - start_ + tie_ - 1);
  const auto a = static_cast<std::int32_t>(slope), b = static_cast<std::int32_t>(-length_);
  if (steep_) return {EdgeFunction{from_above, b, a}, EdgeFunction{from_below, -b, -a}};
  return {EdgeFunction{from_above, a, b}, EdgeFunction{from_below, -a, -b}};
}

PixelRect LineCoverage::box() const {
  const auto [low, high] = std::minmax(minor_a_, minor_b_);
  // A tie may take the lowest row down by one.
  const PixelPosition least = pixel(first_drawn_, floor_of_pixels(low + half_pixel - 1));
  const PixelPosition most = pixel(end_drawn_, floor_of_pixels(high + half_pixel) + width_);
  return {least.x, least.y, most.x, most.y};
}

void LineCoverage::list_columns(std::vector<PixelPosition>& pixels) const {
  const auto ends_in = [&](PixelPosition pixel) { return end_pixel_ && *end_pixel_ == pixel; };
  const bool starts_in_diamond = start_pixel_ && !ends_in(*start_pixel_);
  if (starts_in_diamond && (first_ == end_ || !(*start_pixel_ == pixel_at(direction_ > 0 ? first_ : end_ - 1)))) {
    pixels.push_back(*start_pixel_);
  }
  for (std::int64_t k = 0; k < end_ - first_; ++k) {
    const PixelPosition pixel = pixel_at(direction_ > 0 ? first_ + k : end_ - 1 - k);
    if (!ends_in(pixel)) pixels.push_back(pixel);
  }
}

void LineCoverage::list_column(PixelPosition lowest, std::vector<PixelPosition>& pixels) const {
  for (std::int32_t k = 0; k < width_; ++k) {
    pixels.push_back({lowest.x + (steep_ ? k : 0), lowest.y + (steep_ ? 0 : k)});
  }
}

}  // namespace gouraud::pipeline
