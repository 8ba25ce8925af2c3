// Takes client memory or the target, gives pixel rectangles: only what can be seen, after pixel transfer
// [GL1.5 §3.6.4, §4.3.1, §4.3.3]. A copy has been read before anything is drawn, so that it may overlap itself.
#include "api/commands/pixel_rectangles.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "api/commands/client_pixels.h"
#include "api/commands/fragment_source.h"
#include "api/commands/pixel_transfer.h"
#include "api/commands/render_mode.h"
#include "api/commands/target_values.h"
#include "api/commands/unpack_rows.h"
#include "pipeline/framebuffer/read.h"

namespace gouraud::api {
namespace {

using pipeline::ColorFormat;
using pipeline::DirectRectangle;
using pipeline::PixelImage;
using pipeline::PixelImageFormat;
using pipeline::PixelRectangle;
using pipeline::SourceRange;

/// Columns and rows of a rectangle, and where they go.
struct Part {
  PixelRectangle place;
  SourceRange columns, rows;
  bool empty() const { return columns.count() <= 0 || rows.count() <= 0; }
};

/// What can be seen of a rectangle at the raster position.
Part visible_part(Context& context, GLsizei width, GLsizei height) {
  const pipeline::PixelRect& clip = context.pixel_draw().state.raster.scissor;
  const RasterPosition& raster = context.state.current.raster;
  const PixelGroup& pixel = context.state.pixel;
  Part part;
  part.place.x = static_cast<double>(raster.position_window.x);
  part.place.y = static_cast<double>(raster.position_window.y);
  part.place.zoom_x = static_cast<double>(pixel.zoom_x);
  part.place.zoom_y = static_cast<double>(pixel.zoom_y);
  part.columns = visible_sources(pipeline::map_axis(part.place.x, part.place.zoom_x, 0, width, clip.x0, clip.x1));
  part.rows = visible_sources(pipeline::map_axis(part.place.y, part.place.zoom_y, 0, height, clip.y0, clip.y1));
  return part;
}

void draw_image(Context& context, Part& part, std::shared_ptr<const PixelImage> image) {
  part.place.first_column = part.columns.first;
  part.place.first_row = part.rows.first;
  part.place.image = std::move(image);
  draw_rectangle(context, part.place);
}

/// Draws the part: fill_row(out, j) writes row `j`, counted from part.rows.first.
template <class FillRow>
void draw_part(Context& context, Part& part, PixelImageFormat format, FillRow fill_row) {
  auto image = std::make_shared<PixelImage>(format, part.columns.count(), part.rows.count());
  for (std::int32_t j = 0; j < image->height_px; ++j) fill_row(image->own_row(j), j);
  draw_image(context, part, std::move(image));
}

/// Many pixels come out of the client's memory, without a copy.
void draw_bytes(Context& context, Part& part, const ClientImage& image, const pipeline::ByteOrder& order) {
  const std::int32_t width = part.columns.count(), height = part.rows.count();
  if (order == pipeline::same_order && std::int64_t{width} * height >= pipeline::many_pixels) {
    const std::byte* const first = image.row(part.rows.first) + std::ptrdiff_t{part.columns.first} * 4;
    const auto stride = static_cast<std::ptrdiff_t>(image.row_stride);
    return draw_image(context, part, std::make_shared<PixelImage>(PixelImageFormat::rgba8, width, height, first, stride));
  }
  draw_part(context, part, PixelImageFormat::rgba8, [&](std::byte* out, std::int32_t j) {
    unpack_bytes(image, order, {part.rows.first + j, 0, part.columns.first, width}, out);
  });
}

/// Final conversion clamps, except for targets that store floats [GL1.5 §3.6.4].
void clamp_color(const Context& context, float* rgba, std::int32_t pixels) {
  if (context.target_info().format.color == ColorFormat::rgba32f) return;
  for (float* value = rgba; value != rgba + 4 * static_cast<std::ptrdiff_t>(pixels); ++value) {
    *value = *value > 0.0f ? std::min(*value, 1.0f) : 0.0f;
  }
}

/// Writes stencil, and depth if there are depths, of a part. `stencils(j, out)` and `depths(j, out)` give row j.
template <class StencilRow, class DepthRow>
void write_part(Context& context, Part& part, bool with_depth, StencilRow stencil_row, DepthRow depth_row) {
  const auto width = static_cast<std::size_t>(part.columns.count()), height = static_cast<std::size_t>(part.rows.count());
  DirectRectangle rectangle;
  rectangle.width_px = part.columns.count();
  rectangle.height_px = part.rows.count();
  rectangle.clip = context.pixel_draw().state.raster.scissor;
  rectangle.stencil_write_mask = static_cast<std::uint8_t>(context.state.stencil.front.write_mask);
  part.place.first_column = part.columns.first;
  part.place.first_row = part.rows.first;
  rectangle.place = part.place;

  const bool writes_depth = with_depth && context.state.depth.write_enabled;
  auto stencils = std::make_shared_for_overwrite<std::uint8_t[]>(width * height);
  auto depths = writes_depth ? std::make_shared_for_overwrite<double[]>(width * height) : nullptr;
  std::vector<std::uint32_t> row(width);
  for (std::size_t j = 0; j < height; ++j) {
    stencil_row(static_cast<std::int32_t>(j), row);
    std::transform(row.begin(), row.end(), stencils.get() + j * width, [](std::uint32_t v) { return static_cast<std::uint8_t>(v); });
    if (writes_depth) depth_row(static_cast<std::int32_t>(j), depths.get() + j * width);
  }
  rectangle.stencils = std::move(stencils);
  rectangle.depths = std::move(depths);
  context.renderer().write_rectangle(rectangle);
}

void draw_unpacked(Context& context, const ClientImage& image, Part& part) {
  const auto run = [&](std::int32_t j) { return PixelRun{part.rows.first + j, 0, part.columns.first, part.columns.count()}; };
  switch (image.layout.kind) {
    case PixelKind::depth:
      return draw_part(context, part, PixelImageFormat::depth, [&](std::byte* out, std::int32_t j) {
        transferred_depth(context, image, run(j), reinterpret_cast<double*>(out));
      });
    case PixelKind::stencil_index:
    case PixelKind::depth_stencil:
      return write_part(
          context, part, image.layout.kind == PixelKind::depth_stencil,
          [&](std::int32_t j, std::vector<std::uint32_t>& out) { transferred_stencil(context, image, run(j), out.data()); },
          [&](std::int32_t j, double* out) { transferred_depth(context, image, run(j), out); });
    case PixelKind::color:
    case PixelKind::color_index: break;
  }
  if (const auto order = byte_order(context, image)) return draw_bytes(context, part, image, *order);
  draw_part(context, part, PixelImageFormat::rgba32f, [&](std::byte* out, std::int32_t j) {
    auto* const rgba = reinterpret_cast<float*>(out);
    transferred_color(context, image, run(j), rgba);
    clamp_color(context, rgba, part.columns.count());
  });
}

std::optional<PixelKind> copied_kind(GLenum type) {
  switch (type) {
    case GL_COLOR: return PixelKind::color;
    case GL_DEPTH: return PixelKind::depth;
    case GL_STENCIL: return PixelKind::stencil_index;
    case GL_DEPTH_STENCIL_EXT: return PixelKind::depth_stencil;
    default: return std::nullopt;
  }
}

/// Leaves out the sources outside [0, size) of the target that is read, where source n lies at position + n.
void cut_to_target(SourceRange& sources, GLint position, std::int32_t size) {
  const std::int64_t first = std::max<std::int64_t>(sources.first, -std::int64_t{position});
  const std::int64_t end = std::min<std::int64_t>(sources.end, std::int64_t{size} - position);
  sources = first < end ? SourceRange{static_cast<std::int32_t>(first), static_cast<std::int32_t>(end)} : SourceRange{};
}

void copy(Context& context, const pipeline::Framebuffer& source, GLint x, GLint y, PixelKind kind, Part& part) {
  const PixelTransferGroup& transfer = context.state.pixel.transfer;
  const int from = x + part.columns.first, width = part.columns.count();
  const auto count = static_cast<std::size_t>(width);
  const auto row = [&](std::int32_t j) { return y + part.rows.first + j; };
  const auto depth_row = [&](std::int32_t j, double* out) {
    read_depths(source, from, row(j), width, out);
    if (transfers_depth(transfer)) transfer_depth(context.state, out, count);
  };
  switch (kind) {
    case PixelKind::depth:
      return draw_part(context, part, PixelImageFormat::depth,
                       [&](std::byte* out, std::int32_t j) { depth_row(j, reinterpret_cast<double*>(out)); });
    case PixelKind::stencil_index:
    case PixelKind::depth_stencil:
      return write_part(
          context, part, kind == PixelKind::depth_stencil,
          [&](std::int32_t j, std::vector<std::uint32_t>& out) {
            read_stencils(source, from, row(j), width, out.data());
            if (transfers_stencil(transfer)) transfer_stencil(context.state, out.data(), count);
          },
          depth_row);
    default: break;
  }
  if (source.color_format == ColorFormat::rgba8 && !transfers_color(transfer)) {
    return draw_part(context, part, PixelImageFormat::rgba8,
                     [&](std::byte* out, std::int32_t j) { read_color_row(source, from, row(j), width, out); });
  }
  draw_part(context, part, PixelImageFormat::rgba32f, [&](std::byte* out, std::int32_t j) {
    auto* const rgba = reinterpret_cast<float*>(out);
    read_color_row_float(source, from, row(j), width, rgba);
    if (transfers_color(transfer)) transfer_color(context.state, rgba, count);
    clamp_color(context, rgba, width);
  });
}

}  // namespace

void PixelZoom(Context& context, GLfloat xfactor, GLfloat yfactor) {
  context.state.pixel.zoom_x = xfactor;
  context.state.pixel.zoom_y = yfactor;
}

void DrawPixels(Context& context, GLsizei width, GLsizei height, GLenum format, GLenum type, const void* pixels) {
  constexpr auto command = "glDrawPixels";
  if (!context.can_draw(command) || context.target() == nullptr) return;
  ClientImage image;
  if (!check_unpack(context, command, {width, height}, format, type, pixels, image)) return;
  if (const char* const problem = missing_buffer(*context.target(), image.layout.kind)) {
    return context.record_error(GL_INVALID_OPERATION, command, problem);
  }
  if (!context.state.current.raster.valid) return;
  if (renders_nothing(context)) return report_raster_position(context, GL_DRAW_PIXEL_TOKEN);
  if (image.null()) return;
  Part part = visible_part(context, width, height);
  if (!part.empty()) draw_unpacked(context, image, part);
}

void CopyPixels(Context& context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum type) {
  constexpr auto command = "glCopyPixels";
  if (!context.can_draw(command) || !context.can_read(command)) return;
  if (context.target() == nullptr || context.read_target() == nullptr) return;
  const std::optional<PixelKind> kind = copied_kind(type);
  if (!kind) return context.record_error(GL_INVALID_ENUM, command, "type is unknown");
  if (width < 0 || height < 0) return context.record_error(GL_INVALID_VALUE, command, "a size is negative");
  const pipeline::Framebuffer& source = *context.read_target();
  const char* problem = missing_buffer(source, *kind);
  if (problem == nullptr) problem = missing_buffer(*context.target(), *kind);
  if (*kind == PixelKind::color && source.color_format == ColorFormat::none) problem = "the read buffer is GL_NONE";
  if (problem != nullptr) return context.record_error(GL_INVALID_OPERATION, command, problem);
  if (!context.state.current.raster.valid) return;
  if (renders_nothing(context)) return report_raster_position(context, GL_COPY_PIXEL_TOKEN);
  Part part = visible_part(context, width, height);
  cut_to_target(part.columns, x, source.width_px);
  cut_to_target(part.rows, y, source.height_px);
  if (part.empty()) return;
  context.finish_rendering();
  copy(context, source, x, y, *kind, part);
}

}  // namespace gouraud::api
