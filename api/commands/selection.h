// Hit records, for RenderMode [GL1.5 §5.2].
#pragma once

#include <memory>

#include "api/context/context.h"

namespace gouraud::api {

std::unique_ptr<pipeline::PrimitiveReceiver> make_selection_receiver(Context& context);
/// If there has been a hit since the last record. What does not fit into the buffer is lost.
void write_hit_record(SelectionState& selection);

}  // namespace gouraud::api
