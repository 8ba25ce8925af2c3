// A batch whose vertices go by several matrices, as batches of one each: for those who look on (DrawObserver).
#pragma once

#include <functional>

#include "pipeline/draw/draw_state.h"
#include "pipeline/geometry/vertex_batch.h"

namespace gouraud::pipeline {

/// Calls visit(state, batch) for each transform run's vertices and primitives in order; the batches it gets have no runs.
void split_transform_runs(const DrawState& state, const VertexBatch& batch,
                          const std::function<void(const DrawState&, const VertexBatch&)>& visit);

}  // namespace gouraud::pipeline
