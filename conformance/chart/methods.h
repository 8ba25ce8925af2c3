// The methods that are charted: one row each. A row is what GOURAUD_METHODS gets; the first is the default.
#pragma once

#include <string_view>
#include <vector>

#include "conformance/harness/drivers.h"

namespace gouraud::chart {

struct Method {
  std::string_view setting;  ///< "coverage=scanline"; empty: the default
  std::string_view step;     ///< "coverage"
  bool antialiases = false;  ///< pictures are to be judged by area coverage
};

/// Those that the library of `paths` knows.
std::vector<Method> methods_of(const conformance::Paths& paths);

}  // namespace gouraud::chart
