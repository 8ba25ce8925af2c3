#include "conformance/oracle/shading.h"

#include <algorithm>
#include <vector>

namespace gouraud::oracle {
namespace {

TextureCoordinate interpolated(std::span<const VertexShare> shares, std::size_t unit, bool in_range) {
  double sum = 0, sum_x = 0, sum_y = 0;
  for (const VertexShare& s : shares) {
    sum += s.share;
    sum_x += s.ddx;
    sum_y += s.ddy;
  }
  TextureCoordinate out;
  for (std::size_t c = 0; c < 4; ++c) {
    double value = 0, ddx = 0, ddy = 0;
    bool constant = true;
    for (const VertexShare& s : shares) {
      const double at_vertex = s.vertex->texture_coordinates[unit][c];
      constant &= at_vertex == shares[0].vertex->texture_coordinates[unit][c];
      value += s.share * at_vertex;
      ddx += s.ddx * at_vertex;
      ddy += s.ddy * at_vertex;
    }
    out.value[c] = constant ? shares[0].vertex->texture_coordinates[unit][c] : value / sum;
    out.ddx[c] = constant ? 0 : (ddx * sum - value * sum_x) / (sum * sum);
    out.ddy[c] = constant ? 0 : (ddy * sum - value * sum_y) / (sum * sum);
    if (!in_range) continue;
    double lowest = shares[0].vertex->texture_coordinates[unit][c], highest = lowest;
    for (const VertexShare& s : shares) {
      lowest = std::min(lowest, s.vertex->texture_coordinates[unit][c]);
      highest = std::max(highest, s.vertex->texture_coordinates[unit][c]);
    }
    out.value[c] = out.value[c] >= lowest ? std::min(out.value[c], highest) : lowest;
  }
  return out;
}

void add_secondary(const FragmentSink& sink, std::span<const VertexShare> shares, TexturedColor& color) {
  double sum = 0;
  for (const VertexShare& s : shares) sum += s.share;
  for (std::size_t k = 0; k < 3; ++k) {
    double value = 0;
    for (const VertexShare& s : shares) value += s.share / sum * (sink.flat_colors ? *sink.flat_colors : *s.vertex).secondary[sink.face][k];
    color.color[k] += value;
    color.lowest[k] += value;
    color.highest[k] += value;
  }
}

}  // namespace

void set_color(const TexturedColor& color, Fragment& fragment) {
  constexpr double tie = 1.0 / 1024;
  fragment.color = fragment.color_lowest = fragment.color_highest = color.color;
  bool ties = false;
  for (std::size_t k = 0; k < 4; ++k) ties |= color.highest[k] - color.lowest[k] > tie;
  if (!ties) return;
  fragment.extrapolated = true;
  fragment.color_lowest = color.lowest;
  fragment.color_highest = color.highest;
}

void include_color(const TexturedColor& color, Fragment& fragment) {
  for (std::size_t i = 0; i < 4; ++i) {
    fragment.color_lowest[i] = std::min(fragment.color_lowest[i], color.lowest[i]);
    fragment.color_highest[i] = std::max(fragment.color_highest[i], color.highest[i]);
  }
}

TexturedColor shade(const FragmentSink& sink, const Color& primary, std::span<const VertexShare> shares,
                    const TextureCoordinate* sprite, bool in_range) {
  if (sink.texturing.count == 0) return {primary, primary, primary};
  std::vector<TextureCoordinate> coordinates;
  for (std::size_t i = 0; i < sink.texturing.count; ++i) {
    const bool replaced = sprite != nullptr && (sink.texturing.sprite_units >> sink.texturing.unit[i].unit & 1) != 0;
    coordinates.push_back(replaced ? *sprite : interpolated(shares, i, in_range));
  }
  TexturedColor out = apply_textures(sink.texturing, primary, coordinates);
  if (sink.has_secondary) add_secondary(sink, shares, out);
  return out;
}

}  // namespace gouraud::oracle
