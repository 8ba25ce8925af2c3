// Gouraud's own additions to the OSMesa ABI, for programs that link the static library `gouraud`.
#pragma once

namespace gouraud {
namespace pipeline {
class DrawObserver;
}

/// Shows every draw and clear of this thread's current context to `observer`, in order, from now on (null: no more).
/// The observer is called at once with target_changed, if the context has a target. It is not owned.
/// Returns false, and does nothing, without a current context.
bool set_draw_observer(pipeline::DrawObserver* observer);

}  // namespace gouraud
