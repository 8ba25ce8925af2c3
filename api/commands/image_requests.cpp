#include "api/commands/image_requests.h"

#include <algorithm>
#include <cstdint>

namespace gouraud::api {
namespace {

/// choice: no image is larger than 4 GiB, so that a proxy can say no before the machine does.
constexpr std::uint64_t max_image_bytes = std::uint64_t{1} << 32;
/// The sampler counts an image's texels in 32 bits, and bytes of four to a texel.
constexpr std::uint64_t max_image_texels = std::uint64_t{1} << 28;

int target_dimensions(TextureTarget target) {
  return target == TextureTarget::one_d ? 1 : target == TextureTarget::three_d ? 3 : 2;
}

GLsizei max_side(TextureTarget target, GLint level) {
  return std::max((target == TextureTarget::three_d ? max_texture_3d_size : max_texture_size) >> level, 1);
}

/// True if a side, border included, has an inside, or is null.
bool has_inside(GLsizei side, GLint border) { return side == 0 || side > 2 * border; }

std::nullopt_t refuse(Context& context, GLenum error, const char* command, const char* message) {
  context.record_error(error, command, message);
  return std::nullopt;
}

}  // namespace

GLint level_count(TextureTarget target) {
  switch (target) {
    case TextureTarget::rectangle: return 1;
    case TextureTarget::three_d: return max_texture_3d_levels;
    default: return pipeline::max_texture_levels;
  }
}

std::optional<ImageTarget> check_request(Context& context, const ImageRequest& request) {
  const auto target = image_target(request.target);
  if (!target || target_dimensions(target->target) != request.dimensions) {
    return refuse(context, GL_INVALID_ENUM, request.command, "target is unknown");
  }
  const auto invalid = [&](const char* message) { return refuse(context, GL_INVALID_VALUE, request.command, message); };
  if (request.level < 0 || request.level >= level_count(target->target)) return invalid("no such level");
  const GLint widest_border = target->target == TextureTarget::rectangle ? 0 : 1;
  if (request.border < 0 || request.border > widest_border) return invalid("no such border");
  if (request.width < 0 || request.height < 0 || request.depth < 0) return invalid("a size is negative");
  if (!has_inside(request.width, request.border) || (request.dimensions > 1 && !has_inside(request.height, request.border)) ||
      (request.dimensions > 2 && !has_inside(request.depth, request.border))) {
    return invalid("the image is all border");
  }
  if (target->target == TextureTarget::cube_map && request.width != request.height) {
    return invalid("the face of a cube is square");
  }
  return target;
}

const char* misplaced(const ImageRequest& request, const ImageTarget& target, const StoredFormat& format) {
  using enum TextureTarget;
  const TextureTarget t = target.target;
  if (format.depth() && t != one_d && t != two_d && t != rectangle) return "depth has one or two dimensions";
  if (!format.blocks) return nullptr;
  if (t != two_d && t != cube_map) return "such a compressed image has two dimensions";
  return request.border != 0 ? "compressed images have no border" : nullptr;
}

Fit fit(const ImageRequest& request, TextureTarget target, const StoredFormat& format) {
  const GLsizei side = max_side(target, request.level) + 2 * request.border;
  if (request.width > side || (request.dimensions > 1 && request.height > side) ||
      (request.dimensions > 2 && request.depth > side)) {
    return Fit::too_large;
  }
  // Sides are below 2^15: no overflow.
  const auto texels = static_cast<std::uint64_t>(request.width) * static_cast<std::uint64_t>(request.height) *
                      static_cast<std::uint64_t>(request.depth);
  const auto bytes = texels * static_cast<std::uint64_t>(pipeline::bytes_per_texel(format.texels));
  return bytes <= max_image_bytes && texels <= max_image_texels ? Fit::fits : Fit::no_memory;
}

pipeline::Image make_image(const ImageRequest& request, const StoredFormat& format) {
  pipeline::Image image;
  image.format = format.texels;
  image.base_format = format.base;
  image.colors = format.colors;
  image.srgb = format.srgb;
  image.has_stencil = format.stencil;
  image.width = request.width;
  image.height = request.height;
  image.depth = request.depth;
  image.border = request.border;
  return image;
}

void set_proxy(Context& context, const ImageRequest& request, const ImageTarget& target, GLint internal_format,
               const StoredFormat& format) {
  ProxyImage& proxy = context.texture_proxies[index_of(target.target)][static_cast<std::size_t>(request.level)];
  proxy = {};
  if (fit(request, target.target, format) != Fit::fits) return;
  proxy = {make_image(request, format), stored_name(static_cast<GLenum>(internal_format))};
}

std::optional<ImageTarget> check_region(Context& context, Region& region) {
  const auto target = image_target(region.target);
  if (!target || target->proxy || target_dimensions(target->target) != region.dimensions) {
    return refuse(context, GL_INVALID_ENUM, region.command, "target is unknown");
  }
  const auto invalid = [&](const char* message) { return refuse(context, GL_INVALID_VALUE, region.command, message); };
  if (region.level < 0 || region.level >= level_count(target->target)) return invalid("no such level");
  if (region.width < 0 || region.height < 0 || region.depth < 0) return invalid("a size is negative");
  const pipeline::Image& image =
      bound_texture(context, target->target).texture->faces[target->face][static_cast<std::size_t>(region.level)];
  if (image.empty()) return refuse(context, GL_INVALID_OPERATION, region.command, "there is no image");

  const auto outside = [&](GLint offset, GLsizei size, std::int32_t side, GLint border) {
    return offset < -border || std::int64_t{offset} + size > side - border;
  };
  const GLint border_y = region.dimensions > 1 ? image.border : 0, border_z = region.dimensions > 2 ? image.border : 0;
  if (outside(region.x, region.width, image.width, image.border) ||
      outside(region.y, region.height, image.height, border_y) || outside(region.z, region.depth, image.depth, border_z)) {
    return invalid("the region is not within the image");
  }
  region.x += image.border;
  region.y += border_y;
  region.z += border_z;
  return target;
}

}  // namespace gouraud::api
