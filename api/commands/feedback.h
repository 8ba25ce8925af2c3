// Feedback's part of RenderMode [GL1.5 §5.3].
#pragma once

#include <memory>

#include "api/context/context.h"

namespace gouraud::api {

std::unique_ptr<pipeline::PrimitiveReceiver> make_feedback_receiver(Context& context);

}  // namespace gouraud::api
