// A texture's image as a picture that framebuffers draw into [ARB_framebuffer_object, "Attaching Texture Images"].
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// Whether framebuffers can draw into such an image: it has colours of three or four channels, or
/// depths. A border is part of the picture: pixel (0, 0) is its corner.
bool is_attachable(const Image& image);

/// Puts the image's texels into tiles, where they stay: in place, so nobody else may be using it. Does nothing if they
/// are there already. Throws std::bad_alloc, and nothing is changed. is_attachable(image).
void put_into_tiles(Image& image);

/// A slice of the image in tiles as a surface, the same pixels.
Surface surface_of(const Image& image, int slice);

}  // namespace gouraud::pipeline
