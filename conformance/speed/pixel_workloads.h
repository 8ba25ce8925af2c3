// Workloads of pixels: reading, drawing, copying, uploading.
#pragma once

#include "conformance/speed/workloads.h"

namespace gouraud::speed {

std::vector<Workload> pixel_workloads();

}  // namespace gouraud::speed
