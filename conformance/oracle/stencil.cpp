#include "conformance/oracle/stencil.h"

#include <algorithm>

namespace gouraud::oracle {
namespace {

/// In a buffer of 8 bits, before the mask.
unsigned operated(pipeline::StencilOp op, unsigned stored, unsigned reference) {
  switch (op) {
    case pipeline::StencilOp::keep:
      return stored;
    case pipeline::StencilOp::zero:
      return 0;
    case pipeline::StencilOp::replace:
      return reference;
    case pipeline::StencilOp::increment:
      return std::min(stored + 1, 255u);
    case pipeline::StencilOp::decrement:
      return stored == 0 ? 0 : stored - 1;
    case pipeline::StencilOp::invert:
      return 255 - stored;
    case pipeline::StencilOp::increment_wrap:
      return (stored + 1) % 256;
    case pipeline::StencilOp::decrement_wrap:
      break;
  }
  return (stored + 255) % 256;
}

}  // namespace

bool passes_stencil(const pipeline::StencilFace& face, const OraclePixel& pixel) {
  const int reference = face.reference & face.compare_mask, stored = pixel.stencil & face.compare_mask;
  switch (face.func) {
    case pipeline::CompareFunc::never:
      return false;
    case pipeline::CompareFunc::less:
      return reference < stored;
    case pipeline::CompareFunc::equal:
      return reference == stored;
    case pipeline::CompareFunc::lequal:
      return reference <= stored;
    case pipeline::CompareFunc::greater:
      return reference > stored;
    case pipeline::CompareFunc::notequal:
      return reference != stored;
    case pipeline::CompareFunc::gequal:
      return reference >= stored;
    case pipeline::CompareFunc::always:
      break;
  }
  return true;
}

void update_stencil(const pipeline::StencilFace& face, bool stencil_passes, bool depth_passes, OraclePixel& pixel) {
  const pipeline::StencilOp op = !stencil_passes ? face.fail : depth_passes ? face.depth_pass : face.depth_fail;
  const unsigned result = operated(op, pixel.stencil, face.reference), written = face.write_mask;
  pixel.stencil = static_cast<std::uint8_t>((result & written) | (pixel.stencil & (255 - written)));
}

}  // namespace gouraud::oracle
