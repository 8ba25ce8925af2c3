// What an OSMesa context is besides a GL context: the program's buffer, and a linear snapshot of the depth buffer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <GL/osmesa.h>

#include "api/context/context.h"
#include "pipeline/framebuffer/pack.h"

struct osmesa_context {
 public:
  /// Throws std::bad_alloc. `format` is one of osmesa.h's.
  osmesa_context(GLenum format, const gouraud::api::ContextConfig& config, osmesa_context* share_with);
  osmesa_context(const osmesa_context&) = delete;
  osmesa_context& operator=(const osmesa_context&) = delete;

  /// Copies to `pixels` from now on; see OSMesaMakeCurrent. False, and nothing is changed, if that cannot be.
  bool bind_buffer(void* pixels, GLenum type, GLsizei width_px, GLsizei height_px);

  struct DepthSnapshot {
    std::vector<std::byte> values;  ///< rows bottom-up, without gaps
    int width_px = 0, height_px = 0, bytes_per_value = 0;
  };
  /// The snapshot, brought into being if there is none of the target's size; null without a depth buffer.
  /// Throws std::bad_alloc.
  DepthSnapshot* depth_snapshot();

  GLenum format() const { return format_; }
  GLenum type() const { return type_; }
  void* pixels() const { return pixels_; }
  GLsizei width_px() const { return width_px_; }
  GLsizei height_px() const { return height_px_; }

  gouraud::api::Context gl;
  GLint row_length_px = 0;  ///< 0: the width
  bool y_up = true;

 private:
  void copy_out();
  bool snapshot_fits() const;
  void refresh_snapshot();

  GLenum format_;
  GLenum type_ = GL_NONE;
  gouraud::pipeline::PackedLayout layout_{};
  void* pixels_ = nullptr;
  GLsizei width_px_ = 0, height_px_ = 0;
  DepthSnapshot snapshot_;
};

namespace gouraud::api {

/// True for the formats that a context can be created with.
bool is_osmesa_format(GLenum format);

/// The bits of R, G, B, A that a program's buffer of this format has at most; alpha 0 if it has none.
std::array<std::uint8_t, 4> most_color_bits(GLenum format);

/// How a buffer of this format and type is filled; empty if the two do not go together.
std::optional<pipeline::PackedLayout> packed_layout(GLenum format, GLenum type);

}  // namespace gouraud::api
