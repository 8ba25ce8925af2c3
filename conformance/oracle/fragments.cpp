#include "conformance/oracle/fragments.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "conformance/oracle/blending.h"
#include "conformance/oracle/fog.h"
#include "conformance/oracle/stencil.h"

namespace gouraud::oracle {
namespace {

using pipeline::CompareFunc;

/// NaN becomes 0.
double clamped_to_unit(double value) {
  return value > 0 ? std::min(value, 1.0) : 0.0;
}

/// A depth as the buffer holds it: what is stored, and the range of what may have been stored.
struct Depth {
  double units = 0;
  std::uint32_t stored = 0, lowest = 0, highest = 0;
};

/// Nearest integer, ties to even.
std::uint32_t round_to_integer(double units) {
  return static_cast<std::uint32_t>(std::nearbyint(units));
}

Depth to_buffer_units(const Fragment& fragment, int depth_bits) {
  const double scale = depth_units_of(depth_bits);
  const auto units = [scale](double z) { return clamped_to_unit(z) * scale; };
  const double ideal = units(fragment.depth);
  return {ideal, round_to_integer(ideal), round_to_integer(units(fragment.depth_lowest)),
          round_to_integer(units(fragment.depth_highest))};
}

bool passes(CompareFunc func, std::uint32_t incoming, std::uint32_t stored) {
  switch (func) {
    case CompareFunc::never:
      return false;
    case CompareFunc::less:
      return incoming < stored;
    case CompareFunc::equal:
      return incoming == stored;
    case CompareFunc::lequal:
      return incoming <= stored;
    case CompareFunc::greater:
      return incoming > stored;
    case CompareFunc::notequal:
      return incoming != stored;
    case CompareFunc::gequal:
      return incoming >= stored;
    case CompareFunc::always:
      break;
  }
  return true;
}

/// Whether another outcome than that of the stored values is possible within the legal ranges.
bool is_ambiguous(CompareFunc func, const Depth& incoming, const OraclePixel& pixel) {
  if (incoming.units == pixel.depth_units) return false;
  switch (func) {
    case CompareFunc::never:
    case CompareFunc::always:
      return false;
    case CompareFunc::less:
    case CompareFunc::gequal:
      return incoming.lowest < pixel.depth_highest && incoming.highest >= pixel.depth_lowest;
    case CompareFunc::lequal:
    case CompareFunc::greater:
      return incoming.lowest <= pixel.depth_highest && incoming.highest > pixel.depth_lowest;
    case CompareFunc::equal:
    case CompareFunc::notequal:
      break;
  }
  const bool can_be_equal = incoming.lowest <= pixel.depth_highest && incoming.highest >= pixel.depth_lowest;
  const bool must_be_equal = incoming.lowest == incoming.highest && pixel.depth_lowest == pixel.depth_highest;
  return can_be_equal && !must_be_equal;
}

OraclePixel written(OraclePixel pixel, const pipeline::RasterState& state, const Fragment& fragment, const Depth& depth,
                    std::uint8_t& flags) {
  if (!write_color(pixel, state, fragment)) flags |= pixel_extrapolated;
  if (state.depth.test_enabled && state.depth.write_enabled) {
    pixel.depth_units = depth.units;
    pixel.depth_stored = depth.stored;
    pixel.depth_lowest = depth.lowest;
    pixel.depth_highest = depth.highest;
  }
  return pixel;
}

/// Keeps `outcomes` (the first is the one by stored values) as the pixel's possible contents.
void store(OraclePicture& picture, std::size_t index, const std::vector<OraclePixel>& outcomes) {
  picture.pixels[index] = outcomes.front();
  std::vector<OraclePixel> others;
  for (const OraclePixel& outcome : outcomes) {
    if (outcome == outcomes.front() || std::ranges::find(others, outcome) != others.end()) continue;
    if (others.size() == max_alternatives) {
      picture.flags[index] |= pixel_alternatives_lost;
      break;
    }
    others.push_back(outcome);
  }
  if (others.empty()) {
    picture.alternatives.erase(index);
  } else {
    picture.alternatives[index] = std::move(others);
  }
}

/// The fragment with other coverages that are legal, as far as blending can tell them from this one.
std::vector<Fragment> other_coverages(const pipeline::RasterState& state, const Fragment& fragment) {
  std::vector<Fragment> out;
  if (fragment.coverage_slack == 0 || !state.blend.enabled) return out;
  const auto byte_of = [](double alpha) { return std::nearbyint(clamped_to_unit(alpha) * 255.0); };
  for (const double slack : {-fragment.coverage_slack, fragment.coverage_slack}) {
    Fragment other = fragment;
    other.color[3] += slack;
    if (byte_of(other.color[3]) != byte_of(fragment.color[3])) out.push_back(other);
  }
  return out;
}

/// All contents that the pixel may have.
std::vector<OraclePixel> possible_contents(const OraclePicture& picture, std::size_t index) {
  std::vector<OraclePixel> out{picture.pixels[index]};
  if (const auto found = picture.alternatives.find(index); found != picture.alternatives.end()) {
    out.insert(out.end(), found->second.begin(), found->second.end());
  }
  return out;
}

/// Whether the fragment has this sample: its place is covered, and its alpha reaches far enough [GL1.5 §4.1.3].
/// choice: sample k of n is covered from alpha = (k + 1/2) / n on.
AlphaVerdict test_sample(const pipeline::RasterState& state, std::size_t sample, const Fragment& fragment) {
  AlphaVerdict verdict{true, fragment.may_be_absent};
  if (state.alpha_to_coverage == 0) return verdict;
  constexpr double slack = color_slack_bytes / 255;
  const double least = (static_cast<double>(sample) + 0.5) / state.alpha_to_coverage;
  const double lowest = std::min(fragment.color_lowest[3], fragment.color[3]) - slack;
  const double highest = std::max(fragment.color_highest[3], fragment.color[3]) + slack;
  verdict.passes = fragment.color[3] >= least;
  verdict.ambiguous |= lowest < least && highest >= least;
  return verdict;
}

/// Of a fragment that must pass both.
AlphaVerdict both(const AlphaVerdict& a, const AlphaVerdict& b) {
  const bool may = (a.passes || a.ambiguous) && (b.passes || b.ambiguous);
  return {a.passes && b.passes, may && (a.ambiguous || b.ambiguous)};
}

/// Fog is monotonous in a colour and in its coordinate: the ends of their ranges give those of the result.
void apply_fog(const pipeline::FogState& fog, Fragment& fragment) {
  const double coordinate = fragment.fog_coordinate, other = fragment.other_fog_coordinate.value_or(coordinate);
  const Color lowest = fogged(fog, fragment.color_lowest, other), highest = fogged(fog, fragment.color_highest, other);
  for (Color* color : {&fragment.color, &fragment.color_lowest, &fragment.color_highest}) *color = fogged(fog, *color, coordinate);
  for (std::size_t i = 0; i < 4; ++i) {
    fragment.color_lowest[i] = std::min(fragment.color_lowest[i], lowest[i]);
    fragment.color_highest[i] = std::max(fragment.color_highest[i], highest[i]);
  }
}

/// Clears one possible content of a pixel.
void clear_pixel(OraclePixel& pixel, const pipeline::ClearState& state, double depth_units) {
  for (std::size_t i = 0; state.color && i < 4; ++i) {
    if ((state.color_write_mask >> i & 1) == 0) continue;
    pixel.color[i] = static_cast<double>(state.clear_color[static_cast<int>(i)]);
    pixel.color_unorm8[i] = static_cast<std::uint8_t>(std::nearbyint(pixel.color[i] * 255.0));
    pixel.color_lowest[i] = pixel.color_highest[i] = static_cast<float>(pixel.color[i]);
  }
  if (state.stencil) {
    pixel.stencil = static_cast<std::uint8_t>((pixel.stencil & ~state.stencil_write_mask) |
                                              (state.clear_stencil & state.stencil_write_mask));
  }
  for (std::size_t i = 0; state.accum && i < 4; ++i) {
    pixel.accum[i] = static_cast<double>(state.clear_accum[static_cast<int>(i)]);
    pixel.accum_lowest[i] = pixel.accum_highest[i] = state.clear_accum[static_cast<int>(i)];
  }
  if (state.depth) {
    pixel.depth_units = depth_units;
    pixel.depth_stored = pixel.depth_lowest = pixel.depth_highest = round_to_integer(depth_units);
  }
}

}  // namespace

double depth_units_of(int depth_bits) {
  return std::ldexp(1.0, depth_bits) - 1.0;
}

OraclePicture make_picture(int width_px, int height_px, int depth_bits) {
  OraclePicture picture;
  picture.width_px = width_px;
  picture.height_px = height_px;
  picture.depth_bits = depth_bits;
  const std::size_t size = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  picture.pixels.resize(size);
  picture.flags.resize(size);
  picture.fragments_written.resize(size);
  return picture;
}

void PixelOutcomes::include(const PixelOutcomes& other) {
  flags |= other.flags | pixel_extrapolated;
  for (std::size_t i = 0; i < 4; ++i) {
    pixel.color_lowest[i] = std::min(pixel.color_lowest[i], other.pixel.color_lowest[i]);
    pixel.color_highest[i] = std::max(pixel.color_highest[i], other.pixel.color_highest[i]);
  }
  pixel.depth_lowest = std::min(pixel.depth_lowest, other.pixel.depth_lowest);
  pixel.depth_highest = std::max(pixel.depth_highest, other.pixel.depth_highest);
}

PixelOutcomes with_all_outcomes(const OraclePicture& picture, std::size_t index) {
  PixelOutcomes out{picture.pixels[index], picture.flags[index]};
  const auto found = picture.alternatives.find(index);
  if (found == picture.alternatives.end()) return out;
  for (const OraclePixel& other : found->second) out.include({other, 0});
  return out;
}

void write_fragment(OraclePicture& picture, const pipeline::RasterState& state, const Fragment& rasterized, std::size_t sample) {
  Fragment fragment = rasterized;
  apply_fog(state.fog, fragment);
  for (Color* color : {&fragment.color, &fragment.color_lowest, &fragment.color_highest}) (*color)[3] *= fragment.coverage;
  const pipeline::PixelRect& box = state.scissor;
  if (fragment.x < box.x0 || fragment.x >= box.x1 || fragment.y < box.y0 || fragment.y >= box.y1) return;
  if (fragment.x < 0 || fragment.x >= picture.width_px || fragment.y < 0 || fragment.y >= picture.height_px) return;
  const std::size_t index = picture.index(fragment.x, fragment.y);
  picture.flags[index] |= pixel_covered;
  if (fragment.extrapolated) picture.flags[index] |= pixel_extrapolated;

  const bool tested = state.depth.test_enabled && picture.depth_bits > 0;
  const Depth depth = to_buffer_units(fragment, picture.depth_bits);
  const AlphaVerdict has_sample = test_sample(state, sample, fragment);
  if (state.alpha_to_one) fragment.color[3] = fragment.color_lowest[3] = fragment.color_highest[3] = 1;
  const AlphaVerdict alpha = both(has_sample, test_alpha(state.alpha_test, fragment));
  if (!alpha.passes && !alpha.ambiguous) return;
  const auto passes_on = [&](const OraclePixel& pixel) {
    return !tested || passes(state.depth.func, depth.stored, pixel.depth_stored);
  };
  const pipeline::StencilFace& stencil = fragment.face == front ? state.stencil.front : state.stencil.back;
  const auto arrives = [&](const OraclePixel& pixel) { return !state.stencil.enabled || passes_stencil(stencil, pixel); };
  const auto outcome = [&](const Fragment& written_fragment, OraclePixel pixel, bool alpha_passes, bool depth_passes) {
    if (!alpha_passes) return pixel;
    const bool arrived = arrives(pixel);
    if (state.stencil.enabled) update_stencil(stencil, arrived, depth_passes, pixel);
    return arrived && depth_passes ? written(pixel, state, written_fragment, depth, picture.flags[index]) : pixel;
  };
  OraclePixel& pixel = picture.pixels[index];
  // A smooth primitive's faintest fragments leave a pixel as it is, whatever it is.
  const bool is_faint = fragment.coverage < 1 && state.blend.enabled && std::nearbyint(fragment.color[3] * 255.0) == 0;
  const bool writes = !is_faint && (state.color_write_mask != 0 || (tested && state.depth.write_enabled));
  if (writes && alpha.passes && arrives(pixel) && passes_on(pixel)) ++picture.fragments_written[index];
  const std::vector<Fragment> others = other_coverages(state, fragment);
  const auto hangs_on_depth = [&](const OraclePixel& content) {
    return tested && arrives(content) && is_ambiguous(state.depth.func, depth, content);
  };

  // The usual case: one content, one outcome.
  const bool only_one = picture.alternatives.empty() || !picture.alternatives.contains(index);
  if (only_one && others.empty() && !alpha.ambiguous && !hangs_on_depth(pixel)) {
    pixel = outcome(fragment, pixel, alpha.passes, passes_on(pixel));
    return;
  }

  // The outcomes by stored values first, so that `max_alternatives` cuts off the less likely ones.
  std::vector<OraclePixel> outcomes, less_likely;
  for (const OraclePixel& content : possible_contents(picture, index)) {
    const bool depth_passes = passes_on(content);
    outcomes.push_back(outcome(fragment, content, alpha.passes, depth_passes));
    for (const Fragment& other : others) less_likely.push_back(outcome(other, content, alpha.passes, depth_passes));
    if (alpha.ambiguous) less_likely.push_back(outcome(fragment, content, !alpha.passes, depth_passes));
    if (hangs_on_depth(content)) less_likely.push_back(outcome(fragment, content, true, !depth_passes));
  }
  if (!less_likely.empty()) picture.flags[index] |= pixel_depth_ambiguous;
  outcomes.insert(outcomes.end(), less_likely.begin(), less_likely.end());
  store(picture, index, outcomes);
}

void change_pixels(OraclePicture& picture, const pipeline::PixelRect& box, const std::function<void(OraclePixel&)>& change) {
  const int x0 = std::max(box.x0, 0), x1 = std::min(box.x1, picture.width_px);
  const int y0 = std::max(box.y0, 0), y1 = std::min(box.y1, picture.height_px);
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const std::size_t index = picture.index(x, y);
      if (!picture.alternatives.contains(index)) {
        change(picture.pixels[index]);
        continue;
      }
      std::vector<OraclePixel> contents = possible_contents(picture, index);
      for (OraclePixel& pixel : contents) change(pixel);
      store(picture, index, contents);
    }
  }
}

void clear_picture(OraclePicture& picture, const pipeline::ClearState& state) {
  const double depth_units = state.clear_depth * depth_units_of(picture.depth_bits);
  const pipeline::PixelRect& box = state.scissor;
  change_pixels(picture, box, [&](OraclePixel& pixel) { clear_pixel(pixel, state, depth_units); });
  if (!state.color || state.color_write_mask != 0xF) return;
  for (int y = std::max(box.y0, 0); y < std::min(box.y1, picture.height_px); ++y) {
    for (int x = std::max(box.x0, 0); x < std::min(box.x1, picture.width_px); ++x) {
      const std::size_t index = picture.index(x, y);
      picture.flags[index] = picture.alternatives.contains(index) ? pixel_depth_ambiguous : 0;
      picture.fragments_written[index] = 0;
    }
  }
}

}  // namespace gouraud::oracle
