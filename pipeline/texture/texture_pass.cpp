// Takes a block with colours and varyings, gives the block with its textured colours. First all units are sampled, since
// a combiner may read any of them, then their functions are applied in order.
#include "pipeline/texture/texture_pass.h"

#include <array>

#include "pipeline/raster/primitive.h"
#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {
namespace {

void apply_textures(FragmentBlock& block, const TileTarget&) {
  const TextureUnits& units = *block.primitive->binding->texture_units;
  std::array<TexelBlock, max_texture_units> texels;
  TexelBlock primary;
  if (units.keeps_primary) primary.channel = block.color;
  const auto count = static_cast<std::size_t>(units.count);
  for (std::size_t i = 0; units.fetches && i < count; ++i) {
    if (units.unit[i].fetch != nullptr) units.unit[i].fetch(block, units.unit[i]);
  }
  for (std::size_t i = 0; i < count; ++i) units.unit[i].sample(block, units.unit[i], texels[units.unit[i].state.unit]);
  for (std::size_t i = 0; i < count; ++i) {
    const PreparedUnit& unit = units.unit[i];
    unit.environment(block, {&unit, &texels[unit.state.unit], texels.data(), &primary, i + 1 == count ? units.output_scale : 1.0f});
  }
}

void apply_textures_to_words(FragmentBlock& block, const TileTarget& target) {
  const TextureUnits& units = *block.primitive->binding->texture_units;
  if (units.fixed != nullptr && units.fixed(block, units)) return;
  apply_textures(block, target);
  units.pack(block);
}

}  // namespace

FragmentPass texture_pass() { return apply_textures; }
FragmentPass texture_words_pass() { return apply_textures_to_words; }

}  // namespace gouraud::pipeline
