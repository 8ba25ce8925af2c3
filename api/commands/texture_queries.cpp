// Gives what texture objects hold: images through the pack road, without pixel transfer [GL1.5 §6.1.4, Table 6.1].
#include "api/commands/texture_queries.h"

#include <cstring>
#include <optional>
#include <vector>

#include "api/commands/client_pixels.h"
#include "api/commands/image_requests.h"
#include "api/commands/pack_rows.h"
#include "api/commands/state_table.h"
#include "api/commands/texel_formats.h"
#include "api/commands/texture_targets.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

using pipeline::Image;

/// An image, what its format is, and its blocks; null texels of a proxy.
struct LevelInfo {
  const Image* image = nullptr;
  GLenum internal_format = 1;
  const std::vector<std::byte>* blocks = nullptr;
};

std::optional<LevelInfo> find_level(Context& context, const char* command, GLenum name, GLint level, bool proxies) {
  const auto target = image_target(name);
  if (!target || (target->proxy && !proxies)) {
    context.record_error(GL_INVALID_ENUM, command, "target is unknown");
    return std::nullopt;
  }
  if (level < 0 || level >= level_count(target->target)) {
    context.record_error(GL_INVALID_VALUE, command, "no such level");
    return std::nullopt;
  }
  const auto index = static_cast<std::size_t>(level);
  if (target->proxy) {
    const ProxyImage& proxy = context.texture_proxies[index_of(target->target)][index];
    return LevelInfo{&proxy.image, proxy.internal_format};
  }
  const TextureObject& object = bound_texture(context, target->target);
  const ImageDescription& description = object.descriptions[target->face][index];
  return LevelInfo{&object.texture->faces[target->face][index], description.internal_format, description.blocks.get()};
}

/// Nothing for an unknown pname. An image that does not exist has no components.
std::optional<int> level_parameter(const LevelInfo& level, GLenum pname) {
  const Image& image = *level.image;
  const bool exists = image.format != pipeline::TexelFormat::none;
  const auto format = find_stored_format(static_cast<GLint>(level.internal_format));
  const ComponentBits bits = exists && format ? component_bits(*format) : ComponentBits();
  switch (pname) {
    case GL_TEXTURE_WIDTH: return image.width;
    case GL_TEXTURE_HEIGHT: return image.height;
    case GL_TEXTURE_DEPTH: return image.depth;
    case GL_TEXTURE_BORDER: return image.border;
    case GL_TEXTURE_INTERNAL_FORMAT: return static_cast<int>(level.internal_format);
    case GL_TEXTURE_RED_SIZE: return bits.red;
    case GL_TEXTURE_GREEN_SIZE: return bits.green;
    case GL_TEXTURE_BLUE_SIZE: return bits.blue;
    case GL_TEXTURE_ALPHA_SIZE: return bits.alpha;
    case GL_TEXTURE_LUMINANCE_SIZE: return bits.luminance;
    case GL_TEXTURE_INTENSITY_SIZE: return bits.intensity;
    case GL_TEXTURE_DEPTH_SIZE: return bits.depth;
    case GL_TEXTURE_STENCIL_SIZE_EXT: return bits.stencil;
    case GL_TEXTURE_COMPRESSED: return level.blocks != nullptr;
    default: return std::nullopt;
  }
}

template <class T>
void get_level_parameter(Context& context, const char* command, GLenum target, GLint level, GLenum pname, T* params) {
  const auto info = find_level(context, command, target, level, true);
  if (!info) return;
  if (pname == GL_TEXTURE_COMPRESSED_IMAGE_SIZE) {
    if (info->blocks == nullptr) return context.record_error(GL_INVALID_OPERATION, command, "it is not compressed");
    *params = static_cast<T>(info->blocks->size());
    return;
  }
  const auto value = level_parameter(*info, pname);
  if (!value) return context.record_error(GL_INVALID_ENUM, command, "pname is unknown");
  *params = static_cast<T>(*value);
}

