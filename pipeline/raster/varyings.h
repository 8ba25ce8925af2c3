// What is interpolated over a primitive besides depth and primary colour: texture coordinates, fog coordinate, secondary
// colour. One float each, perspective-correct. This header says where each of them stands.
#pragma once

#include <array>
#include <cstdint>

#include "pipeline/draw/limits.h"

namespace gouraud::pipeline {

/// Texture coordinates of one unit among the varyings: s, t, r as far as `dimensions` goes, then q if `has_q`.
struct TextureCoordinateLayout {
  std::int8_t first = -1;        ///< -1: the unit has none
  std::int8_t dimensions = 0;    ///< 1 to 3
  bool has_q = false;            ///< else q is 1 all over, and nothing is divided by it
  bool operator==(const TextureCoordinateLayout&) const = default;
};

/// Which belongs to a draw and not to a plan: q is found to be 1 by looking at the vertices.
struct VaryingLayout {
  std::int8_t count = 0;
  std::int8_t secondary_color = -1;  ///< first of three, r, g, b, in [0, 1] and behind all others; -1: none
  std::int8_t lighting = -1;  ///< first of those that lighting per fragment takes (draw/phong_shading.h); -1: none
  std::int8_t fog_coordinate = -1;   ///< the fog coordinate, or the distance |z_eye|; -1: none
  std::array<TextureCoordinateLayout, max_texture_units> texture_coordinates{};
  bool operator==(const VaryingLayout&) const = default;
  /// Those that a vertex has by itself. Its secondary colour depends on the facing of the primitive.
  int of_vertices() const { return secondary_color < 0 ? count : secondary_color; }
};

inline constexpr int max_varyings = 3 + 1 + 10 + 4 * max_texture_units;

}  // namespace gouraud::pipeline
