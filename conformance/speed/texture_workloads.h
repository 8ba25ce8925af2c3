// Workloads of texturing.
#pragma once

#include "conformance/speed/workloads.h"

namespace gouraud::speed {

std::vector<Workload> texture_workloads();

}  // namespace gouraud::speed
