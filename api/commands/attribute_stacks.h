// The attribute stacks [GL1.5 §6.1.14, Table 6.2].
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// Bits without a group are ignored. GL_STACK_OVERFLOW if the stack is full, GL_STACK_UNDERFLOW if it is empty.
void PushAttrib(Context& context, GLbitfield mask);
void PopAttrib(Context& context);
void PushClientAttrib(Context& context, GLbitfield mask);
void PopClientAttrib(Context& context);

}  // namespace gouraud::api
