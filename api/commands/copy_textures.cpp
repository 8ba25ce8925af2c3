// Takes pixels of the framebuffer, gives texels, by way of pixel transfer [GL1.5 §3.8.2, §4.3.3].
//
// choice: pixels outside the framebuffer, undefined by the specification, change nothing; new images are zero there.
#include "api/commands/copy_textures.h"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "api/commands/compressed_blocks.h"
#include "api/commands/image_requests.h"
#include "api/commands/pixel_transfer.h"
#include "api/commands/texel_upload.h"
#include "api/commands/target_values.h"
#include "api/commands/texture_storage.h"
#include "pipeline/framebuffer/read.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

using pipeline::Framebuffer;
using pipeline::Image;

/// Pixels inside the framebuffer, and where the first one goes.
struct Copy {
  int x = 0, y = 0, width = 0, height = 0;
  TexelPosition to;
};

/// The part of a rectangle that the framebuffer has.
Copy clipped(const Framebuffer& source, GLint x, GLint y, GLsizei width, GLsizei height, const TexelPosition& to) {
  const std::int64_t x0 = std::max<std::int64_t>(x, 0), y0 = std::max<std::int64_t>(y, 0);
  const std::int64_t x1 = std::min<std::int64_t>(std::int64_t{x} + width, source.width_px);
  const std::int64_t y1 = std::min<std::int64_t>(std::int64_t{y} + height, source.height_px);
  if (x0 >= x1 || y0 >= y1) return {};
  return {static_cast<int>(x0), static_cast<int>(y0), static_cast<int>(x1 - x0), static_cast<int>(y1 - y0),
          {to.x + static_cast<int>(x0 - x), to.y + static_cast<int>(y0 - y), to.z}};
}

/// Bytes that are stored as they are: whole rows at once, block by block out of the tiles.
void copy_bytes(const Framebuffer& source, const Copy& copy, const Image& image) {
  std::byte* const first = pipeline::texel_row(image, copy.to.y, copy.to.z) + static_cast<std::size_t>(copy.to.x) * 4;
  const std::ptrdiff_t stride = std::ptrdiff_t{image.width} * 4;
  pipeline::read_color_rows(source, copy.x, copy.y, copy.width, copy.height, first, stride);
  if (image.base_format != pipeline::BaseFormat::rgb) return;
  for (int y = 0; y < copy.height; ++y) {
    std::byte* const row = first + y * stride;
    for (std::ptrdiff_t i = 0; i < copy.width; ++i) {
      for (std::ptrdiff_t color = image.colors; color < 3; ++color) row[4 * i + color] = std::byte{0};
      row[4 * i + 3] = std::byte{255};
    }
  }
}

void copy_colors(const Context& context, const Framebuffer& source, const Copy& copy, const Image& image) {
  const bool transfers = transfers_color(context.state.pixel.transfer);
  const bool bytes = source.color_format == pipeline::ColorFormat::rgba8 && !transfers;
  if (bytes && image.format == pipeline::TexelFormat::rgba8 && !pipeline::is_widened(image) && image.tiles == nullptr) {
    return copy_bytes(source, copy, image);
  }
  const auto width = static_cast<std::size_t>(copy.width);
  std::vector<std::uint8_t> byte_colors(bytes ? 4 * width : 0);
  std::vector<float> colors(bytes ? 0 : 4 * width);
  std::vector<std::byte> texels(width * static_cast<std::size_t>(pipeline::bytes_per_texel(image.format)));
  for (int y = 0; y < copy.height; ++y) {
    if (bytes) {
      pipeline::read_color_row_unorm8(source, copy.x, copy.y + y, copy.width, byte_colors.data());
      pipeline::store_colors(image, byte_colors.data(), width, texels.data());
    } else {
      pipeline::read_color_row_float(source, copy.x, copy.y + y, copy.width, colors.data());
      if (transfers) transfer_color(context.state, colors.data(), width);
      pipeline::store_colors(image, colors.data(), width, texels.data());
    }
    pipeline::write_texels(image, copy.to.x, copy.to.y + y, copy.to.z, copy.width, texels.data());
  }
}

void copy_depths(const Context& context, const Framebuffer& source, const Copy& copy, const Image& image, bool stencil) {
  const auto width = static_cast<std::size_t>(copy.width);
  std::vector<double> depths(width);
  std::vector<std::uint8_t> bytes(stencil ? width : 0);
  std::vector<std::uint32_t> stencils(stencil ? width : 0);
  std::vector<std::byte> texels(width * static_cast<std::size_t>(pipeline::bytes_per_texel(image.format)));
  for (int y = 0; y < copy.height; ++y) {
    read_depths(source, copy.x, copy.y + y, copy.width, depths.data());
    if (transfers_depth(context.state.pixel.transfer)) transfer_depth(context.state, depths.data(), width);
    if (stencil) {
      pipeline::read_stencil_row(source, copy.x, copy.y + y, copy.width, bytes.data());
      std::copy(bytes.begin(), bytes.end(), stencils.begin());
      if (transfers_stencil(context.state.pixel.transfer)) transfer_stencil(context.state, stencils.data(), width);
    }
    pipeline::store_depths(image, depths.data(), stencil ? stencils.data() : nullptr, width, texels.data());
    pipeline::write_texels(image, copy.to.x, copy.to.y + y, copy.to.z, copy.width, texels.data());
    if (stencil) pipeline::write_stencils(image, copy.to.x, copy.to.y + y, copy.width, stencils.data());
  }
}

