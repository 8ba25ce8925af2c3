// Flush, Finish and Hint [GL1.5 §5.5, §5.6].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Both draw everything that is pending and let the window system show it.
void Flush(Context& context);
void Finish(Context& context);

/// GL_INVALID_ENUM for an unknown target or hint. choice: hints are kept and have no effect.
void Hint(Context& context, GLenum target, GLenum mode);

}  // namespace gouraud::api
