// The scenes of the chart: what pictures need, one each.
#pragma once

#include <string_view>
#include <vector>

#include "conformance/probes/probe.h"

namespace gouraud::chart {

using namespace probes;  // the chart is made of them

enum class ReferenceKind : std::uint8_t {
  exact,      ///< the oracle's picture of the scene
  area,       ///< exact area coverage: the scene antialiased by pixel boxes
  finer_mesh, ///< the oracle's picture at knob 1: the same surfaces cut finer
};

/// The steps of the pipeline whose methods a scene shows; the others would draw as the default does.
using Steps = std::vector<std::string_view>;
inline const Steps polygon_steps{"coverage", "ownership", "clipping", "colors", "shading", "depth", "antialiasing"};
inline const Steps lit_steps{"coverage", "ownership", "clipping", "colors", "shading", "depth", "antialiasing", "highlight", "power"};
inline const Steps flat_steps{"coverage", "ownership", "clipping", "depth", "antialiasing"};  ///< one colour a polygon
inline const Steps line_steps{"lines", "colors"};
inline const Steps point_steps{"points"};

struct ChartScene {
  Probe probe;  ///< knob 0
  Steps steps;
  ReferenceKind reference = ReferenceKind::exact;
};

inline constexpr int chart_width_px = 400, chart_height_px = 300;

const std::vector<ChartScene>& chart_scenes();

// By file.
std::vector<ChartScene> surface_scenes();   // meshes, floors, depth
std::vector<ChartScene> detail_scenes();    // lines, points, text, slivers
std::vector<ChartScene> blended_scenes();   // layers, shared edges, area coverage

}  // namespace gouraud::chart
