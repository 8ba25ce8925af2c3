// The lighting part of the snapshot: lights ready for use in eye space, materials as the lights can show them.
#pragma once

#include "api/state/lighting.h"
#include "pipeline/draw/draw_state.h"

namespace gouraud::api {

/// Fills all of `result` but its material. `colors_matter` is false if no colour can reach the target.
void update_lighting(const LightingGroup& group, bool colors_matter, pipeline::CullMode cull,
                     pipeline::LightingState& result);

/// One light as the lighting equations use it [GL1.5 §2.14.1].
pipeline::PreparedLight prepare_light(const Light& light);

/// The material pair as draws with `lighting` see it: initial values without lighting, back equal to front unless
/// two-sided, parameters that follow the vertex colour or that no light can show at their initial values.
pipeline::MaterialPair canonical_material(const LightingGroup& group, const pipeline::LightingState& lighting);

}  // namespace gouraud::api
