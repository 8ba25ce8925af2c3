// Points, lines and polygons [GL1.5 §3.3 to §3.5, Table 6.13].
#pragma once

#include <array>
#include <cstdint>

#include <GL/gl.h>
#include <glm/glm.hpp>

#include "api/state/limits.h"

namespace gouraud::api {

/// Attribute group POINT_BIT.
struct PointGroup {
  float size_px = 1.0f;  ///< as given: > 0, not clamped to the supported range
  bool smooth_enabled = false;
  bool sprite_enabled = false;     ///< ARB_point_sprite
  std::uint8_t coord_replace = 0;  ///< bit k: COORD_REPLACE of texture unit k
  float smallest_px = 0.0f, largest_px = max_point_size, fade_threshold_px = 1.0f;  ///< >= 0
  glm::vec3 distance_attenuation{1.0f, 0.0f, 0.0f};
  bool operator==(const PointGroup&) const = default;
};

/// Attribute group LINE_BIT.
struct LineGroup {
  float width_px = 1.0f;  ///< as given: > 0, not clamped to the supported range
  bool smooth_enabled = false;
  bool stipple_enabled = false;
  GLushort stipple_pattern = 0xFFFF;
  GLint stipple_factor = 1;  ///< in [1, 256]
  bool operator==(const LineGroup&) const = default;
};

/// Attribute group POLYGON_BIT.
struct PolygonGroup {
  bool cull_enabled = false;
  GLenum cull_face = GL_BACK;
  GLenum front_face = GL_CCW;
  GLenum front_mode = GL_FILL, back_mode = GL_FILL;
  bool smooth_enabled = false;
  bool stipple_enabled = false;  ///< the pattern is of a group of its own
  bool offset_fill_enabled = false, offset_line_enabled = false, offset_point_enabled = false;
  float offset_factor = 0.0f;
  float offset_units = 0.0f;  ///< 0 after PolygonOffsetEXT
  float offset_bias = 0.0f;   ///< of PolygonOffsetEXT, in window z; 0 after PolygonOffset
  bool operator==(const PolygonGroup&) const = default;
};

/// Attribute group POLYGON_STIPPLE_BIT. Row r is for y mod 32 = r, its bit k for x mod 32 = k.
struct PolygonStippleGroup {
  std::array<std::uint32_t, 32> rows = all_ones();
  static constexpr std::array<std::uint32_t, 32> all_ones() {
    std::array<std::uint32_t, 32> result{};
    for (std::uint32_t& row : result) row = ~std::uint32_t{0};
    return result;
  }
  bool operator==(const PolygonStippleGroup&) const = default;
};

}  // namespace gouraud::api
