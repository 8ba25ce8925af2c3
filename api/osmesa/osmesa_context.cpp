// Takes a finished picture, gives it to the program's buffer: the copy-out of OSMesa.
//
// Contexts of the formats without alpha (OSMESA_RGB, OSMESA_BGR, OSMESA_RGB_565) have none: it is 1 for blending and
// reading [GL1.5 §4.1.8, §4.3.2].
// choice: colours of OSMESA_RGB_565 are kept with 8 bits while they are drawn, and rounded when they are copied out.
#include "api/osmesa/osmesa_context.h"

#include <cstdint>
#include <cstring>

#include "pipeline/framebuffer/read.h"

using gouraud::pipeline::DepthFormat;
using gouraud::pipeline::Framebuffer;
using gouraud::pipeline::PackedLayout;

namespace gouraud::api {

bool is_osmesa_format(GLenum format) {
  switch (format) {
    case OSMESA_COLOR_INDEX:
    case OSMESA_RGBA:
    case OSMESA_BGRA:
    case OSMESA_ARGB:
    case OSMESA_RGB:
    case OSMESA_BGR:
    case OSMESA_RGB_565:
      return true;
    default:
      return false;
  }
}

std::array<std::uint8_t, 4> most_color_bits(GLenum format) {
  switch (format) {
    case OSMESA_RGB_565:
      return {5, 6, 5, 0};
    case OSMESA_RGB:
    case OSMESA_BGR:
      return {32, 32, 32, 0};
    default:
      return {32, 32, 32, 32};
  }
}

// Words and floats of the four-channel formats are always R, G, B, A (MESA-RULES 10).
std::optional<PackedLayout> packed_layout(GLenum format, GLenum type) {
  if (format == OSMESA_RGB_565) {
    return type == GL_UNSIGNED_SHORT_5_6_5 ? std::optional(PackedLayout::rgb565) : std::nullopt;
  }
  const auto by_type = [type](PackedLayout bytes, PackedLayout words, PackedLayout floats) {
    switch (type) {
      case GL_UNSIGNED_BYTE:
        return std::optional(bytes);
      case GL_UNSIGNED_SHORT:
        return std::optional(words);
      case GL_FLOAT:
        return std::optional(floats);
      default:
        return std::optional<PackedLayout>();
    }
  };
  switch (format) {
    case OSMESA_RGBA:
      return by_type(PackedLayout::rgba8, PackedLayout::rgba16, PackedLayout::rgba32f);
    case OSMESA_BGRA:
      return by_type(PackedLayout::bgra8, PackedLayout::rgba16, PackedLayout::rgba32f);
    case OSMESA_ARGB:
      return by_type(PackedLayout::argb8, PackedLayout::rgba16, PackedLayout::rgba32f);
    case OSMESA_RGB:
      return by_type(PackedLayout::rgb8, PackedLayout::rgb16, PackedLayout::rgb32f);
    case OSMESA_BGR:
      return by_type(PackedLayout::bgr8, PackedLayout::bgr16, PackedLayout::bgr32f);
    default:
      return std::nullopt;
  }
}

namespace {

// A float depth in [0, 1] as 32-bit fixed point, which is what a client with 32 depth bits takes it for.
void fixed_point_of_floats(std::vector<std::byte>& values) {
  for (std::size_t i = 0; i < values.size(); i += sizeof(float)) {
    float depth;
    std::memcpy(&depth, &values[i], sizeof depth);
    const auto fixed = static_cast<std::uint32_t>(static_cast<double>(depth) * 4294967295.0 + 0.5);
    std::memcpy(&values[i], &fixed, sizeof fixed);
  }
}

}  // namespace
}  // namespace gouraud::api

osmesa_context::osmesa_context(GLenum format, const gouraud::api::ContextConfig& config, osmesa_context* share_with)
    : gl(config, share_with != nullptr ? &share_with->gl : nullptr), format_(format) {
  gl.copy_out = [this] { copy_out(); };
}

bool osmesa_context::bind_buffer(void* pixels, GLenum type, GLsizei width_px, GLsizei height_px) {
  const auto layout = gouraud::api::packed_layout(format_, type);
  if (pixels == nullptr || !layout) return false;
  const bool same_picture = type == type_ && width_px == width_px_ && height_px == height_px_;
  if (!gl.set_window_size(width_px, height_px, stored_format(*layout))) return false;
  if (!same_picture) gl.take_window_dirty();  // what was drawn into the old picture is gone
  pixels_ = pixels;
  type_ = type;
  layout_ = *layout;
  width_px_ = width_px;
  height_px_ = height_px;
  return true;
}

void osmesa_context::copy_out() {
  if (pixels_ == nullptr || !gl.take_window_dirty()) return;
  const int row_px = row_length_px > 0 ? row_length_px : width_px_;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(row_px) * bytes_per_pixel(layout_);
  auto* const first_row = static_cast<std::byte*>(pixels_) + (y_up ? 0 : (height_px_ - 1) * stride);
  pack_color_rows(*gl.window(), layout_, 0, 0, width_px_, height_px_, first_row, y_up ? stride : -stride);
  if (snapshot_fits()) refresh_snapshot();
}

bool osmesa_context::snapshot_fits() const {
  return !snapshot_.values.empty() && snapshot_.width_px == width_px_ && snapshot_.height_px == height_px_ &&
         snapshot_.bytes_per_value == gouraud::pipeline::bytes_per_pixel(gl.window()->depth_format);
}

void osmesa_context::refresh_snapshot() {
  const Framebuffer& target = *gl.window();
  read_depth_rows(target, 0, 0, snapshot_.width_px, snapshot_.height_px, snapshot_.values.data(),
                  static_cast<std::ptrdiff_t>(snapshot_.width_px) * snapshot_.bytes_per_value);
  if (target.depth_format == DepthFormat::z32f) gouraud::api::fixed_point_of_floats(snapshot_.values);
}

// A snapshot of another size stays where it is until the program asks again: it may still look at the old one.
osmesa_context::DepthSnapshot* osmesa_context::depth_snapshot() {
  if (gl.window() == nullptr || gl.window()->depth_format == DepthFormat::none) return nullptr;
  if (!snapshot_fits()) {
    const int bytes = gouraud::pipeline::bytes_per_pixel(gl.window()->depth_format);
    std::vector<std::byte> values(static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_) *
                                  static_cast<std::size_t>(bytes));
    snapshot_ = {std::move(values), width_px_, height_px_, bytes};
    gl.finish_rendering();
    refresh_snapshot();
  }
  return &snapshot_;
}
