#include "api/commands/compressed_blocks.h"

#include <algorithm>
#include <cstring>

#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

using pipeline::Image;
using pipeline::S3tcFormat;
using pipeline::TexelBlock;

constexpr GLsizei block_side = 4;

std::size_t blocks_along(GLsizei texels) {
  return static_cast<std::size_t>(texels + block_side - 1) / static_cast<std::size_t>(block_side);
}

/// Calls visit(x, y) for the corner of each block of the rectangle, row after row.
template <class Visit>
void for_blocks(const BlockRect& rect, Visit visit) {
  for (GLint y = rect.y; y < rect.y + rect.height; y += block_side) {
    for (GLint x = rect.x; x < rect.x + rect.width; x += block_side) visit(x, y);
  }
}

/// The block's texels; those beyond the image repeat its edge.
TexelBlock read_block(const Image& image, GLint x, GLint y) {
  TexelBlock texels;
  for (GLint row = 0; row < block_side; ++row) {
    for (GLint column = 0; column < block_side; ++column) {
      const GLint tx = std::min(x + column, image.width - 1), ty = std::min(y + row, image.height - 1);
      pipeline::read_texels(image, tx, ty, 0, 1,
                            reinterpret_cast<std::byte*>(texels.data() + 4 * (row * block_side + column)));
    }
  }
  return texels;
}

void write_block(const Image& image, GLint x, GLint y, const TexelBlock& texels) {
  const GLsizei columns = std::min(block_side, image.width - x), rows = std::min(block_side, image.height - y);
  for (GLint row = 0; row < rows; ++row) {
    pipeline::write_texels(image, x, y + row, 0, columns,
                           reinterpret_cast<const std::byte*>(texels.data() + 4 * block_side * row));
  }
}

}  // namespace

std::size_t block_bytes(S3tcFormat format, GLsizei width, GLsizei height) {
  return blocks_along(width) * blocks_along(height) * pipeline::bytes_per_block(format);
}

void decode_blocks(S3tcFormat format, const std::byte* blocks, const BlockRect& rect, const Image& image) {
  for_blocks(rect, [&](GLint x, GLint y) {
    write_block(image, x, y, pipeline::decode_block(format, blocks));
    blocks += pipeline::bytes_per_block(format);
  });
}

std::shared_ptr<const std::vector<std::byte>> encode_image(S3tcFormat format, const Image& image) {
  auto blocks = std::make_shared<std::vector<std::byte>>(block_bytes(format, image.width, image.height));
  encode_region(format, image, {0, 0, image.width, image.height}, *blocks);
  return blocks;
}

void encode_region(S3tcFormat format, const Image& image, const BlockRect& rect, std::vector<std::byte>& blocks) {
  const std::size_t blocks_per_row = blocks_along(image.width);
  for_blocks(rect, [&](GLint x, GLint y) {
    const std::size_t index = static_cast<std::size_t>(y / block_side) * blocks_per_row + static_cast<std::size_t>(x / block_side);
    std::byte* const block = blocks.data() + index * pipeline::bytes_per_block(format);
    pipeline::encode_block(format, read_block(image, x, y), block);
    write_block(image, x, y, pipeline::decode_block(format, block));
  });
}

void splice_blocks(S3tcFormat format, const std::byte* from, const BlockRect& rect, GLsizei image_width,
                   std::vector<std::byte>& blocks) {
  const std::size_t size = pipeline::bytes_per_block(format), row_bytes = blocks_along(rect.width) * size;
  for (std::size_t row = 0; row < blocks_along(rect.height); ++row) {
    const std::size_t index = (static_cast<std::size_t>(rect.y / block_side) + row) * blocks_along(image_width) +
                              static_cast<std::size_t>(rect.x / block_side);
    std::memcpy(blocks.data() + index * size, from + row * row_bytes, row_bytes);
  }
}

bool check_blocks(Context& context, const Region& region, const Image& image) {
  const auto whole = [](GLint offset, GLsizei size, GLsizei side) {
    return offset % block_side == 0 && (size % block_side == 0 || offset + size == side);
  };
  if (whole(region.x, region.width, image.width) && whole(region.y, region.height, image.height)) return true;
  context.record_error(GL_INVALID_OPERATION, region.command, "the region is not made of whole blocks");
  return false;
}

}  // namespace gouraud::api
