// What GL 1.5 can be told about features that are off: parameters that must not cost an instruction.
#pragma once

#include <string_view>
#include <vector>

#include "gl_table.h"

namespace gouraud::conformance {

/// Sets every parameter of a feature away from its initial value, and leaves the feature off.
struct OffFeature {
  std::string_view name;  ///< for the report and for file names
  void (*set)(const GlTable& gl) = nullptr;
  /// On in the scene that is lit and depth-tested: only the plain scene can tell what its parameters cost while off.
  bool plain_scene_only = false;
};

/// In the order of the specification's sections; then some that are on, called "on_...": their cost must show, or the
/// measurement measures nothing.
const std::vector<OffFeature>& off_features();

}  // namespace gouraud::conformance
