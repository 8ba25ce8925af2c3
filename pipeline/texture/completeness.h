// Which levels of a texture can be sampled. Takes images and level parameters, gives the range of levels
// [GL1.5 §3.8.8, §3.8.10]; sizes of levels as ARB_texture_non_power_of_two has them, rounded down.
#pragma once

#include <optional>

#include "pipeline/texture/image.h"

namespace gouraud::pipeline {

/// First and last level, as array indices: levelbase and q. Equal if only the base level is used.
struct LevelRange {
  int base = 0, last = 0;
  bool operator==(const LevelRange&) const = default;
};

/// In how many dimensions an image of this target has a border: also those that its levels shrink in.
constexpr int dimensions(TextureTarget target) {
  return target == TextureTarget::one_d ? 1 : target == TextureTarget::three_d ? 3 : 2;
}

/// The levels that a filter may use; none if the texture is incomplete for it. `mipmapped`: the minification filter needs
/// a mipmap. `base_level` and `max_level` are as given by the program, not negative.
/// choice: images count as of the same internal format if they are stored alike.
std::optional<LevelRange> usable_levels(const Texture& texture, int base_level, int max_level, bool mipmapped);

/// The size of the level after one of `image`'s size, its border as well.
struct LevelSize {
  int width = 0, height = 0, depth = 0;
  bool operator==(const LevelSize&) const = default;
};
LevelSize next_level_size(TextureTarget target, const Image& image);
/// True if the image is 1 texel large in each dimension, its border apart: no level comes after.
bool is_last_level(TextureTarget target, const Image& image);

}  // namespace gouraud::pipeline
