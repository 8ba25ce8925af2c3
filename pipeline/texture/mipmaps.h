// Mipmap generation [GL1.5 §3.8.8 "Automatic Mipmap Generation", EXT_framebuffer_object GenerateMipmap].
#pragma once

#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// The image that follows `image` in a mipmap of this target: every texel the mean of the texels that it covers (a box
/// filter, weighted by area where a size is odd), rounded to nearest; sRGB colours are averaged in linear light. Border
/// texels are filtered along the border. Rows, never tiles. Throws std::bad_alloc.
Image half_size(TextureTarget target, const Image& image);

/// The same in two steps, for storage that is there already: its shape, without texels, and into them.
Image next_level(TextureTarget target, const Image& image);
void fill_half_size(TextureTarget target, const Image& image, const Image& out);

/// Makes levels base_level + 1 to the 1x1x1 image of all faces from the base level (at most to `last_level`); nothing if
/// there is no base level or faces differ. Throws std::bad_alloc, with the texture as it was. Framebuffer attachments
/// (tiles) among the levels that are made are replaced.
void generate_mipmaps(Texture& texture, int base_level, int last_level = max_texture_levels - 1);

/// New storage for the texels of an image of this size and format (rows; with the spare bytes behind), not initialized.
std::shared_ptr<std::byte[]> allocate_texels(TexelFormat format, int width, int height, int depth);

}  // namespace gouraud::pipeline
