// A scene with everything at once, as a simulator's viewer draws it.
#pragma once

#include "conformance/speed/workloads.h"

namespace gouraud::speed {

std::vector<Workload> mirror_workload();

}  // namespace gouraud::speed
