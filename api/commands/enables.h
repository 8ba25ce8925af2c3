// Enable, Disable and IsEnabled [GL1.5 §2.5, §6.1.1], for every capability that has state.
#pragma once

#include <GL/gl.h>

#include "api/context/context.h"

namespace gouraud::api {

/// All three: GL_INVALID_ENUM for what is no capability, or none that is written yet. IsEnabled knows the vertex arrays
/// as well.
void Enable(Context& context, GLenum cap);
void Disable(Context& context, GLenum cap);
GLboolean IsEnabled(Context& context, GLenum cap);

/// Where a capability's flag lies and which parts of the draw state depend on it (DirtyBits). `flag` is null for what
/// is no capability.
struct Capability {
  bool* flag = nullptr;
  std::uint32_t dirty = 0;
};
Capability find_capability(AttributeGroups& groups, GLenum cap);

}  // namespace gouraud::api
