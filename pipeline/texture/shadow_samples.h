// Comparison with the nearest texel of a depth texture [GL1.5 §3.8.14]: what shadow maps are sampled by.
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// Both null if the unit needs more than this can do: a comparison with one level of two dimensions, without border or filter,
/// clamped to the edge.
struct ShadowFunctions {
  SampleFunction sample = nullptr;
  FetchFunction fetch = nullptr;
};
ShadowFunctions shadow_functions(const PreparedUnit& unit);

}  // namespace gouraud::pipeline
