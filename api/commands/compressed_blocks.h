// Images as S3TC blocks [EXT_texture_compression_s3tc].
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "api/commands/image_requests.h"
#include "pipeline/texture/image.h"
#include "pipeline/texture/s3tc.h"

namespace gouraud::api {

/// Bytes of an image of this size, in blocks.
std::size_t block_bytes(pipeline::S3tcFormat format, GLsizei width, GLsizei height);

/// A rectangle of texels; its corner lies on that of a block.
struct BlockRect {
  GLint x = 0, y = 0;
  GLsizei width = 0, height = 0;
};

/// Texels from blocks. `blocks` are those of the rectangle alone; the image is rgba8 in rows.
void decode_blocks(pipeline::S3tcFormat format, const std::byte* blocks, const BlockRect& rect, const pipeline::Image& image);

/// Blocks from texels; the texels then become what the blocks say.
std::shared_ptr<const std::vector<std::byte>> encode_image(pipeline::S3tcFormat format, const pipeline::Image& image);
/// The same of a rectangle; `blocks` are those of the image.
void encode_region(pipeline::S3tcFormat format, const pipeline::Image& image, const BlockRect& rect,
                   std::vector<std::byte>& blocks);

/// Puts the rectangle's blocks among those of an image of this width.
void splice_blocks(pipeline::S3tcFormat format, const std::byte* from, const BlockRect& rect, GLsizei image_width,
                   std::vector<std::byte>& blocks);

/// True if a region consists of whole blocks, or ends at the image's edge; else GL_INVALID_OPERATION is recorded.
bool check_blocks(Context& context, const Region& region, const pipeline::Image& image);

}  // namespace gouraud::api
