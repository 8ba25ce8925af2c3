// Points, lines and polygons [GL1.5 §3.3 to §3.5, Table 6.13].
#pragma once

#include <GL/gl.h>

namespace gouraud::api {

/// Attribute group POINT_BIT.
struct PointGroup {
  float size_px = 1.0f;  ///< as given: > 0, not clamped to the supported range
  bool operator==(const PointGroup&) const = default;
};

/// Attribute group LINE_BIT.
struct LineGroup {
  float width_px = 1.0f;  ///< as given: > 0, not clamped to the supported range
  bool operator==(const LineGroup&) const = default;
};

/// Attribute group POLYGON_BIT.
struct PolygonGroup {
  bool cull_enabled = false;
  GLenum cull_face = GL_BACK;
  GLenum front_face = GL_CCW;
  GLenum front_mode = GL_FILL, back_mode = GL_FILL;
  bool operator==(const PolygonGroup&) const = default;
};

}  // namespace gouraud::api
