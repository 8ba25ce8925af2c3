// Takes the shares of a primitive's vertices in a fragment, gives its final colour: textures, then the colour sum
// [GL1.5 §3.8, §3.9].
#pragma once

#include <span>

#include "conformance/oracle/rasterize.h"
#include "conformance/oracle/textures.h"

namespace gouraud::oracle {

/// How much a vertex counts at a pixel's centre: its weight in window space over its w, and the derivatives of that by
/// window x and y.
struct VertexShare {
  const VertexColors* vertex = nullptr;
  double share = 0, ddx = 0, ddy = 0;
};

/// The colour of a fragment whose interpolated primary colour is `primary`. Without textures that is all (the sum with
/// the secondary colour is linear and was made at the vertices).
/// `sprite`: what point sprites have in place of their vertex's texture coordinates [ARB_point_sprite].
/// `in_range`: texture coordinates are kept in the range of the vertices' (but not their derivatives).
TexturedColor shade(const FragmentSink& sink, const Color& primary, std::span<const VertexShare> shares,
                    const TextureCoordinate* sprite = nullptr, bool in_range = false);

/// Takes a colour into a fragment. Where several outcomes are legal the fragment has bounds (PixelFlags).
void set_color(const TexturedColor& color, Fragment& fragment);
/// Widens the fragment's bounds by another colour that it may have.
void include_color(const TexturedColor& color, Fragment& fragment);

}  // namespace gouraud::oracle
