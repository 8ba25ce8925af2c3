// Evaluators: polynomial maps and the grids on which they are evaluated [GL1.5 §5.1, Table 6.24].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "api/state/limits.h"

namespace gouraud::api {

/// What a map gives, in the order of the targets GL_MAP1_COLOR_4 ... GL_MAP1_VERTEX_4 (and GL_MAP2_...).
enum MapKind : std::size_t {
  map_color, map_index, map_normal, map_texture_coordinate_1, map_texture_coordinate_2, map_texture_coordinate_3,
  map_texture_coordinate_4, map_vertex_3, map_vertex_4
};
inline constexpr std::size_t map_kinds = 9;

/// Values of a control point [GL1.5 Table 5.1].
inline constexpr std::array<int, map_kinds> map_components{4, 1, 3, 1, 2, 3, 4, 3, 4};

/// An interval of the domain; a map takes its ends to 0 and 1.
struct MapDomain {
  float first = 0.0f, last = 1.0f;
  bool operator==(const MapDomain&) const = default;
};

/// Kept in float, as all that a vertex is made of; evaluated in double.
struct Map1 {
  int order = 1;  ///< in [1, max_eval_order]
  MapDomain u;
  std::vector<float> points;  ///< point i from i * components on
  bool operator==(const Map1&) const = default;
};
struct Map2 {
  int u_order = 1, v_order = 1;
  MapDomain u, v;
  std::vector<float> points;  ///< point (i, j) from (i * v_order + j) * components on
  bool operator==(const Map2&) const = default;
};

/// The maps belong to no attribute group. Initially each is constant: its point is what the current value initially is.
struct EvaluatorMaps {
  EvaluatorMaps() {
    const std::array<std::vector<float>, map_kinds> initial{{{1, 1, 1, 1}, {1}, {0, 0, 1}, {0}, {0, 0}, {0, 0, 0},
                                                             {0, 0, 0, 1}, {0, 0, 0}, {0, 0, 0, 1}}};
    for (std::size_t kind = 0; kind < map_kinds; ++kind) one[kind].points = two[kind].points = initial[kind];
  }
  std::array<Map1, map_kinds> one;
  std::array<Map2, map_kinds> two;
  bool operator==(const EvaluatorMaps&) const = default;
};

/// `segments` (> 0) equal parts of an interval.
struct MapGrid {
  MapDomain domain;
  int segments = 1;
  bool operator==(const MapGrid&) const = default;
};

/// Attribute group EVAL_BIT.
struct EvalGroup {
  std::array<bool, map_kinds> map1_enabled{}, map2_enabled{};
  bool auto_normal_enabled = false;
  MapGrid grid1_u, grid2_u, grid2_v;
  bool operator==(const EvalGroup&) const = default;
};

}  // namespace gouraud::api
