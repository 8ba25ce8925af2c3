// What is timed: named workloads, each a function that prepares and gives back what draws one frame. To add one, write
// its function and add a row to all_workloads().
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "gl_table.h"

namespace gouraud::speed {

/// Draws one frame, clear included, without finishing it. Owns all coordinates that it sends.
using Frame = std::function<void(const GlTable& gl)>;

struct Workload {
  std::string_view name;
  std::string_view what;  ///< for the table
  int width_px, height_px;
  /// Sets the state of a fresh context with 24 bits of depth, generates data. Not timed.
  Frame (*setup)(const GlTable& gl);
};

const std::vector<Workload>& all_workloads();

/// The frame of the first-frame measurements: clear, one Gouraud triangle with depth. 640 x 480.
void draw_first_frame(const GlTable& gl);

}  // namespace gouraud::speed
