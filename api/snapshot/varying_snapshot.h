// The parts of the DrawState that deal with what is interpolated beside depth and colour, and with the user's clip planes.
#pragma once

#include <cstdint>

#include "api/state/state.h"
#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

/// The enabled planes [GL1.5 §2.12].
pipeline::ClipPlaneState clip_plane_state(const TransformGroup& group);

/// Fog changes red, green and blue [GL1.5 §3.10]: absent if none is written.
pipeline::FogState fog_state(const FogGroup& group, std::uint8_t color_write_mask);

/// Whether vertices bring a secondary colour that is added [GL1.5 §3.9]: with lighting, its own decides.
bool color_sum_state(const State& state, std::uint8_t color_write_mask);

/// The textured units, a bit each.
std::uint8_t units_of(const pipeline::TexturingState& texturing);

/// Of the units in `units`: the textured ones, or those that are reported [GL1.5 §2.11.4].
pipeline::TextureCoordinatesState texture_coordinates_state(const State& state, std::uint8_t units);

/// Whether a unit's coordinates come from normals.
bool generates_from_normals(const pipeline::TextureCoordinatesState& state);

}  // namespace gouraud::api
