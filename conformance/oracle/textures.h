// Takes a fragment's colour and texture coordinates, gives its textured colour [GL1.5 §3.8.6-3.8.10, §3.8.13, §3.8.14].
// Everything in double, texel by texel. choice: magnification begins at lambda = 0 (as Mesa); a comparison under a linear
// filter gives the weighted share of the texels that pass; where the tables leave decals undefined they do nothing.
#pragma once

#include <span>

#include "conformance/oracle/vertex.h"
#include "pipeline/draw/draw_state.h"
#include "pipeline/texture/image.h"

namespace gouraud::oracle {

/// s, t, r, q of one unit at a fragment, not divided by q, and their derivatives by window x and y.
struct TextureCoordinate {
  Vector4 value{0, 0, 0, 1}, ddx{}, ddy{};
};

/// The colour, and the range of what a conforming implementation may have: where a nearest filter, a face of a cube map,
/// a level or a comparison hangs on less than the legal error, all outcomes are legal.
struct TexturedColor {
  Color color{}, lowest{}, highest{};
};

/// `coordinates`: of the units of `state`, in order.
TexturedColor apply_textures(const pipeline::TexturingState& state, const Color& primary,
                             std::span<const TextureCoordinate> coordinates);

/// Part of the above: a unit's function or combiner [GL1.5 §3.8.13]. `texels`: R, G, B, A of each unit in order, as
/// [GL1.5 Table 3.21] has them.
Color apply_environment(const pipeline::TexturingState& state, std::size_t unit, const Color& primary, const Color& previous,
                        std::span<const Color> texels);

/// What the environment sees of a unit's texture.
pipeline::BaseFormat seen_format(const pipeline::TextureUnitState& unit);

}  // namespace gouraud::oracle
