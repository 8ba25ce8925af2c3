// The plan's part about textures: what a draw's units read, and how they are described.
#pragma once

#include <string>

#include "pipeline/draw/draw_state.h"

namespace gouraud::pipeline {

/// Whether the units' functions leave anything of the fragment's own colour [GL1.5 §3.8.13]: not if an opaque texture
/// replaces it. Computed backwards over the units.
bool textures_read_color(const TexturingState& state);

/// "unit 0: 2D, bilinear, modulate".
std::string describe_unit(const TextureUnitState& unit);

}  // namespace gouraud::pipeline
