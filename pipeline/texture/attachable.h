// A texture's image as a picture that framebuffers draw into [ARB_framebuffer_object, "Attaching Texture Images"].
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// Whether framebuffers can draw into such an image: it has colours of four channels or depths, no border, one slice.
bool is_attachable(const Image& image);

/// Puts the image's texels into tiles, where they stay: in place, so nobody else may be using it. Does nothing if they
/// are there already. Throws std::bad_alloc, and nothing is changed. is_attachable(image).
void put_into_tiles(Image& image);

/// The image in tiles as a surface, the same pixels. `has_stencil` says that the depth words hold stencil values.
Surface surface_of(const Image& image, bool has_stencil);

}  // namespace gouraud::pipeline
