// Changing the images of texture objects that a draw may be using: see pipeline/texture/image.h.
#pragma once

#include <cstddef>

#include "api/commands/image_requests.h"
#include "api/context/context.h"

namespace gouraud::api {

/// Puts an image in place of what the object had there, as S3TC blocks if that is its internal format, and makes a mipmap
/// if GENERATE_MIPMAP asks for it. Throws std::bad_alloc, and nothing is changed.
void put_image(Context& context, TextureObject& object, std::size_t face, std::size_t level, pipeline::Image image,
               GLenum internal_format);
/// The same of an image whose description is complete.
void put_image(Context& context, TextureObject& object, std::size_t face, std::size_t level, pipeline::Image image,
               ImageDescription description);

/// An image whose texels may be written now: this context's own draws are finished; if anybody else uses the texels, the
/// object has got a copy. Throws std::bad_alloc, and nothing is changed.
pipeline::Image& writable_image(Context& context, TextureObject& object, std::size_t face, std::size_t level);
/// Called when they have been written: the region's blocks are made anew, and the mipmap.
void texels_changed(Context& context, TextureObject& object, std::size_t face, const Region& region);

/// Both, from the region's blocks.
void put_blocks(Context& context, TextureObject& object, std::size_t face, const Region& region,
                pipeline::S3tcFormat format, const std::byte* blocks);

/// Makes the levels after the base level of these faces [GL1.5 §3.8.8]. Throws std::bad_alloc, and nothing is changed.
void generate_mipmaps(Context& context, TextureObject& object, std::size_t first_face, std::size_t end_face);

}  // namespace gouraud::api
