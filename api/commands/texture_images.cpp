// Takes images in client memory, gives those of texture objects [GL1.5 §3.8.1, §3.8.2]. Every image takes one road:
// checked, located, allocated, filled row by row, put in its place. Bytes that no pixel transfer changes are copied.
#include "api/commands/texture_images.h"

#include <new>
#include <utility>

#include "api/commands/client_pixels.h"
#include "api/commands/compressed_blocks.h"
#include "api/commands/image_requests.h"
#include "api/commands/texel_upload.h"
#include "api/commands/texture_storage.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

/// The layout of what a program gives to an image; false, and an error is recorded, if the two do not go together.
bool find_layout(Context& context, const char* command, const StoredFormat& format, GLenum pixel_format, GLenum type,
                 PixelLayout& layout) {
  if (pixel_format == GL_STENCIL_INDEX) {
    context.record_error(GL_INVALID_ENUM, command, "a texture has no stencil alone");
    return false;
  }
  if (!find_pixel_layout(context, command, pixel_format, type, layout)) return false;
  const bool gives_depth = layout.kind == PixelKind::depth || layout.kind == PixelKind::depth_stencil;
  if (gives_depth == format.depth()) return true;
  context.record_error(GL_INVALID_OPERATION, command, "depth goes with depth alone");
  return false;
}

struct ClientData {
  GLenum format = 0, type = 0;
  const void* pixels = nullptr;
};

/// Whether the object's image is replaced by one of the same shape, so large that fresh pages would cost more than to finish
/// the draws that still read the old texels: then the new ones take their place.
bool takes_the_place(const TextureObject& object, std::size_t face, std::size_t level, const pipeline::Image& image, GLint internal_format) {
  constexpr std::size_t worth_finishing = std::size_t{1} << 18;
  const pipeline::Image& old = object.texture->faces[face][level];
  const ImageDescription& description = object.descriptions[face][level];
  return pipeline::texel_bytes(image) >= worth_finishing && pipeline::have_same_shape(old, image) && old.texels != nullptr &&
         old.tiles == nullptr && !image.has_stencil && description.blocks == nullptr &&
         description.internal_format == stored_name(static_cast<GLenum>(internal_format));
}

void tex_image(Context& context, const ImageRequest& request, GLint internal_format, const ClientData& data) {
  const auto refuse = [&](GLenum error, const char* message) { context.record_error(error, request.command, message); };
  const auto target = check_request(context, request);
  if (!target) return;
  const auto format = find_stored_format(internal_format);
  if (!format) return refuse(GL_INVALID_VALUE, "no such internal format");
  PixelLayout layout;
  if (!find_layout(context, request.command, *format, data.format, data.type, layout)) return;
  if (const char* const message = misplaced(request, *target, *format)) return refuse(GL_INVALID_OPERATION, message);
  if (target->proxy) return set_proxy(context, request, *target, internal_format, *format);
  const Fit fits = fit(request, target->target, *format);
  if (fits == Fit::too_large) return refuse(GL_INVALID_VALUE, "the image is too large");
  if (fits == Fit::no_memory) throw std::bad_alloc();

  const ImageSize size{request.width, request.height, request.depth, request.dimensions == 3};
  ClientImage client;
  if (!locate_unpack(context, request.command, size, layout, data.pixels, client)) return;
  pipeline::Image image = make_image(request, *format);
  TextureObject& object = bound_texture(context, target->target);
  const auto level = static_cast<std::size_t>(request.level);
  if (!client.null() && takes_the_place(object, target->face, level, image, internal_format)) {
    upload(context, client, writable_image(context, object, target->face, level), {0, 0, 0});
    return texels_changed(context, object, target->face, {.command = request.command, .level = request.level});
  }
  if (!image.empty()) {
    pipeline::allocate_texels(image, client.null());
    if (!client.null()) upload(context, client, image, {0, 0, 0});
  }
  put_image(context, object, target->face, level, std::move(image), static_cast<GLenum>(internal_format));
}

void tex_sub_image(Context& context, Region region, const ClientData& data) {
  const auto target = check_region(context, region);
  if (!target) return;
  TextureObject& object = bound_texture(context, target->target);
  const auto level = static_cast<std::size_t>(region.level);
  const ImageDescription& description = object.descriptions[target->face][level];
  const auto format = find_stored_format(static_cast<GLint>(description.internal_format));
  PixelLayout layout;
  if (!format || !find_layout(context, region.command, *format, data.format, data.type, layout)) return;
  if (format->blocks && !check_blocks(context, region, object.texture->faces[target->face][level])) return;

  const ImageSize size{region.width, region.height, region.depth, region.dimensions == 3};
  ClientImage client;
  if (!locate_unpack(context, region.command, size, layout, data.pixels, client)) return;
  if (client.null() || region.width == 0 || region.height == 0 || region.depth == 0) return;
  upload(context, client, writable_image(context, object, target->face, level), {region.x, region.y, region.z});
  texels_changed(context, object, target->face, region);
}

}  // namespace

void TexImage1D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLint border,
                GLenum format, GLenum type, const void* pixels) {
  tex_image(context, {"glTexImage1D", 1, target, level, width, 1, 1, border}, internalformat, {format, type, pixels});
}

void TexImage2D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLint border, GLenum format, GLenum type, const void* pixels) {
  tex_image(context, {"glTexImage2D", 2, target, level, width, height, 1, border}, internalformat,
            {format, type, pixels});
}

void TexImage3D(Context& context, GLenum target, GLint level, GLint internalformat, GLsizei width, GLsizei height,
                GLsizei depth, GLint border, GLenum format, GLenum type, const void* pixels) {
  tex_image(context, {"glTexImage3D", 3, target, level, width, height, depth, border}, internalformat,
            {format, type, pixels});
}

void TexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLsizei width, GLenum format,
                   GLenum type, const void* pixels) {
  tex_sub_image(context, {"glTexSubImage1D", 1, target, level, xoffset, 0, 0, width}, {format, type, pixels});
}

void TexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLsizei width,
                   GLsizei height, GLenum format, GLenum type, const void* pixels) {
  tex_sub_image(context, {"glTexSubImage2D", 2, target, level, xoffset, yoffset, 0, width, height},
                {format, type, pixels});
}

void TexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                   GLsizei width, GLsizei height, GLsizei depth, GLenum format, GLenum type, const void* pixels) {
  tex_sub_image(context, {"glTexSubImage3D", 3, target, level, xoffset, yoffset, zoffset, width, height, depth},
                {format, type, pixels});
}

}  // namespace gouraud::api
