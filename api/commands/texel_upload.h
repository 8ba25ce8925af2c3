// Pixels of client memory become texels [GL1.5 §3.6.4, §3.6.5, §3.8.1].
#pragma once

#include "api/commands/client_pixels.h"
#include "pipeline/texture/image.h"

namespace gouraud::api {

/// A texel of an image's array, counted from the border's edge.
struct TexelPosition {
  int x = 0, y = 0, z = 0;
};

/// Writes all pixels of `client`, whose memory is readable and of a kind that goes with the image, from `at` on; they
/// are within the image.
void upload(const Context& context, const ClientImage& client, const pipeline::Image& image, const TexelPosition& at);

}  // namespace gouraud::api
