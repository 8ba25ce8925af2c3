// The static library's OSMesa functions, for programs that link it: what load_osmesa() finds in a shared one.
#pragma once

#include <GL/osmesa.h>

#include "conformance/harness/offscreen.h"

namespace gouraud::conformance {

inline const OsmesaFunctions linked_osmesa{
    .CreateContextExt = [](GLenum format, GLint depth, GLint stencil, GLint accum, void* share) -> void* {
      return OSMesaCreateContextExt(format, depth, stencil, accum, static_cast<OSMesaContext>(share));
    },
    .DestroyContext = [](void* context) { OSMesaDestroyContext(static_cast<OSMesaContext>(context)); },
    .MakeCurrent =
        [](void* context, void* buffer, GLenum type, GLsizei width, GLsizei height) {
          return OSMesaMakeCurrent(static_cast<OSMesaContext>(context), buffer, type, width, height);
        },
    .GetDepthBuffer =
        [](void* context, GLint* width, GLint* height, GLint* bytes, void** buffer) {
          return OSMesaGetDepthBuffer(static_cast<OSMesaContext>(context), width, height, bytes, buffer);
        },
    .GetProcAddress = [](const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }};

}  // namespace gouraud::conformance
