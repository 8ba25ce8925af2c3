// Three scenes, as they are and with everything enabled: what a picture needs, and what it would cost to model more.
#pragma once

#include <string_view>
#include <vector>

#include "gl_table.h"

namespace gouraud::speed {

struct NecessityScene {
  std::string_view name, shows;
  void (*set)(const GlTable& gl);
  /// Each is drawn by itself, and finished before the next.
  std::vector<void (*)(const GlTable& gl)> passes;
};

const std::vector<NecessityScene>& necessity_scenes();

/// Turns on everything that can be on at once, none of it without effect.
void enable_everything(const GlTable& gl);

/// Vertices that the passes have sent since the last call.
long take_vertex_count();

inline constexpr int necessity_width_px = 320, necessity_height_px = 240;

}  // namespace gouraud::speed
