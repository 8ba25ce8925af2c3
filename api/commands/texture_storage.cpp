#include "api/commands/texture_storage.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <utility>

#include "api/commands/compressed_blocks.h"
#include "pipeline/texture/attachable.h"
#include "pipeline/texture/completeness.h"
#include "pipeline/texture/mipmaps.h"
#include "pipeline/texture/texel_rows.h"

namespace gouraud::api {
namespace {

/// The object's texture, held by nobody else: its shape may change.
pipeline::Texture& own_texture(TextureObject& object) {
  if (object.texture.use_count() > 1) object.texture = std::make_shared<pipeline::Texture>(*object.texture);
  return *object.texture;
}

/// Whether texels may be written now: nobody else uses them, and this context's own draws are finished.
bool may_write(const Context& context, const TextureObject& object, const pipeline::Image& image) {
  return object.texture.use_count() <= 1 + context.texture_uses(*object.texture) && image.texels.use_count() <= 1;
}

using Levels = std::array<pipeline::Image, pipeline::max_texture_levels>;

/// Whether the levels after `base` are all there in their shape and may be written: then they can be made where they lie.
bool may_remake_levels(const Context& context, const TextureObject& object, const Levels& levels, std::size_t base) {
  if (levels[base].empty()) return false;
  for (std::size_t level = base; !pipeline::is_last_level(object.target, levels[level]); ++level) {
    const pipeline::Image& next = levels[level + 1];
    if (next.texels == nullptr || next.tiles != nullptr || !may_write(context, object, next)) return false;
    if (!pipeline::have_same_shape(next, pipeline::next_level(object.target, levels[level]))) return false;
  }
  return true;
}

void remake_levels(TextureTarget target, const Levels& levels, std::size_t base) {
  for (std::size_t level = base; !pipeline::is_last_level(target, levels[level]); ++level) {
    pipeline::fill_half_size(target, levels[level], levels[level + 1]);
  }
}

/// New levels after `base`.
void make_levels(TextureTarget target, Levels& levels, std::size_t base) {
  for (std::size_t level = base; !levels[level].empty() && !pipeline::is_last_level(target, levels[level]); ++level) {
    levels[level + 1] = pipeline::half_size(target, levels[level]);
  }
}

/// With GENERATE_MIPMAP the levels after the base level are made anew [GL1.5 §3.8.8].
void base_level_changed(Context& context, TextureObject& object, std::size_t face, std::size_t level) {
  const TextureParameters& parameters = object.parameters;
  if (!parameters.generate_mipmap || static_cast<GLint>(level) != parameters.base_level) return;
  generate_mipmaps(context, object, face, face + 1);
}

}  // namespace

void put_image(Context& context, TextureObject& object, std::size_t face, std::size_t level, pipeline::Image image,
               GLenum internal_format) {
  ImageDescription description{stored_name(internal_format), nullptr};
  const auto format = find_stored_format(static_cast<GLint>(internal_format));
  if (format && format->blocks && !image.empty()) description.blocks = encode_image(*format->blocks, image);
  put_image(context, object, face, level, std::move(image), std::move(description));
}

void put_image(Context& context, TextureObject& object, std::size_t face, std::size_t level, pipeline::Image image,
               ImageDescription description) {
  if (pipeline::has_widened_images(*object.texture)) pipeline::widen(image);
  own_texture(object).faces[face][level] = std::move(image);
  object.descriptions[face][level] = std::move(description);
  context.change(dirty_textures);
  context.update_targets();
  base_level_changed(context, object, face, level);
}

// An image in tiles is a picture that framebuffer objects draw into: it stays the same for all of them.
pipeline::Image& writable_image(Context& context, TextureObject& object, std::size_t face, std::size_t level) {
  if (object.texture.use_count() > 1) context.finish_rendering();
  pipeline::Image& image = object.texture->faces[face][level];
  if (image.tiles != nullptr) {
    context.finish_rendering();
    return image;
  }
  if (may_write(context, object, image)) return image;

  pipeline::Image copy = image;
  pipeline::allocate_texels(copy, false);
  copy.stencil = image.stencil;
  std::memcpy(copy.texels.get(), image.texels.get(), pipeline::texel_bytes(image));
  pipeline::Image& fresh = own_texture(object).faces[face][level];
  fresh = std::move(copy);
  context.change(dirty_textures);
  return fresh;
}

void texels_changed(Context& context, TextureObject& object, std::size_t face, const Region& region) {
  const auto level = static_cast<std::size_t>(region.level);
  ImageDescription& description = object.descriptions[face][level];
  if (description.blocks != nullptr) {
    const auto format = find_stored_format(static_cast<GLint>(description.internal_format));
    auto blocks = std::make_shared<std::vector<std::byte>>(*description.blocks);
    encode_region(*format->blocks, object.texture->faces[face][level], {region.x, region.y, region.width, region.height},
                  *blocks);
    description.blocks = std::move(blocks);
  }
  base_level_changed(context, object, face, level);
}

void put_blocks(Context& context, TextureObject& object, std::size_t face, const Region& region,
                pipeline::S3tcFormat format, const std::byte* blocks) {
  const auto level = static_cast<std::size_t>(region.level);
  ImageDescription& description = object.descriptions[face][level];
  const BlockRect rect{region.x, region.y, region.width, region.height};
  auto kept = std::make_shared<std::vector<std::byte>>(*description.blocks);
  pipeline::Image& image = writable_image(context, object, face, level);
  splice_blocks(format, blocks, rect, image.width, *kept);
  decode_blocks(format, blocks, rect, image);
  description.blocks = std::move(kept);
  base_level_changed(context, object, face, level);
}

// Levels that are made anew lose their blocks and get the internal format of their base level.
void generate_mipmaps(Context& context, TextureObject& object, std::size_t first_face, std::size_t end_face) {
  if (object.parameters.base_level >= pipeline::max_texture_levels || object.target == TextureTarget::rectangle) return;
  const auto base = static_cast<std::size_t>(object.parameters.base_level);
  if (object.texture.use_count() > 1) context.finish_rendering();
  const std::span faces(object.texture->faces.begin() + static_cast<std::ptrdiff_t>(first_face), end_face - first_face);
  if (std::ranges::all_of(faces, [&](const Levels& levels) { return may_remake_levels(context, object, levels, base); })) {
    for (const Levels& levels : faces) remake_levels(object.target, levels, base);
  } else {
    auto fresh = std::make_shared<pipeline::Texture>(*object.texture);
    for (std::size_t face = first_face; face < end_face; ++face) make_levels(object.target, fresh->faces[face], base);
    object.texture = std::move(fresh);
    context.change(dirty_textures);
  }
  for (std::size_t face = first_face; face < end_face; ++face) {
    auto& descriptions = object.descriptions[face];
    for (std::size_t level = base + 1; level < descriptions.size(); ++level) {
      descriptions[level] = {descriptions[base].internal_format, nullptr};
    }
  }
  context.update_targets();
}

}  // namespace gouraud::api
