#include "pipeline/texture/completeness.h"

#include <algorithm>

namespace gouraud::pipeline {
namespace {

LevelSize size_of(const Image& image) { return {image.width, image.height, image.depth}; }

LevelSize interior(TextureTarget target, const Image& image) {
  const int count = dimensions(target), borders = 2 * image.border;
  return {image.width - borders, count > 1 ? image.height - borders : image.height,
          count > 2 ? image.depth - borders : image.depth};
}

bool same_storage(const Image& a, const Image& b) {
  return a.format == b.format && a.base_format == b.base_format && a.colors == b.colors && a.srgb == b.srgb && a.border == b.border;
}

/// [GL1.5 §3.8.10]: the base levels of the six faces have identical, square dimensions, format and border.
bool cube_complete(const Texture& texture, std::size_t base) {
  const Image& first = texture.faces[0][base];
  if (first.width != first.height) return false;
  return std::all_of(texture.faces.begin(), texture.faces.end(), [&](const auto& face) {
    return same_storage(face[base], first) && size_of(face[base]) == size_of(first);
  });
}

/// The last level of a mipmap from `base` on, at most `max_level`; none if a level is missing or of the wrong kind.
std::optional<int> last_mipmap_level(TextureTarget target, const std::array<Image, max_texture_levels>& levels, int base,
                                     int max_level) {
  int level = base;
  for (; level < max_level; ++level) {
    const Image& image = levels[static_cast<std::size_t>(level)];
    if (is_last_level(target, image)) break;
    if (level + 1 >= max_texture_levels) return std::nullopt;
    const Image& next = levels[static_cast<std::size_t>(level) + 1];
    if (!same_storage(next, image) || size_of(next) != next_level_size(target, image)) return std::nullopt;
  }
  return level;
}

}  // namespace

LevelSize next_level_size(TextureTarget target, const Image& image) {
  const LevelSize size = interior(target, image);
  const int count = dimensions(target), borders = 2 * image.border;
  return {std::max(size.width / 2, 1) + borders, std::max(size.height / 2, 1) + (count > 1 ? borders : 0),
          std::max(size.depth / 2, 1) + (count > 2 ? borders : 0)};
}

bool is_last_level(TextureTarget target, const Image& image) {
  const LevelSize size = interior(target, image);
  return size.width <= 1 && size.height <= 1 && size.depth <= 1;
}

std::optional<LevelRange> usable_levels(const Texture& texture, int base_level, int max_level, bool mipmapped) {
  if (base_level >= max_texture_levels || texture.faces.empty()) return std::nullopt;
  const auto base = static_cast<std::size_t>(base_level);
  if (texture.faces[0][base].empty()) return std::nullopt;
  if (texture.target == TextureTarget::cube_map && !cube_complete(texture, base)) return std::nullopt;
  if (!mipmapped) return LevelRange{base_level, base_level};

  if (base_level > max_level) return std::nullopt;
  LevelRange range{base_level, base_level};
  for (const auto& face : texture.faces) {
    const std::optional<int> last = last_mipmap_level(texture.target, face, base_level, max_level);
    if (!last) return std::nullopt;
    range.last = *last;
  }
  return range;
}

}  // namespace gouraud::pipeline
