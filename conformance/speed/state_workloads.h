// Workloads of fragment operations, of features together, and of many changes of state.
#pragma once

#include "conformance/speed/workloads.h"

namespace gouraud::speed {

std::vector<Workload> state_workloads();

}  // namespace gouraud::speed
