// A texture's image as a picture that framebuffers draw into [ARB_framebuffer_object, "Attaching Texture Images"].
#pragma once

#include "pipeline/framebuffer/framebuffer.h"
#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// Whether framebuffers can draw into such an image: it has colours or depths. A border is part of the picture: pixel (0, 0) is its corner.
bool is_attachable(const Image& image);

/// Gives the image texels of four channels (wide_format()), those that it had in their places. It lies in rows, and nobody
/// else may be using it. Throws std::bad_alloc, and nothing is changed.
void widen(Image& image);
/// All its images, so that they stay alike. Throws std::bad_alloc: some may be wide then.
void widen(Texture& texture);
bool has_widened_images(const Texture& texture);

/// Puts the image's texels into tiles, widened, where they stay: in place, so nobody else may be using it. Does nothing if they
/// are there already. Throws std::bad_alloc, and nothing is changed. is_attachable(image).
void put_into_tiles(Image& image);

/// A slice of the image in tiles as a surface, the same pixels.
Surface surface_of(const Image& image, int slice);

}  // namespace gouraud::pipeline
