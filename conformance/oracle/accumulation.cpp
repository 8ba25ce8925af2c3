#include "conformance/oracle/accumulation.h"

#include <algorithm>
#include <cmath>

#include "conformance/oracle/fragments.h"

namespace gouraud::oracle {
namespace {

/// A value and the bounds of what a conforming implementation may have in its place.
struct Bounded {
  double value = 0, lowest = 0, highest = 0;

  Bounded scaled(double factor) const {
    const double a = lowest * factor, b = highest * factor;
    return {value * factor, std::min(a, b), std::max(a, b)};
  }
  Bounded plus(const Bounded& other) const { return {value + other.value, lowest + other.lowest, highest + other.highest}; }
  Bounded clamped(double low, double high) const {
    return {std::clamp(value, low, high), std::clamp(lowest, low, high), std::clamp(highest, low, high)};
  }
};

/// A colour is taken as it is stored. Where that is not known exactly, its bounds are those of the pixel.
Bounded color_of(const OraclePixel& pixel, std::size_t i) {
  const double stored = pixel.color_unorm8[i] / 255.0;
  if (pixel.color_lowest[i] == pixel.color_highest[i]) return {stored, stored, stored};
  return {stored, static_cast<double>(pixel.color_lowest[i]), static_cast<double>(pixel.color_highest[i])};
}

Bounded sum_of(const OraclePixel& pixel, std::size_t i) {
  const bool exact = pixel.accum_lowest[i] == pixel.accum_highest[i];
  if (exact) return {pixel.accum[i], pixel.accum[i], pixel.accum[i]};
  return {pixel.accum[i], static_cast<double>(pixel.accum_lowest[i]), static_cast<double>(pixel.accum_highest[i])};
}

void set_sum(OraclePixel& pixel, std::size_t i, const Bounded& sum) {
  const Bounded kept = sum.clamped(-1, 1);
  pixel.accum[i] = kept.value;
  pixel.accum_lowest[i] = static_cast<float>(kept.lowest);
  pixel.accum_highest[i] = static_cast<float>(kept.highest);
}

void set_color(OraclePixel& pixel, std::size_t i, const Bounded& color) {
  const Bounded kept = color.clamped(0, 1);
  pixel.color[i] = kept.value;
  pixel.color_unorm8[i] = static_cast<std::uint8_t>(std::nearbyint(kept.value * 255));
  pixel.color_lowest[i] = static_cast<float>(kept.lowest);
  pixel.color_highest[i] = static_cast<float>(kept.highest);
}

void accumulate_channel(const pipeline::AccumState& state, OraclePixel& pixel, std::size_t i) {
  const auto value = static_cast<double>(state.value);
  switch (state.op) {
    case pipeline::AccumOp::accumulate:
      return set_sum(pixel, i, sum_of(pixel, i).plus(color_of(pixel, i).scaled(value)));
    case pipeline::AccumOp::load:
      return set_sum(pixel, i, color_of(pixel, i).scaled(value));
    case pipeline::AccumOp::add:
      return set_sum(pixel, i, sum_of(pixel, i).plus({value, value, value}));
    case pipeline::AccumOp::multiply:
      return set_sum(pixel, i, sum_of(pixel, i).scaled(value));
    case pipeline::AccumOp::give_back:
      if ((state.color_write_mask >> i & 1) != 0) set_color(pixel, i, sum_of(pixel, i).scaled(value));
  }
}

}  // namespace

void accumulate_picture(OraclePicture& picture, const pipeline::AccumState& state) {
  change_pixels(picture, state.scissor, [&](OraclePixel& pixel) {
    for (std::size_t i = 0; i < 4; ++i) accumulate_channel(state, pixel, i);
  });
}

}  // namespace gouraud::oracle
