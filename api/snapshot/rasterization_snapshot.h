// Points, lines and polygons as the pipeline wants them: what is off, or cannot be seen, is absent.
#pragma once

#include "api/state/state.h"
#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

pipeline::PointState point_state(const PointGroup& point, bool multisampled);
pipeline::LineState line_state(const LineGroup& line, bool multisampled);
/// `assembly` says how the faces that are drawn are drawn.
pipeline::PolygonState polygon_state(const PolygonGroup& polygon, const pipeline::AssemblyState& assembly,
                                     bool depth_matters);
/// A pattern of all ones is no stipple.
pipeline::PolygonStippleState polygon_stipple_state(const PolygonGroup& polygon, const PolygonStippleGroup& pattern);

}  // namespace gouraud::api
