// Sweeps: each turns one knob of a scene until something breaks.
#pragma once

#include <vector>

#include "conformance/chart/probe.h"

namespace gouraud::stability {

using chart::Drawing;
using chart::Probe;

struct Sweep {
  Probe probe;
};

std::vector<Sweep> all_sweeps();

}  // namespace gouraud::stability
