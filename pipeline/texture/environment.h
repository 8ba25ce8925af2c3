// Texture functions: what a unit's texels make of the fragment's colour [GL1.5 §3.8.13].
#pragma once

#include "pipeline/texture/texture_units.h"

namespace gouraud::pipeline {

/// The function of a mode and base format, for the instruction set in use.
EnvironmentFunction environment_function(const TextureEnvironment& environment, BaseFormat format);

/// What a texture function makes of R, G, B or of alpha [GL1.5 Tables 3.22, 3.23]; `keep` is also the choice for decals
/// that the tables leave undefined (choice: as Mesa, which follows NV_texture_shader).
enum class TextureFunction : std::uint8_t { keep, replace, modulate, mix_by_alpha, blend, add };
struct TextureFunctions {
  TextureFunction rgb = TextureFunction::keep, alpha = TextureFunction::keep;
  bool operator==(const TextureFunctions&) const = default;
};
/// Not for `combine`.
TextureFunctions texture_functions(EnvironmentMode mode, BaseFormat format);

/// A block's scaled colours to its words, for the instruction set in use.
void (*packing_function())(FragmentBlock& block);

}  // namespace gouraud::pipeline