/// What the framebuffer lacks for such an image; null if nothing.
const char* lack(const Framebuffer& source, const StoredFormat& format) {
  if (!format.depth()) return source.color_format == pipeline::ColorFormat::none ? "there is no color buffer" : nullptr;
  if (source.depth_format == pipeline::DepthFormat::none) return "there is no depth buffer";
  return format.stencil && source.stencil_bits == 0 ? "there is no stencil buffer" : nullptr;
}

void copy_pixels(Context& context, const Framebuffer& source, const Copy& copy, const Image& image, const StoredFormat& format) {
  if (copy.width == 0) return;
  context.finish_rendering();
  format.depth() ? copy_depths(context, source, copy, image, format.stencil) : copy_colors(context, source, copy, image);
}

void copy_tex_image(Context& context, const ImageRequest& request, GLenum internal_format, GLint x, GLint y) {
  const auto refuse = [&](GLenum error, const char* message) { context.record_error(error, request.command, message); };
  const auto target = check_request(context, request);
  if (!target) return;
  if (target->proxy) return refuse(GL_INVALID_ENUM, "a proxy takes no texels");
  const auto format = find_stored_format(static_cast<GLint>(internal_format));
  if (!format || internal_format <= 4) return refuse(GL_INVALID_ENUM, "no such internal format");
  if (const char* const message = misplaced(request, *target, *format)) return refuse(GL_INVALID_OPERATION, message);
  const Fit fits = fit(request, target->target, *format);
  if (fits == Fit::too_large) return refuse(GL_INVALID_VALUE, "the image is too large");
  if (fits == Fit::no_memory) throw std::bad_alloc();
  if (!context.can_read(request.command)) return;
  const Framebuffer* const source = context.read_target();
  if (source == nullptr) return;
  if (const char* const message = lack(*source, *format)) return refuse(GL_INVALID_OPERATION, message);

  Image image = make_image(request, *format);
  if (!image.empty()) {
    pipeline::allocate_texels(image);
    copy_pixels(context, *source, clipped(*source, x, y, image.width, image.height, {}), image, *format);
  }
  put_image(context, bound_texture(context, target->target), target->face, static_cast<std::size_t>(request.level),
            std::move(image), internal_format);
}

void copy_tex_sub_image(Context& context, Region region, GLint x, GLint y) {
  const auto refuse = [&](GLenum error, const char* message) { context.record_error(error, region.command, message); };
  const auto target = check_region(context, region);
  if (!target) return;
  TextureObject& object = bound_texture(context, target->target);
  const auto level = static_cast<std::size_t>(region.level);
  const auto format = find_stored_format(static_cast<GLint>(object.descriptions[target->face][level].internal_format));
  if (!format) return refuse(GL_INVALID_OPERATION, "no such internal format");
  if (format->blocks && !check_blocks(context, region, object.texture->faces[target->face][level])) return;
  if (!context.can_read(region.command)) return;
  const Framebuffer* const source = context.read_target();
  if (source == nullptr) return;
  if (const char* const message = lack(*source, *format)) return refuse(GL_INVALID_OPERATION, message);
  const Copy copy = clipped(*source, x, y, region.width, region.height, {region.x, region.y, region.z});
  if (copy.width == 0) return;
  copy_pixels(context, *source, copy, writable_image(context, object, target->face, level), *format);
  texels_changed(context, object, target->face, region);
}

}  // namespace

void CopyTexImage1D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                    GLint border) {
  copy_tex_image(context, {"glCopyTexImage1D", 1, target, level, width, 1, 1, border}, internalformat, x, y);
}

void CopyTexImage2D(Context& context, GLenum target, GLint level, GLenum internalformat, GLint x, GLint y, GLsizei width,
                    GLsizei height, GLint border) {
  copy_tex_image(context, {"glCopyTexImage2D", 2, target, level, width, height, 1, border}, internalformat, x, y);
}

void CopyTexSubImage1D(Context& context, GLenum target, GLint level, GLint xoffset, GLint x, GLint y, GLsizei width) {
  copy_tex_sub_image(context, {"glCopyTexSubImage1D", 1, target, level, xoffset, 0, 0, width}, x, y);
}

void CopyTexSubImage2D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint x, GLint y,
                       GLsizei width, GLsizei height) {
  copy_tex_sub_image(context, {"glCopyTexSubImage2D", 2, target, level, xoffset, yoffset, 0, width, height}, x, y);
}

void CopyTexSubImage3D(Context& context, GLenum target, GLint level, GLint xoffset, GLint yoffset, GLint zoffset,
                       GLint x, GLint y, GLsizei width, GLsizei height) {
  copy_tex_sub_image(context, {"glCopyTexSubImage3D", 3, target, level, xoffset, yoffset, zoffset, width, height}, x, y);
}

}  // namespace gouraud::api
