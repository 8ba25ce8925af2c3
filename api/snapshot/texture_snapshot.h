// The part of the snapshot that says what texture units do with a fragment's colour [GL1.5 §3.8].
#pragma once

#include "api/state/state.h"
#include "pipeline/draw/texture_state.h"

namespace gouraud::api {

/// Canonical (pipeline/draw/texture_state.h): units that are off, or whose texture is incomplete, are absent; so are
/// parameters that no filter, wrap mode or combiner reads. The pointers are those of the bound objects' textures.
pipeline::TexturingState texturing_state(const State& state);

}  // namespace gouraud::api
