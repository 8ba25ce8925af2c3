// Current values: what the next vertex gets [GL1.5 §2.7, Table 6.5].
#pragma once

#include <array>

#include <glm/glm.hpp>

#include "api/state/limits.h"

namespace gouraud::api {

/// Where bitmaps and pixel rectangles go, and what they get there [GL1.5 §2.13]. While it is not valid the rest is
/// what it was when it last was.
struct RasterPosition {
  glm::vec4 position_window{0.0f, 0.0f, 0.0f, 1.0f};  ///< x, y up, z in [0, 1]; and the clip coordinate w
  bool valid = true;
  float distance = 0.0f;                              ///< the fog coordinate
  glm::vec4 color{1.0f};                              ///< in [0, 1]
  glm::vec4 secondary_color{0.0f, 0.0f, 0.0f, 1.0f};  ///< in [0, 1]
  float color_index = 1.0f;                           ///< never changes: there is no color index mode
  std::array<glm::vec4, max_texture_units> texture_coordinates{
      glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1),
      glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1)};
  bool operator==(const RasterPosition&) const = default;
};

/// Attribute group CURRENT_BIT.
struct CurrentGroup {
  glm::vec4 color{1.0f};  ///< unclamped
  glm::vec3 normal_object{0.0f, 0.0f, 1.0f};
  bool edge_flag = true;
  float fog_coordinate = 0.0f;
  float color_index = 1.0f;
  glm::vec4 secondary_color{0.0f, 0.0f, 0.0f, 1.0f};  ///< unclamped; alpha is always 1
  std::array<glm::vec4, max_texture_units> texture_coordinates{
      glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1),
      glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1), glm::vec4(0, 0, 0, 1)};
  RasterPosition raster;
  bool operator==(const CurrentGroup&) const = default;
};

}  // namespace gouraud::api
