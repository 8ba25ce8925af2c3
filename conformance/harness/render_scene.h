// One scene through one driver: what each driver program does for every scene it is asked for.
#pragma once

#include <functional>

#include "conformance/harness/offscreen.h"
#include "conformance/harness/picture.h"
#include "conformance/scenes/scene.h"

namespace gouraud::conformance {

enum class CoverageWanted { no, yes };

/// Draws `scene` in a fresh context and reads it; with coverage, draws it a second time under a CoverageWatch.
Picture render_scene(const OsmesaFunctions& osmesa, const Scene& scene, CoverageWanted coverage);

/// The scene of that name; throws std::runtime_error if there is none.
const Scene& scene_of_name(std::string_view name);

/// The body of a driver program. Draws the named scenes with `render` and writes to child_output_fd, for each, its
/// name and, when it is drawn, the picture (true, picture) or what was thrown (false, text). Returns the exit status.
int serve_scenes(const std::vector<std::string>& names, const std::function<Picture(const Scene&)>& render);

}  // namespace gouraud::conformance
