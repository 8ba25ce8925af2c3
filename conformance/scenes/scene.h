// A scene: GL calls that make one picture, the same through every driver.
//
// Scenes stand one file per section of the specification (scenes/lighting_2_14_1.cpp). A scene gets a fresh context
// (initial GL state, cleared to zero by nobody) and a GlTable of one driver; it sets all state that it needs, draws,
// and leaves; the harness finishes and reads colour and depth.
#pragma once

#include <string_view>
#include <vector>

#include "gl_table.h"

namespace gouraud::conformance {

/// Who judges what of a scene. The bounds themselves are ARCHITECTURE §5's; exceptions stand in conformance/accepted.
enum class Judge {
  textures,  ///< as polygons, but colours may differ from llvmpipe's in 1 % of the pixels, by 1/255
  polygons,  ///< coverage equal to llvmpipe's and the oracle's; colours within 1/255 of both; depth by the oracle
  lines_and_points,  ///< the oracle judges; llvmpipe may differ in at most 0.5 % of the pixels drawn
  oracle_only,       ///< Mesa's pictures are reported, not judged (the scene's comment says why)
};

struct Scene {
  std::string_view name;     ///< unique, lower_snake: "spot_cutoff_30"
  std::string_view section;  ///< "§2.14.1"
  std::string_view shows;    ///< one sentence for the report: what a viewer should see
  Judge judge = Judge::polygons;
  int width_px = 256, height_px = 256;
  void (*draw)(const GlTable& gl) = nullptr;
  int depth_bits = 24;
};

/// All scenes of the suite, in the order of the files' sections.
const std::vector<Scene>& all_scenes();

/// Each scene file defines one of these and all_scenes() lists them.
using SceneList = std::vector<Scene>;

}  // namespace gouraud::conformance
