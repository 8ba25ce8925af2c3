// What the chart leaves in its folder: chart.json, an SVG a scene and axis, and chart.html with everything inside.
#pragma once

#include <string>
#include <vector>

#include "conformance/chart/measure_chart.h"

namespace gouraud::chart {

/// Everything that was measured, without pictures.
std::string chart_json(const std::vector<SceneChart>& charts);

/// overall.svg (and overall.png), overall_depth.svg, ..., SCENE.svg, SCENE_coverage.svg, ...
void write_chart_plots(const std::string& folder, const std::vector<SceneChart>& charts);

/// One page without any file beside it: plots, tables, and behind every point its picture and error map.
std::string chart_html(const std::vector<SceneChart>& charts);

/// Where the default is beaten, or matched by something faster; a line each. Empty: it lies on the front everywhere.
std::vector<std::string> front_report(const std::vector<SceneChart>& charts);

}  // namespace gouraud::chart
