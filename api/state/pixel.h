// Pixel transfer and zoom [GL1.5 §3.6.3, §3.6.4, Tables 3.2, 3.3 and 6.21 to 6.25].
#pragma once

#include <array>
#include <cstddef>

#include <GL/gl.h>
#include <glm/glm.hpp>

#include "api/state/limits.h"

namespace gouraud::api {

struct PixelTransferGroup {
  bool map_color = false, map_stencil = false;
  GLint index_shift = 0, index_offset = 0;
  glm::vec4 scale{1.0f}, bias{0.0f};  ///< R, G, B, A
  float depth_scale = 1.0f, depth_bias = 0.0f;
  bool operator==(const PixelTransferGroup&) const = default;
};

/// Part of attribute group PIXEL_MODE_BIT.
struct PixelGroup {
  PixelTransferGroup transfer;
  float zoom_x = 1.0f, zoom_y = 1.0f;
  GLenum read_buffer = GL_FRONT;  ///< of a saved group; in force is the read buffer of the framebuffer that is bound
  bool operator==(const PixelGroup&) const = default;
};

/// One pixel map. Entries are exact: colours and colour indices are floats, stencil indices 32-bit integers.
struct PixelMap {
  GLsizei size = 1;
  std::array<double, max_pixel_map_table> entry{};
  bool operator==(const PixelMap&) const = default;
};

/// Places in PixelMaps, in the order of the names GL_PIXEL_MAP_I_TO_I to GL_PIXEL_MAP_A_TO_A.
enum PixelMapName : std::size_t {
  map_i_to_i, map_s_to_s, map_i_to_r, map_i_to_g, map_i_to_b, map_i_to_a, map_r_to_r, map_g_to_g, map_b_to_b, map_a_to_a,
  pixel_map_count
};
using PixelMaps = std::array<PixelMap, pixel_map_count>;

}  // namespace gouraud::api
