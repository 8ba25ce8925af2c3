// How pictures that can be drawn into are stored, by their internal format [ARB_framebuffer_object].
#pragma once

#include <optional>

#include <GL/gl.h>

#include "pipeline/framebuffer/framebuffer.h"

namespace gouraud::api {

/// A surface of that internal format, without size and planes; empty if nothing can be drawn into the format.
std::optional<pipeline::Surface> surface_of_format(GLenum internal_format);

/// Bits of each component of a surface as it is stored.
struct ComponentBits {
  GLint red = 0, green = 0, blue = 0, alpha = 0, depth = 0, stencil = 0;
};
ComponentBits component_bits(const pipeline::Surface& surface);

}  // namespace gouraud::api