/// False, and an error is recorded, if such an image is never given as this.
bool find_layout(Context& context, const char* command, const Image& image, GLenum format, GLenum type,
                 PixelLayout& layout) {
  if (format == GL_STENCIL_INDEX || format == GL_COLOR_INDEX) {
    context.record_error(GL_INVALID_ENUM, command, "a texture has no indices");
    return false;
  }
  if (!find_pixel_layout(context, command, format, type, layout)) return false;
  // choice: luminance is R, as Mesa has it and later specifications say; only ReadPixels adds R, G and B.
  for (std::uint8_t& channel : layout.channel) channel = channel == channel_luminance ? 0 : channel;
  const bool wants_depth = layout.kind == PixelKind::depth || layout.kind == PixelKind::depth_stencil;
  if (image.empty() || wants_depth == (image.base_format == pipeline::BaseFormat::depth)) return true;
  context.record_error(GL_INVALID_OPERATION, command, "depth goes with depth alone");
  return false;
}

void download(const Image& image, const ClientImage& client) {
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<std::byte> texels(width * static_cast<std::size_t>(pipeline::bytes_per_texel(image.format)));
  const bool depth = image.base_format == pipeline::BaseFormat::depth;
  const bool bytes = pipeline::has_byte_channels(image.format);
  std::vector<float> colors(depth || bytes ? 0 : 4 * width);
  std::vector<std::uint8_t> byte_colors(bytes ? 4 * width : 0);
  std::vector<double> depths(depth ? width : 0);
  std::vector<std::uint32_t> stencils(depth ? width : 0);
  for (int z = 0; z < image.depth; ++z) {
    for (int y = 0; y < image.height; ++y) {
      const PixelRun run = whole_row(client, y, z);
      pipeline::read_texels(image, 0, y, z, image.width, texels.data());
      if (depth) {
        pipeline::load_depths(image, texels.data(), width, depths.data(), stencils.data());
        if (image.stencil != nullptr) pipeline::read_stencils(image, 0, y, image.width, stencils.data());
        client.layout.kind == PixelKind::depth_stencil ? pack_depth_stencil(client, run, depths.data(), stencils.data())
                                                       : pack_depth(client, run, depths.data());
      } else if (bytes) {
        pipeline::load_colors(image, texels.data(), width, byte_colors.data());
        pack_color(client, run, byte_colors.data());
      } else {
        pipeline::load_colors(image, texels.data(), width, colors.data());
        pack_color(client, run, colors.data());
      }
    }
  }
}

}  // namespace

void GetTexLevelParameterfv(Context& context, GLenum target, GLint level, GLenum pname, GLfloat* params) {
  get_level_parameter(context, "glGetTexLevelParameterfv", target, level, pname, params);
}

void GetTexLevelParameteriv(Context& context, GLenum target, GLint level, GLenum pname, GLint* params) {
  get_level_parameter(context, "glGetTexLevelParameteriv", target, level, pname, params);
}

void GetTexImage(Context& context, GLenum target, GLint level, GLenum format, GLenum type, void* pixels) {
  constexpr auto command = "glGetTexImage";
  const auto info = find_level(context, command, target, level, false);
  if (!info) return;
  const Image& image = *info->image;
  PixelLayout layout;
  if (!find_layout(context, command, image, format, type, layout)) return;
  ClientImage client;
  const ImageSize size{image.width, image.height, image.depth, target == GL_TEXTURE_3D};
  if (!locate_pack(context, command, size, layout, pixels, client) || client.null() || image.empty()) return;
  if (image.tiles != nullptr) context.finish_rendering();
  download(image, client);
}

void GetCompressedTexImage(Context& context, GLenum target, GLint level, void* img) {
  constexpr auto command = "glGetCompressedTexImage";
  const auto info = find_level(context, command, target, level, false);
  if (!info) return;
  if (info->blocks == nullptr) return context.record_error(GL_INVALID_OPERATION, command, "it is not compressed");
  std::byte* out = nullptr;
  if (!check_pack_array(context, command, info->blocks->size(), 1, img, out) || out == nullptr) return;
  std::memcpy(out, info->blocks->data(), info->blocks->size());
}

}  // namespace gouraud::api
