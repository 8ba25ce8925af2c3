// Takes S3TC blocks, gives images that keep them beside the texels that they stand for. S3TC has images of two
// dimensions alone, so that the commands of one and three know no format.
#include "api/commands/compressed_textures.h"

#include <new>
#include <utility>
#include <vector>

#include "api/commands/client_pixels.h"
#include "api/commands/compressed_blocks.h"
#include "api/commands/image_requests.h"
#include "api/commands/texture_storage.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

void compressed_tex_image(Context& context, const ImageRequest& request, GLenum internal_format, GLsizei image_size,
                          const void* data) {
  const auto refuse = [&](GLenum error, const char* message) { context.record_error(error, request.command, message); };
  const auto target = check_request(context, request);
  if (!target) return;
  const auto format = find_stored_format(static_cast<GLint>(internal_format));
  if (!format || !format->blocks || request.dimensions != 2 || target->target == TextureTarget::rectangle) {
    return refuse(GL_INVALID_ENUM, "no compressed format of this dimension");
  }
  if (const char* const message = misplaced(request, *target, *format)) return refuse(GL_INVALID_OPERATION, message);
  if (target->proxy) {
    return set_proxy(context, request, *target, static_cast<GLint>(internal_format), *format);
  }
  const Fit fits = fit(request, target->target, *format);
  if (fits == Fit::too_large) return refuse(GL_INVALID_VALUE, "the image is too large");
  if (fits == Fit::no_memory) throw std::bad_alloc();
  const std::size_t bytes = block_bytes(*format->blocks, request.width, request.height);
  if (image_size < 0 || static_cast<std::size_t>(image_size) != bytes) {
    return refuse(GL_INVALID_VALUE, "imageSize is not that of the image");
  }
  const std::byte* blocks = nullptr;
  if (!check_unpack_array(context, request.command, bytes, 1, data, blocks)) return;

  pipeline::Image image = make_image(request, *format);
  ImageDescription description{internal_format, nullptr};
  if (!image.empty()) {
    pipeline::allocate_texels(image);
    // Without data a block is zeros: black.
    auto kept = blocks != nullptr ? std::make_shared<std::vector<std::byte>>(blocks, blocks + bytes)
                                  : std::make_shared<std::vector<std::byte>>(bytes);
    decode_blocks(*format->blocks, kept->data(), {0, 0, image.width, image.height}, image);
    description.blocks = std::move(kept);
  }
  put_image(context, bound_texture(context, target->target), target->face, static_cast<std::size_t>(request.level),
            std::move(image), std::move(description));
}

void compressed_tex_sub_image(Context& context, Region region, GLenum format_name, GLsizei image_size, const void* data) {
  const auto refuse = [&](GLenum error, const char* message) { context.record_error(error, region.command, message); };
  const auto format = find_stored_format(static_cast<GLint>(format_name));
  if (!format || !format->blocks || region.dimensions != 2) {
    return refuse(GL_INVALID_ENUM, "no compressed format of this dimension");
  }
  const auto target = check_region(context, region);
  if (!target) return;
  TextureObject& object = bound_texture(context, target->target);
  const auto level = static_cast<std::size_t>(region.level);
  const pipeline::Image& old = object.texture->faces[target->face][level];
  const ImageDescription& description = object.descriptions[target->face][level];
  if (description.internal_format != format_name || description.blocks == nullptr) {
    return refuse(GL_INVALID_OPERATION, "the image is of another format");
  }
  if (!check_blocks(context, region, old)) return;
  const std::size_t bytes = block_bytes(*format->blocks, region.width, region.height);
  if (image_size < 0 || static_cast<std::size_t>(image_size) != bytes) {
    return refuse(GL_INVALID_VALUE, "imageSize is not that of the region");
  }
  const std::byte* blocks = nullptr;
  if (!check_unpack_array(context, region.command, bytes, 1, data, blocks)) return;
  if (blocks == nullptr || bytes == 0) return;
  put_blocks(context, object, target->face, region, *format->blocks, blocks);
}

}  // namespace

void CompressedTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLint border, GLsizei imageSize, const void* data) {
  compressed_tex_image(context, {"glCompressedTexImage1D", 1, target, level, width, 1, 1, border}, internalformat,
                       imageSize, data);
}

void CompressedTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLint border, GLsizei imageSize, const void* data) {
  compressed_tex_image(context, {"glCompressedTexImage2D", 2, target, level, width, height, 1, border}, internalformat,
                       imageSize, data);
}

void CompressedTexImage3D(Context& context, GLenum target, GLint level, GLenum internalformat, GLsizei width,
                          GLsizei height, GLsizei depth, GLint border, GLsizei imageSize, const void* data) {
  compressed_tex_image(context, {"glCompressedTexImage3D", 3, target, level, width, height, depth, border},
                       internalformat, imageSize, data);
}

void CompressedTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                             GLsizei imageSize, const void* data) {
  compressed_tex_sub_image(context, {"glCompressedTexSubImage1D", 1, target, level, xoffset, 0, 0, width}, format,
                           imageSize, data);
}

void CompressedTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                             GLsizei height, GLenum format, GLsizei imageSize, const void* data) {
  compressed_tex_sub_image(context, {"glCompressedTexSubImage2D", 2, target, level, xoffset, yoffset, 0, width, height},
                           format, imageSize, data);
}

void CompressedTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                             GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLsizei imageSize,
                             const void* data) {
  compressed_tex_sub_image(
      context, {"glCompressedTexSubImage3D", 3, target, level, xoffset, yoffset, zoffset, width, height, depth}, format,
      imageSize, data);
}

}  // namespace gouraud::api
