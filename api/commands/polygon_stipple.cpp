#include "api/commands/polygon_stipple.h"

#include <array>

#include "api/commands/client_pixels.h"
#include "api/commands/pack_rows.h"
#include "api/commands/unpack_rows.h"

namespace gouraud::api {
namespace {

constexpr GLsizei side = 32;

}  // namespace

void PolygonStipple(Context& context, const GLubyte* mask) {
  ClientImage image;
  if (!check_unpack(context, "glPolygonStipple", {side, side}, GL_COLOR_INDEX, GL_BITMAP, mask, image) || image.null()) return;
  for (GLsizei y = 0; y < side; ++y) {
    std::array<std::uint8_t, side> bits;
    unpack_bits(image, whole_row(image, y), bits.data());
    std::uint32_t& row = context.state.polygon_stipple.rows[static_cast<std::size_t>(y)];
    row = 0;
    for (std::size_t x = 0; x < bits.size(); ++x) row |= static_cast<std::uint32_t>(bits[x]) << x;
  }
  context.change(dirty_raster);
}

void GetPolygonStipple(Context& context, GLubyte* mask) {
  ClientImage image;
  if (!check_pack(context, "glGetPolygonStipple", {side, side}, GL_COLOR_INDEX, GL_BITMAP, mask, image) || image.null()) return;
  for (GLsizei y = 0; y < side; ++y) {
    const std::uint32_t row = context.state.polygon_stipple.rows[static_cast<std::size_t>(y)];
    std::array<std::uint32_t, side> bits;
    for (std::size_t x = 0; x < bits.size(); ++x) bits[x] = row >> x & 1;
    pack_indices(image, whole_row(image, y), bits.data());
  }
}

}  // namespace gouraud::api
