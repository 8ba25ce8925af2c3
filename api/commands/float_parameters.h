// Parameters that come as floats and stand for something else [GL1.5 §2.3, Table 2.2 and §6.1.2].
#pragma once

#include <cmath>

#include <GL/gl.h>

namespace gouraud::api {

/// No GLenum; for a value that is none.
inline constexpr GLenum no_enum = 0xFFFFFFFF;

inline GLenum to_enum(GLfloat value) {
  return value >= 0.0f && value < 1048576.0f && value == std::floor(value) ? static_cast<GLenum>(value) : no_enum;
}

/// The nearest integer; NaN gives -1, which what must not be negative refuses.
inline GLint to_level(GLfloat value) {
  if (std::isnan(value)) return -1;
  if (value >= 2147483648.0f) return 2147483647;
  if (value <= -2147483648.0f) return -2147483647 - 1;
  return static_cast<GLint>(std::lround(value));
}

}  // namespace gouraud::api
