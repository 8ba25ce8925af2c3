// Takes bits and the current raster position, gives a pipeline Bitmap: bits in one order, no more than can be seen
// [GL1.5 §3.7].
//
// choice: the position is moved by 0.0001 before it is rounded down, as Mesa does (MESA-RULES 9): a position that came
// out of the matrices as 9.9999995 is meant to be 10.
#include "api/commands/bitmaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "api/commands/client_pixels.h"
#include "api/commands/fragment_source.h"
#include "api/commands/render_mode.h"
#include "pipeline/raster/pixel_image.h"

namespace gouraud::api {
namespace {

constexpr PixelLayout bits_layout{PixelKind::color_index, ElementType::bits, 1, 1, 0, {}, {}};

/// The low bits of the result are the columns to the left.
std::uint8_t reversed(std::uint8_t bits) {
  bits = static_cast<std::uint8_t>((bits & 0xF0u) >> 4 | (bits & 0x0Fu) << 4);
  bits = static_cast<std::uint8_t>((bits & 0xCCu) >> 2 | (bits & 0x33u) << 2);
  return static_cast<std::uint8_t>((bits & 0xAAu) >> 1 | (bits & 0x55u) << 1);
}

/// The bits of [first, first + count) of a row, the leftmost first.
void copy_bits(const ClientImage& image, GLsizei y, std::int32_t first, std::int32_t count, std::uint8_t* out) {
  const auto* const row = reinterpret_cast<const std::uint8_t*>(image.row(y));
  const std::size_t begin = image.first_bit + static_cast<std::size_t>(first);
  const std::size_t last_byte = (begin + static_cast<std::size_t>(count) - 1) / 8, shift = begin % 8;
  const auto at = [&](std::size_t i) {
    return i > last_byte ? 0u : std::uint32_t{image.lsb_first ? row[i] : reversed(row[i])};
  };
  std::size_t byte = begin / 8;
  for (std::int32_t done = 0; done < count; done += 8, ++byte) {
    *out++ = static_cast<std::uint8_t>((at(byte) | at(byte + 1) << 8) >> shift);
  }
  if (count % 8 != 0) out[-1] = static_cast<std::uint8_t>(out[-1] & ((1u << count % 8) - 1));
}

/// The part of [at, at + size) inside [low, high), counted from `at`.
struct Part {
  std::int32_t first = 0, count = 0;
};
Part part_inside(double at, GLsizei size, std::int32_t low, std::int32_t high) {
  const double begin = std::max(at, static_cast<double>(low)), end = std::min(at + size, static_cast<double>(high));
  if (!(begin < end)) return {};
  return {static_cast<std::int32_t>(begin - at), static_cast<std::int32_t>(end - begin)};
}

void draw(Context& context, const ClientImage& image, float xorig, float yorig) {
  constexpr double meant = 0.0001;
  const glm::vec4& position = context.state.current.raster.position_window;
  const double x = std::floor(static_cast<double>(position.x) + meant - static_cast<double>(xorig));
  const double y = std::floor(static_cast<double>(position.y) + meant - static_cast<double>(yorig));
  const pipeline::PixelRect& clip = context.pixel_draw().state.raster.scissor;
  const Part columns = part_inside(x, image.size.width, clip.x0, clip.x1);
  const Part rows = part_inside(y, image.size.height, clip.y0, clip.y1);
  if (columns.count <= 0 || rows.count <= 0) return;

  const std::int32_t row_bytes = (columns.count + 7) / 8;
  const std::size_t bytes = static_cast<std::size_t>(row_bytes) * static_cast<std::size_t>(rows.count);
  std::array<std::uint8_t, 512> small;
  std::vector<std::uint8_t> large(bytes > small.size() ? bytes : 0);
  std::uint8_t* const bits = bytes > small.size() ? large.data() : small.data();
  for (std::int32_t j = 0; j < rows.count; ++j) {
    copy_bits(image, rows.first + j, columns.first, columns.count, bits + j * row_bytes);
  }
  draw_bitmap(context, {static_cast<std::int32_t>(x + columns.first), static_cast<std::int32_t>(y + rows.first),
                        columns.count, rows.count, bits, row_bytes});
}

}  // namespace

void Bitmap(Context& context, GLsizei width, GLsizei height, GLfloat xorig, GLfloat yorig, GLfloat xmove, GLfloat ymove,
            const GLubyte* bitmap) {
  constexpr auto command = "glBitmap";
  if (!context.can_draw(command)) return;
  if (width < 0 || height < 0) return context.record_error(GL_INVALID_VALUE, command, "a size is negative");
  ClientImage image;
  if (!locate_unpack(context, command, {width, height}, bits_layout, bitmap, image)) return;
  RasterPosition& raster = context.state.current.raster;
  if (!raster.valid) return;
  if (renders_nothing(context)) {
    report_raster_position(context, GL_BITMAP_TOKEN);
  } else if (!image.null() && width > 0 && height > 0) {
    draw(context, image, xorig, yorig);
  }
  raster.position_window.x += xmove;
  raster.position_window.y += ymove;
}

}  // namespace gouraud::api
